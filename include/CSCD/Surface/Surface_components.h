// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of a closed surface, and their orientation.

#ifndef CSCD_SURFACE_SURFACE_COMPONENTS_H
#define CSCD_SURFACE_SURFACE_COMPONENTS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The components of faces that are connected through edges, numbered in the order of their first faces.
struct Surface_components
{
  /// Numbers and measures the components of `triangles`; near linear.
  /// \pre the faces of each vertex form one fan: what has a vertex in common is connected
  explicit Surface_components(const Indexed_triangles& triangles)
  {
    number_components(triangles);
    measure(triangles);
  }

  struct Measure
  {
    double area = 0;                      ///< without hole-filling faces
    double volume = 0;                    ///< signed: negative where the faces look inwards
    Vector_3 centroid = Vector_3::Zero(); ///< of the area; of the faces' centers where there is no area
    double max_squared_length = 0;        ///< of the edges
    std::size_t number_of_faces = 0;      ///< with hole-filling faces
    std::size_t number_of_long_faces = 0; ///< faces much longer than high

    /// Whether the faces look inwards: a volume near 0 has no reliable sign.
    bool faces_inwards() const { return volume < -min_signed_volume * area * std::sqrt(area); }
  };

  Index number() const { return Index(measures.size()); }
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

  /// Joins the corners of each face: neighbors are often far away in memory, but faces are read one after the other.
  void number_components(const Indexed_triangles& triangles)
  {
    Disjoint_sets joined(triangles.points.size());
    for (const std::array<Index, 3>& face : triangles.faces) {
      joined.join(face[0], face[1]);
      joined.join(face[0], face[2]);
    }
    component.reserve(triangles.faces.size());
    std::vector<Index> number_of_set(triangles.points.size(), no_index);
    for (const std::array<Index, 3>& face : triangles.faces) {
      Index& number_of_face = number_of_set[joined.find(face[0])];
      if (number_of_face == no_index) {
        number_of_face = number();
        measures.emplace_back();
      }
      component.push_back(number_of_face);
    }
  }

  void measure(const Indexed_triangles& triangles)
  {
    for (Index f = 0; f < triangles.faces.size(); ++f) {
#ifdef __GNUC__
      if (f + prefetch_distance < triangles.faces.size()) {
        for (const Index corner : triangles.faces[f + prefetch_distance]) {
          __builtin_prefetch(&triangles.points[corner]);
        }
      }
#endif
      const bool is_hole_filling = f >= triangles.first_hole_filling_face;
      if (add_face(triangles, f, is_hole_filling, measures[component[f]]) && !is_hole_filling) {
        degenerate_faces.push_back(f);
      }
    }
    std::vector<Vector_3> center_sum;
    for (Index i = 0; i < number(); ++i) {
      if (!(measures[i].area > 0) && center_sum.empty()) {
        center_sum = sums_of_centers(triangles);
      }
      measures[i].centroid = measures[i].area > 0 ? Vector_3(measures[i].centroid / measures[i].area)
                                                  : Vector_3(center_sum[i] / double(measures[i].number_of_faces));
    }
  }

  /// \return whether the face has (nearly) no area for its longest side, or is hole-filling
  static bool add_face(const Indexed_triangles& triangles, Index f, bool is_hole_filling, Measure& sum)
  {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector_3& a = triangles.points[face[0]];
    const Vector_3& b = triangles.points[face[1]];
    const Vector_3& c = triangles.points[face[2]];
    const Vector_3 vector = triangle_vector(a, b, c);
    const double doubled_area = is_hole_filling ? 0. : vector.norm();
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    sum.max_squared_length = std::max(sum.max_squared_length, longest);
    sum.area += doubled_area / 2;
    sum.volume += a.dot(vector) / 6;
    sum.centroid += doubled_area / 2 * center(a, b, c);
    ++sum.number_of_faces;
    sum.number_of_long_faces += longest >= long_ratio * doubled_area ? 1 : 0;
    return !(doubled_area > degenerate_height * longest);
  }

  static Vector_3 center(const Vector_3& a, const Vector_3& b, const Vector_3& c)
  {
    return (a + b + c) / 3;
  }

  /// Of every component.
  std::vector<Vector_3> sums_of_centers(const Indexed_triangles& triangles) const
  {
    std::vector<Vector_3> result(number(), Vector_3::Zero());
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      const auto& [a, b, c] = triangles.faces[f];
      result[component[f]] += center(triangles.points[a], triangles.points[b], triangles.points[c]);
    }
    return result;
  }
};

/// The genus of each of `components`, of closed `triangles`. Linear. \pre `pairing` is that of the faces
inline std::vector<std::size_t> genus_of_components(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                                    const Surface_components& components)
{
  std::vector<std::size_t> number_of_vertices(components.number(), 0);
  std::vector<std::size_t> number_of_faces(components.number(), 0);
  for (const Index component : components.component) {
    ++number_of_faces[component];
  }
  for (Index vertex = 0; vertex < triangles.points.size(); ++vertex) {
    if (pairing.outgoing().size(vertex) > 0) {
      ++number_of_vertices[components.component_of_vertex(pairing, vertex)];
    }
  }
  std::vector<std::size_t> genus(components.number());
  for (std::size_t i = 0; i < genus.size(); ++i) {
    genus[i] = genus_of_closed_surface(1, number_of_vertices[i], number_of_faces[i]);
  }
  return genus;
}

/// Removes the components for which `is_removed(component)` holds, and the points that only they use. Linear.
/// \return the old numbers of the points that remain, in order
/// \pre `components` are those of `triangles`, which they no longer are afterwards
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
  std::vector<Index> old_number = compact_numbers(triangles.faces, triangles.points.size());
  for (std::size_t i = 0; i < old_number.size(); ++i) {
    triangles.points[i] = triangles.points[old_number[i]];
  }
  triangles.points.resize(old_number.size());
  return old_number;
}

/// Reverses the faces of all components that enclose a negative volume: each component is then a body of its own.
/// Linear.
/// \param is_cavity of each component, whether it is to stay as it is; may be empty
/// \return the number of components that were reversed
/// \pre `pairing` and `components` are those of `triangles`, and are kept so
inline std::size_t orient_outwards(Indexed_triangles& triangles, Halfedge_pairing& pairing,
                                   Surface_components& components, const std::vector<char>& is_cavity = {})
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
    pairing = Halfedge_pairing(triangles.faces, triangles.points.size());
  }
  return number_of_reversed;
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_SURFACE_COMPONENTS_H
