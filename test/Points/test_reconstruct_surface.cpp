// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of a cloud is the same, triangle by triangle, whatever the process did before.

#include "support/Shape.h"
#include "support/name_of_shape.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/reconstruct_surface.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Vector_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using CSCD::Index;
using CSCD::test::Shape;
using CSCD::test::Shape_maker;
using CSCD::test::Triple;

/// Blocks of memory of many sizes with gaps between them, so that what is allocated next lies in no order.
class Scattered_blocks
{
public:
  explicit Scattered_blocks(unsigned seed)
  {
    constexpr std::size_t number = 20000;
    constexpr std::size_t largest = 400; // bytes: more than the nodes of any container have
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < number; ++i) {
      m_blocks.push_back(std::make_unique<std::vector<char>>(1 + random() % largest));
    }
    for (auto& block : m_blocks) {
      if (random() % 2 == 0) {
        block.reset();
      }
    }
  }

private:
  std::vector<std::unique_ptr<std::vector<char>>> m_blocks;
};

std::vector<std::array<Index, 3>> triangles_of(const std::vector<Triple>& triples)
{
  std::vector<Point> points;
  for (const Triple& p : triples) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  const auto cloud =
      CSCD::internal::collect_points(points, CGAL::Identity_property_map<const Point>(), CSCD::internal::No_normals());
  return CSCD::internal::reconstruct_surface(cloud).triangles.faces;
}

class Cloud_of_shape : public testing::TestWithParam<Shape_maker>
{
};

std::vector<Shape_maker> shapes_of_clouds()
{
  using namespace CSCD::test;
  return {{"torus", [] { return torus(3, 1, 24); }},
          {"trefoil_knot", [] { return trefoil_knot(0.4, 16); }},
          {"hand", [] { return hand(0.12); }},
          {"genus_4", [] { return ladder(4, 0.15); }}};
}

INSTANTIATE_TEST_SUITE_P(All, Cloud_of_shape, testing::ValuesIn(shapes_of_clouds()), CSCD::test::name_of_shape);

TEST_P(Cloud_of_shape, gets_the_same_triangles_whatever_lies_in_memory)
{
  const Shape shape = GetParam().make();
  constexpr std::size_t number = 1500;
  for (const double deviation : {0., 0.4, 0.8}) {
    SCOPED_TRACE(deviation);
    const double noise = deviation * mean_spacing(shape, number);
    const std::vector<Triple> points = CSCD::test::shaken(sampled(shape, number, 1), noise, 2);
    const std::vector<std::array<Index, 3>> first = triangles_of(points);
    std::vector<Scattered_blocks> history;
    for (const unsigned seed : {1u, 2u}) {
      history.emplace_back(seed);
      EXPECT_TRUE(first == triangles_of(points)) << "seed " << seed;
    }
  }
}

TEST(reconstruct_surface, of_a_grid_is_the_same_whatever_lies_in_memory)
{
  // Most triangles are as large as others.
  const std::vector<Triple> points = CSCD::test::torus(3, 1, 24).points;
  const std::vector<std::array<Index, 3>> first = triangles_of(points);
  const Scattered_blocks blocks(1);
  EXPECT_TRUE(first == triangles_of(points));
}

} // namespace
