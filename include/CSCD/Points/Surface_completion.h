// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From triangles with fragments, holes and false handles to a closed surface.

#ifndef CSCD_POINTS_SURFACE_COMPLETION_H
#define CSCD_POINTS_SURFACE_COMPLETION_H

#include <CSCD/Points/Fragment_joining.h>
#include <CSCD/Points/Handle_repair.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Gives every fan of faces around a vertex a vertex of its own: the first keeps it, the others get copies, which are
/// appended. Near linear.
/// \pre `pairing`, that of the faces, has no conflict; it is kept so
inline void split_pinched_vertices(Indexed_triangles& triangles, Halfedge_pairing& pairing)
{
  if (pairing.pinched_vertex() == no_index) {
    return;
  }
  Disjoint_sets fans(pairing.number_of_halfedges()); // of the halfedges that leave their vertices
  for (Index h = 0; h < fans.size(); ++h) {
    const Index next = pairing.twin(Halfedge_pairing::previous(h));
    if (next != no_index) {
      fans.join(h, next);
    }
  }
  std::vector<Index> vertex_of_fan(fans.size(), no_index);
  std::vector<char> has_fan(triangles.points.size(), 0);
  for (Index h = 0; h < fans.size(); ++h) {
    Index& corner = triangles.faces[h / 3][h % 3];
    Index& vertex = vertex_of_fan[fans.find(h)];
    if (vertex == no_index && std::exchange(has_fan[corner], 1) == 0) {
      vertex = corner;
    } else if (vertex == no_index) {
      vertex = Index(triangles.points.size());
      triangles.points.push_back(Vector3(triangles.points[corner]));
    }
    corner = vertex;
  }
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
}

/// The result of a reconstruction: a closed surface through points.
struct Reconstructed_surface
{
  Indexed_triangles triangles; ///< a closed manifold, looking outwards
  Halfedge_pairing pairing;    ///< of the triangles
  bool is_sheet = false;       ///< whether the triangles have borders instead, those of a sheet
  /// The point that a vertex is; `no_index` for inserted vertices and for second copies of points.
  std::vector<Index> point_of_vertex;
  Reconstruction_report report;
};

/// Closes the triangles between points. All changes are added to the report, in the coordinates of the input.
class Surface_completion
{
public:
  /// \param surface its triangles are turned outwards, no two have a side in the same direction, and their vertices are
  ///        the points; referred to
  /// \param normalization of the points
  Surface_completion(Reconstructed_surface& surface, const Normalization& normalization)
      : m_surface(surface), m_normalization(normalization)
  {
  }

  /// Splits vertices where several fans meet, counts border edges, and drops points without faces.
  void prepare()
  {
    m_surface.point_of_vertex = all_indices(m_surface.triangles.points.size());
    split_pinched_vertices();
    for (const std::size_t size : sizes_of_holes()) {
      m_surface.report.number_of_border_edges += size;
    }
    compact();
  }

  /// Joins fragments, closes holes, turns components outwards, and cuts false handles. \pre the triangles are prepared
  void operator()()
  {
    join_fragments();
    close();
    remove_false_handles();
  }

  /// Opens all holes again, but not gaps, if the closed surface encloses next to no volume: the points are those of a
  /// sheet, or of a body that is thinner than they are far apart. Near linear.
  void open_sheet(double spacing)
  {
    if (m_surface.report.number_of_holes == 0) {
      return;
    }
    Indexed_triangles& triangles = m_surface.triangles;
    const Surface_components components(triangles);
    double thickness_by_area = 0;
    for (const Surface_components::Measure& measure : components.measures) {
      thickness_by_area += 2 * measure.volume - max_thickness * spacing * measure.area;
    }
    m_surface.is_sheet = thickness_by_area < 0;
    if (!m_surface.is_sheet) {
      return;
    }
    const auto first_filling_face = Index(triangles.first_hole_filling_face);
    Disjoint_sets holes(triangles.faces.size());
    for (Index h = 3 * first_filling_face; h < m_surface.pairing.number_of_halfedges(); ++h) {
      if (m_surface.pairing.twin(h) >= 3 * first_filling_face) {
        holes.join(h / 3, m_surface.pairing.twin(h) / 3);
      }
    }
    std::vector<std::size_t> size_of_hole(triangles.faces.size(), 0);
    for (Index face = first_filling_face; face < triangles.faces.size(); ++face) {
      ++size_of_hole[holes.find(face)];
    }
    std::vector<std::array<Index, 3>> kept;
    for (Index face = 0; face < triangles.faces.size(); ++face) {
      if (size_of_hole[holes.find(face)] <= largest_gap) {
        kept.push_back(triangles.faces[face]);
      }
    }
    triangles.faces = std::move(kept);
    split_pinched_vertices();
    compact();
    m_surface.report.number_of_holes = 0;
  }

private:
  /// The thickness of a sheet, relative to the spacing, is at most this: of the clouds of 45 bodies it is 2.3 and more,
  /// of plates as thick as the spacing 0.06.
  static constexpr double max_thickness = 0.25;
  /// The most edges of a border that is a gap between random points rather than a hole.
  static constexpr std::size_t largest_gap = 7;

  /// The numbers of edges of the borders that are not gaps: of holes, and around fragments of a few faces.
  std::vector<std::size_t> sizes_of_holes() const
  {
    const Surface_components components(m_surface.triangles);
    std::vector<std::size_t> result;
    for (const std::vector<Index>& border : border_cycles(m_surface.triangles, m_surface.pairing)) {
      const std::size_t size = components.measures[components.component[border.front() / 3]].number_of_faces;
      if (border.size() > largest_gap || size <= 2 * largest_gap) {
        result.push_back(border.size());
      }
    }
    return result;
  }

  /// Removes vertices without faces, and pairs the halfedges again.
  void compact()
  {
    Indexed_triangles& triangles = m_surface.triangles;
    m_surface.point_of_vertex = reordered(m_surface.point_of_vertex, remove_unused_points(triangles));
    triangles.first_hole_filling_face = triangles.faces.size();
    pair();
  }

  void pair()
  {
    m_surface.pairing = Halfedge_pairing(m_surface.triangles.faces, m_surface.triangles.points.size());
    CGAL_assertion(m_surface.pairing.conflict() == no_index);
  }

  /// Pairs the halfedges. Copies of vertices are of no point.
  void split_pinched_vertices()
  {
    pair();
    internal::split_pinched_vertices(m_surface.triangles, m_surface.pairing);
    m_surface.point_of_vertex.resize(m_surface.triangles.points.size(), no_index);
  }

  void join_fragments()
  {
    Fragment_joining joining(m_surface.triangles, m_surface.pairing);
    for (const Joined_gap& gap : joining()) {
      m_surface.report.joined_gaps.push_back(repair(gap.center, gap.width));
    }
    compact();
  }

  Reconstruction_repair repair(const Vector3& center, double length) const
  {
    const Vector3 input = m_normalization.to_input(center);
    return {{input.x(), input.y(), input.z()}, length * m_normalization.unit};
  }

  /// Closes all holes. New vertices are of no point.
  void bridge()
  {
    bridge_borders(m_surface.triangles, m_surface.pairing);
    m_surface.point_of_vertex.resize(m_surface.triangles.points.size(), no_index);
    pair();
  }

  /// Closes all holes and orients the surface.
  void close()
  {
    m_surface.report.number_of_holes = sizes_of_holes().size();
    bridge();
    Surface_components components(m_surface.triangles);
    if (orient_outwards(m_surface.triangles, components) > 0) {
      pair();
    }
  }

  /// Cuts small handles, round by round: loops of one round have no vertex in common.
  void remove_false_handles()
  {
    Indexed_triangles& triangles = m_surface.triangles;
    for (;;) {
      const Surface_components components(triangles);
      if (genus_of_closed_surface(components.number(), triangles.points.size(), triangles.faces.size()) == 0) {
        return;
      }
      renumber_canonically(components);
      const Triangulated_surface whole{Indexed_triangles(triangles)};
      const std::vector<Vertex_loop> loops = Handle_repair(whole)();
      if (loops.empty()) {
        return;
      }
      for (const Vertex_loop& loop : loops) {
        Vector3 center = Vector3::Zero();
        for (const Index vertex : loop) {
          center += triangles.points[vertex] / double(loop.size());
        }
        m_surface.report.cut_handles.push_back(repair(center, loop_length(triangles.points, loop)));
      }
      cut_along_loops(triangles, whole, loops);
      pair();
      bridge();
    }
  }

  /// The cuts must not depend on the numbering.
  void renumber_canonically(const Surface_components& components)
  {
    const std::vector<Index> order = canonical_order(m_surface.triangles, m_surface.pairing, components);
    renumber(m_surface.triangles, order);
    pair();
    m_surface.point_of_vertex = reordered(m_surface.point_of_vertex, order);
  }

  Reconstructed_surface& m_surface;
  const Normalization m_normalization;
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_SURFACE_COMPLETION_H
