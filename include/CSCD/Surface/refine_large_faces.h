// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits faces that are too large to sample the limbs of a surface.

#ifndef CSCD_SURFACE_REFINE_LARGE_FACES_H
#define CSCD_SURFACE_REFINE_LARGE_FACES_H

#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The square of the longest edge allowed where `size` vertices sample `area`. Relative to the square root of the area
/// of a vertex, an even triangulation has edges of 1.07: the factor keeps clear of uneven ones and of the halving of
/// edges.
inline double squared_edge(double area, double size)
{
  constexpr double edge_factor = 2.2; // relative to the square root of the area that a vertex has
  return area * edge_factor * edge_factor / size;
}

/// How many limbs each component has, by the curvature of its corners: the tip of a limb holds 2 pi, and so does one
/// side of a handle, twice. Linear.
inline std::vector<double> numbers_of_limbs(const Indexed_triangles& triangles, const Surface_components& components)
{
  // A cube's corners have pi / 2; rounded corners and noise have less, and a fin that is too thin for any number of
  // vertices has pi.
  constexpr double min_curvature = boost::math::double_constants::third_pi;
  constexpr double max_curvature = 0.9 * boost::math::double_constants::pi;
  std::vector<double> curvature(triangles.points.size(), boost::math::double_constants::two_pi);
  for (const std::array<Index, 3>& face : triangles.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3& a = triangles.points[face[i]];
      const Vector3 ab = triangles.points[face[(i + 1) % 3]] - a;
      const Vector3 ac = triangles.points[face[(i + 2) % 3]] - a;
      curvature[face[i]] -= std::atan2(ab.cross(ac).norm(), ab.dot(ac));
    }
  }
  std::vector<double> curvature_of_corners(components.number(), 0.);
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    for (const Index corner : triangles.faces[f]) {
      if (curvature[corner] >= min_curvature && curvature[corner] <= max_curvature) {
        curvature_of_corners[components.component[f]] += curvature[corner];
        curvature[corner] = 0; // counted
      }
    }
  }
  std::vector<double> result(components.number());
  for (Index i = 0; i < components.number(); ++i) {
    result[i] = std::max(curvature_of_corners[i] / boost::math::double_constants::two_pi -
                             2 * double(components.measures[i].genus()),
                         0.);
  }
  return result;
}

/// The normal of the common plane of the faces `a` `b` `c` and `b` `a` `d`, up to the rounding of files.
inline std::optional<Vector3> common_normal(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  constexpr double flatness = 1e-5; // relative to the square root of the larger area: thin bodies are not flat
  const Vector3 of_c = (b - a).cross(c - a);
  const Vector3 of_d = (a - b).cross(d - b);
  const bool is_c_larger = of_c.squaredNorm() > of_d.squaredNorm();
  const Vector3& larger = is_c_larger ? of_c : of_d;
  const Vector3 normal = larger.normalized();
  return std::abs(normal.dot((is_c_larger ? d : c) - a)) <= flatness * std::sqrt(larger.norm())
             ? std::optional<Vector3>(normal)
             : std::nullopt;
}

/// Of each face, whether it fills a hole.
inline std::vector<char> hole_filling_faces(const Indexed_triangles& triangles)
{
  std::vector<char> result(triangles.first_hole_filling_face, 0);
  result.resize(triangles.faces.size(), 1);
  return result;
}

/// Puts the faces where `is_hole_filling` is true behind all others, in `components`, too.
inline void put_hole_filling_faces_last(Indexed_triangles& triangles, Surface_components& components,
                                        const std::vector<char>& is_hole_filling)
{
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> component;
  for (const char is_last : {char(0), char(1)}) {
    for (std::size_t f = 0; f < is_hole_filling.size(); ++f) {
      if (is_hole_filling[f] == is_last) {
        faces.push_back(triangles.faces[f]);
        component.push_back(components.component[f]);
      }
    }
    triangles.first_hole_filling_face = is_last == 0 ? faces.size() : triangles.first_hole_filling_face;
  }
  triangles.faces = std::move(faces);
  components.component = std::move(component);
}

/// The bound of edges that are left as they are.
inline constexpr double no_bound = std::numeric_limits<double>::max();

/// Splits long edges at their midpoints, the longest first, except between hole-filling faces, and flips edges between
/// faces of one plane so that these are a Delaunay triangulation all the time: slivers, which fill facets of many
/// corners, then need few vertices.
class Face_refinement : private Triangle_halfedges
{
public:
  /// \param squared_bound the square of the longest allowed edge of each component
  Face_refinement(Indexed_triangles& triangles, Halfedge_pairing&& pairing, Surface_components& components,
                  const std::vector<double>& squared_bound)
      : m_triangles(triangles), m_components(components), m_squared_bound(squared_bound),
        m_is_hole_filling(hole_filling_faces(triangles)), m_rank(triangles.points.size())
  {
    const std::vector<Index> order = canonical_order(triangles, pairing, components);
    for (Index rank = 0; rank < order.size(); ++rank) {
      m_rank[order[rank]] = rank;
    }
    Compressed_rows<Index> outgoing;
    std::move(pairing).move_to(m_twin, outgoing);
    const auto leads_to_lower = [this](Index g, Index h) { return m_rank[target(g)] < m_rank[target(h)]; };
    for (const Index vertex : order) {
      const std::size_t begin = m_unchecked.size();
      std::copy_if(outgoing[vertex].begin(), outgoing[vertex].end(), std::back_inserter(m_unchecked),
                   [this](Index h) { return h == directed(h); });
      std::sort(m_unchecked.begin() + std::ptrdiff_t(begin), m_unchecked.end(), leads_to_lower);
    }
  }

  /// Inserts at most `max_number` vertices.
  void operator()(std::size_t max_number)
  {
    m_flips_left = max_flips_per_halfedge * (m_twin.size() + 6 * max_number);
    std::for_each(m_unchecked.begin(), m_unchecked.end(), [this](Index h) { push_if_long(h); });
    flip_edges();
    while (max_number > 0 && !m_long_edges.empty()) {
      const Long_edge edge = m_long_edges.top();
      m_long_edges.pop();
      if (edge.first == key(edge.second)) {
        split(directed(edge.second));
        flip_edges();
        --max_number;
      }
    }
    put_hole_filling_faces_last(m_triangles, m_components, m_is_hole_filling);
  }

private:
  /// The squared length, relative to the bound, in single precision, and a number from the ranks of the ends: equally
  /// long edges have an order that neither their numbers nor rounding decide.
  using Key = std::pair<float, std::uint32_t>;
  using Long_edge = std::pair<Key, Index>;

  /// Angles that differ less from the angles of a rectangle are not worth a flip: rounding would decide.
  static constexpr double min_sine = 1e-6;
  /// Bounds the work where faces that are nearly flat flip for ever.
  static constexpr std::size_t max_flips_per_halfedge = 8;

  Index& origin(Index h) { return m_triangles.faces[h / 3][h % 3]; }
  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next(h)); }
  const Vector3& point(Index h) const { return m_triangles.points[origin(h)]; }

  /// The halfedge of the edge of `h` that leads to the end of higher rank.
  Index directed(Index h) const { return m_rank[origin(h)] < m_rank[target(h)] ? h : m_twin[h]; }

  Vector3 midpoint(Index h) const { return (point(h) + point(next(h))) / 2; }
  Key key(Index h) const
  {
    const Index its = directed(h);
    return {float((point(h) - point(next(h))).squaredNorm() / m_squared_bound[m_components.component[h / 3]]),
            scattered(m_rank[origin(its)], m_rank[target(its)])};
  }
  void push_if_long(Index h)
  {
    const Key edge = key(h);
    const bool is_within_hole = m_is_hole_filling[h / 3] != 0 && m_is_hole_filling[m_twin[h] / 3] != 0;
    if (edge.first > 1 && !is_within_hole) {
      m_long_edges.emplace(edge, h);
    }
  }
  void pair(Index h, Index twin)
  {
    m_twin[h] = twin;
    m_twin[twin] = h;
  }

  /// Splits the edge of `h`, and the faces on both of its sides.
  void split(Index h)
  {
    const Index t = m_twin[h];
    const Index b = target(h);
    const Index c = origin(previous(h));
    const Index d = origin(previous(t));
    const Index after_h = m_twin[next(h)];
    const Index before_t = m_twin[previous(t)];
    const Index middle = Index(m_triangles.points.size());
    m_triangles.points.push_back(midpoint(h));
    m_rank.push_back(middle);
    const Index k = Index(m_twin.size());
    const Index l = k + 3;
    origin(next(h)) = middle;
    origin(t) = middle;
    m_triangles.faces.push_back({middle, b, c});
    m_triangles.faces.push_back({b, middle, d});
    m_components.component.resize(m_triangles.faces.size(), m_components.component[h / 3]);
    m_is_hole_filling.push_back(m_is_hole_filling[h / 3]);
    m_is_hole_filling.push_back(m_is_hole_filling[t / 3]);
    m_twin.resize(m_twin.size() + 6);
    pair(k, l);
    pair(k + 1, after_h);
    pair(k + 2, next(h));
    pair(l + 2, before_t);
    pair(l + 1, previous(t));
    for (const Index changed : {h, k, k + 1, k + 2, l + 1, l + 2}) {
      push_if_long(changed);
    }
    for (const Index opposite : {previous(h), k + 1, next(t), l + 2}) {
      m_unchecked.push_back(opposite);
    }
  }

  void flip_edges()
  {
    while (!m_unchecked.empty()) {
      const Index h = directed(m_unchecked.back());
      m_unchecked.pop_back();
      if (m_flips_left > 0 && m_components.measures[m_components.component[h / 3]].is_body() && is_to_be_flipped(h)) {
        flip(h);
        --m_flips_left;
      }
    }
  }

  /// Whether the faces at `h` lie in a plane and look to the same side, the angles opposite to it are together more
  /// than pi, and the other diagonal is not an edge yet.
  bool is_to_be_flipped(Index h) const
  {
    const Index t = m_twin[h];
    const Vector3& a = point(h);
    const Vector3& b = point(t);
    const Vector3& c = point(previous(h));
    const Vector3& d = point(previous(t));
    const Vector3 of_h = (b - a).cross(c - a);
    const Vector3 of_t = (a - b).cross(d - b);
    const double sine = of_h.norm() * (a - d).dot(b - d) + of_t.norm() * (a - c).dot(b - c);
    if (!(sine < -min_sine * (a - c).norm() * (b - c).norm() * (a - d).norm() * (b - d).norm())) {
      return false;
    }
    const std::optional<Vector3> normal = of_h.dot(of_t) < 0 ? std::nullopt : common_normal(a, b, c, d);
    return normal && (c - d).cross(a - d).dot(*normal) > 0 && (d - c).cross(b - c).dot(*normal) > 0 &&
           !has_edge(previous(h), previous(t));
  }

  /// Whether an edge joins the origins of `first` and `second`; goes around both at once, so that the smaller degree
  /// decides.
  bool has_edge(Index first, Index second) const
  {
    const Index first_origin = origin(first);
    const Index second_origin = origin(second);
    Index i = first;
    Index j = second;
    do {
      if (target(i) == second_origin || target(j) == first_origin) {
        return true;
      }
      i = m_twin[previous(i)];
      j = m_twin[previous(j)];
    } while (i != first && j != second);
    return false;
  }

  /// Replaces the edge of `h` by the other diagonal of its faces.
  void flip(Index h)
  {
    const Index t = m_twin[h];
    const Index a = origin(h);
    const Index b = origin(t);
    const Index c = origin(previous(h));
    const Index d = origin(previous(t));
    const Index bc = m_twin[next(h)];
    const Index ca = m_twin[previous(h)];
    const Index ad = m_twin[next(t)];
    const Index db = m_twin[previous(t)];
    origin(h) = d;
    origin(next(h)) = c;
    origin(previous(h)) = a;
    origin(t) = c;
    origin(next(t)) = d;
    origin(previous(t)) = b;
    pair(next(h), ca);
    pair(previous(h), ad);
    pair(next(t), db);
    pair(previous(t), bc);
    for (const Index changed : {h, next(h), previous(h), next(t), previous(t)}) {
      push_if_long(changed);
    }
    for (const Index around : {next(h), previous(h), next(t), previous(t)}) {
      m_unchecked.push_back(around);
    }
  }

  Indexed_triangles& m_triangles;
  Surface_components& m_components;
  const std::vector<double>& m_squared_bound;
  std::vector<char> m_is_hole_filling; ///< of every face
  std::vector<Index> m_rank;           ///< of every vertex: that in canonical order, or of insertion
  std::vector<Index> m_twin;
  std::priority_queue<Long_edge> m_long_edges;
  std::vector<Index> m_unchecked; ///< halfedges of edges that may have to be flipped
  std::size_t m_flips_left = 0;
};

/// Lowers the squares of the longest edges allowed, `squared_bound`, where components that are not open have many limbs
/// of a few long faces each, so that an even triangulation has about 64 vertices for a limb. Linear.
/// \return the number of limbs of all such components
inline double lower_bounds_for_limbs(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                     const Surface_components& components, std::vector<double>& squared_bound)
{
  constexpr double size_of_limb = 64; // vertices: a dozen rings and more
  constexpr double min_limbs = 16;    // with fewer, the area bounds the size of faces
  const auto has_long_faces = [](const Surface_components::Measure& measure) {
    return 2 * measure.number_of_long_faces >= measure.number_of_faces;
  };
  if (std::none_of(components.measures.begin(), components.measures.end(), has_long_faces)) {
    return 0;
  }
  const std::vector<double> limbs = numbers_of_limbs(triangles, components);
  std::vector<double> bound(components.number(), no_bound);
  for (Index i = 0; i < components.number(); ++i) {
    if (limbs[i] >= min_limbs && has_long_faces(components.measures[i]) && components.measures[i].is_body()) {
      bound[i] = squared_edge(components.measures[i].area, size_of_limb * limbs[i]);
    }
  }
  const auto point = [&](Index h) -> const Vector3& { return triangles.points[triangles.origin(h)]; };
  const auto is_flat = [&](Index h) {
    const Index twin = pairing.twin(h);
    return common_normal(point(h), point(twin), point(Halfedge_pairing::previous(h)),
                         point(Halfedge_pairing::previous(twin)))
        .has_value();
  };
  std::vector<std::size_t> number_of_long_sides(components.number(), 0);
  std::vector<std::size_t> number_of_flat_faces(components.number(), 0); // coplanar with an adjacent one
  for (Index f = 0; f < triangles.faces.size(); ++f) {
    const Index component = components.component[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const double squared_length = (point(Halfedge_pairing::next(h)) - point(h)).squaredNorm();
      number_of_long_sides[component] += squared_length > bound[component] ? 1 : 0;
    }
    number_of_flat_faces[component] += is_flat(3 * f) || is_flat(3 * f + 1) || is_flat(3 * f + 2) ? 1 : 0;
  }
  double number_of_limbs = 0;
  for (Index i = 0; i < components.number(); ++i) {
    // Where fewer sides of faces than a quarter are longer, limbs are sampled already. The corners of a noisy body, of
    // few flat faces, carry no information.
    const std::size_t number_of_faces = components.measures[i].number_of_faces;
    if (4 * number_of_long_sides[i] >= 3 * number_of_faces && 2 * number_of_flat_faces[i] >= number_of_faces) {
      squared_bound[i] = std::min(squared_bound[i], bound[i]);
      number_of_limbs += limbs[i];
    }
  }
  return number_of_limbs;
}

/// Splits the second face of every component of two faces at its center. A single triangle becomes such a component
/// when its border is bridged; refined as it is, it would get several edges between the same vertices. Linear.
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces, and are kept so
inline void split_two_face_components(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                      Surface_components& components)
{
  const auto has_two_faces = [](const Surface_components::Measure& measure) { return measure.number_of_faces == 2; };
  if (std::none_of(components.measures.begin(), components.measures.end(), has_two_faces)) {
    return;
  }
  std::vector<char> is_hole_filling = hole_filling_faces(triangles);
  std::vector<char> is_visited(components.number(), 0);
  const std::size_t number_of_faces = triangles.faces.size();
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    const Index component = components.component[f];
    Surface_components::Measure& measure = components.measures[component];
    if (has_two_faces(measure) && std::exchange(is_visited[component], 1) != 0) {
      const auto [a, b, c] = triangles.faces[f];
      const Index center = Index(triangles.points.size());
      triangles.points.push_back((triangles.points[a] + triangles.points[b] + triangles.points[c]) / 3);
      triangles.faces[f] = {a, b, center};
      triangles.faces.insert(triangles.faces.end(), {{b, c, center}, {c, a, center}});
      components.component.resize(triangles.faces.size(), component);
      is_hole_filling.resize(triangles.faces.size(), is_hole_filling[f]);
      measure.number_of_faces += 2;
      ++measure.number_of_vertices;
    }
  }
  put_hole_filling_faces_last(triangles, components, is_hole_filling);
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
}

/// Vertices that sample a body well enough for fronts and loops. Fuzz targets are run with fewer, for a tenth of the
/// time.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr double size_of_sampled_body = 100;
#else
inline constexpr double size_of_sampled_body = 2000;
#endif

/// Splits edges of `triangles` that are long relative to the area of their component, so that about 2000 vertices, 32
/// for each handle, and 64 for each of many limbs of a few long faces, or more sample it; a surface that is sampled so
/// already stays as it is. The shape does not change, but edges in flat parts do, except in sheets and in components
/// with hole-filling faces. Inserted vertices are appended; hole-filling faces stay bridging. Vertices grow at most to
/// 4 n + 6 g + 20000 for genus g, and 128 for each limb, which are fewer than n; faces accordingly. O(n log n).
/// \return whether there are many limbs, which coarser triangulations lose
/// \pre `triangles` is closed and no two faces have the same corners; `pairing` and `components` are those of its
///      faces, and are kept so
inline bool refine_large_faces(Indexed_triangles& triangles, Halfedge_pairing& pairing, Surface_components& components)
{
  // Vertices that sample a handle well enough: with fewer, loops around each of many struts have no room.
  constexpr double size_of_sampled_handle = 32;
  // With fewer vertices left for each of many components, none is refined: these would not sample a body.
  constexpr double min_size = 24;
  // A component of less area cannot be sampled: its edges count as short. Relative to the square of the extent.
  constexpr double min_area = 1e-14;
  // Inserted vertices are at most this multiple of the vertices of the input, these more, ...
  constexpr std::size_t max_growth = 3;
  constexpr std::size_t free_vertices = 20000;
  // ... as many for each handle, since the halving of all edges takes so many more than of a sphere, ...
  constexpr std::size_t midpoints_of_handle = 6;
  // ... and twice those of an even triangulation for each limb.
  constexpr double midpoints_of_limb = 128;

  std::size_t budget = max_growth * triangles.points.size() + free_vertices;
  for (const Surface_components::Measure& measure : components.measures) {
    budget += midpoints_of_handle * measure.genus();
  }
  std::vector<double> squared_bound(components.number(), no_bound);
  for (Index i = 0; i < components.number(); ++i) {
    const double size =
        std::min(std::max(size_of_sampled_body, size_of_sampled_handle * double(components.measures[i].genus())),
                 double(budget) / components.number());
    if (components.measures[i].area > min_area && size >= min_size) {
      squared_bound[i] = squared_edge(components.measures[i].area, size);
    }
  }
  const double limbs = lower_bounds_for_limbs(triangles, pairing, components, squared_bound);
  budget += std::size_t(midpoints_of_limb * limbs);
  for (Index i = 0; i < components.number(); ++i) {
    if (components.measures[i].max_squared_length > squared_bound[i]) {
      Face_refinement(triangles, std::move(pairing), components, squared_bound)(budget);
      pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
      break;
    }
  }
  return limbs > 0;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_REFINE_LARGE_FACES_H
