// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the components that are sheets, and makes thin bodies of them.

#ifndef CSCD_SURFACE_DOUBLE_SHEETS_H
#define CSCD_SURFACE_DOUBLE_SHEETS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Sums over faces are rounded to multiples of its inverse, so that they are the same for any order of the faces. A
/// conversion to single precision and back would do, but g++ 12 leaves it out where it computes several numbers at
/// once.
inline constexpr double sum_precision = 1 << 24;

/// A closed curve of edges with faces on one side only.
struct Border_cycle
{
  std::vector<Index> halfedges; ///< in order against their direction
  double length = 0;
  bool is_wide = true; ///< whether open separators end there
  bool is_rim = false; ///< whether it is the longest one of a flat component
};

/// Finds the wide borders of a surface and the components that are sheets.
///
/// Fronts start from borders. Where two of them meet from opposite directions, they determine the sides of a loop that
/// crosses a border or two: a path over the surface from border to border, and the chord between its ends in space. A
/// border that is long compared with the loops across it is not the end of a limb, which loops along the border
/// surround.
class Sheet_search
{
public:
  Sheet_search(const Indexed_triangles& triangles, const Halfedge_pairing& pairing)
      : m_triangles(triangles), m_pairing(pairing),
        m_components(sets_of_vertices(triangles.faces, triangles.points.size())),
        m_border_of_vertex(triangles.points.size(), no_index), m_position(triangles.points.size(), 0),
        m_is_sheet(triangles.points.size(), 0), m_width(triangles.points.size(), 0)
  {
    collect_borders();
  }

  /// Treats all borders as wide, and all components with a border as sheets.
  void take_all()
  {
    for (const Border_cycle& border : m_borders) {
      m_is_sheet[component(origin(border.halfedges.front()))] = 1;
    }
    find_meetings();
  }

  /// Chooses sheets by their shape; O(n log n).
  void choose()
  {
    mark_rims();
    find_meetings();
    choose_wide();
    if (std::none_of(m_borders.begin(), m_borders.end(), [](const Border_cycle& border) { return border.is_wide; })) {
      return;
    }
    // Small holes stop fronts early, and do not count.
    find_meetings();
    choose_wide();
    std::vector<double> area(m_triangles.points.size(), 0);
    std::vector<double> wide_area(m_triangles.points.size(), 0);
    for (const std::array<Index, 3>& face : m_triangles.faces) {
      const double third = triangle_area(point(face[0]), point(face[1]), point(face[2])) / 3;
      for (const Index vertex : face) {
        area[component(vertex)] += third;
        wide_area[component(vertex)] += is_near_wide_border(vertex) ? third : 0.;
      }
    }
    for (Index c = 0; c < area.size(); ++c) {
      m_is_sheet[c] = wide_area[c] > 0 && wide_area[c] >= min_wide_share * area[c] ? 1 : 0;
    }
    for (const Border_cycle& border : m_borders) {
      m_is_sheet[component(origin(border.halfedges.front()))] |= char(border.is_rim);
    }
  }

  const std::vector<Border_cycle>& borders() const { return m_borders; }
  /// The vertex that stands for the component of `vertex`.
  Index component(Index vertex) { return m_components.find(vertex); }
  bool is_sheet(Index vertex) { return m_is_sheet[component(vertex)] != 0; }
  /// The width of the component of `vertex`.
  double width(Index vertex) { return m_width[component(vertex)]; }

private:
  /// A border is wide if it is this long, relative to the loops across it: a flat disc has 1.57, a hemisphere 1.22, a
  /// square 2; a tube, open at both ends and of three radii, 1.05.
  static constexpr double min_border_length = 1.5;
  /// A component is flat if the sum of the area vectors of its faces is at least as long as this share of its area, as
  /// of a cap of a sphere up to 25 degrees from its middle, ...
  static constexpr double min_flatness = 0.95;
  /// ... and the squared length of its border at most this, relative to its area: of a square 16. Fronts in a square
  /// meet at corners, nearly without a loop; in longer flat components, loops decide.
  static constexpr double max_squared_length = 20;
  /// A component is a sheet if it is flat, or this share of its area is as near to wide borders ...
  static constexpr double min_wide_share = 0.75;
  /// ... as this, relative to half of the largest width of loops across them.
  static constexpr double max_distance = 1.25;
  /// Fronts meet from opposite directions if the cosine of the angle between these is at most that of 2 pi / 3.
  static constexpr double max_cosine = -0.5;
  /// Meetings on the fronts of a border count if they are this wide, relative to the widest: many are made at corners
  /// of borders, and by single faces in them.
  static constexpr double min_relative_width = 0.5;
  /// This share of the loops across a border is at most as long as the one that stands for them: where a limb is slit
  /// along a part of its length, the rest decides.
  static constexpr double decisive_share = 0.75;

  static constexpr double no_loop = std::numeric_limits<double>::infinity();

  /// Where fronts meet.
  struct Meeting
  {
    double width; ///< from border to border along the surface
    double loop;  ///< this and the chord; `no_loop` where that crosses no border
  };

  Index origin(Index h) const { return m_triangles.origin(h); }
  Index target(Index h) const { return m_triangles.target(h); }
  const Vector3& point(Index vertex) const { return m_triangles.points[vertex]; }
  double length(Index h) const { return (point(target(h)) - point(origin(h))).norm(); }

  void collect_borders()
  {
    for (std::vector<Index>& halfedges : border_cycles(m_triangles, m_pairing)) {
      Border_cycle border;
      for (const Index h : halfedges) {
        m_border_of_vertex[target(h)] = Index(m_borders.size());
        m_position[target(h)] = border.length;
        border.length += length(h);
      }
      border.halfedges = std::move(halfedges);
      m_borders.push_back(std::move(border));
    }
  }

  /// Finds the longest border of each flat component.
  void mark_rims()
  {
    std::vector<double> area(m_triangles.points.size(), 0);
    std::vector<Vector3> vector(m_triangles.points.size(), Vector3::Zero());
    for (const auto& [a, b, c] : m_triangles.faces) {
      area[component(a)] += triangle_area(point(a), point(b), point(c));
      vector[component(a)] += triangle_vector(point(a), point(b), point(c)) / 2;
    }
    std::vector<Border_cycle*> longest(m_triangles.points.size(), nullptr);
    for (Border_cycle& border : m_borders) {
      Border_cycle*& other = longest[component(origin(border.halfedges.front()))];
      other = other == nullptr || border.length > other->length ? &border : other;
    }
    for (Index c = 0; c < longest.size(); ++c) {
      if (longest[c] != nullptr) {
        longest[c]->is_rim = vector[c].norm() >= min_flatness * area[c] &&
                             longest[c]->length * longest[c]->length <= max_squared_length * area[c];
      }
    }
  }

  /// Keeps wide borders that are also wide by the loops across them.
  void choose_wide()
  {
    for (Index i = 0; i < m_borders.size(); ++i) {
      m_borders[i].is_wide = m_borders[i].is_rim || (m_borders[i].is_wide && m_loop_length[i] > 0 &&
                                                     m_borders[i].length >= min_border_length * m_loop_length[i]);
    }
  }

  bool is_near_wide_border(Index vertex) const
  {
    const Index start = m_front.label(vertex);
    return start != no_index && m_borders[m_border_of_vertex[start]].is_wide &&
           2 * double(m_front.distance(vertex)) <= max_distance * m_max_width[m_border_of_vertex[start]];
  }

  /// Lets fronts go from all wide borders, and measures the loops where they meet.
  void find_meetings()
  {
    m_front = Multi_source_dijkstra_search(m_triangles.points.size());
    m_before.assign(m_triangles.points.size(), no_index);
    spread();
    std::vector<std::vector<Meeting>> meetings(m_borders.size());
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      const Index a = m_front.label(origin(h));
      const Index b = m_front.label(target(h));
      if (m_pairing.twin(h) == no_index || m_pairing.twin(h) < h || a == b || a == no_index || b == no_index ||
          !is_opposite(origin(h), target(h))) {
        continue;
      }
      const double width = double(m_front.distance(origin(h))) + length(h) + double(m_front.distance(target(h)));
      const bool is_across = distance_along_border(a, b) >= width;
      const Meeting meeting{width, is_across ? width + (point(a) - point(b)).norm() : no_loop};
      meetings[m_border_of_vertex[a]].push_back(meeting);
      if (m_border_of_vertex[b] != m_border_of_vertex[a]) {
        meetings[m_border_of_vertex[b]].push_back(meeting);
      }
    }
    measure(meetings);
    measure_widths();
  }

  void spread()
  {
    const Compressed_rows<Index> neighbors(m_triangles.points.size(), [this](const auto& add) {
      for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
        add(origin(h), target(h));
        if (m_pairing.twin(h) == no_index) {
          add(target(h), origin(h));
        }
      }
    });
    const auto edge_length = [this](Index a, Index b) { return float((point(a) - point(b)).norm()); };
    for (Index vertex = 0; vertex < m_border_of_vertex.size(); ++vertex) {
      if (m_border_of_vertex[vertex] != no_index && m_borders[m_border_of_vertex[vertex]].is_wide) {
        m_front.reach(vertex, 0, vertex);
      }
    }
    m_front.spread([&](Index vertex, const auto& visit) {
      for (const Index neighbor : neighbors[vertex]) {
        visit(neighbor, edge_length(vertex, neighbor));
      }
    });
    for (Index vertex = 0; vertex < m_before.size(); ++vertex) {
      for (const Index neighbor : neighbors[vertex]) {
        if (m_front.label(neighbor) == m_front.label(vertex) &&
            m_front.distance(neighbor) + edge_length(neighbor, vertex) == m_front.distance(vertex) &&
            m_front.distance(neighbor) < m_front.distance(vertex)) {
          m_before[vertex] = neighbor;
        }
      }
    }
  }

  /// The length of the shorter part of a border between two of its vertices; infinite between two borders. Around a
  /// limb far from a border, fronts meet from opposite directions, too, but they come from one part of the border, and
  /// the loop surrounds the limb.
  double distance_along_border(Index a, Index b) const
  {
    if (m_border_of_vertex[a] != m_border_of_vertex[b]) {
      return std::numeric_limits<double>::infinity();
    }
    const double distance = std::abs(m_position[a] - m_position[b]);
    return std::min(distance, m_borders[m_border_of_vertex[a]].length - distance);
  }

  /// Whether the fronts that have come to the neighbors `a` and `b` met there from opposite directions.
  bool is_opposite(Index a, Index b) const
  {
    if (m_before[a] == no_index && m_before[b] == no_index) {
      return true;
    }
    return way_back(a, b).dot(way_back(b, a)) <= max_cosine;
  }

  /// The direction from `vertex` back along the last quarter of the path of the front that came there; on a border, the
  /// direction from its `neighbor`. The direction of the first edge of the path alone scatters too much.
  Vector3 way_back(Index vertex, Index neighbor) const
  {
    if (m_before[vertex] == no_index) {
      return (point(vertex) - point(neighbor)).normalized();
    }
    Index at = m_before[vertex];
    while (m_before[at] != no_index && 4 * m_front.distance(at) > 3 * m_front.distance(vertex)) {
      at = m_before[at];
    }
    return (point(at) - point(vertex)).normalized();
  }

  /// Finds the length of the loops across each border.
  void measure(std::vector<std::vector<Meeting>>& meetings)
  {
    m_loop_length.assign(m_borders.size(), 0);
    m_max_width.assign(m_borders.size(), 0);
    for (Index i = 0; i < m_borders.size(); ++i) {
      double max_width = 0;
      for (const Meeting& meeting : meetings[i]) {
        max_width = std::max(max_width, meeting.width);
        if (meeting.loop < no_loop) {
          m_max_width[i] = std::max(m_max_width[i], meeting.width);
        }
      }
      std::vector<double> loops;
      loops.reserve(meetings[i].size());
      for (const Meeting& meeting : meetings[i]) {
        if (meeting.width >= min_relative_width * max_width) {
          loops.push_back(meeting.loop);
        }
      }
      if (!loops.empty()) {
        const auto decisive = loops.begin() + std::ptrdiff_t(decisive_share * double(loops.size()));
        std::nth_element(loops.begin(), decisive, loops.end());
        m_loop_length[i] = *decisive;
      }
    }
  }

  /// The width of components is twice the largest distance from their borders, which does not depend on the order of
  /// vertices as meetings do; of a ribbon, whose vertices are all on borders, twice its area over their length.
  void measure_widths()
  {
    for (Index vertex = 0; vertex < m_width.size(); ++vertex) {
      if (m_front.label(vertex) != no_index) {
        m_width[component(vertex)] = std::max(m_width[component(vertex)], 2 * double(m_front.distance(vertex)));
      }
    }
    std::vector<double> area(m_width.size(), 0);
    std::vector<double> length(m_width.size(), 0);
    for (const std::array<Index, 3>& face : m_triangles.faces) {
      area[component(face[0])] += triangle_area(point(face[0]), point(face[1]), point(face[2]));
    }
    for (const Border_cycle& border : m_borders) {
      length[component(origin(border.halfedges.front()))] += border.length;
    }
    for (Index c = 0; c < m_width.size(); ++c) {
      if (m_width[c] == 0 && length[c] > 0) {
        int exponent = 0;
        const double fraction = std::frexp(2 * area[c] / length[c], &exponent);
        m_width[c] = std::ldexp(std::round(fraction * sum_precision) / sum_precision, exponent);
      }
    }
  }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  Disjoint_sets m_components; ///< of vertices
  std::vector<Border_cycle> m_borders;
  std::vector<Index> m_border_of_vertex;
  std::vector<double> m_position;          ///< of each vertex of a border, along it
  Multi_source_dijkstra_search m_front{0}; ///< labels are the vertices of borders where it started
  std::vector<Index> m_before;             ///< the vertex that the front came from
  std::vector<double> m_loop_length;       ///< of each border, across it; 0 unless fronts have met
  std::vector<double> m_max_width;         ///< of each border, along the surface to the other end of a loop across it
  std::vector<char> m_is_sheet;            ///< of each vertex that stands for a component
  std::vector<double> m_width;             ///< likewise
};

/// The result of `double_sheets()`.
struct Doubled_sheets
{
  std::vector<signed char> side; ///< of each vertex, 1 or 2; 0 on components that are not sheets; empty without sheets
  std::size_t number_of_sheets = 0;
  std::size_t number_of_wide_borders = 0;
  std::size_t number_of_copied_borders = 0; ///< narrow borders of sheets: each side has a copy now
};

/// Gives each sheet two sides, at a small distance, joined by a rim along its wide borders. Copies of vertices and
/// faces come after the originals, which are the first side. O(n log n).
/// \param takes_all whether all components with borders are sheets, or only components with the shape of one
/// \pre `pairing` is that of the faces of `triangles`; none of them fills a hole
inline Doubled_sheets double_sheets(Indexed_triangles& triangles, const Halfedge_pairing& pairing, bool takes_all)
{
  // Half of the thickness, relative to the width: well below the precision of nodes, yet coarse levels of detail keep
  // the two sides apart.
  constexpr double relative_offset = 0.015;
  // Both sides of a flat sheet would be mirror images, and which of them comes first a matter of rounding.
  constexpr double offset_of_second_side = 1 - 1e-3;
  Doubled_sheets result;
  Sheet_search search(triangles, pairing);
  if (takes_all) {
    search.take_all();
  } else {
    search.choose();
  }

  const std::size_t n = triangles.points.size();
  const std::size_t number_of_faces = triangles.faces.size();
  std::vector<Index> copy(n, no_index);
  for (Index vertex = 0; vertex < n; ++vertex) {
    if (search.is_sheet(vertex)) {
      result.number_of_sheets += search.component(vertex) == vertex ? 1 : 0;
      copy[vertex] = Index(triangles.points.size());
      triangles.points.push_back(triangles.points[vertex]);
    }
  }
  if (result.number_of_sheets == 0) {
    return result;
  }
  result.side.assign(triangles.points.size(), 2);
  std::vector<Vector3> normal(n, Vector3::Zero());
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    const auto [a, b, c] = triangles.faces[f];
    const Vector3 vector = triangle_vector(triangles.points[a], triangles.points[b], triangles.points[c]);
    for (const Index corner : {a, b, c}) {
      normal[corner] += vector;
    }
    if (copy[a] != no_index) {
      triangles.faces.push_back({copy[a], copy[c], copy[b]});
    }
  }
  for (Index vertex = 0; vertex < n; ++vertex) {
    result.side[vertex] = copy[vertex] == no_index ? 0 : 1;
    if (copy[vertex] != no_index && normal[vertex].norm() > 0) {
      const Vector3 direction = sum_precision * normal[vertex].normalized();
      const Vector3 rounded(std::round(direction.x()), std::round(direction.y()), std::round(direction.z()));
      const Vector3 offset = relative_offset * search.width(vertex) / sum_precision * rounded;
      triangles.points[vertex] += offset;
      triangles.points[copy[vertex]] -= offset_of_second_side * offset;
    }
  }
  for (const Border_cycle& border : search.borders()) {
    if (copy[triangles.origin(border.halfedges.front())] == no_index) {
      continue;
    }
    ++(border.is_wide ? result.number_of_wide_borders : result.number_of_copied_borders);
    for (std::size_t i = 0; border.is_wide && i < border.halfedges.size(); ++i) {
      const Index a = triangles.origin(border.halfedges[i]);
      const Index b = triangles.target(border.halfedges[i]);
      triangles.faces.push_back({b, a, copy[a]});
      triangles.faces.push_back({b, copy[a], copy[b]});
    }
  }
  triangles.first_hole_filling_face = triangles.faces.size();
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_DOUBLE_SHEETS_H
