// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The components of a surface, their orientation, and an order of vertices that depends on the shape alone.

#ifndef CSCD_SURFACE_SURFACE_COMPONENTS_H
#define CSCD_SURFACE_SURFACE_COMPONENTS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The components of faces that are connected through edges, numbered in the order of their first faces.
struct Surface_components
{
  /// Numbers and measures the components of `triangles`; near linear.
  /// \param side of every vertex, not 0 on a sheet; empty without sheets
  /// \pre the faces of each vertex form one fan: faces with a common vertex are connected
  explicit Surface_components(const Indexed_triangles& triangles, const std::vector<signed char>& side = {})
  {
    // Joins the corners of each face: neighbors are often far away in memory, but faces are read one after the other.
    Disjoint_sets joined = sets_of_vertices(triangles.faces, triangles.points.size());
    std::vector<Index> number_of_set(triangles.points.size(), no_index);
    std::vector<Vector3> center_sum; // of the faces of every component
    component.reserve(triangles.faces.size());
    for (Index f = 0; f < triangles.faces.size(); ++f) {
#ifdef __GNUC__
      if (f + prefetch_distance < triangles.faces.size()) {
        for (const Index corner : triangles.faces[f + prefetch_distance]) {
          __builtin_prefetch(&triangles.points[corner]);
        }
      }
#endif
      const Index corner = triangles.faces[f][0];
      Index& its_component = number_of_set[joined.find(corner)];
      if (its_component == no_index) {
        its_component = number();
        measures.emplace_back();
        measures.back().is_sheet = !side.empty() && side[corner] != 0;
        center_sum.emplace_back();
      }
      component.push_back(its_component);
      add_face(triangles, f, measures[its_component], center_sum[its_component]);
    }
    for (Index vertex = 0; vertex < triangles.points.size(); ++vertex) {
      const Index its_component = number_of_set[joined.find(vertex)];
      if (its_component != no_index) {
        ++measures[its_component].number_of_vertices;
      }
    }
    for (Index i = 0; i < number(); ++i) {
      measures[i].centroid = measures[i].area > 0 ? measures[i].centroid / measures[i].area
                                                  : center_sum[i] / double(measures[i].number_of_faces);
    }
  }

  struct Measure
  {
    double area = 0;                      ///< without hole-filling faces
    double volume = 0;                    ///< signed: negative where the faces look inwards
    Vector3 centroid = Vector3::Zero();   ///< of the area; mean of the faces' centers if the area is 0
    double max_squared_length = 0;        ///< of the edges
    std::size_t number_of_vertices = 0;   ///< of all faces
    std::size_t number_of_faces = 0;      ///< with hole-filling faces
    std::size_t number_of_long_faces = 0; ///< faces much longer than high
    bool is_sheet = false;                ///< of two sides
    bool is_bridged = false;              ///< whether there are hole-filling faces

    /// Whether the faces look inwards: a volume near 0 has no reliable sign.
    bool faces_inwards() const { return volume < -min_signed_volume * area * std::sqrt(area); }
    /// Whether it has neither had borders nor is a sheet.
    bool is_body() const { return !is_sheet && !is_bridged; }
    /// The number of handles. \pre the triangles are closed
    std::size_t genus() const { return genus_of_closed_surface(1, number_of_vertices, number_of_faces); }
  };

  Index number() const
  {
    return Index(measures.size());
  }
  /// The component of `vertex`, which has a face in `pairing`.
  Index component_of_vertex(const Halfedge_pairing& pairing, Index vertex) const
  {
    return number() == 1 ? 0 : component[*pairing.outgoing()[vertex].begin() / 3];
  }

  std::vector<Index> component;  ///< of every face
  std::vector<Measure> measures; ///< of every component
  /// Faces with (nearly) no area for their longest side, in order, without hole-filling faces.
  std::vector<Index> degenerate_faces;

private:
  /// Volumes below this, relative to the area to the power 3/2, have no reliable sign: a ball has about 0.1.
  static constexpr double min_signed_volume = 1e-9;
  /// A face is degenerate if its height is less than this, relative to its longest side: rounding may have made it up.
  static constexpr double degenerate_height = 1e-8;
  /// A face is long if it is at least this much longer than high: halves of squares are twice as long.
  static constexpr double long_ratio = 2.5;

  /// Prefetch distance, in faces.
  static constexpr std::size_t prefetch_distance = 16;

  void add_face(const Indexed_triangles& triangles, Index f, Measure& sum, Vector3& center_sum)
  {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector3& a = triangles.points[face[0]];
    const Vector3& b = triangles.points[face[1]];
    const Vector3& c = triangles.points[face[2]];
    const bool is_hole_filling = f >= triangles.first_hole_filling_face;
    const Vector3 vector = triangle_vector(a, b, c);
    const Vector3 center = (a + b + c) / 3;
    const double doubled_area = is_hole_filling ? 0. : vector.norm();
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    sum.max_squared_length = std::max(sum.max_squared_length, longest);
    sum.area += doubled_area / 2;
    sum.volume += a.dot(vector) / 6;
    sum.centroid += doubled_area / 2 * center;
    center_sum += center;
    ++sum.number_of_faces;
    sum.number_of_long_faces += longest >= long_ratio * doubled_area ? 1 : 0;
    sum.is_bridged = sum.is_bridged || is_hole_filling;
    if (!is_hole_filling && !(doubled_area > degenerate_height * longest)) {
      degenerate_faces.push_back(f);
    }
  }
};

/// Removes the components that satisfy `is_removed(component)`, and the points that only they use. Linear.
/// \return the old numbers of the remaining points, in order
/// \pre `components` are those of `triangles`; they are outdated afterwards
template <class Predicate>
std::vector<Index> remove_components(Indexed_triangles& triangles, const Surface_components& components,
                                     const Predicate& is_removed)
{
  std::size_t kept = 0;
  std::size_t first_hole_filling_face = 0;
  for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
    if (!is_removed(components.component[face])) {
      triangles.faces[kept++] = triangles.faces[face];
      first_hole_filling_face += face < triangles.first_hole_filling_face ? 1 : 0;
    }
  }
  triangles.faces.resize(kept);
  triangles.first_hole_filling_face = first_hole_filling_face;
  return remove_unused_points(triangles);
}

/// Reverses the faces of all components that enclose a negative volume: each component is then a body of its own.
/// Linear.
/// \param is_cavity of each component, whether it is to stay as it is; may be empty
/// \return the number of components that were reversed; if there are some, a pairing of the faces must be made anew
/// \pre `components` are those of `triangles`, and are kept so
inline std::size_t orient_outwards(Indexed_triangles& triangles, Surface_components& components,
                                   const std::vector<char>& is_cavity = {})
{
  std::size_t number_of_reversed = 0;
  std::vector<char> is_reversed(components.number(), 0);
  for (Index c = 0; c < components.number(); ++c) {
    Surface_components::Measure& measure = components.measures[c];
    if (measure.faces_inwards() && (is_cavity.empty() || is_cavity[c] == 0)) {
      measure.volume = -measure.volume;
      is_reversed[c] = 1;
      ++number_of_reversed;
    }
  }
  if (number_of_reversed > 0) {
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      if (is_reversed[components.component[f]]) {
        std::swap(triangles.faces[f][1], triangles.faces[f][2]);
      }
    }
  }
  return number_of_reversed;
}

/// Where the canonical order of each component begins: the root is the vertex farthest from the centroid, and then
/// comes the neighbor of the root that is farthest. Of equally far vertices, the lexicographically least is taken, up
/// to rounding.
struct Canonical_roots
{
  Canonical_roots(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                  const Surface_components& components)
      : vertex(components.number(), no_index), neighbor(components.number(), no_index),
        squared_distance(components.number(), 0.)
  {
    const std::vector<Vector3>& points = triangles.points;
    const auto distance = [&](Index v, Index c) { return (points[v] - components.measures[c].centroid).squaredNorm(); };
    const auto choose = [&](Index v, Index c, double greatest, Index& chosen) {
      if (distance(v, c) >= (1 - distance_tolerance) * greatest &&
          (chosen == no_index || is_lexicographically_less(on_grid(points[v]), on_grid(points[chosen])))) {
        chosen = v;
      }
    };
    for (Index v = 0; v < points.size(); ++v) {
      const Index c = components.component_of_vertex(pairing, v);
      squared_distance[c] = std::max(squared_distance[c], distance(v, c));
    }
    for (Index v = 0; v < points.size(); ++v) {
      const Index c = components.component_of_vertex(pairing, v);
      choose(v, c, squared_distance[c], vertex[c]);
    }
    for (Index c = 0; c < components.number(); ++c) {
      double greatest = 0;
      for (const Index h : pairing.outgoing()[vertex[c]]) {
        greatest = std::max(greatest, distance(triangles.target(h), c));
      }
      for (const Index h : pairing.outgoing()[vertex[c]]) {
        choose(triangles.target(h), c, greatest, neighbor[c]);
      }
    }
  }

  /// Distances that differ by less, relatively, are equal: they differ by rounding only, which depends on the order.
  static constexpr double distance_tolerance = 1e-9;

  std::vector<Index> vertex;
  std::vector<Index> neighbor;
  std::vector<double> squared_distance; ///< of the root from the centroid
};

/// Finds an order of the vertices that does not depend on their numbers nor, up to rounding and symmetry, on the pose
/// of the surface: breadth-first from the roots over the rings, in counterclockwise order, component by component, in
/// order of decreasing area. O(n + c log c) for c components. \return the old number of every new vertex
/// \pre `triangles` is closed, without isolated vertices; `pairing` and `components` are those of its faces
inline std::vector<Index> canonical_order(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                          const Surface_components& components)
{
  constexpr std::size_t prefetch_distance = 8; // in vertices
  const Canonical_roots roots(triangles, pairing, components);
  // The sums are rounded to single precision, so that the order of their terms does not matter.
  const auto key = [&](Index c) {
    const Vector3 root = on_grid(triangles.points[roots.vertex[c]]);
    return std::tuple(-float(components.measures[c].area), -float(roots.squared_distance[c]), root.x(), root.y(),
                      root.z());
  };
  std::vector<Index> sorted = all_indices(components.number());
  std::sort(sorted.begin(), sorted.end(), [&key](Index c, Index d) { return key(c) < key(d); });

  std::vector<Index> result;
  std::vector<Index> parent; // of each of the vertices in order, the neighbor where its ring begins
  std::vector<char> is_numbered(triangles.points.size(), 0);
  result.reserve(triangles.points.size());
  parent.reserve(triangles.points.size());
  const auto append = [&](Index vertex, Index its_parent) {
    if (is_numbered[vertex] == 0) {
      is_numbered[vertex] = 1;
      result.push_back(vertex);
      parent.push_back(its_parent);
    }
  };
  for (const Index component : sorted) {
    std::size_t at = result.size();
    append(roots.vertex[component], roots.neighbor[component]);
    for (; at < result.size(); ++at) {
#ifdef __GNUC__
      // Where numbers are scattered, most of the time goes to waiting: prefetch the data of vertices that come soon.
      if (at + 2 * prefetch_distance < result.size()) {
        __builtin_prefetch(pairing.outgoing()[result[at + 2 * prefetch_distance]].begin());
        const auto row = pairing.outgoing()[result[at + prefetch_distance]];
        for (std::size_t j = 0; j < row.size(); j += 2) {
          __builtin_prefetch(&triangles.faces[row.begin()[j] / 3]);
        }
      }
#endif
      const Index vertex = result[at];
      const auto row = pairing.outgoing()[vertex];
      const Index* const first = std::find_if(
          row.begin(), row.end(), [&, its_parent = parent[at]](Index h) { return triangles.target(h) == its_parent; });
      std::for_each(first, row.end(), [&](Index h) { append(triangles.target(h), vertex); });
      std::for_each(row.begin(), first, [&](Index h) { append(triangles.target(h), vertex); });
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_SURFACE_COMPONENTS_H
