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

#include <algorithm>
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

/// The greatest number of cells for a skeleton: what is built on a million of them takes a gigabyte; and the field is
/// evaluated about twice for each cell, each time over all edges, which should not take minutes.
inline std::size_t maximum_number_of_cells(const Indexed_skeleton& skeleton)
{
  constexpr std::size_t most_cells = std::size_t(1) << 20;
  constexpr std::size_t least_cells = std::size_t(1) << 12;
  constexpr std::size_t most_cells_times_edges = std::size_t(1) << 27;
  return std::clamp(most_cells_times_edges / (skeleton.edges.size() + 1), least_cells, most_cells);
}

/// Triangulates the zero set of `field` on a lattice, seeded along `skeleton`.
/// Where that takes more cells than allowed, since radii or the skeleton are huge, the lattice is made coarser.
/// \param cell_size of the lattice, positive
/// \param maximum_number the greatest number of cells
template <class Field>
Field_surface triangulate_field(const Field& field, const Indexed_skeleton& skeleton, double cell_size,
                                std::size_t maximum_number)
{
  for (;; cell_size *= 2) {
    Isosurface_tracker<Field> tracker(field, cell_size, maximum_number);
    const std::vector<Edge_sample> samples = sample_edges(skeleton, cell_size);
    std::size_t number_unresolved = 0;
    for (const Edge_sample& sample : samples) {
      if (tracker.is_too_large()) {
        break;
      }
      Eigen::Index axis = 0;
      sample.tangent.cwiseAbs().minCoeff(&axis);
      number_unresolved += tracker.track_around(sample.point, int(axis)) ? 0 : 1;
    }
    for (const Vector_3& point : skeleton.points) { // nodes without edges, and edges shorter than a cell
      if (!tracker.is_too_large()) {
        tracker.track_around(point, 0);
      }
    }
    if (!tracker.is_too_large()) {
      const double fraction = samples.empty() ? undefined_measure : double(number_unresolved) / double(samples.size());
      return {tracker.release(), cell_size, fraction};
    }
  }
}

/// The same with as many cells as the skeleton may have.
template <class Field>
Field_surface triangulate_field(const Field& field, const Indexed_skeleton& skeleton, double cell_size)
{
  return triangulate_field(field, skeleton, cell_size, maximum_number_of_cells(skeleton));
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_TRIANGULATE_FIELD_H
