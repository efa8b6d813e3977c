// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A checked and prepared mesh: the body that it bounds, and the input vertices of each vertex of its surface.

#ifndef CSCD_SURFACE_PREPARED_MESH_H
#define CSCD_SURFACE_PREPARED_MESH_H

#include <CSCD/Options.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>

#include <CGAL/Iterator_range.h>

#include <chrono>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The body that a mesh bounds, and the numbers by which the input calls its vertices.
class Prepared_mesh
{
public:
  /// Prepares the triangles that `check()`, a function without arguments, returns as `Checked_triangles`; near linear.
  /// \param treatment which borders are bridged, and which are rims of sheets
  /// \param number_of_threads 0 for as many as TBB allows; the surface is the same for any number
  template <class Check>
  Prepared_mesh(const Check& check, Border_treatment treatment, unsigned number_of_threads)
      : m_start(Clock::now()), m_checked(check()),
        m_solid(std::move(m_checked.triangles), std::move(m_checked.pairing), treatment, number_of_threads)
  {
    if (m_solid.number_of_cavities() > 0) {
      sort_input_vertices();
    }
    m_seconds = std::chrono::duration<double>(Clock::now() - m_start).count();
  }

  /// The body.
  const Triangulated_solid& solid() const { return m_solid; }
  /// The numbers of the input vertices that belong to `vertex`: its own, unless it was inserted, and the numbers of the
  /// vertices of cavities to which it is the nearest.
  CGAL::Iterator_range<const Index*> input_vertices(Index vertex) const
  {
    if (m_solid.number_of_cavities() > 0) {
      return m_rows[vertex];
    }
    const Index point = m_solid.input_vertex(vertex);
    const Index* first = m_checked.input_number.data() + (point == no_index ? 0 : point);
    return {first, point == no_index ? first : first + 1};
  }
  /// Writes what is known of the input to `report`.
  void describe(Skeletonization_report& report) const
  {
    report.number_of_input_vertices = m_checked.input_number.size();
    report.number_of_isolated_vertices = m_checked.number_of_isolated_vertices;
    report.seconds[std::size_t(Skeletonization_stage::compile_surface)] = m_seconds;
    m_solid.describe(report);
    m_solid.warn(report);
  }

private:
  using Clock = std::chrono::steady_clock;

  /// Sorts the input vertices by the vertices of the surface to which they belong.
  void sort_input_vertices()
  {
    const Index n = m_solid.triangulation().number_of_vertices();
    m_rows = Compressed_rows<Index>(n, [&](const auto& add) {
      for (Index vertex = 0; vertex < n; ++vertex) {
        if (m_solid.input_vertex(vertex) != no_index) {
          add(vertex, m_checked.input_number[m_solid.input_vertex(vertex)]);
        }
      }
      for (const auto& [vertex, point] : m_solid.cavity_vertices()) {
        add(vertex, m_checked.input_number[point]);
      }
    });
  }

  Clock::time_point m_start;
  Checked_triangles m_checked; ///< without triangles and pairing, once the body has them
  Triangulated_solid m_solid;
  Compressed_rows<Index> m_rows; ///< input vertices by vertices of the surface, where there are cavities
  double m_seconds = 0;
};

} // namespace CSCD::internal

#endif // CSCD_SURFACE_PREPARED_MESH_H
