// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The message of the Input_error that a call throws.

#ifndef CSCD_TEST_SUPPORT_MESSAGE_OF_H
#define CSCD_TEST_SUPPORT_MESSAGE_OF_H

#include <CSCD/exceptions.h>

#include <string>

namespace CSCD::test {

/// Empty if `call` does not throw.
template <class Call>
std::string message_of(const Call& call)
{
  try {
    call();
  } catch (const Input_error& error) {
    return error.what();
  }
  return "";
}

/// Whether `message` begins with `beginning` and names a remedy after a colon.
inline bool names(const std::string& message, const std::string& beginning)
{
  return message.compare(0, beginning.size(), beginning) == 0 && message.find(": ") != std::string::npos;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_MESSAGE_OF_H
