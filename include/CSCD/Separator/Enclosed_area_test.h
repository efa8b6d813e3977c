// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distinguishes loops around a limb from those that only encircle a bump.

#ifndef CSCD_SEPARATOR_ENCLOSED_AREA_TEST_H
#define CSCD_SEPARATOR_ENCLOSED_AREA_TEST_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Vertex_loop.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Epoch_marks.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// What an open separator has to cut off, on both sides of its sheet, relative to a closed one: by default, 0.19 of its
/// squared length. A corner at a right angle has 1 / 8, and is no limb; a half disc has pi / 16.
inline constexpr double open_area_factor = 1.9;

/// Measures how much surface a loop cuts off, relative to the square of its length.
/// A flat disc gives 1 / (4 pi) = 0.080, a hemisphere 1 / (2 pi) = 0.159, the end of a limb of length l and radius R
/// about (l / R + 1) / (2 pi). Work is bounded by the limit on the area, not by the surface. Reuse one object.
class Enclosed_area_test
{
public:
  explicit Enclosed_area_test(const Triangulated_surface& surface)
      : m_surface(surface), m_edges(surface.number_of_halfedges()), m_faces(surface.number_of_faces())
  {
  }

  /// The area on the smaller side of `loop` over the square of its length, or something above `limit` if it is larger;
  /// 0 if the loop has no length, or an edge that the surface has not.
  double area_ratio(const Vertex_loop& loop, double limit)
  {
    m_edges.clear();
    m_sides.clear();
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index h = m_surface.find_halfedge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
      if (h == no_index) {
        return 0;
      }
      m_edges.mark(m_surface.edge(h));
      m_sides.push_back(h);
      length += m_surface.length(h);
    }
    if (length == 0) {
      return 0;
    }
    const double left = flood([this](std::size_t i) { return m_sides[i]; }, limit * length * length);
    const double right = flood([this](std::size_t i) { return m_surface.twin(m_sides[i]); }, limit * length * length);
    return std::min(left, right) / (length * length);
  }

private:
  /// The area of the faces that can be reached from the faces of the halfedges `side(i)` without crossing the loop;
  /// stops above `limit`.
  template <class Side>
  double flood(const Side& side, double limit)
  {
    m_faces.clear();
    m_stack.clear();
    double area = 0;
    const auto visit = [&](Index face) {
      if (m_faces.mark(face)) {
        area += double(m_surface.face_area(face));
        m_stack.push_back(face);
      }
    };
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
      visit(Triangulated_surface::face(side(i)));
    }
    while (!m_stack.empty() && area < limit) {
      const Index face = m_stack.back();
      m_stack.pop_back();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (!m_edges.is_marked(m_surface.edge(h))) {
          visit(Triangulated_surface::face(m_surface.twin(h)));
        }
      }
    }
    return area;
  }

  const Triangulated_surface& m_surface;
  Epoch_marks m_edges;
  Epoch_marks m_faces;
  std::vector<Index> m_sides;
  std::vector<Index> m_stack;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_ENCLOSED_AREA_TEST_H
