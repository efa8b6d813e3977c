// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the skeleton of a limb ends.

#ifndef CSCD_SKELETON_LIMB_END_H
#define CSCD_SKELETON_LIMB_END_H

#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// The surface of a limb beyond its last separator, by vertices.
class Limb_end
{
public:
  /// A limb gets a tip if its end is higher than this, relative to its radius.
  static constexpr double min_tip_height = 0.7;

  /// \param distance from the last separator
  void add(const Vector_3& point, double area, float distance) { m_vertices.push_back({point, area, distance}); }

  /// The largest distance; 0 if there is no vertex.
  float height() const
  {
    float result = 0;
    for (const Vertex& vertex : m_vertices) {
      result = std::max(result, vertex.distance);
    }
    return result;
  }

  /// What is at least `distance` from the separator, with distances from there.
  Limb_end beyond(double distance) const
  {
    Limb_end result;
    for (const Vertex& vertex : m_vertices) {
      if (vertex.distance >= float(distance)) {
        result.add(vertex.point, vertex.area, vertex.distance - float(distance));
      }
    }
    return result;
  }
  /// What is nearer to it than `distance`.
  Limb_end below(double distance) const
  {
    Limb_end result;
    std::copy_if(m_vertices.begin(), m_vertices.end(), std::back_inserter(result.m_vertices),
                 [distance](const Vertex& vertex) { return vertex.distance < float(distance); });
    return result;
  }

  struct Ball
  {
    Vector_3 center;
    double radius;
  };
  /// The centroid by area, and the mean distance from it; nothing if there are too few vertices for either.
  std::optional<Ball> ball() const
  {
    if (m_vertices.size() < min_vertices) {
      return std::nullopt;
    }
    Ball result{Vector_3::Zero(), 0};
    double weight = 0;
    for (const Vertex& vertex : m_vertices) {
      result.center += vertex.area * vertex.point;
      weight += vertex.area;
    }
    result.center /= weight;
    for (const Vertex& vertex : m_vertices) {
      result.radius += vertex.area / weight * (vertex.point - result.center).norm();
    }
    return weight > 0 ? std::optional<Ball>(result) : std::nullopt;
  }

  /// The tip of a limb with its last node at `base`, in the direction of what is far from that; nothing if the end is
  /// not higher than `min_height`, relative to the radius.
  std::optional<Vector_3> tip(const Vector_3& base, double radius, double min_height = min_tip_height) const
  {
    const float far = float(far_part * height());
    Vector_3 sum = Vector_3::Zero();
    double weight = 0;
    for (const Vertex& vertex : m_vertices) {
      if (vertex.distance >= far) {
        sum += vertex.area * vertex.point;
        weight += vertex.area;
      }
    }
    const bool is_high = height() > min_height * radius && weight > 0;
    return is_high ? tip_towards(base, (sum / weight - base).normalized(), radius) : std::nullopt;
  }

  /// The tip in `direction`, if the limb extends far enough there.
  std::optional<Vector_3> tip_towards(const Vector_3& base, const Vector_3& direction, double radius) const
  {
    double extent = 0;
    for (const Vertex& vertex : m_vertices) {
      extent = std::max(extent, direction.dot(vertex.point - base));
    }
    const double length = extent - tip_depth * radius;
    return length > min_tip_length * radius ? std::optional<Vector_3>(base + length * direction) : std::nullopt;
  }

private:
  /// The tip stays this far below the surface ...
  static constexpr double tip_depth = 0.75;
  /// ... and this far from the node that it is joined to, relative to the radius.
  static constexpr double min_tip_length = 0.3;
  /// The direction of a tip is that to the vertices beyond this part of the height.
  static constexpr double far_part = 0.6;
  /// Fewer surround nothing.
  static constexpr std::size_t min_vertices = 6;

  struct Vertex
  {
    Vector_3 point;
    double area;
    float distance;
  };
  std::vector<Vertex> m_vertices;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_LIMB_END_H
