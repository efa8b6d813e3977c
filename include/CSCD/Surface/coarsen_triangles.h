// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes triangles fewer before they are compiled, so that surfaces of more vertices than memory can be skeletonized.

#ifndef CSCD_SURFACE_COARSEN_TRIANGLES_H
#define CSCD_SURFACE_COARSEN_TRIANGLES_H

#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <cstddef>
#include <vector>

namespace CSCD {

/// How many vertices `coarsen_triangles()` compiles at a time; a block takes about 300 bytes for each.
inline constexpr std::size_t default_coarsening_block = 100000;

/// coarsens triangles until they have at most `max_number_of_points` points, by collapses of edges that keep the
/// topology, or until that is no longer possible.
///
/// Space is divided into blocks; the triangles of one are compiled, and nearly three quarters of their vertices are
/// collapsed into others; what touches another block stays. The next pass has other blocks. So the memory of a few
/// blocks, one for each thread, and six bytes for each point are enough beside the triangles. Points that remain keep
/// their places. Points on borders, where the triangles are no oriented manifold, and without a triangle all remain,
/// with the triangles there. Near linear.
///
/// \param points, corners the places, and the numbers of the corners of each triangle, one triangle after the other;
///        both become those of the coarse triangles, which have no order
/// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
/// \param block the greatest number of points of a block, about
/// \return for each point the number of the coarse one that it is or was collapsed into; empty if none was
/// \pre the numbers of corners are those of points
std::vector<Index> coarsen_triangles(std::vector<Vector_3>& points, std::vector<Index>& corners,
                                     std::size_t max_number_of_points, unsigned number_of_threads = 1,
                                     std::size_t block = default_coarsening_block);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Surface/coarsen_triangles_impl.h>
#endif

#endif // CSCD_SURFACE_COARSEN_TRIANGLES_H
