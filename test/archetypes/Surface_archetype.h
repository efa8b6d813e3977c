// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Minimal models of SkeletonizationSurface and of SurfaceTriangulation.

#ifndef CSCD_TEST_ARCHETYPES_SURFACE_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SURFACE_ARCHETYPE_H

#include "support/Shape.h"
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A number that can be read, and nothing else.
class Number_archetype
{
public:
  explicit Number_archetype(double value) : m_value(value) {}
  operator double() const { return m_value; }

private:
  double m_value;
};

/// A range that can be traversed once, and nothing else.
class Halfedge_range_archetype
{
public:
  class Iterator
  {
  public:
    explicit Iterator(const Index* place) : m_place(place) {}
    Index operator*() const { return *m_place; }
    void operator++() { ++m_place; }
    bool operator!=(const Iterator& other) const { return m_place != other.m_place; }

  private:
    const Index* m_place;
  };

  explicit Halfedge_range_archetype(const std::vector<Index>& halfedges) : m_halfedges(halfedges) {}
  Iterator begin() const { return Iterator(m_halfedges.data()); }
  Iterator end() const { return Iterator(m_halfedges.data() + m_halfedges.size()); }

private:
  const std::vector<Index>& m_halfedges;
};

/// The triangles of a closed shape, in arrays of its own.
class Triangulation_archetype
{
public:
  explicit Triangulation_archetype(const Shape& shape) : m_outgoing(shape.points.size()), m_area(shape.points.size(), 0)
  {
    for (const Triple& p : shape.points) {
      m_points.emplace_back(p[0], p[1], p[2]);
    }
    std::map<std::pair<Index, Index>, Index> halfedge_between;
    for (const Triangle& t : shape.triangles) {
      const double area = (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]).norm() / 2;
      for (std::size_t k = 0; k < 3; ++k) {
        halfedge_between[{Index(t[k]), Index(t[(k + 1) % 3])}] = Index(m_ends.size());
        m_outgoing[t[k]].push_back(Index(m_ends.size()));
        m_ends.push_back({Index(t[k]), Index(t[(k + 1) % 3])});
        m_area[t[k]] += area / 3;
      }
    }
    for (const auto& [origin, target] : m_ends) {
      m_twins.push_back(halfedge_between.at({target, origin}));
    }
  }
  Triangulation_archetype(const Triangulation_archetype&) = delete;
  Triangulation_archetype& operator=(const Triangulation_archetype&) = delete;
  ~Triangulation_archetype() = default;

  Index number_of_vertices() const { return Index(m_points.size()); }
  Index number_of_halfedges() const { return Index(m_ends.size()); }
  Index number_of_faces() const { return Index(m_ends.size() / 3); }
  static Index face(Index halfedge) { return halfedge / 3; }
  static Index next(Index halfedge) { return halfedge / 3 * 3 + (halfedge + 1) % 3; }
  static Index previous(Index halfedge) { return halfedge / 3 * 3 + (halfedge + 2) % 3; }
  Index origin(Index halfedge) const { return m_ends[halfedge].first; }
  Index target(Index halfedge) const { return m_ends[halfedge].second; }
  Index twin(Index halfedge) const { return m_twins[halfedge]; }
  Halfedge_range_archetype outgoing(Index vertex) const { return Halfedge_range_archetype(m_outgoing[vertex]); }
  const std::vector<Vector3>& points() const { return m_points; }
  Number_archetype length(Index halfedge) const
  {
    return Number_archetype((m_points[target(halfedge)] - m_points[origin(halfedge)]).norm());
  }
  Number_archetype vertex_area(Index vertex) const { return Number_archetype(m_area[vertex]); }

private:
  std::vector<Vector3> m_points;
  std::vector<std::pair<Index, Index>> m_ends;
  std::vector<Index> m_twins;
  std::vector<std::vector<Index>> m_outgoing;
  std::vector<double> m_area;
};

/// A shape, and its body by the signed distance from a curve in its middle.
class Surface_archetype
{
public:
  /// \param nearest_of_middle gives the point of the middle that is nearest to a point \param radius of the body
  Surface_archetype(const Shape& shape, std::function<Vector3(const Vector3&)> nearest_of_middle, double radius)
      : m_triangulation(shape), m_nearest_of_middle(std::move(nearest_of_middle)), m_radius(radius)
  {
  }
  Surface_archetype(const Surface_archetype&) = delete;
  Surface_archetype& operator=(const Surface_archetype&) = delete;
  ~Surface_archetype() = default;

  const Triangulation_archetype& triangulation() const { return m_triangulation; }
  bool is_inside(const Vector3& p) const { return height(p) < 0; }
  std::optional<Vector3> middle_behind(const Vector3& p) const { return m_nearest_of_middle(p); }
  void crossings(const Vector3& p, const Vector3& q, std::vector<double>& distances) const
  {
    distances.clear();
    const double length = (q - p).norm();
    double last = height(p);
    for (double at = 0; at < length;) {
      at = std::min(length, at + std::max(std::fabs(last), 1e-6));
      const double here = height(p + at / length * (q - p));
      if ((here < 0) != (last < 0)) {
        distances.push_back(at);
      }
      last = here;
    }
  }

private:
  double height(const Vector3& p) const { return (p - m_nearest_of_middle(p)).norm() - m_radius; }

  Triangulation_archetype m_triangulation;
  std::function<Vector3(const Vector3&)> m_nearest_of_middle;
  double m_radius;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SURFACE_ARCHETYPE_H
