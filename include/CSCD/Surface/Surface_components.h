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
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The components of faces that are connected through edges, numbered in the order of their first faces.
struct Surface_components
{
  /// Numbers and measures the components of `triangles`; near linear.
  /// \pre the faces of each vertex form one fan: faces with a common vertex are connected
  explicit Surface_components(const Indexed_triangles& triangles)
  {
    number_components(triangles);
    measure(triangles);
  }

  struct Measure
  {
    double area = 0;                      ///< without hole-filling faces
    double volume = 0;                    ///< signed: negative where the faces look inwards
    Vector3 centroid = Vector3::Zero();   ///< of the area; of the faces' centers if the area is 0
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
    Disjoint_sets joined = sets_of_vertices(triangles.faces, triangles.points.size());
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
    std::vector<Vector3> center_sum;
    for (Index i = 0; i < number(); ++i) {
      if (!(measures[i].area > 0) && center_sum.empty()) {
        center_sum = sums_of_centers(triangles);
      }
      measures[i].centroid = measures[i].area > 0 ? Vector3(measures[i].centroid / measures[i].area)
                                                  : Vector3(center_sum[i] / double(measures[i].number_of_faces));
    }
  }

  /// \return whether the face has (nearly) no area for its longest side, or is hole-filling
  static bool add_face(const Indexed_triangles& triangles, Index f, bool is_hole_filling, Measure& sum)
  {
    const std::array<Index, 3>& face = triangles.faces[f];
    const Vector3& a = triangles.points[face[0]];
    const Vector3& b = triangles.points[face[1]];
    const Vector3& c = triangles.points[face[2]];
    const Vector3 vector = triangle_vector(a, b, c);
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

  static Vector3 center(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    return (a + b + c) / 3;
  }

  /// Of every component.
  std::vector<Vector3> sums_of_centers(const Indexed_triangles& triangles) const
  {
    std::vector<Vector3> result(number(), Vector3::Zero());
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

/// An order of the vertices of a surface, component by component.
struct Canonical_order
{
  std::vector<Index> vertices;        ///< the old number of every new vertex
  std::vector<Index> component_begin; ///< the first new vertex of every component, and their number at the end
};

/// Finds the canonical order: breadth-first over the rings, in counterclockwise order, which the root and its first
/// halfedge determine. Root is the vertex farthest from the centroid of its component, and its first halfedge leads to
/// the farthest neighbor; components come in order of decreasing area.
class Canonical_ordering
{
public:
  Canonical_ordering(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                     const Surface_components& components)
      : m_triangles(triangles), m_pairing(pairing), m_components(components)
  {
    find_roots();
  }

  Canonical_order order() const
  {
    std::vector<Index> sorted(m_components.number());
    std::iota(sorted.begin(), sorted.end(), Index(0));
    std::sort(sorted.begin(), sorted.end(), [this](Index c, Index d) { return key(c) < key(d); });
    Numbering numbering(m_triangles.points.size());
    Canonical_order result;
    for (Index component : sorted) {
      result.component_begin.push_back(Index(numbering.vertices.size()));
      append_component(m_first[component], numbering);
    }
    result.component_begin.push_back(Index(numbering.vertices.size()));
    result.vertices = std::move(numbering.vertices);
    return result;
  }

private:
  /// Distances that differ by less, relatively, are equal: they differ by rounding only, which depends on the order.
  static constexpr double distance_tolerance = 1e-9;
  /// Prefetch distance, in vertices.
  static constexpr std::size_t prefetch_distance = 8;
  /// The vertices in the order so far.
  struct Numbering
  {
    explicit Numbering(std::size_t number_of_vertices) : is_numbered(number_of_vertices, 0)
    {
      vertices.reserve(number_of_vertices);
      parent.reserve(number_of_vertices);
    }

    void append(Index vertex, Index its_parent)
    {
      if (is_numbered[vertex] == 0) {
        is_numbered[vertex] = 1;
        vertices.push_back(vertex);
        parent.push_back(its_parent);
      }
    }

    std::vector<Index> vertices;
    std::vector<Index> parent; ///< of each of them, the neighbor where its ring begins
    std::vector<char> is_numbered;
  };

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  const Vector3& origin_point(Index h) const { return m_triangles.points[origin(h)]; }
  double squared_distance(Index vertex, Index component) const
  {
    return (m_triangles.points[vertex] - m_components.measures[component].centroid).squaredNorm();
  }

  /// The sums are rounded to single precision, so that the order of their terms does not matter.
  std::tuple<float, float, double, double, double> key(Index component) const
  {
    const Vector3& root = origin_point(m_first[component]);
    return {-float(m_components.measures[component].area), -float(m_greatest[component]), root.x(), root.y(), root.z()};
  }

  /// Among equally far vertices the lexicographically smallest is the root; likewise for its neighbors.
  void find_roots()
  {
    const std::size_t n = m_triangles.points.size();
    m_greatest.assign(m_components.number(), 0.);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      m_greatest[component] = std::max(m_greatest[component], squared_distance(vertex, component));
    }
    m_first.assign(m_components.number(), no_index);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      Index& first = m_first[component];
      if (squared_distance(vertex, component) >= (1 - distance_tolerance) * m_greatest[component] &&
          (first == no_index || is_lexicographically_less(m_triangles.points[vertex], origin_point(first)))) {
        first = *m_pairing.outgoing()[vertex].begin();
      }
    }
    for (Index component = 0; component < m_components.number(); ++component) {
      m_first[component] = first_halfedge(m_first[component], component);
    }
  }

  /// The halfedge around the origin of `start` that leads farthest from the centroid.
  Index first_halfedge(Index start, Index component) const
  {
    double greatest = 0;
    Index halfedge = start;
    do {
      greatest = std::max(greatest, squared_distance(target(halfedge), component));
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    Index result = no_index;
    do {
      if (squared_distance(target(halfedge), component) >= (1 - distance_tolerance) * greatest &&
          (result == no_index ||
           is_lexicographically_less(m_triangles.points[target(halfedge)], m_triangles.points[target(result)]))) {
        result = halfedge;
      }
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    return result;
  }

  Index next_around_origin(Index h) const { return m_pairing.twin(Halfedge_pairing::previous(h)); }

  /// Prefetches the data of the vertices that come soon: where their numbers are scattered, most of the time goes to
  /// waiting.
  void prefetch_rows([[maybe_unused]] const Numbering& numbering, [[maybe_unused]] std::size_t i) const
  {
#ifdef __GNUC__
    if (i + 2 * prefetch_distance < numbering.vertices.size()) {
      __builtin_prefetch(m_pairing.outgoing()[numbering.vertices[i + 2 * prefetch_distance]].begin());
      const auto row = m_pairing.outgoing()[numbering.vertices[i + prefetch_distance]];
      for (std::size_t j = 0; j < row.size(); j += 2) {
        __builtin_prefetch(&m_triangles.faces[row.begin()[j] / 3]);
      }
    }
#endif
  }

  /// Writes the neighbors of `vertex` to `ring`, counterclockwise.
  void read_ring(Index vertex, std::vector<Index>& ring) const
  {
    ring.clear();
    for (const Index halfedge : m_pairing.outgoing()[vertex]) {
      ring.push_back(target(halfedge));
    }
  }

  void append_component(Index first, Numbering& numbering) const
  {
    std::vector<Index> ring;
    std::size_t at = numbering.vertices.size();
    numbering.append(origin(first), target(first));
    for (; at < numbering.vertices.size(); ++at) {
      prefetch_rows(numbering, at);
      const Index vertex = numbering.vertices[at];
      read_ring(vertex, ring);
      std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), numbering.parent[at]), ring.end());
      for (const Index neighbor : ring) {
        numbering.append(neighbor, vertex);
      }
    }
  }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  const Surface_components& m_components;
  std::vector<double> m_greatest; // squared distance from the centroid, of every component
  std::vector<Index> m_first;     // the first halfedge of every component
};

/// Finds an order of the vertices that does not depend on their numbers nor, up to rounding and symmetry, on the pose
/// of the surface. O(n + c log c) for c components.
/// \pre `triangles` is closed, without isolated vertices; `pairing` and `components` are those of its faces
inline Canonical_order canonical_order(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                       const Surface_components& components)
{
  return Canonical_ordering(triangles, pairing, components).order();
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_SURFACE_COMPONENTS_H
