// Makes memory end, for faults.sh: LD_PRELOAD of a program. Calls are counted from the start of main(); operator new
// calls malloc.
//   FAULT_AT=n        the nth call gets no memory
//   FAULT_LASTS=1     nor do all after it
//   FAULT_TOLD=file   is made when a call gets none
//   FAULT_PLACES=file gets the numbers of the calls that come from places of their own: from a chain of calls that no
//                     earlier one came from; with it no call fails
//   FAULT_DEPTH=n     so many callers make a place, at most 61
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static long at, told = -1, calls;
static int lasts;
static long places = -1;
static int depth = 61;
static __thread int inside;

/// Lists the call if it comes from a new place.
static void list(long n) {
  static uint64_t known[1 << 20]; // by hash; at most half full
  static long kept;
  if (inside || kept == 1 << 19) return;
  inside = 1; // the unwinder may take memory
  void* chain[64];
  const int length = backtrace(chain, depth + 3); // list, fails and malloc
  uint64_t hash = 1;
  for (int k = 0; k < length; ++k) hash = (hash ^ (uintptr_t)chain[k]) * 0x9e3779b97f4a7c15U + (hash >> 29);
  uint64_t slot = hash & ((1 << 20) - 1);
  while (known[slot] != 0 && known[slot] != hash) slot = (slot + 1) & ((1 << 20) - 1);
  if (known[slot] == 0) {
    known[slot] = hash;
    ++kept;
    char text[24];
    syscall(SYS_write, places, text, snprintf(text, sizeof(text), "%ld\n", n));
  }
  inside = 0;
}

/// Whether this call is to get none.
static int fails(void) {
  if (at == 0 && places < 0) return 0;
  const long n = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
  if (places >= 0) {
    list(n);
    return 0;
  }
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
  const int flags = O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC;
  if (getenv("FAULT_PLACES") != NULL) {
    void* first[1];
    backtrace(first, 1); // loads the unwinder
    if (getenv("FAULT_DEPTH") != NULL) depth = atoi(getenv("FAULT_DEPTH"));
    if (depth > 61) depth = 61;
    places = syscall(SYS_openat, AT_FDCWD, getenv("FAULT_PLACES"), flags, 0600);
    return program_main(argc, argv, environment);
  }
  told = syscall(SYS_openat, AT_FDCWD, getenv("FAULT_TOLD"), flags, 0600);
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
