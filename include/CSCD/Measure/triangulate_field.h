// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface that a field of a skeleton describes, as triangles.

#ifndef CSCD_MEASURE_TRIANGULATE_FIELD_H
#define CSCD_MEASURE_TRIANGULATE_FIELD_H

#include <CSCD/Measure/Isosurface_tracker.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/sample_edges.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/internal/Vector_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A triangulated field.
struct Field_surface
{
  Indexed_triangles triangles;                    ///< closed and oriented, or empty
  double cell_size = 0;                           ///< of the lattice
  double unresolved_fraction = undefined_measure; ///< of the skeleton's length: no lattice point beside it is inside
};

/// With all that is built on so many cells, a gigabyte.
inline constexpr std::size_t default_maximum_number_of_cells = std::size_t(1) << 20;

/// Triangulates the zero set of `field` on a lattice, seeded along `skeleton`.
/// Where that takes more cells than allowed, since radii are huge, the lattice is made coarser.
/// \param cell_size of the lattice, positive
template <class Field>
Field_surface triangulate_field(const Field& field, const Indexed_skeleton& skeleton, double cell_size,
                                std::size_t maximum_number_of_cells = default_maximum_number_of_cells)
{
  for (;; cell_size *= 2) {
    Isosurface_tracker<Field> tracker(field, cell_size, maximum_number_of_cells);
    const std::vector<Edge_sample> samples = sample_edges(skeleton, cell_size);
    std::size_t number_unresolved = 0;
    for (const Edge_sample& sample : samples) {
      Eigen::Index axis = 0;
      sample.tangent.cwiseAbs().minCoeff(&axis);
      number_unresolved += tracker.track_around(sample.point, int(axis)) ? 0 : 1;
    }
    for (const Vector_3& point : skeleton.points) { // nodes without edges, and edges shorter than a cell
      tracker.track_around(point, 0);
    }
    if (!tracker.is_too_large()) {
      const double fraction = samples.empty() ? undefined_measure : double(number_unresolved) / double(samples.size());
      return {tracker.release(), cell_size, fraction};
    }
  }
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_TRIANGULATE_FIELD_H
