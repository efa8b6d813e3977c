// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every intrinsic triangulation of a surface has to hold, whatever was flipped.

#ifndef CSCD_TEST_SURFACE_EXPECT_CONSISTENT_H
#define CSCD_TEST_SURFACE_EXPECT_CONSISTENT_H

#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CSCD::test {

using Intrinsic_surface = CSCD::internal::Intrinsic_triangulation<CSCD::Triangulated_surface>;

/// The points of the line along `halfedge` over the input, both ends included.
inline std::vector<CSCD::Vector_3> traced_points(const Intrinsic_surface& triangulation, CSCD::Index halfedge)
{
  const auto& surface = triangulation.input();
  CSCD::internal::Edge_trace trace;
  triangulation.trace(halfedge, trace);
  std::vector<CSCD::Vector_3> points{surface.point(triangulation.origin(halfedge))};
  for (const CSCD::Edge_crossing& crossing : trace.crossings()) {
    points.push_back((1 - crossing.position) * surface.point(surface.origin(crossing.halfedge)) +
                     crossing.position * surface.point(surface.target(crossing.halfedge)));
  }
  points.push_back(surface.point(triangulation.target(halfedge)));
  return points;
}

inline double length_of(const std::vector<CSCD::Vector_3>& points)
{
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += (points[i] - points[i - 1]).norm();
  }
  return sum;
}

/// The edges that `halfedge` crosses are a strip of faces from its origin to its target.
template <class Triangulation>
void expect_strip(const Triangulation& crossed, CSCD::Index first_corner, CSCD::Index target,
                  const std::vector<CSCD::Edge_crossing>& crossings)
{
  using CSCD::Index;
  Index face = Triangulation::face(first_corner);
  ASSERT_EQ(crossings.front().halfedge, Triangulation::next(first_corner));
  for (const CSCD::Edge_crossing& crossing : crossings) {
    ASSERT_EQ(Triangulation::face(crossing.halfedge), face);
    ASSERT_TRUE(crossing.position > 0 && crossing.position < 1);
    face = Triangulation::face(crossed.twin(crossing.halfedge));
  }
  ASSERT_EQ(crossed.opposite_vertex(crossed.twin(crossings.back().halfedge)), target);
}

/// Halfedges are paired.
inline void expect_paired(const Intrinsic_surface& triangulation)
{
  using CSCD::Index;
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    const Index twin = triangulation.twin(h);
    if (twin != CSCD::no_index) {
      ASSERT_EQ(triangulation.twin(twin), h);
      ASSERT_EQ(triangulation.origin(twin), triangulation.target(h));
      ASSERT_EQ(triangulation.length(twin), triangulation.length(h));
      ASSERT_EQ(triangulation.number_of_crossings(twin), triangulation.number_of_crossings(h));
    }
  }
}

/// Every edge can be traced over the input, from both ends alike, and is as long as it says.
inline void expect_traceable(const Intrinsic_surface& triangulation, double tolerance)
{
  using CSCD::Index;
  const auto& surface = triangulation.input();
  CSCD::internal::Edge_trace trace;
  CSCD::internal::Edge_trace reverse;
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    triangulation.trace(h, trace);
    const auto& crossings = trace.crossings();
    const Index corner = triangulation.input_halfedge(h);
    ASSERT_EQ(surface.origin(corner), triangulation.origin(h));
    ASSERT_EQ(crossings.size(), triangulation.number_of_crossings(h));
    ASSERT_EQ(crossings.empty(), triangulation.is_input_edge(h));
    // A face that was a line is, with the length d added to its sides, about sqrt(d * length) high.
    const double mollification =
        double(crossings.size() + 1) * std::sqrt(triangulation.added_length() * triangulation.length(h));
    ASSERT_NEAR(length_of(traced_points(triangulation, h)), triangulation.length(h),
                tolerance * triangulation.length(h) + mollification);
    if (crossings.empty()) {
      ASSERT_EQ(surface.target(corner), triangulation.target(h));
      continue;
    }
    expect_strip(surface, corner, triangulation.target(h), crossings);
    triangulation.trace(triangulation.twin(h), reverse);
    ASSERT_EQ(reverse.crossings().size(), crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const CSCD::Edge_crossing& back = reverse.crossings()[crossings.size() - 1 - i];
      ASSERT_EQ(back.halfedge, surface.twin(crossings[i].halfedge));
      ASSERT_NEAR(back.position, 1 - crossings[i].position, tolerance);
    }
  }
}

/// The input edges cross those edges of the triangulation that cross them, in an order that is a strip of its faces.
inline void expect_crossed_mutually(const Intrinsic_surface& triangulation)
{
  using CSCD::Edge_crossing;
  using CSCD::Index;
  const auto& surface = triangulation.input();
  CSCD::internal::Edge_trace trace;
  // Of every input halfedge: those it crosses from left to right, with the place on it.
  std::vector<std::vector<Edge_crossing>> crossings(surface.number_of_halfedges());
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    triangulation.trace(h, trace);
    for (const Edge_crossing& crossing : trace.crossings()) {
      crossings[crossing.halfedge].push_back({triangulation.twin(h), crossing.position});
    }
  }
  for (Index g = 0; g < triangulation.number_of_halfedges(); ++g) {
    ASSERT_EQ(crossings[g].size(), crossings[surface.twin(g)].size()) << "input halfedge " << g;
    if (!crossings[g].empty()) {
      std::sort(crossings[g].begin(), crossings[g].end(),
                [](const Edge_crossing& a, const Edge_crossing& b) { return a.position < b.position; });
      const Index corner = Intrinsic_surface::previous(crossings[g].front().halfedge);
      ASSERT_EQ(triangulation.origin(corner), surface.origin(g));
      expect_strip(triangulation, corner, surface.target(g), crossings[g]);
    }
  }
}

inline double face_area(const Intrinsic_surface& triangulation, CSCD::Index face)
{
  return CSCD::internal::flat_triangle(triangulation, 3 * face).area();
}

/// For every vertex, the sum of the angles of its faces there: 2 pi where the surface is flat.
template <class Triangulation>
std::vector<double> vertex_angles(const CSCD::internal::Intrinsic_triangulation<Triangulation>& triangulation)
{
  std::vector<double> sums(triangulation.number_of_vertices(), 0.);
  for (CSCD::Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    sums[triangulation.origin(h)] += triangulation.angle(h);
  }
  return sums;
}

inline double total_area(const Intrinsic_surface& triangulation)
{
  double sum = 0;
  for (CSCD::Index f = 0; f < triangulation.number_of_faces(); ++f) {
    sum += face_area(triangulation, f);
  }
  return sum;
}

/// What flips must not change.
struct Invariants
{
  explicit Invariants(const Intrinsic_surface& triangulation)
      : area(total_area(triangulation)), angles(vertex_angles(triangulation))
  {
  }

  void expect_of(const Intrinsic_surface& triangulation, double tolerance) const
  {
    const Invariants other(triangulation);
    EXPECT_NEAR(other.area, area, tolerance * area);
    for (std::size_t vertex = 0; vertex < angles.size(); ++vertex) {
      ASSERT_NEAR(other.angles[vertex], angles[vertex], tolerance) << "vertex " << vertex;
    }
  }

  double area;
  std::vector<double> angles; // of the vertices
};

/// All of the above.
inline void expect_consistent(const Intrinsic_surface& triangulation, const Invariants& invariants, double tolerance)
{
  expect_paired(triangulation);
  expect_traceable(triangulation, tolerance);
  expect_crossed_mutually(triangulation);
  invariants.expect_of(triangulation, tolerance);
}

} // namespace CSCD::test

#endif // CSCD_TEST_SURFACE_EXPECT_CONSISTENT_H
