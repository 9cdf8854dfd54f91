// Makes calls of the system fail, for faults.sh: LD_PRELOAD of a program. Calls are counted from the start of main().
//   FAULT_AT=n        the nth call fails
//   FAULT_LASTS=1     so do all after it
//   FAULT_KIND=k      EIO, ENOSPC, EDQUOT; or short: a write takes half of its bytes, and other calls are not counted
//   FAULT_TOLD=file   gets the name of each call that was made to fail
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static long at, told = -1;
static int lasts, error, running;
static long calls;

/// Whether this call is to fail.
static int fails(const char* name) {
  if (!running) return 0;
  const long n = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
  if (at == 0 || (lasts ? n < at : n != at)) return 0;
  syscall(SYS_write, told, name, strlen(name));
  syscall(SYS_write, told, "\n", 1);
  if (error != 0) errno = error;
  return 1;
}

// A function of the C library, by its result, name, parameters and arguments. Short writes leave all but writes alone.
#define FAILING(type, name, parameters, arguments)                                                                     \
  type name parameters {                                                                                               \
    static type(*next) parameters;                                                                                     \
    if (!next) next = (type(*) parameters)dlsym(RTLD_NEXT, #name);                                                     \
    if (error != 0 && fails(#name)) return -1;                                                                         \
    return next arguments;                                                                                             \
  }
#define FAILING_OPEN(name, first, names)                                                                               \
  int name(first const char* path, int flags, ...) {                                                                   \
    static int (*next)(first const char*, int, ...);                                                                   \
    if (!next) next = (int (*)(first const char*, int, ...))dlsym(RTLD_NEXT, #name);                                   \
    va_list rest;                                                                                                      \
    va_start(rest, flags);                                                                                             \
    const int mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, int) : 0;                                            \
    va_end(rest);                                                                                                      \
    if (error != 0 && fails(#name)) return -1;                                                                         \
    return next(names path, flags, mode);                                                                              \
  }
#define FAILING_WRITE(name, parameters, arguments, halved)                                                             \
  ssize_t name parameters {                                                                                            \
    static ssize_t(*next) parameters;                                                                                  \
    if (!next) next = (ssize_t(*) parameters)dlsym(RTLD_NEXT, #name);                                                  \
    if (!fails(#name)) return next arguments;                                                                          \
    return error != 0 ? -1 : next halved;                                                                              \
  }
#define COMMA ,
FAILING_OPEN(open, , )
FAILING_OPEN(open64, , )
FAILING_OPEN(openat, int folder COMMA, folder COMMA)
FAILING_OPEN(openat64, int folder COMMA, folder COMMA)
FAILING_WRITE(write, (int file, const void* bytes, size_t size), (file, bytes, size), (file, bytes, (size + 1) / 2))
FAILING_WRITE(pwrite, (int file, const void* bytes, size_t size, off_t where), (file, bytes, size, where),
              (file, bytes, (size + 1) / 2, where))
FAILING_WRITE(pwrite64, (int file, const void* bytes, size_t size, off64_t where), (file, bytes, size, where),
              (file, bytes, (size + 1) / 2, where))
FAILING_WRITE(writev, (int file, const struct iovec* parts, int n), (file, parts, n), (file, parts, (n + 1) / 2))
FAILING(ssize_t, read, (int file, void* bytes, size_t size), (file, bytes, size))
FAILING(ssize_t, pread, (int file, void* bytes, size_t size, off_t where), (file, bytes, size, where))
FAILING(ssize_t, pread64, (int file, void* bytes, size_t size, off64_t where), (file, bytes, size, where))
FAILING(int, mkstemp, (char* name), (name))
FAILING(int, mkstemp64, (char* name), (name))
FAILING(int, rename, (const char* from, const char* to), (from, to))
FAILING(int, fsync, (int file), (file))
FAILING(int, fdatasync, (int file), (file))
FAILING(int, ftruncate, (int file, off_t size), (file, size))
FAILING(int, ftruncate64, (int file, off64_t size), (file, size))
FAILING(int, fchmod, (int file, mode_t mode), (file, mode))
FAILING(int, mkdir, (const char* name, mode_t mode), (name, mode))
FAILING(int, unlink, (const char* name), (name))
FAILING(int, flock, (int file, int how), (file, how))

static int (*program_main)(int, char**, char**);
static int counted_main(int argc, char** argv, char** environment) {
  const char* kind = getenv("FAULT_KIND");
  error = !strcmp(kind, "EIO") ? EIO : !strcmp(kind, "ENOSPC") ? ENOSPC : !strcmp(kind, "EDQUOT") ? EDQUOT : 0;
  at = atol(getenv("FAULT_AT"));
  lasts = getenv("FAULT_LASTS") != NULL;
  told = syscall(SYS_openat, AT_FDCWD, getenv("FAULT_TOLD"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  running = 1;
  return program_main(argc, argv, environment);
}
int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void), void (*fini)(void),
                      void (*rtld_fini)(void), void* stack_end) {
  program_main = main;
  int (*next)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
  *(void**)&next = dlsym(RTLD_NEXT, "__libc_start_main");
  return next(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
