// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distance on a triangulation by the heat method.

#ifndef CSCD_GEODESIC_HEAT_METHOD_H
#define CSCD_GEODESIC_HEAT_METHOD_H

#include <CSCD/Geodesic/Geodesic_source.h>
#include <CSCD/Geodesic/Heat_batch.h>
#include <CSCD/Geodesic/Heat_field.h>
#include <CSCD/Geodesic/Heat_operators.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// Geodesic distance from any number of sources, on a triangulation given by its edge lengths: factored once, asked
/// often.
///
/// On Delaunay triangulations a distance is exact to a few tenths of an edge where the surface is smooth, and rounded
/// off over two or three edges on ridges, where shortest paths from different sides meet. Other triangulations should
/// be made Delaunay first. Distances of any number of edges are right (see `Heat_batch`). All members are const and may
/// be called by several threads at once, each with its own workspace.
class Heat_method
{
public:
  /// As many sets of sources are solved for at once.
  static constexpr std::size_t batch_size = 8;

  /// Working memory, 200 bytes a vertex where batches are solved, reused from call to call.
  class Workspace
  {
    friend class Heat_method;
    Heat_batch<1> m_single;
    Heat_batch<batch_size> m_batch;
  };

  /// Factors the equations of `triangulation`, which is not referred to later; O(n^1.5), and usually nearly linear.
  /// \tparam Triangulation see `Cotangent_elements`
  /// \param time_step_factor the duration of the heat flow, in squared mean edge lengths of the component: more is
  ///        smoother and less exact
  /// \pre `time_step_factor` is positive
  /// \throw Input_error if the equations cannot be factored
  template <class Triangulation>
  explicit Heat_method(const Triangulation& triangulation, double time_step_factor = 1)
      : m_operators(triangulation, time_step_factor)
  {
    CGAL_precondition(time_step_factor > 0);
  }

  /// Computes the distance from the nearest one of `sources`; near linear in the number of vertices.
  void operator()(const std::vector<Geodesic_source>& sources, Heat_field& field, Workspace& workspace,
                  Heat_field_parts parts = {}) const
  {
    workspace.m_single(m_operators, {&sources}, {&field}, parts);
  }

  /// Computes the distances from each of `source_sets` by itself, eight at a time, in about a third of the time.
  /// They are the same as one by one, bit for bit unless the compiler fuses multiplications and additions as it likes.
  void operator()(const std::vector<std::vector<Geodesic_source>>& source_sets, std::vector<Heat_field>& fields,
                  Workspace& workspace, Heat_field_parts parts = {}) const
  {
    fields.resize(source_sets.size());
    for (std::size_t begin = 0; begin < source_sets.size(); begin += batch_size) {
      const std::size_t size = std::min(batch_size, source_sets.size() - begin);
      if (size < least_batch) {
        for (std::size_t i = begin; i < begin + size; ++i) {
          (*this)(source_sets[i], fields[i], workspace, parts);
        }
        continue;
      }
      std::array<const std::vector<Geodesic_source>*, batch_size> batch_sets{};
      std::array<Heat_field*, batch_size> batch_fields{};
      for (std::size_t lane = 0; lane < batch_size; ++lane) {
        // Lanes to spare repeat the last set.
        const std::size_t i = begin + std::min(lane, size - 1);
        batch_sets[lane] = &source_sets[i];
        batch_fields[lane] = &fields[i];
      }
      workspace.m_batch(m_operators, batch_sets, batch_fields, parts);
    }
  }

  const Heat_operators& operators() const { return m_operators; }

private:
  /// From this number of sets on, a batch takes less time than one by one.
  static constexpr std::size_t least_batch = 3;

  Heat_operators m_operators;
};

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_HEAT_METHOD_H
