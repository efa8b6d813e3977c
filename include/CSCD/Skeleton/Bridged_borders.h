// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The borders of the input, which faces without area close, and the pieces of the cut surface that they lie in.

#ifndef CSCD_SKELETON_BRIDGED_BORDERS_H
#define CSCD_SKELETON_BRIDGED_BORDERS_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A closed curve of edges between faces of the surface and hole-filling faces.
struct Bridged_border
{
  Vector_3 centroid = Vector_3::Zero(); ///< by length
  Vector_3 normal = Vector_3::Zero();   ///< the direction in which the body is open: that of the area vector
  double length = 0;                    ///< of the curve
  double radius = 0;                    ///< mean distance of the curve from its centroid
  std::vector<Index> pieces;            ///< of the cut surface, that it passes, in ascending order
};

/// Finds the borders of a surface that were bridged.
class Bridged_border_search
{
public:
  Bridged_border_search(const Triangulated_surface& surface, const Cut_graph& cut_graph)
      : m_surface(surface), m_cut_graph(cut_graph)
  {
  }

  /// All borders, in the order of their first halfedges; linear in the number of hole-filling faces.
  std::vector<Bridged_border> operator()() const
  {
    std::vector<Bridged_border> result;
    const Index first = 3 * m_surface.first_hole_filling_face();
    std::vector<char> is_met(m_surface.number_of_halfedges() - first, 0);
    std::vector<Index> curve;
    for (Index start = first; start < m_surface.number_of_halfedges(); ++start) {
      curve.clear();
      for (Index h = start; is_on_border(h) && is_met[h - first] == 0; h = next_on_border(h)) {
        is_met[h - first] = 1;
        curve.push_back(h);
      }
      if (!curve.empty()) {
        result.push_back(measure(curve));
      }
    }
    return result;
  }

private:
  bool is_hole_filling(Index h) const { return m_surface.is_hole_filling(Triangulated_surface::face(h)); }
  bool is_on_border(Index h) const { return is_hole_filling(h) && !is_hole_filling(m_surface.twin(h)); }

  /// The next halfedge of the curve, along the hole-filling faces around the target of `h`.
  Index next_on_border(Index h) const
  {
    h = Triangulated_surface::next(h);
    while (!is_on_border(h)) {
      h = Triangulated_surface::next(m_surface.twin(h));
    }
    return h;
  }

  Bridged_border measure(const std::vector<Index>& curve) const
  {
    Bridged_border border;
    std::vector<Vector_3> points;
    for (Index h : curve) {
      points.push_back(m_surface.point(m_surface.origin(h)));
      border.pieces.push_back(m_cut_graph.piece_of_vertex(m_surface.origin(h)));
    }
    std::sort(border.pieces.begin(), border.pieces.end());
    border.pieces.erase(std::unique(border.pieces.begin(), border.pieces.end()), border.pieces.end());
    const Polygon_measures measures = measure_polygon(points);
    border.centroid = measures.center;
    border.normal = measures.vector_area.normalized();
    border.length = measures.length;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector_3& next = points[i + 1 < points.size() ? i + 1 : 0];
      const double distance = ((points[i] - border.centroid).norm() + (next - border.centroid).norm()) / 2;
      border.radius += (next - points[i]).norm() / border.length * distance;
    }
    return border;
  }

  const Triangulated_surface& m_surface;
  const Cut_graph& m_cut_graph;
};

/// The borders of `surface` that were bridged, if any.
inline std::vector<Bridged_border> bridged_borders(const Triangulated_surface& surface, const Cut_graph& cut_graph)
{
  return Bridged_border_search(surface, cut_graph)();
}

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BRIDGED_BORDERS_H
