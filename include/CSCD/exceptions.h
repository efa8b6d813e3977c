// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exceptions that the library throws for data and for interrupted work.
// They do not depend on NDEBUG; contracts of the programmer are CGAL preconditions instead.

#ifndef CSCD_EXCEPTIONS_H
#define CSCD_EXCEPTIONS_H

#include <stdexcept>

namespace CSCD {

/// The input cannot be skeletonized. The message names the offending element and the remedy.
struct Input_error : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

/// The points do not sample the surface of a body. They may be a scan of trees or of other thin things.
struct Surface_error : Input_error
{
  using Input_error::Input_error;
};

/// A file cannot be read or written, or its content does not match its name. The message names the file and the place
/// in it.
struct File_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A visitor stopped the computation. Outputs are as they were before the call.
struct Cancelled_error : std::runtime_error
{
  Cancelled_error() : std::runtime_error("skeletonization cancelled by its visitor") {}
};

} // namespace CSCD

#endif // CSCD_EXCEPTIONS_H
