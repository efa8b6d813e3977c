// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve that is straight within the faces of a surface.

#ifndef CSCD_SEPARATOR_SURFACE_PATH_H
#define CSCD_SEPARATOR_SURFACE_PATH_H

#include <CSCD/Traits/Edge_crossing.h>

#include <vector>

namespace CSCD::internal {

/// A polygon over a surface, open or closed, which may pass through vertices and along edges.
struct Surface_path
{
  /// Where it crosses edges, see `Edge_crossing`, and the vertices that it passes through, in order. At a vertex,
  /// `position` is 0 and `halfedge` is from the vertex: the path leaves along it if the next point is a vertex too, and
  /// otherwise into its face. The last point of an open path is a vertex of which any halfedge is given.
  std::vector<Edge_crossing> points;
  bool is_closed = true;
  double length = 0;
};

/// Whether a point of a `Surface_path` is a vertex.
inline bool is_vertex(const Edge_crossing& point)
{
  return point.position == 0;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_SURFACE_PATH_H
