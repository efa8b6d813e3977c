// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances in flat arrays, on a surface or on points: prepared once, estimated from many sources.

#ifndef CSCD_PUBLISHED_PREPARED_DISTANCES_H
#define CSCD_PUBLISHED_PREPARED_DISTANCES_H

#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace CSCD::internal {

struct Heat_method;

/// Where distance is measured from: a vertex, or else a point of a face, by barycentric coordinates.
struct Distance_source
{
  Index vertex = no_index;
  Index face = no_index;
  std::array<double, 3> coordinates{};
};

/// Estimates distances by the heat method on an intrinsic Delaunay triangulation. Copies share the preparation; const
/// and thread safe.
class Prepared_distances
{
public:
  /// Takes the distance of every vertex.
  using Use = std::function<void(const std::vector<double>&)>;

  /// Prepares a triangulated surface, perhaps with borders; O(n^1.5), and usually nearly linear.
  /// \param pairing that of the faces of `triangles`, which are a manifold
  /// \param time_step_factor see `Heat_method`
  /// \throw Input_error if the triangles are too uneven to be computed with
  Prepared_distances(Indexed_triangles&& triangles, Halfedge_pairing&& pairing, double time_step_factor);

  /// Prepares points, on the tufted cover of their complex; else as above.
  /// \throw Input_error if the points do not sample a surface
  Prepared_distances(const Point_cloud& cloud, double time_step_factor);

  /// Estimates the distance of every vertex, or point of the cloud, from the nearest source of each set by itself, and
  /// calls `use` set by set. Distances near a source may be a little below 0.
  void estimate_each(const std::vector<std::vector<Distance_source>>& source_sets, const Use& use) const;

private:
  std::shared_ptr<const Triangulated_surface> m_surface; // none for points
  std::shared_ptr<const Heat_method> m_method;
};

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Published/Prepared_distances_impl.h>
#endif

#endif // CSCD_PUBLISHED_PREPARED_DISTANCES_H
