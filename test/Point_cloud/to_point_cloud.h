// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of tests as clouds, and shapes as complexes.

#ifndef CSCD_TEST_POINT_CLOUD_TO_POINT_CLOUD_H
#define CSCD_TEST_POINT_CLOUD_TO_POINT_CLOUD_H

#include "support/Shape.h"
#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/Reconstruction/collect_points.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <utility>
#include <vector>

namespace CSCD::test {

inline CSCD::internal::Point_cloud to_point_cloud(const std::vector<Triple>& triples)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  for (const Triple& p : triples) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  return CSCD::internal::collect_points(points, CGAL::Identity_property_map<const Point>(),
                                        CSCD::internal::No_normals());
}

/// The vertices and triangles of a closed shape as they are, with the mean normals of the triangles.
inline CSCD::internal::Point_complex to_point_complex(const Shape& shape)
{
  using CSCD::internal::Index;
  std::vector<CSCD::internal::Vector_3> points;
  for (const Triple& p : shape.points) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  std::vector<CSCD::internal::Vector_3> normals(points.size(), CSCD::internal::Vector_3::Zero());
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& t : shape.triangles) {
    triangles.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
    for (const std::size_t v : t) {
      normals[v] += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    }
  }
  for (CSCD::internal::Vector_3& normal : normals) {
    normal.normalize();
  }
  return {std::move(points), std::move(normals), triangles};
}

} // namespace CSCD::test

#endif // CSCD_TEST_POINT_CLOUD_TO_POINT_CLOUD_H
