// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles that are coarsened in blocks keep their topology, their borders, and what is no manifold.

#include "Surface/to_indexed_triangles.h"
#include "support/Allow_threads.h"
#include "support/shape_operations.h"
#include "support/shapes.h"
#include "support/simple_shapes.h"
#include "support/swept_shapes.h"
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/coarsen_triangles.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Indexed_triangles;
using CSCD::Vector_3;
using CSCD::test::Shape;

/// Points of a block: so few that small shapes have several blocks.
constexpr std::size_t small_block = 400;

/// Triangles in the form in which they are coarsened.
struct Soup
{
  explicit Soup(const Shape& shape)
  {
    Indexed_triangles triangles = CSCD::test::to_indexed_triangles(shape);
    points = triangles.points;
    for (const std::array<Index, 3>& face : triangles.faces) {
      add(face);
    }
  }

  void add(const std::array<Index, 3>& face) { corners.insert(corners.end(), face.begin(), face.end()); }

  std::vector<Index> coarsen(std::size_t size, unsigned number_of_threads = 1)
  {
    return CSCD::coarsen_triangles(points, corners, size, number_of_threads, small_block);
  }

  Indexed_triangles triangles() const
  {
    Indexed_triangles result;
    result.points = points;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      result.faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    result.first_hole_filling_face = result.faces.size();
    return result;
  }

  /// The places of the corners of a triangle, the least of them first.
  std::array<std::array<double, 3>, 3> places(std::size_t triangle) const
  {
    std::array<std::array<double, 3>, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector_3& p = points[corners[3 * triangle + i]];
      result[i] = {p.x(), p.y(), p.z()};
    }
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<Vector_3> points;
  std::vector<Index> corners;
};

struct Facts
{
  bool is_manifold = false;
  long euler_number = 0;
  std::size_t number_of_components = 0;
  std::set<std::array<double, 6>> border; ///< the ends of its sides
};

Facts facts(const Soup& soup)
{
  const Indexed_triangles triangles = soup.triangles();
  const CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  Facts result;
  result.is_manifold = pairing.conflict() == CSCD::no_index && pairing.pinched_vertex() == CSCD::no_index;
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    if (pairing.twin(h) == CSCD::no_index) {
      const Vector_3& a = triangles.points[soup.corners[h]];
      const Vector_3& b = triangles.points[soup.corners[CSCD::Halfedge_pairing::next(h)]];
      result.border.insert({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
    }
  }
  result.number_of_components = CSCD::internal::Surface_components(triangles).number();
  result.euler_number = long(triangles.points.size()) - long(pairing.number_of_halfedges() + result.border.size()) / 2 +
                        long(triangles.faces.size());
  return result;
}

void expect_same_topology(const Soup& fine, const Soup& coarse)
{
  const Facts before = facts(fine);
  const Facts after = facts(coarse);
  EXPECT_TRUE(after.is_manifold);
  EXPECT_EQ(before.euler_number, after.euler_number);
  EXPECT_EQ(before.number_of_components, after.number_of_components);
  EXPECT_EQ(before.border, after.border);
}

/// Expects every point to go to one that stays, and those that stay to keep their places.
void expect_map(const Soup& fine, const Soup& coarse, const std::vector<Index>& coarse_point)
{
  ASSERT_EQ(fine.points.size(), coarse_point.size());
  std::vector<std::size_t> number_at_place(coarse.points.size(), 0);
  for (std::size_t i = 0; i < fine.points.size(); ++i) {
    ASSERT_LT(coarse_point[i], coarse.points.size());
    number_at_place[coarse_point[i]] += fine.points[i] == coarse.points[coarse_point[i]] ? 1 : 0;
  }
  EXPECT_EQ(0, std::count(number_at_place.begin(), number_at_place.end(), 0));
}

TEST(Coarsen_triangles, keeps_topology_and_borders)
{
  std::vector<CSCD::test::Shape_maker> makers = CSCD::test::hard_closed_shapes();
  for (const CSCD::test::Shape_maker& maker : CSCD::test::open_shapes()) {
    makers.push_back(maker);
  }
  for (const CSCD::test::Shape_maker& maker : makers) {
    SCOPED_TRACE(maker.name);
    const Soup fine(maker.make());
    Soup coarse = fine;
    const std::vector<Index> coarse_point = coarse.coarsen(fine.points.size() / 10);
    expect_same_topology(fine, coarse);
    expect_map(fine, coarse, coarse_point);
  }
}

TEST(Coarsen_triangles, ends_at_the_bound)
{
  const Soup fine(CSCD::test::torus(3, 1, 40));
  Soup coarse = fine;
  EXPECT_TRUE(coarse.coarsen(fine.points.size()).empty());
  EXPECT_EQ(fine.points, coarse.points);
  EXPECT_EQ(fine.corners, coarse.corners);
  coarse.coarsen(fine.points.size() - 1);
  EXPECT_LT(coarse.points.size(), fine.points.size() * 3 / 4);
  EXPECT_GT(coarse.points.size(), fine.points.size() / 5);
  coarse = fine;
  coarse.coarsen(fine.points.size() / 10);
  EXPECT_LE(coarse.points.size(), fine.points.size() / 10);
}

TEST(Coarsen_triangles, is_the_same_for_any_number_of_threads)
{
  const CSCD::test::Allow_threads allow(3);
  const Soup fine(CSCD::test::torus(3, 1, 40));
  Soup one = fine;
  Soup three = fine;
  EXPECT_EQ(one.coarsen(fine.points.size() / 20), three.coarsen(fine.points.size() / 20, 3));
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.corners, three.corners);
}

TEST(Coarsen_triangles, keeps_what_is_no_manifold)
{
  // Two spheres that touch in a point, with a fin, a triangle that stands twice, and one that names a point twice.
  const Shape sphere = CSCD::test::sphere(4);
  Soup fine(CSCD::test::merged("two spheres", {sphere, CSCD::test::translated(sphere, {5, 0, 0})}));
  const auto half = Index(sphere.points.size());
  std::replace(fine.corners.begin(), fine.corners.end(), half, Index(0));
  const std::size_t first = fine.corners.size() / 3;
  fine.points.emplace_back(0, 0, 9);
  fine.add({fine.corners[30], fine.corners[31], Index(fine.points.size() - 1)});
  fine.add({fine.corners[90], fine.corners[91], fine.corners[92]});
  fine.add({fine.corners[150], fine.corners[150], fine.corners[151]});
  Soup coarse = fine;
  const std::vector<Index> coarse_point = coarse.coarsen(fine.points.size() / 3);
  EXPECT_LT(coarse.points.size(), fine.points.size() / 2);
  expect_map(fine, coarse, coarse_point);
  std::multiset<std::array<std::array<double, 3>, 3>> places;
  for (std::size_t t = 0; t < coarse.corners.size() / 3; ++t) {
    places.insert(coarse.places(t));
  }
  for (std::size_t t = first; t < fine.corners.size() / 3; ++t) {
    EXPECT_EQ(t == first + 1 ? 2U : 1U, places.count(fine.places(t)));
  }
  // The point that nothing uses any more is there, and the one at which the spheres touch is where it was.
  EXPECT_EQ(fine.points[half], coarse.points[coarse_point[half]]);
  EXPECT_EQ(fine.points[0], coarse.points[coarse_point[0]]);
}

} // namespace
