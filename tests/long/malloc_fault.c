// Makes memory end, for faults.sh: LD_PRELOAD of a program. Calls are counted from the start of main(); operator new
// calls malloc.
//   FAULT_AT=n        the nth call gets no memory
//   FAULT_LASTS=1     nor do all after it
//   FAULT_TOLD=file   is made when a call gets none
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static long at, told = -1, calls;
static int lasts;

/// Whether this call is to get none.
static int fails(void) {
  if (at == 0) return 0;
  const long n = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
  if (lasts ? n < at : n != at) return 0;
  if (n == at) syscall(SYS_write, told, "malloc\n", 7);
  errno = ENOMEM;
  return 1;
}
void* malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return fails() ? NULL : __libc_calloc(n, size); }
void* realloc(void* old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) { return fails() ? NULL : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** memory, size_t alignment, size_t size) {
  void* got = memalign(alignment, size);
  if (got) *memory = got;
  return got ? 0 : ENOMEM;
}

static int (*program_main)(int, char**, char**);
static int counted_main(int argc, char** argv, char** environment) {
  told = syscall(SYS_openat, AT_FDCWD, getenv("FAULT_TOLD"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  lasts = getenv("FAULT_LASTS") != NULL;
  at = atol(getenv("FAULT_AT"));
  return program_main(argc, argv, environment);
}
int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void), void (*fini)(void),
                      void (*rtld_fini)(void), void* stack_end) {
  program_main = main;
  int (*next)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
  *(void**)&next = dlsym(RTLD_NEXT, "__libc_start_main");
  return next(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
