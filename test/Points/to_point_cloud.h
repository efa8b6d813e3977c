// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of tests as clouds.

#ifndef CSCD_TEST_POINTS_TO_POINT_CLOUD_H
#define CSCD_TEST_POINTS_TO_POINT_CLOUD_H

#include "support/Shape.h"
#include "support/point_skeletons.h"
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Traits/Input_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <vector>

namespace CSCD::test {

inline CSCD::Point_cloud to_point_cloud(const std::vector<Triple>& triples)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  return CSCD::internal::collect_points(to_points<Point>(triples), CGAL::Identity_property_map<const Point>(),
                                        CSCD::internal::No_normals());
}

} // namespace CSCD::test

#endif // CSCD_TEST_POINTS_TO_POINT_CLOUD_H
