// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From points to triangles between them: CGAL's advancing front, kept from growing sheets across gaps.

#ifndef CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
#define CSCD_RECONSTRUCTION_ADVANCE_FRONT_H

#include <CSCD/internal/Vector_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// What a triangle must respect at a point.
struct Front_limit
{
  /// That a triangle may have at the point; if zero, the point is left out.
  double longest_edge = 0;            ///< that a triangle may have at the point
  Vector_3 normal = Vector_3::Zero(); ///< of unit length and either orientation, or zero if it is not known
};

/// The priority of a triangle in the front: that of CGAL, the radius of its smallest empty sphere. Triangles with an
/// edge that is too long, or across the normals at its corners, are never taken.
class Front_priority
{
public:
  explicit Front_priority(const std::vector<Front_limit>& limits) : m_limits(&limits) {}

  template <class AdvancingFront, class CellHandle>
  double operator()(const AdvancingFront& front, CellHandle& cell, const int& index) const
  {
    const double radius = front.smallest_radius_delaunay_sphere(cell, index);
    if (radius == front.infinity()) {
      return radius;
    }
    const auto corner = [&](int i) { return cell->vertex((index + 1 + i % 3) & 3); };
    for (int i = 0; i < 3; ++i) {
      const double at_source = limit(corner(i)).longest_edge;
      const double at_target = limit(corner(i + 1)).longest_edge;
      const double longest = std::min(at_source, at_target) > 0 ? std::max(at_source, at_target) : 0;
      if (CGAL::squared_distance(corner(i)->point(), corner(i + 1)->point()) > longest * longest) {
        return front.infinity();
      }
    }
    if (is_across_normals(corner(0), corner(1), corner(2))) {
      return front.infinity();
    }
    return radius * (1 + tie_break(corner(0)->info(), corner(1)->info(), corner(2)->info()));
  }

private:
  /// The least cosine of the angle between a triangle and the surface at its corners, if that is known.
  static constexpr double least_cosine = 0.1;

  template <class VertexHandle>
  const Front_limit& limit(VertexHandle vertex) const
  {
    return (*m_limits)[vertex->info()];
  }

  template <class VertexHandle>
  bool is_across_normals(VertexHandle a, VertexHandle b, VertexHandle c) const
  {
    const auto vector = CGAL::cross_product(b->point() - a->point(), c->point() - a->point());
    const Vector_3 normal = Vector_3(vector.x(), vector.y(), vector.z()).stableNormalized();
    const auto is_across = [&](VertexHandle vertex) {
      const Vector_3& given = limit(vertex).normal;
      return given != Vector_3::Zero() && std::abs(given.dot(normal)) < least_cosine;
    };
    return is_across(a) || is_across(b) || is_across(c);
  }

  /// A number between 0 and 1e-10 that hangs on the corners alone: equal triangles, as on a grid, would else be taken
  /// in the order of their addresses.
  static double tie_break(std::size_t a, std::size_t b, std::size_t c)
  {
    std::array<std::size_t, 3> corners{a, b, c};
    std::sort(corners.begin(), corners.end());
    std::uint32_t hash = 0;
    for (std::size_t corner : corners) {
      hash = (hash ^ std::uint32_t(corner)) * 2654435761u; // Knuth's multiplier
      hash ^= hash >> 15;
    }
    return 1e-10 * double(hash) / double(std::numeric_limits<std::uint32_t>::max());
  }

  const std::vector<Front_limit>* m_limits;
};

/// Triangulates a surface through `points`, some of which may be left out; O(n log n) for points on a surface.
/// \param limits what triangles must respect at each point
/// \return triangles with consistent orientation in each component, each edge of which has at most two
inline std::vector<std::array<Index, 3>> advance_front(const std::vector<Vector_3>& points,
                                                       const std::vector<Front_limit>& limits)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> cgal_points;
  cgal_points.reserve(points.size());
  for (const Vector_3& point : points) {
    cgal_points.emplace_back(point.x(), point.y(), point.z());
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(cgal_points.begin(), cgal_points.end(), std::back_inserter(triangles),
                                               Front_priority(limits));
  std::vector<std::array<Index, 3>> result;
  result.reserve(triangles.size());
  for (const std::array<std::size_t, 3>& t : triangles) {
    result.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_ADVANCE_FRONT_H
