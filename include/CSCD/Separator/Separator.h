// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One separator: the closed curve, its measures, and the loop along edges that it comes from.

#ifndef CSCD_SEPARATOR_SEPARATOR_H
#define CSCD_SEPARATOR_SEPARATOR_H

#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD {

/// A local separator: a simple closed curve on the surface, given by the edges that it crosses, with its measures in
/// the normalized frame of the traits object.
struct Separator
{
  /// The crossings in order along the curve. On a mesh, consecutive ones lie in one face, the last and the first too;
  /// on a point cloud they have an end in common, or ends that are neighbors.
  std::vector<Edge_crossing> crossings;
  /// The points of a curve that passes the crossed edges at a distance, as on a point cloud. Any other curve is the
  /// polygon of its crossings. `Curve_skeletonization::polyline()` gives the points of either.
  std::optional<std::vector<Vector3>> points;
  /// Length of the curve.
  double length = 0;
  /// Mean of its points by length.
  Vector3 center = Vector3::Zero();
  /// Unit normal of the vector area of the curve; the left side of the curve lies on its positive side.
  Vector3 normal = Vector3::UnitZ();
  /// Norm of the vector area: the area that a planar curve encloses.
  double area = 0;
  /// Root mean square distance of the curve from its mean plane, relative to its length.
  double planarity = 0;
  /// Whether it leads from border to border of a sheet, there on one side of it and back on the other.
  bool is_open = false;
  /// Its source, a vertex of the finest surface.
  Index source = no_index;

  /// Radius of the circle of the same length.
  double radius() const { return length / (2 * boost::math::double_constants::pi); }
  /// The isoperimetric quotient: 1 for a circle, less for all other curves.
  double roundness() const { return 4 * boost::math::double_constants::pi * area / (length * length); }
};

/// How the search for the separator of one source ended.
enum class Search_outcome
{
  found,     ///< a separator was found
  no_cut,    ///< no acceptable cut point was met
  bump,      ///< the loop only encircles a bump
  degenerate ///< the loop is not a simple curve of enough edges, or shrank to a point
};

/// The result of the search for the separator of one source.
struct Search_result
{
  Search_outcome outcome = Search_outcome::no_cut; ///< how the search ended
  Separator separator;                             ///< where one was found
  bool is_section = false; ///< whether it was shortened by the section plane, else by straightening
  Index level = 0;         ///< the level of detail that decided
};

} // namespace CSCD

namespace CSCD::internal {

/// The halfedge that stands for the edge of `halfedge`: the smaller one of the two.
template <class Surface>
Index edge_of(const Surface& surface, Index halfedge)
{
  return std::min<Index>(halfedge, surface.twin(halfedge));
}

/// The point where `crossing` lies.
/// \tparam Surface a model of `SurfaceTriangulation`, or `Point_complex`
template <class Surface>
Vector3 crossing_point(const Surface& surface, const Edge_crossing& crossing)
{
  return (1 - crossing.position) * surface.points()[surface.origin(crossing.halfedge)] +
         crossing.position * surface.points()[surface.target(crossing.halfedge)];
}

/// Writes the points of `crossings` to `points`, which is reused.
template <class Surface>
void crossing_points(const Surface& surface, const std::vector<Edge_crossing>& crossings, std::vector<Vector3>& points)
{
  points.resize(crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    points[i] = crossing_point(surface, crossings[i]);
  }
}

/// Writes the points of the curve of `separator` to `points`, which is reused.
template <class Surface>
void curve_points(const Surface& surface, const Separator& separator, std::vector<Vector3>& points)
{
  if (separator.points) {
    points = *separator.points;
  } else {
    crossing_points(surface, separator.crossings, points);
  }
}

/// The curve of `separator` in the coordinates of the input.
template <class Triangulation>
std::vector<Vector3> to_input(const Separator& separator, const Triangulation& triangulation,
                              const Normalization& normalization)
{
  std::vector<Vector3> points;
  curve_points(triangulation, separator, points);
  for (Vector3& point : points) {
    point = normalization.to_input(point);
  }
  return points;
}

/// The sides of a sheet that the curve of `crossings` passes: bit 0 for the first, bit 1 for the second. An open
/// separator is a curve around a doubled sheet, and passes both.
/// \param side_of_sheet returns 1 or 2 for a vertex on a sheet, else 0
template <class Surface, class Sides>
unsigned sides_of_sheet(const Surface& surface, const Sides& side_of_sheet, const std::vector<Edge_crossing>& crossings)
{
  unsigned sides = 0;
  for (const Edge_crossing& crossing : crossings) {
    sides |= unsigned(side_of_sheet(surface.origin(crossing.halfedge)));
    sides |= unsigned(side_of_sheet(surface.target(crossing.halfedge)));
  }
  return sides;
}

/// Sets whether `separator` of `solid` is open.
template <class Solid>
void mark_open([[maybe_unused]] const Solid& solid, [[maybe_unused]] Separator& separator)
{
  if constexpr (CSCD_IS_VALID(const Solid&, t.side_of_sheet(Index()))) {
    const auto side = [&solid](Index vertex) { return solid.side_of_sheet(vertex); };
    separator.is_open =
        solid.number_of_sheets() > 0 && sides_of_sheet(solid.triangulation(), side, separator.crossings) == 3;
  }
}

/// Removes pairs of consecutive crossings that go through an edge and straight back, also where the end of the closed
/// curve meets its beginning. Linear.
template <class Surface>
void cancel_backtracks(const Surface& surface, std::vector<Edge_crossing>& crossings)
{
  const auto cancels = [&surface](const Edge_crossing& a, const Edge_crossing& b) {
    return a.halfedge == surface.twin(b.halfedge);
  };
  std::size_t size = 0;
  for (const Edge_crossing& crossing : crossings) {
    if (size > 0 && cancels(crossings[size - 1], crossing)) {
      --size;
    } else {
      crossings[size++] = crossing;
    }
  }
  std::size_t stem = 0;
  while (2 * stem + 2 <= size && cancels(crossings[size - 1 - stem], crossings[stem])) {
    ++stem;
  }
  crossings.resize(size - stem);
  crossings.erase(crossings.begin(), crossings.begin() + std::ptrdiff_t(stem));
}

/// The measures of a closed polygon.
struct Polygon_measures
{
  double length = 0;
  Vector3 center = Vector3::Zero();      ///< mean by length
  Vector3 vector_area = Vector3::Zero(); ///< half the sum of the cross products of consecutive points
  double planarity = 0;                  ///< root mean square distance from the mean plane, relative to the length
};

/// Measures the closed polygon `points`; linear.
inline Polygon_measures measure_polygon(const std::vector<Vector3>& points)
{
  Polygon_measures result;
  const std::size_t size = points.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Vector3& a = points[i];
    const Vector3& b = points[i + 1 < size ? i + 1 : 0];
    const double length = (b - a).norm();
    result.length += length;
    result.center += length / 2 * (a + b);
  }
  if (!(result.length > 0)) {
    result.center = size == 0 ? Vector3(Vector3::Zero()) : points.front();
    return result;
  }
  result.center /= result.length;
  for (std::size_t i = 0; i < size; ++i) {
    const Vector3& b = points[i + 1 < size ? i + 1 : 0];
    result.vector_area += (points[i] - result.center).cross(b - result.center) / 2;
  }
  const Vector3 normal = result.vector_area.normalized();
  double squared_deviation = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double length = (points[i + 1 < size ? i + 1 : 0] - points[i]).norm();
    const double height = (points[i] - result.center).dot(normal);
    squared_deviation += length * height * height;
  }
  result.planarity = std::sqrt(squared_deviation / result.length) / result.length;
  return result;
}

/// Sets the measures of `separator`.
inline void set_measures(Separator& separator, const Polygon_measures& measures)
{
  separator.length = measures.length;
  separator.center = measures.center;
  separator.area = measures.vector_area.norm();
  separator.normal = separator.area > 0 ? Vector3(measures.vector_area / separator.area) : Vector3(Vector3::UnitZ());
  separator.planarity = measures.planarity;
}

/// Sets the measures of `separator` to those of the closed polygon `points`.
inline void set_measures(Separator& separator, const std::vector<Vector3>& points)
{
  set_measures(separator, measure_polygon(points));
}

/// Writes to `crossings` the edges that `loop` crosses when it is pushed a little to its left.
/// \return whether consecutive vertices are neighbors and at least three edges are crossed
inline bool push_off(const Triangulated_surface& surface, const Vertex_loop& loop,
                     std::vector<Edge_crossing>& crossings)
{
  // Distance from the loop, relative to the length of the crossed edge.
  constexpr double offset = 0.15;
  crossings.clear();
  const std::size_t size = loop.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Index before = loop[(i + size - 1) % size];
    const Index after = loop[(i + 1) % size];
    const Index forward = surface.find_halfedge(loop[i], after);
    if (forward == no_index || before == after || surface.find_halfedge(loop[i], before) == no_index) {
      return false;
    }
    const std::size_t first_here = crossings.size();
    for (Index h = surface.next_around_origin(forward); surface.target(h) != before;
         h = surface.next_around_origin(h)) {
      crossings.push_back({h, offset});
    }
    // The incident edges were collected from the way out to the way in.
    std::reverse(crossings.begin() + std::ptrdiff_t(first_here), crossings.end());
  }
  return crossings.size() >= 3;
}

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_SEPARATOR_H
