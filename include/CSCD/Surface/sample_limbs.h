// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inserts vertices where each of many limbs has a few long faces only, as the teeth of a comb.

#ifndef CSCD_SURFACE_SAMPLE_LIMBS_H
#define CSCD_SURFACE_SAMPLE_LIMBS_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// How many limbs each component has, by the curvature of its corners: the tip of a limb holds 2 pi, and so does one
/// side of a handle, twice. Linear. \param genus of each component
inline std::vector<double> numbers_of_limbs(const Indexed_triangles& triangles, const Surface_components& components,
                                            const std::vector<std::size_t>& genus)
{
  // Of a cube's corners it is pi / 2; what is rounded, or noise, has less, and a fin that is too thin for any number of
  // vertices has pi.
  constexpr double min_curvature = boost::math::double_constants::third_pi;
  constexpr double max_curvature = 0.9 * boost::math::double_constants::pi;
  std::vector<double> curvature(triangles.points.size(), boost::math::double_constants::two_pi);
  for (const std::array<Index, 3>& face : triangles.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3& a = triangles.points[face[i]];
      const Vector_3 ab = triangles.points[face[(i + 1) % 3]] - a;
      const Vector_3 ac = triangles.points[face[(i + 2) % 3]] - a;
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
    result[i] = std::max(curvature_of_corners[i] / boost::math::double_constants::two_pi - 2 * double(genus[i]), 0.);
  }
  return result;
}

/// The normal of the plane in which the faces `a` `b` `c` and `b` `a` `d` lie, up to what files round to.
inline std::optional<Vector_3> common_normal(const Vector_3& a, const Vector_3& b, const Vector_3& c, const Vector_3& d)
{
  constexpr double flatness = 1e-5; // relative to the longest side
  const Vector_3 of_c = (b - a).cross(c - a);
  const Vector_3 of_d = (a - b).cross(d - b);
  const bool is_c_larger = of_c.squaredNorm() > of_d.squaredNorm();
  const Vector_3 normal = (is_c_larger ? of_c : of_d).normalized();
  const Vector_3& other = is_c_larger ? d : c;
  const double longest = std::max({(b - a).norm(), (other - a).norm(), (other - b).norm()});
  return std::abs(normal.dot(other - a)) <= flatness * longest ? std::optional<Vector_3>(normal) : std::nullopt;
}

/// How many faces of each component lie in one plane with one beside them. Linear.
inline std::vector<std::size_t> numbers_of_flat_faces(const Indexed_triangles& triangles,
                                                      const Halfedge_pairing& pairing,
                                                      const Surface_components& components)
{
  const auto point = [&](Index h) -> const Vector_3& { return triangles.points[triangles.faces[h / 3][h % 3]]; };
  const auto is_flat = [&](Index h) {
    const Index twin = pairing.twin(h);
    return common_normal(point(h), point(twin), point(Halfedge_pairing::previous(h)),
                         point(Halfedge_pairing::previous(twin)))
        .has_value();
  };
  std::vector<std::size_t> result(components.number(), 0);
  for (Index f = 0; f < triangles.faces.size(); ++f) {
    result[components.component[f]] += is_flat(3 * f) || is_flat(3 * f + 1) || is_flat(3 * f + 2) ? 1 : 0;
  }
  return result;
}

/// Splits long edges at their midpoints, the longest first, and flips edges between faces of one plane so that these
/// are a Delaunay triangulation all the time: slivers, which fill facets of many corners, then need few vertices.
class Flat_refinement : private Triangle_halfedges
{
public:
  /// The bound of a component that is left as it is.
  static constexpr double no_bound = std::numeric_limits<double>::max();

  /// \param squared_bound the square of the longest edge allowed, of each component; none of one with hole-filling faces
  Flat_refinement(Indexed_triangles& triangles, const Halfedge_pairing& pairing, Surface_components& components,
                  const std::vector<double>& squared_bound)
      : m_triangles(triangles), m_components(components), m_squared_bound(squared_bound),
        m_number_of_faces(triangles.faces.size())
  {
    m_twin.reserve(pairing.number_of_halfedges());
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      m_twin.push_back(pairing.twin(h));
    }
  }

  /// Inserts at most `max_number` vertices.
  void operator()(std::size_t max_number)
  {
    m_flips_left = max_flips_per_halfedge * (m_twin.size() + 6 * max_number);
    for (Index h = 0; h < m_twin.size(); ++h) {
      if (h < m_twin[h]) {
        m_unchecked.push_back(h);
        push_if_long(h);
      }
    }
    flip_edges();
    while (max_number > 0 && !m_long_edges.empty()) {
      const Long_edge edge = m_long_edges.top();
      m_long_edges.pop();
      if (edge.first == key(edge.second)) {
        split(edge.second);
        flip_edges();
        --max_number;
      }
    }
    // New faces come before those that fill holes.
    const auto rotate = [&](auto& rows) {
      std::rotate(rows.begin() + std::ptrdiff_t(m_triangles.first_hole_filling_face),
                  rows.begin() + std::ptrdiff_t(m_number_of_faces), rows.end());
    };
    rotate(m_triangles.faces);
    rotate(m_components.component);
    m_triangles.first_hole_filling_face += m_triangles.faces.size() - m_number_of_faces;
  }

private:
  /// The squared length and the midpoint, so that equally long edges have an order that their numbers do not decide.
  using Key = std::tuple<double, double, double, double>;
  using Long_edge = std::pair<Key, Index>;

  /// Angles that differ from those of a rectangle by less are not worth a flip: rounding would decide.
  static constexpr double min_sine = 1e-6;
  /// Bounds the work where faces that are nearly flat flip for ever.
  static constexpr std::size_t max_flips_per_halfedge = 8;

  Index& origin(Index h) { return m_triangles.faces[h / 3][h % 3]; }
  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next(h)); }
  const Vector_3& point(Index h) const { return m_triangles.points[origin(h)]; }

  Vector_3 midpoint(Index h) const { return (point(h) + point(next(h))) / 2; }
  Key key(Index h) const
  {
    const Vector_3 middle = midpoint(h);
    return {(point(h) - point(next(h))).squaredNorm(), middle.x(), middle.y(), middle.z()};
  }
  void push_if_long(Index h)
  {
    const Key edge = key(h);
    if (std::get<0>(edge) > m_squared_bound[m_components.component[h / 3]]) {
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
    const Index k = Index(m_twin.size());
    const Index l = k + 3;
    origin(next(h)) = middle;
    origin(t) = middle;
    m_triangles.faces.push_back({middle, b, c});
    m_triangles.faces.push_back({b, middle, d});
    m_components.component.resize(m_triangles.faces.size(), m_components.component[h / 3]);
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
      const Index h = m_unchecked.back();
      m_unchecked.pop_back();
      if (m_flips_left > 0 && m_squared_bound[m_components.component[h / 3]] < no_bound && is_to_be_flipped(h)) {
        flip(h);
        --m_flips_left;
      }
    }
  }

  /// Whether the faces beside `h` lie in a plane, the angles opposite to it are together more than pi, and the other
  /// diagonal is no edge yet.
  bool is_to_be_flipped(Index h) const
  {
    const Index t = m_twin[h];
    const Vector_3& a = point(h);
    const Vector_3& b = point(t);
    const Vector_3& c = point(previous(h));
    const Vector_3& d = point(previous(t));
    const Vector_3 of_h = (b - a).cross(c - a);
    const Vector_3 of_t = (a - b).cross(d - b);
    const double sine = of_h.norm() * (a - d).dot(b - d) + of_t.norm() * (a - c).dot(b - c);
    if (!(sine < -min_sine * (a - c).norm() * (b - c).norm() * (a - d).norm() * (b - d).norm())) {
      return false;
    }
    const std::optional<Vector_3> normal = common_normal(a, b, c, d);
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

  /// Replaces the edge of `h` by the other diagonal of the faces beside it.
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
  std::size_t m_number_of_faces; ///< before the refinement
  std::vector<Index> m_twin;
  std::priority_queue<Long_edge> m_long_edges;
  std::vector<Index> m_unchecked;
  std::size_t m_flips_left = 0;
};

/// Squares of the longest edges allowed in components that have many limbs of a few long faces each, so that an even
/// triangulation has about 64 vertices for a limb; `Flat_refinement::no_bound` for all others. Linear.
inline std::vector<double> bounds_for_limbs(const Indexed_triangles& triangles, const Surface_components& components,
                                            const std::vector<double>& limbs)
{
  constexpr double size_of_limb = 64; // vertices: a dozen rings and more
  constexpr double min_limbs = 16;    // with fewer, the area tells how large faces may be
  constexpr double edge_factor = 2.2; // of the longest edge to the square root of the area that a vertex has
  std::vector<double> squared_bound(components.number(), Flat_refinement::no_bound);
  for (Index i = 0; i < components.number(); ++i) {
    const Surface_components::Measure& measure = components.measures[i];
    if (limbs[i] >= min_limbs && 2 * measure.number_of_long_faces >= measure.number_of_faces) {
      squared_bound[i] = measure.area * edge_factor * edge_factor / (size_of_limb * limbs[i]);
    }
  }
  // Where fewer sides of faces than a quarter are longer, limbs are sampled already.
  std::vector<std::size_t> number_of_long_sides(components.number(), 0);
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const Index component = components.component[f];
    const std::array<Index, 3>& face = triangles.faces[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3 side = triangles.points[face[(i + 1) % 3]] - triangles.points[face[i]];
      number_of_long_sides[component] += side.squaredNorm() > squared_bound[component] ? 1 : 0;
    }
  }
  for (Index i = 0; i < components.number(); ++i) {
    if (4 * number_of_long_sides[i] < 3 * components.measures[i].number_of_faces) {
      squared_bound[i] = Flat_refinement::no_bound;
    }
  }
  return squared_bound;
}

/// Inserts vertices into components that have many limbs of a few long faces each, except sheets and components with
/// hole-filling faces. The shape does not change, but some edges in flat parts do. Vertices grow by at most 128 for
/// each limb, of which there are fewer than vertices. Near linear. \return the number of inserted vertices, which are
/// appended \param side of every vertex, not 0 on a sheet; empty without sheets
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces, and are kept so
inline std::size_t sample_limbs(Indexed_triangles& triangles, Halfedge_pairing& pairing, Surface_components& components,
                                const std::vector<signed char>& side = {})
{
  constexpr double max_growth = 128; // vertices for each limb: twice those of an even triangulation
  const auto has_long_faces = [](const Surface_components::Measure& measure) {
    return 2 * measure.number_of_long_faces >= measure.number_of_faces;
  };
  if (std::none_of(components.measures.begin(), components.measures.end(), has_long_faces)) {
    return 0;
  }
  const std::vector<double> limbs =
      numbers_of_limbs(triangles, components, genus_of_components(triangles, pairing, components));
  std::vector<double> squared_bound = bounds_for_limbs(triangles, components, limbs);
  // Of a noisy body corners tell nothing.
  const std::vector<std::size_t> flat_faces = numbers_of_flat_faces(triangles, pairing, components);
  for (Index i = 0; i < components.number(); ++i) {
    if (2 * flat_faces[i] < components.measures[i].number_of_faces) {
      squared_bound[i] = Flat_refinement::no_bound;
    }
  }
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    if (f >= triangles.first_hole_filling_face || (!side.empty() && side[triangles.faces[f][0]] != 0)) {
      squared_bound[components.component[f]] = Flat_refinement::no_bound;
    }
  }
  double max_number = 0;
  for (Index i = 0; i < components.number(); ++i) {
    max_number += squared_bound[i] < Flat_refinement::no_bound ? max_growth * limbs[i] : 0;
  }
  if (!(max_number > 0)) {
    return 0;
  }
  const std::size_t number_of_points = triangles.points.size();
  Flat_refinement refinement(triangles, pairing, components, squared_bound);
  refinement(std::size_t(max_number));
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  return triangles.points.size() - number_of_points;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_SAMPLE_LIMBS_H
