// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lets the Python module run with glibc 2.28 and newer on x86_64. Linked with Debian's glibc 2.36, it would need newer
// versions of the functions below. They are defined here, hidden, and call the version of glibc 2.2.5.

#include <sys/stat.h>
#include <unistd.h>

// CSCD_DEFINE(<result>, <name>, <parameters>) begins the definition of the function <name> of C.
#define CSCD_DEFINE(Result, name, parameters)                                                                          \
  extern "C" __attribute__((visibility("hidden"))) Result own_##name parameters __asm__(#name);                        \
  Result own_##name parameters
#define CSCD_OLD(Result, name, parameters)                                                                             \
  __asm__(".symver old_" #name "," #name "@GLIBC_2.2.5");                                                              \
  extern "C" Result old_##name parameters

// Of 2.29 and 2.35: without the wrapper that sets errno. Both versions return the same.
CSCD_OLD(double, exp, (double));
CSCD_DEFINE(double, exp, (double x))
{
  return old_exp(x);
}

CSCD_OLD(double, log, (double));
CSCD_DEFINE(double, log, (double x))
{
  return old_log(x);
}

CSCD_OLD(double, pow, (double, double));
CSCD_DEFINE(double, pow, (double x, double y))
{
  return old_pow(x, y);
}

CSCD_OLD(double, hypot, (double, double));
CSCD_DEFINE(double, hypot, (double x, double y))
{
  return old_hypot(x, y);
}

// Of 2.34, which took it over from the library of threads. Every process of Python has that.
CSCD_OLD(int, pthread_once, (int*, void (*)()));
CSCD_DEFINE(int, pthread_once, (int* control, void (*function)()))
{
  return old_pthread_once(control, function);
}

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
