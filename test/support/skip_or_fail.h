// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The behavior of tests if their data is not installed.

#ifndef CSCD_TEST_SUPPORT_SKIP_OR_FAIL_H
#define CSCD_TEST_SUPPORT_SKIP_OR_FAIL_H

#include <gtest/gtest.h>

#include <cstdlib>

namespace CSCD::test {

/// Whether the environment variable CI is set: continuous integration installs everything, so that nothing is skipped.
inline bool is_continuous_integration()
{
  const char* value = std::getenv("CI");
  return value != nullptr && *value != '\0';
}

} // namespace CSCD::test

/// Ends the test, which is skipped or, in continuous integration, fails.
/// \param message names the missing file or library and its package
#define CSCD_TEST_SKIP_OR_FAIL(message)                                                                                \
  do {                                                                                                                 \
    if (CSCD::test::is_continuous_integration()) {                                                                     \
      FAIL() << message;                                                                                               \
    }                                                                                                                  \
    GTEST_SKIP() << message;                                                                                           \
  } while (false)

#endif // CSCD_TEST_SUPPORT_SKIP_OR_FAIL_H
