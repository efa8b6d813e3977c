// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point complexes made of the triangles of a test shape, or of points alone.

#ifndef CSCD_TEST_POINTS_TO_POINT_COMPLEX_H
#define CSCD_TEST_POINTS_TO_POINT_COMPLEX_H

#include "Surface/to_indexed_triangles.h"
#include "support/Shape.h"
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::test {

/// The complex of the triangles of `shape`, with the sums of their normals.
inline CSCD::Point_complex to_point_complex(const Shape& shape)
{
  using CSCD::Vector_3;
  CSCD::Indexed_triangles triangles = to_indexed_triangles(shape);
  std::vector<Vector_3> normals(triangles.points.size(), Vector_3::Zero());
  for (const auto& [a, b, c] : triangles.faces) {
    const Vector_3& p = triangles.points[a];
    const Vector_3 normal = (triangles.points[b] - p).cross(triangles.points[c] - p);
    for (const auto vertex : {a, b, c}) {
      normals[vertex] += normal;
    }
  }
  for (Vector_3& normal : normals) {
    normal.normalize();
  }
  return {std::move(triangles.points), std::move(normals), triangles.faces};
}

/// The complex of different points, in their own coordinates and order.
inline CSCD::Point_complex to_point_complex(const std::vector<Triple>& points)
{
  CSCD::Point_cloud cloud;
  for (const Triple& p : points) {
    cloud.input_point.push_back(CSCD::Index(cloud.points.size()));
    cloud.points.emplace_back(p[0], p[1], p[2]);
  }
  cloud.pose = CSCD::Canonical_pose(cloud.points);
  return CSCD::internal::build_point_complex(cloud);
}

} // namespace CSCD::test

#endif // CSCD_TEST_POINTS_TO_POINT_COMPLEX_H
