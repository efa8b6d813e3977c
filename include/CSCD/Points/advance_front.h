// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates points by CGAL's advancing front, with the same result in every process.

#ifndef CSCD_POINTS_ADVANCE_FRONT_H
#define CSCD_POINTS_ADVANCE_FRONT_H

#include <CSCD/Points/insert_points.h>
#include <CSCD/Points/orient_coherently.h>
#include <CSCD/Vector_3.h>

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
#include <tuple>
#include <unordered_map>
#include <vector>

namespace CSCD::internal {

/// The number of a vertex or a cell in the order in which those of a triangulation were made. CGAL compares handles to
/// elements with such numbers by them, else by address.
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

/// The order in which a front has met its border edges, in each thread.
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
/// ear have equal priority, and so have all whose candidates are bad. Here the edge that was met first comes first. The
/// address serves as a name only: a front keeps its edges in a list to which it appends, and never takes from, while it
/// runs.
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

/// What a triangle must respect at a point.
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

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param limits what triangles must respect at each point
/// \return triangles with consistent orientation in each component, each edge of which has at most two
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

} // namespace CSCD::internal

#endif // CSCD_POINTS_ADVANCE_FRONT_H
