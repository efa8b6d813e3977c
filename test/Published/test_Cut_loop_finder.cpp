// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a distance field to a loop: opposite targets, simple closed curves, stated reasons where there is none.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Cut_loop_outcome;
using CSCD::Index;
using CSCD::Target_rule;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Cut_criterion;
using CSCD::internal::Cut_locus_indicators;
using CSCD::internal::Cut_loop;
using CSCD::internal::Cut_loop_finder;
using CSCD::internal::Tangent_frames;
using CSCD::test::pi;
using CSCD::test::Shape;

/// Distance along an endless tube around the x axis from `source`, as the shorter way around.
double distance_on_tube(const Vector_3& source, const Vector_3& p)
{
  const double turn = std::fabs(std::atan2(p.z(), p.y()) - std::atan2(source.z(), source.y()));
  return std::hypot(p.x() - source.x(), std::min(turn, 2 * pi - turn));
}

/// A tube of radius 1 along the x axis, and the loops of its sources.
template <class Triangulation>
class Tube
{
public:
  explicit Tube(Triangulation&& surface)
      : m_surface(std::move(surface)), m_frames(m_surface), m_finder(m_frames, m_surface.points())
  {
  }

  const Triangulation& surface() const { return m_surface; }
  double edge() const { return m_frames.mean_edge_length(); }

  Cut_loop operator()(Index source, Target_rule rule = Target_rule::nearest_in_space, double factor = 1)
  {
    std::vector<double> distances;
    for (const Vector_3& p : m_surface.points()) {
      distances.push_back(factor * distance_on_tube(m_surface.point(source), p));
    }
    const Cut_locus_indicators<Triangulation> measures(m_frames, distances);
    Cut_loop loop;
    m_finder.find(
        measures, source, m_surface.point(source), rule, [&](Index v) { return measures.is_cut(v, Cut_criterion()); },
        loop);
    return loop;
  }

  /// The loop through `target`, as if it were the only cut point.
  Cut_loop through(Index source, Index target)
  {
    std::vector<double> distances;
    for (const Vector_3& p : m_surface.points()) {
      distances.push_back(distance_on_tube(m_surface.point(source), p));
    }
    const Cut_locus_indicators<Triangulation> measures(m_frames, distances);
    Cut_loop loop;
    m_finder.find(
        measures, source, m_surface.point(source), Target_rule::nearest_in_space, [&](Index v) { return v == target; },
        loop);
    return loop;
  }

  void expect_simple(const Cut_loop& loop) const
  {
    std::set<Index> passed;
    for (std::size_t i = 0; i < loop.halfedges.size(); ++i) {
      const Index h = loop.halfedges[i];
      EXPECT_EQ(m_surface.target(h), m_surface.origin(loop.halfedges[(i + 1) % loop.halfedges.size()]));
      EXPECT_TRUE(passed.insert(m_surface.origin(h)).second) << "a vertex comes twice";
    }
    EXPECT_EQ(m_surface.origin(loop.halfedges.front()), loop.target);
    EXPECT_EQ(passed.count(loop.base), 1u);
  }

  double length(const Cut_loop& loop) const
  {
    double sum = 0;
    for (const Index h : loop.halfedges) {
      sum += m_surface.length(h);
    }
    return sum;
  }

private:
  Triangulation m_surface;
  Tangent_frames<Triangulation> m_frames;
  Cut_loop_finder<Cut_locus_indicators<Triangulation>> m_finder;
};

TEST(Cut_loop_finder, goes_around_a_tube)
{
  for (const std::size_t around : {16u, 24u, 33u}) {
    Tube<Triangulated_surface> tube(
        CSCD::test::to_surface(CSCD::test::tube(10, 1, around, CSCD::test::Tube_end::flat)));
    for (Index source = 0; source < tube.surface().number_of_vertices(); source += 7) {
      const Vector_3 from = tube.surface().point(source);
      if (std::fabs(from.x() - 5) > 2) {
        continue;
      }
      for (const Target_rule rule : {Target_rule::nearest_in_space, Target_rule::nearest_along_surface}) {
        const Cut_loop loop = tube(source, rule);
        ASSERT_EQ(loop.outcome, Cut_loop_outcome::found);
        tube.expect_simple(loop);
        const Vector_3 target = tube.surface().point(loop.target);
        EXPECT_LT((target - Vector_3(from.x(), -from.y(), -from.z())).norm(), 1.1 * tube.edge());
        EXPECT_NEAR((target - from).norm(), 2, 0.1);
        EXPECT_NEAR(loop.distance, pi, 0.2);
        EXPECT_NEAR(loop.path_separation, 2 / pi, 0.1);
        EXPECT_GT(tube.length(loop), 2 * pi * 0.95);
        EXPECT_LT(tube.length(loop), 2 * pi * 1.25) << "ways along edges zigzag";
      }
    }
  }
}

TEST(Cut_loop_finder, states_why_there_is_no_loop)
{
  Tube<Triangulated_surface> tube(CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat)));
  const Triangulated_surface& surface = tube.surface();
  const Index source = CSCD::test::nearest_vertex(surface, {5, 0, 1});

  const Cut_loop short_cut = tube(source, Target_rule::nearest_in_space, 0.6);
  EXPECT_EQ(short_cut.outcome, Cut_loop_outcome::distance_below_chord);
  EXPECT_TRUE(short_cut.halfedges.empty());

  const Cut_loop beside = tube.through(source, CSCD::test::nearest_vertex(surface, {5, 1, 0}));
  EXPECT_NE(beside.outcome, Cut_loop_outcome::found) << "a quarter around, all fronts come from one side";
  EXPECT_EQ(tube.through(source, source).outcome, Cut_loop_outcome::no_cut_point) << "too near";
  EXPECT_EQ(tube.through(source, CSCD::no_index).outcome, Cut_loop_outcome::no_cut_point);

  // Far away along the tube, both ways come the same way most of the time.
  const Cut_loop far = tube.through(source, CSCD::test::nearest_vertex(surface, {9.5, 0, -1}));
  EXPECT_NE(far.outcome, Cut_loop_outcome::found);
}

TEST(Cut_loop_finder, takes_the_flat_side_of_an_elliptic_tube)
{
  // In space the opposite side is near; distances are those of a heat-like field, made by an exact formula along the
  // ellipse only as a table.
  const double width = 4;
  const Shape shape = CSCD::test::moved(CSCD::test::tube(20, 1, 64, CSCD::test::Tube_end::flat), [&](const auto& p) {
    return CSCD::test::Triple{p[0], width * p[1], p[2]};
  });
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  const Tangent_frames<Triangulated_surface> frames(surface);
  // The arc of the ellipse from its highest point, by the angle of the circle that it was.
  constexpr std::size_t steps = 6400;
  std::vector<double> arc(steps + 1, 0);
  for (std::size_t i = 0; i < steps; ++i) {
    const double a = 2 * pi * (double(i) + 0.5) / steps;
    arc[i + 1] = arc[i] + std::hypot(width * std::cos(a), std::sin(a)) * 2 * pi / steps;
  }
  std::vector<double> distances;
  for (const Vector_3& p : surface.points()) {
    double angle = std::atan2(p.y() / width, p.z());
    angle += angle < 0 ? 2 * pi : 0;
    const double around = arc[std::size_t(std::lround(angle / (2 * pi) * steps))];
    distances.push_back(std::hypot(p.x() - 10, std::min(around, arc.back() - around)));
  }
  const Cut_locus_indicators<Triangulated_surface> measures(frames, distances);
  Cut_loop_finder<Cut_locus_indicators<Triangulated_surface>> finder(frames, surface.points());
  Index source = 0;
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    source = distances[v] < distances[source] ? v : source;
  }
  Cut_loop loop;
  finder.find(
      measures, source, surface.point(source), Target_rule::nearest_in_space,
      [&](Index v) { return measures.is_cut(v, Cut_criterion()); }, loop);
  ASSERT_EQ(loop.outcome, Cut_loop_outcome::found);
  const Vector_3 target = surface.point(loop.target);
  EXPECT_NEAR(target.z(), -1, 0.05);
  EXPECT_NEAR(target.y(), 0, 0.5);
  EXPECT_NEAR(target.x(), 10, 0.5);
  EXPECT_NEAR(loop.distance, arc.back() / 2, 0.2);
}

TEST(Cut_loop_finder, runs_along_intrinsic_edges)
{
  // Triangles several times as long as wide, of which Delaunay flips make better ones.
  for (const Shape& shape :
       {CSCD::test::anisotropic_tube(10, 1, 64, 24), CSCD::test::anisotropic_tube(10, 1, 16, 80)}) {
    using Triangulation = CSCD::internal::Intrinsic_triangulation<Triangulated_surface>;
    const Triangulated_surface surface = CSCD::test::to_surface(shape);
    Triangulation triangulation(surface);
    triangulation.make_delaunay();
    const Tangent_frames<Triangulation> frames(triangulation);
    Cut_loop_finder<Cut_locus_indicators<Triangulation>> finder(frames, surface.points());
    CSCD::internal::Heat_method::Workspace workspace;
    const CSCD::internal::Heat_method heat(triangulation);
    std::size_t number_of_loops = 0;
    for (Index source = 0; source < surface.number_of_vertices(); source += 13) {
      std::vector<double> distances;
      heat({CSCD::internal::Geodesic_source::at_vertex(source)}, distances, workspace);
      const Cut_locus_indicators<Triangulation> measures(frames, distances);
      Cut_loop loop;
      finder.find(
          measures, source, surface.point(source), Target_rule::nearest_in_space,
          [&](Index v) { return measures.is_cut(v, Cut_criterion()); }, loop);
      if (loop.outcome != Cut_loop_outcome::found) {
        continue;
      }
      ++number_of_loops;
      double turn = 0;
      for (const Index h : loop.halfedges) {
        const Vector_3& a = surface.point(triangulation.origin(h));
        const Vector_3& b = surface.point(triangulation.target(h));
        turn += std::remainder(std::atan2(b.z(), b.y()) - std::atan2(a.z(), a.y()), 2 * pi);
      }
      const double length = *std::max_element(shape.points.begin(), shape.points.end())->begin();
      if (surface.point(source).x() > 3 && surface.point(source).x() < length - 3) {
        EXPECT_NEAR(std::fabs(turn), 2 * pi, 1e-6) << "it goes around the tube";
      }
    }
    EXPECT_GT(number_of_loops, 10u);
  }
}

} // namespace
