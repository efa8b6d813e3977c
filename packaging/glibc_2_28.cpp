// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lets the Python module run with glibc 2.28 and newer on x86_64. Linked with Debian's glibc 2.36, it would need newer
// versions of the functions below. They are defined here, hidden, and call the version of glibc 2.2.5.

#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

// CSCD_DEFINE(<result>, <name>, <parameters>) begins the definition of the function <name> of C.
#define CSCD_DEFINE(Result, name, parameters)                                                                          \
  extern "C" __attribute__((visibility("hidden"))) Result own_##name parameters __asm__(#name);                        \
  Result own_##name parameters
#define CSCD_OLD(Result, name, parameters)                                                                             \
  __asm__(".symver old_" #name "," #name "@GLIBC_2.2.5");                                                              \
  extern "C" Result old_##name parameters

// CSCD_FORWARD(<result>, <name>, <parameters>, <arguments>) defines a function by its old version.
#define CSCD_FORWARD(Result, name, parameters, arguments)                                                              \
  CSCD_OLD(Result, name, parameters);                                                                                  \
  CSCD_DEFINE(Result, name, parameters)                                                                                \
  {                                                                                                                    \
    return old_##name arguments;                                                                                       \
  }

// Of 2.29 and 2.35: without the wrapper that sets errno. Both versions return the same.
CSCD_FORWARD(double, exp, (double x), (x))
CSCD_FORWARD(double, log, (double x), (x))
CSCD_FORWARD(double, pow, (double x, double y), (x, y))
CSCD_FORWARD(double, hypot, (double x, double y), (x, y))

// Of 2.34, which took them over from the library of threads. Every process of Python has that.
CSCD_FORWARD(int, pthread_once, (pthread_once_t * control, void (*function)()), (control, function))
CSCD_FORWARD(int, pthread_key_create, (pthread_key_t * key, void (*destroy)(void*)), (key, destroy))
CSCD_FORWARD(int, pthread_key_delete, (pthread_key_t key), (key))
CSCD_FORWARD(void*, pthread_getspecific, (pthread_key_t key), (key))
CSCD_FORWARD(int, pthread_setspecific, (pthread_key_t key, const void* value), (key, value))
CSCD_FORWARD(int, pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock))
CSCD_FORWARD(int, pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock))
CSCD_FORWARD(int, pthread_rwlock_unlock, (pthread_rwlock_t * lock), (lock))

// Of 2.33: older versions pass the version of the structure.
constexpr int stat_version = 1;
CSCD_OLD(int, __xstat, (int, const char*, struct stat*));
CSCD_DEFINE(int, stat, (const char* path, struct stat* result))
{
  return old___xstat(stat_version, path, result);
}

CSCD_OLD(int, __lxstat, (int, const char*, struct stat*));
CSCD_DEFINE(int, lstat, (const char* path, struct stat* result))
{
  return old___lxstat(stat_version, path, result);
}

CSCD_OLD(int, __fxstat64, (int, int, struct stat64*));
CSCD_DEFINE(int, fstat64, (int file, struct stat64* result))
{
  return old___fxstat64(stat_version, file, result);
}

// Of 2.32: whether shared pointers may count without atomic operations.
extern "C" __attribute__((visibility("hidden"))) char own_single_threaded __asm__("__libc_single_threaded");
char own_single_threaded = 0;

// Of 2.36: random numbers from the kernel.
CSCD_DEFINE(unsigned int, arc4random, ())
{
  unsigned int number = 0;
  return getentropy(&number, sizeof number) == 0 ? number : 0;
}
