// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits faces that are too large to sample the limbs of a surface.

#ifndef CSCD_SURFACE_REFINE_LARGE_FACES_H
#define CSCD_SURFACE_REFINE_LARGE_FACES_H

#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
    result[i] = std::max(curvature_of_corners[i] / boost::math::double_constants::two_pi - 2 * double(genus[i]), 0.);
  }
  return result;
}

/// The normal of the common plane of the faces `a` `b` `c` and `b` `a` `d`, up to the rounding of files.
inline std::optional<Vector3> common_normal(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  constexpr double flatness = 1e-5; // relative to the longest side
  const Vector3 of_c = (b - a).cross(c - a);
  const Vector3 of_d = (a - b).cross(d - b);
  const bool is_c_larger = of_c.squaredNorm() > of_d.squaredNorm();
  const Vector3 normal = (is_c_larger ? of_c : of_d).normalized();
  const Vector3& other = is_c_larger ? d : c;
  const double longest = std::max({(b - a).norm(), (other - a).norm(), (other - b).norm()});
  return std::abs(normal.dot(other - a)) <= flatness * longest ? std::optional<Vector3>(normal) : std::nullopt;
}

/// How many faces of each component are coplanar with an adjacent one. Linear.
inline std::vector<std::size_t> numbers_of_flat_faces(const Indexed_triangles& triangles,
                                                      const Halfedge_pairing& pairing,
                                                      const Surface_components& components)
{
  const auto point = [&](Index h) -> const Vector3& { return triangles.points[triangles.faces[h / 3][h % 3]]; };
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

  /// \param squared_bound the square of the longest allowed edge of each component; `no_bound` with hole-filling faces
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
    // New faces come before hole-filling faces.
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

  /// Angles that differ less from the angles of a rectangle are not worth a flip: rounding would decide.
  static constexpr double min_sine = 1e-6;
  /// Bounds the work where faces that are nearly flat flip for ever.
  static constexpr std::size_t max_flips_per_halfedge = 8;

  Index& origin(Index h) { return m_triangles.faces[h / 3][h % 3]; }
  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next(h)); }
  const Vector3& point(Index h) const { return m_triangles.points[origin(h)]; }

  Vector3 midpoint(Index h) const { return (point(h) + point(next(h))) / 2; }
  Key key(Index h) const
  {
    const Vector3 middle = midpoint(h);
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

  /// Whether the faces at `h` lie in a plane, the angles opposite to it are together more than pi, and the other
  /// diagonal is not an edge yet.
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
    const std::optional<Vector3> normal = common_normal(a, b, c, d);
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
  constexpr double min_limbs = 16;    // with fewer, the area bounds the size of faces
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
      const Vector3 side = triangles.points[face[(i + 1) % 3]] - triangles.points[face[i]];
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
/// hole-filling faces. The shape does not change, but some edges in flat parts do. At most 128 vertices are added for
/// each limb, and limbs are fewer than vertices. Near linear. \return the number of inserted vertices, which are
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
  // The corners of a noisy body carry no information.
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

/// Splits the second face of every component of two faces at its center. A single triangle becomes such a component
/// when its border is bridged; refined as it is, it would get several edges between the same vertices. Linear.
/// \return the number of inserted vertices
/// \pre `triangles` is closed; `pairing` and `components` are those of its faces, and are kept so
inline std::size_t split_two_face_components(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                             Surface_components& components)
{
  std::vector<Index> number_of_faces(components.number(), 0);
  for (Index component : components.component) {
    ++number_of_faces[component];
  }
  if (std::find(number_of_faces.begin(), number_of_faces.end(), Index(2)) == number_of_faces.end()) {
    return 0;
  }
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> component_of_face;
  std::vector<char> is_visited(components.number(), 0);
  const std::size_t number_of_points = triangles.points.size();
  std::size_t first_hole_filling_face = 0;
  for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
    const auto [a, b, c] = triangles.faces[f];
    const Index component = components.component[f];
    if (number_of_faces[component] == 2 && is_visited[component]) {
      const Index center = Index(triangles.points.size());
      triangles.points.push_back((triangles.points[a] + triangles.points[b] + triangles.points[c]) / 3);
      faces.insert(faces.end(), {{a, b, center}, {b, c, center}, {c, a, center}});
    } else {
      faces.push_back(triangles.faces[f]);
    }
    is_visited[component] = 1;
    component_of_face.resize(faces.size(), component);
    first_hole_filling_face = f < triangles.first_hole_filling_face ? faces.size() : first_hole_filling_face;
  }
  triangles.faces = std::move(faces);
  triangles.first_hole_filling_face = first_hole_filling_face;
  components.component = std::move(component_of_face);
  pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  return triangles.points.size() - number_of_points;
}

/// Vertices that sample a body well enough for fronts and loops. Fuzz targets are run with fewer, for a tenth of the
/// time.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr double size_of_sampled_body = 100;
#else
inline constexpr double size_of_sampled_body = 2000;
#endif

/// Splits long edges at their midpoints, round by round, until none is longer than the bound of its component.
class Face_refinement
{
public:
  Face_refinement(Indexed_triangles& triangles, Halfedge_pairing& pairing, Surface_components& components)
      : m_triangles(triangles), m_pairing(pairing), m_components(components),
        m_budget(triangles.points.size() * maximum_growth + free_vertices)
  {
    const std::vector<std::size_t> genus = genus_of_components(triangles, pairing, components);
    // Halving all edges of a surface of genus g takes this many vertices more than of a sphere.
    constexpr std::size_t midpoints_per_handle = 6;
    m_budget += midpoints_per_handle * std::accumulate(genus.begin(), genus.end(), std::size_t(0));
    set_bounds(genus);
  }

  /// Refines and returns the number of inserted vertices.
  std::size_t refine()
  {
    const std::size_t number_of_points = m_triangles.points.size();
    while (has_long_edge() && insert_midpoints()) {
      split_faces();
      m_pairing = Halfedge_pairing(m_triangles.faces, m_triangles.points.size());
    }
    return m_triangles.points.size() - number_of_points;
  }

private:
  /// Vertices that sample a handle well enough: with fewer, loops around each of many struts have no room.
  static constexpr double target_size_of_handle = 32;
  /// The longest edge allowed, relative to the square root of the area that each of these vertices has.
  /// An even triangulation has edges of 1.07; the factor keeps clear of uneven ones and of the halving of edges.
  static constexpr double edge_factor = 2.2;
  /// With fewer vertices left for each of many components, none is refined: these would not sample a body.
  static constexpr double min_size = 24;
  /// Inserted vertices are at most this multiple of the vertices of the input, and these more.
  static constexpr std::size_t maximum_growth = 3;
  static constexpr std::size_t free_vertices = 20000;

  /// Area below which a component counts as having none; relative to the square of the extent of the surface.
  static constexpr double min_area = 1e-14;

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  double squared_distance(Index a, Index b) const
  {
    return (m_triangles.points[a] - m_triangles.points[b]).squaredNorm();
  }
  bool is_long(Index h) const
  {
    return squared_distance(origin(h), target(h)) > m_squared_bound[m_components.component[h / 3]];
  }

  void set_bounds(const std::vector<std::size_t>& genus)
  {
    for (std::size_t i = 0; i < genus.size(); ++i) {
      const double size = std::min(std::max(size_of_sampled_body, target_size_of_handle * double(genus[i])),
                                   double(m_budget) / double(m_components.number()));
      // A component without area cannot be sampled: its edges count as short.
      const double area = m_components.measures[i].area;
      m_squared_bound.push_back(area > min_area && size >= min_size ? area * edge_factor * edge_factor / size
                                                                    : std::numeric_limits<double>::max());
    }
  }

  /// Whether any edge of the surface as it was given is long; asks the lengths that are known. Midpoints shorten edges.
  bool has_long_edge() const
  {
    for (Index i = 0; i < m_components.number(); ++i) {
      if (m_components.measures[i].max_squared_length > m_squared_bound[i]) {
        return true;
      }
    }
    return false;
  }

  std::size_t count_long_edges() const
  {
    std::size_t result = 0;
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      result += h < m_pairing.twin(h) && is_long(h);
    }
    return result;
  }

  /// Appends the midpoints of all long edges; false without any.
  bool insert_midpoints()
  {
    std::size_t number = count_long_edges();
    while (number > m_budget) {
      for (double& bound : m_squared_bound) {
        bound *= 2;
      }
      number = count_long_edges();
    }
    if (number == 0) {
      return false;
    }
    m_budget -= number;
    m_midpoint.assign(m_pairing.number_of_halfedges(), no_index);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      if (h < m_pairing.twin(h) && is_long(h)) {
        m_midpoint[h] = m_midpoint[m_pairing.twin(h)] = Index(m_triangles.points.size());
        m_triangles.points.push_back((m_triangles.points[origin(h)] + m_triangles.points[target(h)]) / 2);
      }
    }
    return true;
  }

  void split_faces()
  {
    const std::vector<std::array<Index, 3>> old_faces = std::move(m_triangles.faces);
    const std::vector<Index> old_component = std::move(m_components.component);
    const std::size_t first_hole_filling_face = m_triangles.first_hole_filling_face;
    m_triangles.faces.clear();
    m_components.component.clear();
    for (std::size_t f = 0; f < old_faces.size(); ++f) {
      if (f == first_hole_filling_face) {
        m_triangles.first_hole_filling_face = m_triangles.faces.size();
      }
      split_face(old_faces[f], {m_midpoint[3 * f], m_midpoint[3 * f + 1], m_midpoint[3 * f + 2]});
      m_components.component.resize(m_triangles.faces.size(), old_component[f]);
    }
    if (first_hole_filling_face == old_faces.size()) {
      m_triangles.first_hole_filling_face = m_triangles.faces.size();
    }
  }

  /// Splits a face into one more triangle than it has midpoints; `middle[i]` follows `corner[i]`.
  void split_face(std::array<Index, 3> corner, std::array<Index, 3> middle)
  {
    std::vector<std::array<Index, 3>>& faces = m_triangles.faces;
    const auto number = 3 - std::count(middle.begin(), middle.end(), no_index);
    // Turned so that the side without midpoint is the last one, and the single midpoint is on the first.
    while (number != 0 && number != 3 && (middle[2] != no_index || middle[0] == no_index)) {
      std::rotate(corner.begin(), corner.begin() + 1, corner.end());
      std::rotate(middle.begin(), middle.begin() + 1, middle.end());
    }
    const auto [a, b, c] = corner;
    const auto [ab, bc, ca] = middle;
    if (number == 0) {
      faces.push_back(corner);
    } else if (number == 1) {
      faces.insert(faces.end(), {{a, ab, c}, {ab, b, c}});
    } else if (number == 2) {
      faces.push_back({ab, b, bc});
      if (squared_distance(a, bc) < squared_distance(ab, c)) {
        faces.insert(faces.end(), {{a, ab, bc}, {a, bc, c}});
      } else {
        faces.insert(faces.end(), {{a, ab, c}, {ab, bc, c}});
      }
    } else {
      faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }

  Indexed_triangles& m_triangles;
  Halfedge_pairing& m_pairing;
  Surface_components& m_components;
  std::size_t m_budget;                // vertices that may still be inserted
  std::vector<double> m_squared_bound; // of the length of an edge, per component
  std::vector<Index> m_midpoint;       // of every halfedge's edge
};

/// Splits edges of `triangles` that are long relative to the area of their component, so that about 2000 vertices, and
/// 32 for each handle, or more sample it; a surface that is sampled so already stays as it is. The shape does not
/// change. Inserted vertices are appended; hole-filling faces stay bridging. Vertices grow at most to 4 n + 6 g + 20000
/// for genus g, faces accordingly. O(n) for each round of halving. \return the number of inserted vertices
/// \pre `triangles` is closed and no two faces have the same corners; `pairing` and `components` are those of its
///      faces, and are kept so
inline std::size_t refine_large_faces(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                      Surface_components& components)
{
  return Face_refinement(triangles, pairing, components).refine();
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_REFINE_LARGE_FACES_H
