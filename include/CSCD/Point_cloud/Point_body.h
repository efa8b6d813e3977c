// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of the body whose surface points sample: whether it holds a point, and where its surface is met.

#ifndef CSCD_POINT_CLOUD_POINT_BODY_H
#define CSCD_POINT_CLOUD_POINT_BODY_H

#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/Point_cloud/Point_tree.h>
#include <CSCD/Point_cloud/Winding_number.h>
#include <CSCD/internal/Vector_3.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// The body that oriented points enclose, by their winding number: what `Solid_queries` is for surfaces, as well as
/// points can tell. Lines are followed in steps of half the spacing. Const and thread safe.
class Point_body
{
public:
  /// O(n log n).
  /// \param complex is referred to and must outlive this object
  explicit Point_body(const Point_complex& complex)
      : m_complex(complex), m_winding_number(complex), m_tree(complex.points()), m_step(complex.mean_edge_length() / 2)
  {
  }
  explicit Point_body(Point_complex&&) = delete;

  /// Whether the body holds `point`. O(log n).
  bool is_inside(const Vector_3& point) const { return m_winding_number.is_inside(point); }

  /// The middle of the body behind the point of the complex that is nearest to `point`; none where the body is too thin
  /// to tell. O(log n) for each step through the body.
  std::optional<Vector_3> middle_behind(const Vector_3& point) const
  {
    const Index nearest = m_tree.nearest(point);
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

  /// Writes the distances from `from` at which the segment from there to `to` meets the surface, in ascending order.
  /// O(log n) for each step.
  void crossings(const Vector_3& from, const Vector_3& to, std::vector<double>& distances) const
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

private:
  const Point_complex& m_complex;
  Winding_number m_winding_number;
  Point_tree m_tree;
  double m_step; ///< half the spacing of the points
};

} // namespace CSCD::internal

#endif // CSCD_POINT_CLOUD_POINT_BODY_H
