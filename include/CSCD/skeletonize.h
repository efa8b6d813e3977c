// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The door to the default engine: plain arrays in, a plain skeleton out.

#ifndef CSCD_SKELETONIZE_H
#define CSCD_SKELETONIZE_H

#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Vector3.h>

#include <array>
#include <utility>
#include <vector>

namespace CSCD {

/// Computes the curve skeleton of a triangle mesh. `extract_curve_skeleton()` does the same for meshes of any type.
/// Near linear.
/// \param points the positions of the vertices, in any unit; vertices without a face belong to no node
/// \param faces the vertices of each face, counted from 0, counterclockwise seen from outside, three different ones
/// \param options the options
/// \param visitor is informed of progress and may stop the work
/// \param skeleton is replaced; if the function throws, it is left as it was. `skeleton.vertices` holds positions in
///        `points`
/// \return counts, timings and warnings
/// \pre the corners of the faces are less than the number of points
/// \throw Input_error if the mesh cannot be skeletonized or an option is out of its range; the message names the
///        element and the remedy
/// \throw Cancelled_error if the visitor stops the work
Skeletonization_report skeletonize(std::vector<Vector3> points, std::vector<std::array<Index, 3>> faces,
                                   const Options& options, const Any_skeletonization_visitor& visitor,
                                   Skeleton& skeleton);

/// The same without a visitor.
inline Skeletonization_report skeletonize(std::vector<Vector3> points, std::vector<std::array<Index, 3>> faces,
                                          const Options& options, Skeleton& skeleton)
{
  Default_skeletonization_visitor visitor;
  return skeletonize(std::move(points), std::move(faces), options, Any_skeletonization_visitor(visitor), skeleton);
}

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/skeletonize_impl.h>
#endif

#endif // CSCD_SKELETONIZE_H
