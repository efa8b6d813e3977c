// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A smooth surface through the neighborhood of a point, where other sheets of the surface are near.

#ifndef CSCD_POINTS_SHEET_FITTING_H
#define CSCD_POINTS_SHEET_FITTING_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/principal_axes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// Fits a plane to the nearest neighbors of a point, to as many as are flattest, and from there a quadric to those
/// neighbors that are not far off this plane: not to those on another sheet.
class Sheet_fitting
{
public:
  /// \param noise_height heights over the plane that noise makes
  Sheet_fitting(const std::vector<Vector_3>& points, const Neighbor_table& neighbors, double noise_height)
      : m_points(points), m_neighbors(neighbors), m_noise_height(noise_height)
  {
  }

  /// The quadric of `point`; if too few neighbors are left for one, the plane, which takes the point where it is.
  Quadric_fit operator()(Index point)
  {
    const Vector_3 normal = flattest_normal(point);
    m_sheet.clear();
    double reach = 0;
    for (const Index neighbor : m_neighbors.neighbors(point)) {
      const Vector_3 edge = m_points[neighbor] - m_points[point];
      if (std::abs(edge.dot(normal)) <= std::max(m_noise_height, max_slope * edge.norm())) {
        m_sheet.push_back(neighbor);
        reach = std::max(reach, edge.norm());
      }
    }
    if (m_sheet.size() >= min_sheet) {
      return fit_quadric(m_points, point, m_sheet, reach);
    }
    Quadric_fit result;
    result.normal = result.surface_normal = normal;
    result.projection = m_points[point];
    return result;
  }

private:
  /// The sizes of neighborhoods that are compared, ascending: the immediate neighbors, and more for points with noise.
  static constexpr std::array<Index, 3> sizes{7, 10, 16};
  /// The sine of the angle between the plane and the edges to neighbors on the same sheet.
  static constexpr double max_slope = 0.5;
  /// Fewer neighbors do not determine more than a plane.
  static constexpr std::size_t min_sheet = 5;

  /// The normal of that neighborhood that is the thinnest in relation to its width.
  Vector_3 flattest_normal(Index point) const
  {
    const auto neighbors = m_neighbors.neighbors(point);
    const double unit = m_neighbors.reach(point);
    Vector_3 sum = Vector_3::Zero();
    Moment_matrix moments;
    Vector_3 result = Vector_3::UnitZ();
    double min_thickness = std::numeric_limits<double>::infinity();
    auto neighbor = neighbors.begin();
    for (const Index size : sizes) {
      for (; neighbor != neighbors.end() && neighbor - neighbors.begin() < std::ptrdiff_t(size); ++neighbor) {
        const Vector_3 offset = (m_points[*neighbor] - m_points[point]) / unit;
        sum += offset;
        moments += Moment_matrix::product(offset, offset);
      }
      const Principal_axes axes =
          principal_axes(moments - Moment_matrix::product(sum, sum) / double(neighbor - neighbors.begin() + 1));
      const double thickness = std::max(0., axes.values[0]) / axes.values[1];
      if (thickness < min_thickness) {
        min_thickness = thickness;
        result = axes.vectors[0];
      }
    }
    return result;
  }

  const std::vector<Vector_3>& m_points;
  const Neighbor_table& m_neighbors;
  double m_noise_height;
  std::vector<Index> m_sheet; // neighbors that seem to be on the same one
};

} // namespace CSCD::internal

#endif // CSCD_POINTS_SHEET_FITTING_H
