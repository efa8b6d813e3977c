// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An order of vertices and cells of CGAL's triangulations that does not hang on where they lie in memory.

#ifndef CSCD_RECONSTRUCTION_TIME_STAMP_H
#define CSCD_RECONSTRUCTION_TIME_STAMP_H

#include <CGAL/tags.h>

#include <cstddef>

namespace CSCD::internal {

/// The number of a vertex or a cell in the order in which those of a triangulation were made. CGAL compares handles to
/// elements with such numbers by them, else by address.
class Time_stamp
{
public:
  // CGAL looks these names up.
  using Has_timestamp = CGAL::Tag_true;
  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(const std::size_t& time_stamp) { m_time_stamp = time_stamp; }

private:
  std::size_t m_time_stamp = std::size_t(-1); // not set yet, says CGAL
};

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_TIME_STAMP_H
