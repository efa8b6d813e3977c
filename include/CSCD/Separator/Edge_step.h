// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves along the edges of a triangulation, step by step.

#ifndef CSCD_SEPARATOR_EDGE_STEP_H
#define CSCD_SEPARATOR_EDGE_STEP_H

#include <CSCD/internal/Vector_3.h>

#include <vector>

namespace CSCD::internal {

/// A step along an edge. The edge is named by a halfedge, since there may be several between two vertices.
struct Edge_step
{
  Index halfedge = no_index;
  /// Whether the step goes from the target of the halfedge to its origin: on a border there is no other halfedge.
  bool is_reversed = false;
};

/// Consecutive steps, each beginning where the one before ends.
using Edge_steps = std::vector<Edge_step>;

template <class Triangulation>
Index begin_of(const Triangulation& triangulation, const Edge_step& step)
{
  return step.is_reversed ? triangulation.target(step.halfedge) : triangulation.origin(step.halfedge);
}

template <class Triangulation>
Index end_of(const Triangulation& triangulation, const Edge_step& step)
{
  return step.is_reversed ? triangulation.origin(step.halfedge) : triangulation.target(step.halfedge);
}

/// The same step the other way: by the twin of its halfedge, if there is one.
template <class Triangulation>
Edge_step reversed(const Triangulation& triangulation, const Edge_step& step)
{
  const Index twin = triangulation.twin(step.halfedge);
  return twin != no_index ? Edge_step{twin, step.is_reversed} : Edge_step{step.halfedge, !step.is_reversed};
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_EDGE_STEP_H
