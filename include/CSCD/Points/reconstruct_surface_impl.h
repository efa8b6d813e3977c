// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates points by an advancing front and closes the triangles to a surface.

#ifndef CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
#define CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Surface_completion.h>
#include <CSCD/Points/insert_points.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Advancing_front_surface_reconstruction_cell_base_3.h>
#include <CGAL/Advancing_front_surface_reconstruction_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Turns faces, component by component, so that the two at an edge agree with each other and all with the first.
class Coherent_orientation
{
public:
  explicit Coherent_orientation(std::vector<std::array<Index, 3>>& faces)
      : m_faces(faces), m_opposite(3 * faces.size(), no_index), m_is_met(faces.size(), 0), m_is_turned(faces.size(), 0)
  {
  }

  void operator()()
  {
    find_opposite_sides();
    for (Index face = 0; face < m_faces.size(); ++face) {
      if (m_is_met[face] == 0) {
        flood(face);
      }
    }
    std::vector<std::array<Index, 3>> result;
    result.reserve(m_faces.size());
    for (Index face = 0; face < m_faces.size(); ++face) {
      if (!contradicts_later_face(face)) {
        const auto [a, b, c] = m_faces[face];
        result.push_back(m_is_turned[face] != 0 ? std::array<Index, 3>{a, c, b} : m_faces[face]);
      }
    }
    m_faces = std::move(result);
  }

private:
  /// A side of a face: side `number % 3` of face `number / 3`.
  struct Side
  {
    Index smaller_end;
    Index larger_end;
    Index number;

    bool operator<(const Side& other) const
    {
      return std::tie(smaller_end, larger_end, number) < std::tie(other.smaller_end, other.larger_end, other.number);
    }
  };

  void find_opposite_sides()
  {
    std::vector<Side> sides;
    sides.reserve(m_opposite.size());
    for (Index side = 0; side < m_opposite.size(); ++side) {
      const auto [smaller, larger] = std::minmax(origin(side), target(side));
      sides.push_back({smaller, larger, side});
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Side& side = sides[i - 1];
      const Side& next = sides[i];
      if (side.smaller_end == next.smaller_end && side.larger_end == next.larger_end) {
        m_opposite[side.number] = next.number;
        m_opposite[next.number] = side.number;
      }
    }
  }

  void flood(Index seed)
  {
    m_is_met[seed] = 1;
    m_stack.push_back(seed);
    while (!m_stack.empty()) {
      const Index face = m_stack.back();
      m_stack.pop_back();
      for (Index side = 3 * face; side < 3 * face + 3; ++side) {
        const Index neighbor = m_opposite[side] == no_index ? face : m_opposite[side] / 3;
        if (m_is_met[neighbor] == 0) {
          m_is_met[neighbor] = 1;
          m_is_turned[neighbor] = ascends(side) == ascends(m_opposite[side]) ? 1 : 0;
          m_stack.push_back(neighbor);
        }
      }
    }
  }

  const Index& origin(Index side) const { return m_faces[side / 3][side % 3]; }
  const Index& target(Index side) const { return m_faces[side / 3][(side + 1) % 3]; }
  /// Whether a side runs from its smaller to its larger end, once its face is turned.
  bool ascends(Index side) const { return (origin(side) < target(side)) != (m_is_turned[side / 3] != 0); }

  bool contradicts_later_face(Index face) const
  {
    const auto contradicts = [&](Index side) {
      const Index other = m_opposite[side];
      return other != no_index && other > side && ascends(side) == ascends(other);
    };
    return contradicts(3 * face) || contradicts(3 * face + 1) || contradicts(3 * face + 2);
  }

  std::vector<std::array<Index, 3>>& m_faces;
  std::vector<Index> m_opposite; // of every side, the other one at the same edge
  std::vector<char> m_is_met;
  std::vector<char> m_is_turned;
  std::vector<Index> m_stack;
};

/// Turns `faces` so that the two faces at an edge run through it in opposite directions; each component of faces that
/// are connected through edges keeps the direction of its first face. Where that cannot be, on a surface with one side,
/// faces are dropped. O(n log n).
/// \pre no edge has more than two faces
inline void orient_coherently(std::vector<std::array<Index, 3>>& faces)
{
  Coherent_orientation orientation(faces);
  orientation();
}

/// The number of a vertex or a cell of a triangulation, in the order of creation. CGAL compares handles to elements
/// with such numbers by the numbers, else by address.
class Time_stamp
{
public:
  // CGAL looks these names up.
  using Has_timestamp = CGAL::Tag_true;
  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(const std::size_t& time_stamp) { m_time_stamp = time_stamp; }

private:
  std::size_t m_time_stamp = std::size_t(-1); // not set yet, says CGAL
};

/// The border edges of a front, numbered in the order that the front met them, in each thread.
class Front_edge_numbers
{
public:
  /// Removes all edges: to be called before each reconstruction.
  static void clear() { numbers().clear(); }
  /// The number of an edge, the next one if it is met for the first time.
  static std::size_t number(const void* edge) { return numbers().emplace(edge, numbers().size()).first->second; }

private:
  static std::unordered_map<const void*, std::size_t>& numbers()
  {
    thread_local std::unordered_map<const void*, std::size_t> result;
    return result;
  }
};

/// The vertex base of CGAL's advancing front with another order of border edges. The front takes its edges from a set
/// that is ordered by priority and, where that is equal, by address, which differs from call to call; both edges of an
/// ear have equal priority, and so have all edges whose candidates are bad. Here the edge that was met first comes
/// first. The address serves as a name only: a front appends its edges to a list, and takes none away while it runs.
template <class Traits, class Base = CGAL::Triangulation_vertex_base_3<Traits>>
class Front_vertex_base : public CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>,
                          public Time_stamp
{
  using Front_base = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>;

public:
  // CGAL looks these names up.
  template <class Tds>
  struct Rebind_TDS // NOLINT(readability-identifier-naming): what CGAL calls
  {
    using Rebound_base = typename Base::template Rebind_TDS<Tds>::Other;
    using Other = Front_vertex_base<Traits, Rebound_base>;
  };

  struct Radius_ptr_type
  {
    using Criteria = typename Front_base::criteria;
    using Edge = typename Front_base::IO_edge_type;

    Radius_ptr_type(Criteria priority, Edge* edge)
        : first(priority), second(edge), number(Front_edge_numbers::number(edge))
    {
    }
    bool operator<(const Radius_ptr_type& other) const
    {
      return std::tie(first, number) < std::tie(other.first, other.number);
    }

    Criteria first;
    Edge* second;
    std::size_t number;
  };

  Front_vertex_base() { this->info() = std::size_t(-1); } // else undefined: no number of a point
};

/// The cell base of CGAL's advancing front, ordered by time: of the two cells at a facet, the front sees it from the
/// lesser one.
template <class Traits, class Base = CGAL::Delaunay_triangulation_cell_base_3<Traits>>
class Front_cell_base : public CGAL::Advancing_front_surface_reconstruction_cell_base_3<Traits, Base>, public Time_stamp
{
  using Front_base = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Traits, Base>;

public:
  // CGAL looks these names up.
  template <class Tds>
  struct Rebind_TDS // NOLINT(readability-identifier-naming): what CGAL calls
  {
    using Rebound_base = typename Base::template Rebind_TDS<Tds>::Other;
    using Other = Front_cell_base<Traits, Rebound_base>;
  };

  using Front_base::Front_base;
};

/// The limits of a triangle at a point.
struct Front_limit
{
  double longest_edge = 0;            ///< that a triangle may have at the point; if zero, the point is left out
  Vector_3 normal = Vector_3::Zero(); ///< of unit length and either orientation, or zero if it is not known
};

using Front_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Front_delaunay_triangulation = CGAL::Delaunay_triangulation_3<
    Front_kernel, CGAL::Triangulation_data_structure_3<Front_vertex_base<Front_kernel>, Front_cell_base<Front_kernel>>>;

/// A Delaunay triangulation that shows CGAL's front only those finite facets that may become triangles of the surface.
/// Most facets lie inside the body and are too long; the front looks through all of them for each component.
class Front_triangulation : public Front_delaunay_triangulation
{
public:
  using Finite_facets_iterator = std::vector<Facet>::const_iterator; // hides that of CGAL

  /// \param limits of each of `points`; referred to
  Front_triangulation(const std::vector<Vector_3>& points, const std::vector<Front_limit>& limits)
      : m_limits(&limits), m_has_normals(std::any_of(limits.begin(), limits.end(), [](const Front_limit& limit) {
          return limit.normal != Vector_3::Zero();
        }))
  {
    insert_points(*this, points);
  }

  Finite_facets_iterator finite_facets_begin()
  {
    collect_facets();
    return m_facets.begin();
  }
  Finite_facets_iterator finite_facets_end()
  {
    collect_facets();
    return m_facets.end();
  }

  void remove(Vertex_handle vertex)
  {
    m_is_collected = false;
    Front_delaunay_triangulation::remove(vertex);
  }

  /// Whether the facet `index` of a cell may become a triangle.
  bool is_allowed(Cell_handle cell, int index) const
  {
    const Vertex_handle a = cell->vertex((index + 1) & 3);
    const Vertex_handle b = cell->vertex((index + 2) & 3);
    const Vertex_handle c = cell->vertex((index + 3) & 3);
    return !is_too_long(a, b) && !is_too_long(b, c) && !is_too_long(c, a) &&
           !(m_has_normals && is_across_normals(a, b, c));
  }

private:
  /// The minimal cosine of the angle between a triangle and the surface at its corners, if that is known.
  static constexpr double min_cosine = 0.1;

  void collect_facets()
  {
    if (m_is_collected) {
      return;
    }
    m_facets.clear();
    for (auto cell = finite_cells_begin(); cell != finite_cells_end(); ++cell) {
      for (int i = 0; i < 4; ++i) {
        const Cell_handle neighbor = cell->neighbor(i);
        if (is_allowed(cell, i) && (is_infinite(neighbor) || Cell_handle(cell) < neighbor)) {
          m_facets.emplace_back(cell, i);
        }
      }
    }
    m_is_collected = true;
  }

  const Front_limit& limit(Vertex_handle vertex) const
  {
    // In a plane, the front adds a point of its own, to have a body.
    static const Front_limit none;
    return vertex->info() < m_limits->size() ? (*m_limits)[vertex->info()] : none;
  }

  bool is_too_long(Vertex_handle a, Vertex_handle b) const
  {
    const double at_a = limit(a).longest_edge;
    const double at_b = limit(b).longest_edge;
    const double longest = std::min(at_a, at_b) > 0 ? std::max(at_a, at_b) : 0;
    return CGAL::squared_distance(a->point(), b->point()) > longest * longest;
  }

  bool is_across_normals(Vertex_handle a, Vertex_handle b, Vertex_handle c) const
  {
    const auto vector = CGAL::cross_product(b->point() - a->point(), c->point() - a->point());
    const Vector_3 normal = Vector_3(vector.x(), vector.y(), vector.z()).stableNormalized();
    const auto is_across = [&](Vertex_handle vertex) {
      const Vector_3& given = limit(vertex).normal;
      return given != Vector_3::Zero() && std::abs(given.dot(normal)) < min_cosine;
    };
    return is_across(a) || is_across(b) || is_across(c);
  }

  const std::vector<Front_limit>* m_limits;
  bool m_has_normals;
  std::vector<Facet> m_facets;
  bool m_is_collected = false;
};

/// The priority of a triangle in the front: that of CGAL, the radius of its smallest empty sphere. Triangles with an
/// edge that is too long, or across the normals at its corners, are never taken.
struct Front_priority
{
  template <class AdvancingFront, class CellHandle>
  double operator()(const AdvancingFront& front, CellHandle& cell, const int& index) const
  {
    return front.triangulation_3().is_allowed(cell, index) ? front.smallest_radius_delaunay_sphere(cell, index)
                                                           : front.infinity();
  }
};

/// Triangulates a surface through `points`, and may leave some out; O(n log n) for points on a surface.
/// \param limits that triangles must respect at each point
/// \return triangles with consistent orientation in each component; each edge has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<Front_limit>& limits)
{
  Front_triangulation triangulation(points, limits);
  Front_edge_numbers::clear();
  CGAL::Advancing_front_surface_reconstruction<Front_triangulation, Front_priority> front(triangulation);
  front.run();
  Front_edge_numbers::clear();
  // CGAL also makes a surface of these triangles, but in an order, and at pinched vertices with an orientation, that
  // differ from call to call.
  std::vector<std::array<Index, 3>> result;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell) {
    for (int facet = 0; facet < 4; ++facet) {
      if (front.has_on_surface({cell, facet})) {
        const auto corner = [&](int i) { return Index(cell->vertex((facet + i) & 3)->id()); };
        result.push_back({corner(1), corner(2), corner(3)});
      }
    }
  }
  orient_coherently(result);
  return result;
}

/// Makes a closed surface of a cloud, step by step.
class Surface_reconstruction
{
public:
  explicit Surface_reconstruction(const Point_cloud& cloud)
      : m_cloud(cloud), m_neighbors(cloud.points, Cloud_sampling::number_of_neighbors),
        m_sampling(cloud.points, m_neighbors)
  {
    m_result.report.number_of_points = cloud.input_point.size();
    m_result.report.number_of_duplicates = cloud.number_of_duplicates();
    m_result.report.number_of_thinned_points = cloud.number_of_thinned_points;
    m_result.report.is_averaged = cloud.is_averaged;
    m_result.report.number_of_neighbors = m_neighbors.number();
    m_result.report.spacing = m_sampling.spacing() * cloud.normalization.unit;
    m_result.report.noise = m_sampling.noise();
    m_result.report.is_smoothed = m_sampling.is_smoothed();
    m_result.report.number_of_outliers = m_sampling.number_of_outliers();
  }

  /// \throw Surface_error if the points do not sample a surface; another Input_error if it is that of a body in slices
  Reconstructed_surface operator()()
  {
    // A triangulation of points along curves can be of quadratic size.
    if (lie_along_curves(m_cloud.points, m_sampling.spacing())) {
      refuse("they lie along curves; sample the surface more densely between them");
    }
    triangulate();
    Surface_completion complete(m_result, m_cloud.normalization);
    complete.prepare();
    check_border();
    complete();
    m_result.report.number_of_unused_points = m_cloud.points.size() - count_used_points();
    return std::move(m_result);
  }

private:
  /// The longest edge of a triangle, relative to how far the neighborhood of its ends reaches.
  static constexpr double longest_edge = 2;
  /// How far points are moved, for the triangulation only, relative to the reach of their neighborhoods: far more than
  /// rounding, far less than matters.
  static constexpr double jitter = 1e-6;
  /// A result with more border edges than this for each vertex is not a surface: curves have about one.
  static constexpr double max_border_edges = 0.6;
  void triangulate()
  {
    // The result of the front must not depend on the pose, nor, among equal triangles, on the addresses of their
    // points.
    std::vector<Vector_3> posed(m_sampling.points().size());
    std::vector<Front_limit> limits(m_sampling.points().size());
    for (Index point = 0; point < m_sampling.points().size(); ++point) {
      const double reach = m_cloud.pose.scale() * m_neighbors.reach(point);
      posed[point] = m_cloud.pose(m_sampling.points()[point]) + jitter * reach * pseudo_random_vector(point);
      limits[point].longest_edge = m_sampling.is_outlier(point) ? 0 : longest_edge * reach;
      if (!m_cloud.normals.empty()) {
        limits[point].normal = m_cloud.pose.turn(m_cloud.normals[point]);
      }
    }
    Indexed_triangles& triangles = m_result.triangles;
    triangles.points = m_sampling.points();
    triangles.faces = advance_front(posed, limits);
    if (triangles.faces.empty()) {
      throw Surface_error("no surface could be made of the points: they do not sample one densely enough");
    }
  }

  void check_border() const
  {
    const std::size_t number_of_vertices = m_result.triangles.points.size();
    if (double(m_result.report.number_of_border_edges) > max_border_edges * double(number_of_vertices)) {
      refuse("what connects them has " + std::to_string(m_result.report.number_of_border_edges) + " border edges at " +
             std::to_string(number_of_vertices) + " points; sample the surface more densely");
    }
  }

  [[noreturn]] void refuse(const std::string& reason) const
  {
    const std::string what = "the points do not sample a surface: ";
    if (lie_in_slices(m_cloud.points)) {
      throw Input_error(what + "they lie along curves in parallel planes, which are too far apart; add planes between");
    }
    throw Surface_error(what + reason);
  }

  std::size_t count_used_points() const
  {
    return m_result.point_of_vertex.size() -
           std::size_t(std::count(m_result.point_of_vertex.begin(), m_result.point_of_vertex.end(), no_index));
  }

  const Point_cloud& m_cloud;
  Neighbor_table m_neighbors;
  Cloud_sampling m_sampling;
  Reconstructed_surface m_result;
};

CSCD_INLINE Reconstructed_surface reconstruct_surface(const Point_cloud& cloud)
{
  return Surface_reconstruction(cloud)();
}

CSCD_INLINE std::vector<Index> vertices_of_points(const Triangulated_solid& solid, const Point_cloud& cloud,
                                                  const std::vector<Index>& point_of_vertex)
{
  std::vector<Index> result(cloud.points.size(), no_index);
  for (Index vertex = 0; vertex < solid.triangulation().number_of_vertices(); ++vertex) {
    const Index input = solid.input_vertex(vertex);
    if (input != no_index && point_of_vertex[input] != no_index) {
      result[point_of_vertex[input]] = vertex;
    }
  }
  assign_to_nearest(cloud.points, result);
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_RECONSTRUCT_SURFACE_IMPL_H
