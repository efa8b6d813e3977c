// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that move over a point complex stay on its surface, near the vertex that is named.

#include "Points/Measured_cloud.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Published/Cut_locus_indicators.h>
#include <CSCD/Published/Cut_locus_smoothing.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Vector_3;
using CSCD::internal::Cloud_point;
using CSCD::internal::Point_cut_locus_indicators;
using CSCD::internal::Point_smoothing_domain;
using CSCD::test::Measured_cloud;

TEST(Point_smoothing_domain, keeps_points_on_a_sphere)
{
  const Measured_cloud sphere(CSCD::test::sampled(CSCD::test::sphere(5), 4000, 1));
  const std::vector<double> heights = sphere.values([](const Vector_3& p) { return p.z(); });
  const Point_cut_locus_indicators measures(sphere.derivatives(), heights);
  const Point_smoothing_domain ground(measures);
  const double edge = ground.mean_edge_length();
  const Index start = sphere.nearest({1, 0, 0});
  Cloud_point point{start, sphere.complex().point(start)};
  const double step = 0.5 * edge;
  for (double angle = 0; angle < 2; angle += step) {
    const Vector_3 up = ground.gradient(point);
    const Vector_3 meridian = (Vector_3(0, 0, 1) - point.position.z() * point.position);
    EXPECT_LT((up - meridian).norm(), 0.15);
    point = ground.moved(point, step * Vector_3(0, 1, 0).cross(point.position).normalized() * -1);
    EXPECT_NEAR(ground.position(point).norm(), 1, 0.1 * edge);
    EXPECT_LT((sphere.complex().point(point.nearest) - point.position).norm(), 1.5 * edge);
    EXPECT_EQ(point.nearest, sphere.nearest(point.position));
  }
  EXPECT_NEAR(point.position.x(), std::cos(2.), 2 * edge) << "it went its way";
}

} // namespace
