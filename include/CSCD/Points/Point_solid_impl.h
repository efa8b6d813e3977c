// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Inside and outside of the body whose surface oriented points sample.

#ifndef CSCD_POINTS_POINT_SOLID_IMPL_H
#define CSCD_POINTS_POINT_SOLID_IMPL_H

#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Points/Winding_number.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Vector_3.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CSCD {

CSCD_INLINE Point_solid::Point_solid(const Point_cloud& cloud)
    : m_complex(drop_fragments(internal::build_point_complex(cloud), m_vertex_of_point)),
      m_tree(std::make_unique<const internal::Point_tree>(m_complex.points())), m_step(m_complex.mean_edge_length() / 2)
{
  internal::assign_to_nearest(cloud.points, m_vertex_of_point);
  std::vector<Vector_3> area_vectors;
  for (Index vertex = 0; vertex < m_complex.number_of_vertices(); ++vertex) {
    area_vectors.push_back(m_complex.vertex_area(vertex) * m_complex.normal(vertex));
  }
  m_winding_number = std::make_unique<const internal::Winding_number>(m_complex.points(), area_vectors);
}

CSCD_INLINE Point_solid::~Point_solid() = default;

CSCD_INLINE bool Point_solid::is_inside(const Vector_3& point) const
{
  return (*m_winding_number)(point) > 0.5;
}

CSCD_INLINE std::optional<Vector_3> Point_solid::middle_behind(const Vector_3& point) const
{
  const Index nearest = m_tree->nearest(point);
  const Vector_3& begin = m_complex.point(nearest);
  const Vector_3 inward = -m_complex.normal(nearest);
  // A full spacing away, the winding number does not feel single points any more.
  double depth = 2 * m_step;
  if (!is_inside(begin + depth * inward)) {
    return std::nullopt;
  }
  // The body lies between the points, so this ends.
  do {
    depth += m_step;
  } while (is_inside(begin + depth * inward));
  return Vector_3(begin + depth / 2 * inward);
}

CSCD_INLINE void Point_solid::crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
{
  distances.clear();
  const double length = (to - from).norm();
  const auto number_of_steps = std::size_t(std::ceil(length / m_step));
  bool is_last_inside = is_inside(from);
  for (std::size_t step = 1; step <= number_of_steps; ++step) {
    const bool is_next_inside = is_inside(from + double(step) / double(number_of_steps) * (to - from));
    if (is_next_inside != is_last_inside) {
      distances.push_back((double(step) - 0.5) / double(number_of_steps) * length);
    }
    is_last_inside = is_next_inside;
  }
}

} // namespace CSCD

#endif // CSCD_POINTS_POINT_SOLID_IMPL_H
