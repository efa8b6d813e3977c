// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries on the body that a closed surface bounds: whether it contains a point, and where lines meet its surface.

#ifndef CSCD_SURFACE_SOLID_QUERIES_H
#define CSCD_SURFACE_SOLID_QUERIES_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A bounding volume hierarchy over the faces of a closed surface. Hole-filling faces count: they close the body.
/// All queries are const and may be called by several threads at once; each is O(log n) for well-shaped surfaces.
class Solid_queries
{
public:
  /// Builds the hierarchy in O(n log n).
  /// \param surface is referred to and must outlive this object
  explicit Solid_queries(const Triangulated_surface& surface)
      : Solid_queries(surface, face_boxes(surface), all_indices(surface.number_of_faces()))
  {
  }
  /// The same for the body that `faces` bound, those of a component.
  /// \param boxes of all faces, see `face_boxes()`
  template <class Range>
  Solid_queries(const Triangulated_surface& surface, const std::vector<Bounding_box>& boxes, const Range& faces)
      : m_surface(surface), m_tree(boxes, faces, faces_of_leaf)
  {
    for (const Index face : faces) {
      m_box.extend(boxes[face]);
    }
    m_offset = relative_offset * m_box.diagonal();
  }
  explicit Solid_queries(Triangulated_surface&&) = delete;

  /// The boxes of the faces of `surface`.
  static std::vector<Bounding_box> face_boxes(const Triangulated_surface& surface)
  {
    std::vector<Bounding_box> boxes(surface.number_of_faces());
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      boxes[Triangulated_surface::face(h)].extend(surface.point(surface.origin(h)));
    }
    return boxes;
  }

  /// Whether the body holds `point`: whether the surface winds around it. Where bodies overlap, or the surface
  /// intersects itself, the inside of several sheets is inside.
  bool is_inside(const Vector3& point) const { return winding_number(point) != 0; }

  /// The point of the surface that is nearest to `point`.
  /// \param near a face that may be near, such as that of the answer for a neighbor of `point`: it saves time
  Surface_point closest_point(const Vector3& point, Index near = no_index) const
  {
    Surface_point nearest;
    double least = std::numeric_limits<double>::max();
    const auto try_face = [&](Index face) {
      const Vector3 candidate = closest_point_of_face(face, point);
      const double distance = (candidate - point).squaredNorm();
      if (nearest.face == no_index || distance < least) {
        least = distance;
        nearest = {candidate, face};
      }
      return distance;
    };
    m_tree.minimize([&point](const Bounding_box& box) { return box.squared_distance(point); }, try_face,
                    near != no_index ? try_face(near) : infinity);
    return nearest;
  }

  /// The first point where the ray from `origin` along `direction`, not necessarily of unit length, meets the surface.
  /// \pre `direction` is not zero
  std::optional<Surface_hit> first_hit(const Vector3& origin, const Vector3& direction) const
  {
    const Ray ray(origin, direction.normalized());
    std::optional<Surface_hit> hit;
    const auto try_face = [&](Index face) {
      const double distance = hit_of_face(face, ray).distance;
      if (distance < infinity && (!hit || distance < hit->distance)) {
        hit = {{ray.origin + distance * ray.direction, face}, distance};
      }
      return distance;
    };
    m_tree.minimize([&ray](const Bounding_box& box) { return ray.entry(box); }, try_face);
    return hit;
  }

  /// The direction into the body at `nearest`, the point of the surface that is nearest to `point`. On an edge or at a
  /// vertex no single face represents the surface, so it is that between the two points, unless rounding decides it.
  /// Zero at a face without area.
  Vector3 inward_direction(const Surface_point& nearest, const Vector3& point) const
  {
    const Vector3 way = nearest.point - point;
    if (!(way.norm() > m_offset)) {
      return -m_surface.face_normal(nearest.face);
    }
    return is_inside(point) ? Vector3(-way.normalized()) : way.normalized();
  }

  /// The middle of the body behind the point of the surface that is nearest to `point`: half way to where the line from
  /// `point` through there leaves the body again. None where the body is too thin to decide, or the surface intersects
  /// itself. \pre `point` is not inside the body
  std::optional<Vector3> middle_behind(const Vector3& point) const
  {
    const Surface_point nearest = closest_point(point);
    const Vector3 through = nearest.point - point;
    const Vector3 inward = through.norm() > m_offset ? through.normalized() : inward_direction(nearest, point);
    const std::optional<Surface_hit> hit =
        inward.squaredNorm() > 0 ? first_hit(nearest.point + m_offset * inward, inward) : std::nullopt;
    if (!hit) {
      return std::nullopt;
    }
    const Vector3 middle = (nearest.point + hit->point) / 2;
    return is_inside(middle) ? std::optional<Vector3>(middle) : std::nullopt;
  }

  /// Writes to `distances`, ascending, the distances from `from` where the segment from there to `to` enters or leaves
  /// the body. Where faces lie upon each other, rounding does not make it leave.
  void crossings(const Vector3& from, const Vector3& to, std::vector<double>& distances) const
  {
    distances.clear();
    const double length = (to - from).norm();
    if (!(length > 0)) {
      return;
    }
    std::vector<std::pair<double, int>> hits;
    visit_hits(Ray(from, (to - from) / length), length,
               [&](const Hit& hit) { hits.emplace_back(hit.distance, hit.turn); });
    if (hits.empty()) {
      return;
    }
    std::sort(hits.begin(), hits.end());
    int number = winding_number(from);
    for (const auto& [distance, turn] : hits) {
      const bool was_inside = number != 0;
      number -= turn;
      if (!was_inside && !distances.empty() && distance - distances.back() <= m_offset) {
        distances.pop_back();
      } else if (was_inside != (number != 0)) {
        distances.push_back(distance);
      }
    }
  }

private:
  /// The point of `face` that is nearest to `point`, by the signs of the point's barycentric coordinates
  /// (C. Ericson, Real-Time Collision Detection, 5.1.5). A side without length is left to the other sides.
  Vector3 closest_point_of_face(Index face, const Vector3& point) const
  {
    const std::array<Index, 3> corner = corners(face);
    const Vector3& a = m_surface.point(corner[0]);
    const Vector3& b = m_surface.point(corner[1]);
    const Vector3& c = m_surface.point(corner[2]);
    const Vector3 ab = b - a;
    const Vector3 ac = c - a;
    const double ab_at_a = ab.dot(point - a), ac_at_a = ac.dot(point - a);
    const double ab_at_b = ab.dot(point - b), ac_at_b = ac.dot(point - b);
    const double ab_at_c = ab.dot(point - c), ac_at_c = ac.dot(point - c);
    if (ab_at_a <= 0 && ac_at_a <= 0) {
      return a;
    }
    if (ab_at_b >= 0 && ac_at_b <= ab_at_b) {
      return b;
    }
    if (ac_at_c >= 0 && ab_at_c <= ac_at_c) {
      return c;
    }
    const double at_c = ab_at_a * ac_at_b - ab_at_b * ac_at_a; // barycentric coordinates, not normalized
    const double at_b = ab_at_c * ac_at_a - ab_at_a * ac_at_c;
    const double at_a = ab_at_b * ac_at_c - ab_at_c * ac_at_b;
    if (at_c <= 0 && ab_at_a >= 0 && ab_at_b <= 0 && ab_at_a > ab_at_b) {
      return a + ab_at_a / (ab_at_a - ab_at_b) * ab;
    }
    if (at_b <= 0 && ac_at_a >= 0 && ac_at_c <= 0 && ac_at_a > ac_at_c) {
      return a + ac_at_a / (ac_at_a - ac_at_c) * ac;
    }
    const double from_b = ac_at_b - ab_at_b;
    const double from_c = ab_at_c - ac_at_c;
    if (at_a <= 0 && from_b >= 0 && from_c >= 0 && from_b + from_c > 0) {
      return b + from_b / (from_b + from_c) * (c - b);
    }
    const double sum = at_a + at_b + at_c;
    return sum > 0 ? Vector3(a + at_b / sum * ab + at_c / sum * ac) : a;
  }

  /// Fewer leaves of the hierarchy are built faster, and queries are as fast.
  static constexpr Index faces_of_leaf = 4;
  /// Rays into the body start this far from the surface, relative to the diagonal of the bounding box.
  static constexpr double relative_offset = 1e-7;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The direction of a ray that leaves the bounding box soon: any will do, and it misses most of many thin components.
  /// Not along an axis, as faces of designed parts are often perpendicular or parallel to these.
  Vector3 way_out(const Vector3& point) const
  {
    const Vector3 below = point - m_box.min();
    const Vector3 above = m_box.max() - point;
    const Vector3 nearer = below.cwiseMin(above);
    const auto axis = std::min_element(nearer.begin(), nearer.end()) - nearer.begin();
    Vector3 direction;
    direction[axis] = below[axis] < above[axis] ? -0.8523 : 0.8523;
    direction[(axis + 1) % 3] = 0.4127;
    direction[(axis + 2) % 3] = 0.3211;
    return direction;
  }

  struct Ray
  {
    Ray(const Vector3& ray_origin, const Vector3& ray_direction) : origin(ray_origin), direction(ray_direction)
    {
      for (int i = 0; i < 3; ++i) {
        inverse[i] = direction[i] != 0 ? 1 / direction[i] : 0;
      }
      const Vector3 lengths = direction.cwiseAbs();
      main_axis = int(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
      first_axis = (main_axis + 1) % 3;
      second_axis = (main_axis + 2) % 3;
    }

    /// Coordinates of `point` where the ray is the positive third axis: the third one is the distance along the ray of
    /// the plane through `point` that is perpendicular to the main axis, the others are sheared along the ray.
    Vector3 to_ray_coordinates(const Vector3& point) const
    {
      const double height = (point[main_axis] - origin[main_axis]) * inverse[main_axis];
      return {point[first_axis] - origin[first_axis] - height * direction[first_axis],
              point[second_axis] - origin[second_axis] - height * direction[second_axis], height};
    }

    /// The distance of the point where the ray enters `box`, `infinity` if it does not.
    double entry(const Bounding_box& box) const
    {
      double from = 0;
      double to = infinity;
      for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0) {
          if (origin[i] < box.min()[i] || origin[i] > box.max()[i]) {
            return infinity;
          }
          continue;
        }
        const double a = (box.min()[i] - origin[i]) * inverse[i];
        const double b = (box.max()[i] - origin[i]) * inverse[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
      }
      // Rounding must not lose a face that lies in the side of its box.
      return from <= to * (1 + 4 * std::numeric_limits<double>::epsilon()) ? from : infinity;
    }

    Vector3 origin, direction;
    Vector3 inverse; // of the coordinates of the direction, 0 for 0
    int main_axis = 0, first_axis = 1, second_axis = 2;
  };

  /// Where a ray meets a face.
  struct Hit
  {
    double distance = infinity; ///< from the origin of the ray
    int turn = 0;               ///< 1 where the ray leaves the body at the face, -1 where it enters
  };

  /// How often the surface winds around `point`: by the crossings along one ray, which is exact on a closed surface, so
  /// that further rays would not help.
  int winding_number(const Vector3& point) const
  {
    int number = 0;
    visit_hits(Ray(point, way_out(point)), infinity, [&number](const Hit& hit) { number += hit.turn; });
    return number;
  }

  /// Calls `visit` with every hit of the ray up to `max_distance`.
  template <class Visit>
  void visit_hits(const Ray& ray, double max_distance, const Visit& visit) const
  {
    m_tree.visit(
        [&](const Bounding_box& box) {
          const double distance = ray.entry(box);
          return distance < infinity && distance <= max_distance;
        },
        [&](Index face) {
          const Hit hit = hit_of_face(face, ray);
          if (hit.distance < infinity && hit.distance <= max_distance) {
            visit(hit);
          }
        });
  }

  std::array<Index, 3> corners(Index face) const
  {
    return {m_surface.origin(3 * face), m_surface.origin(3 * face + 1), m_surface.origin(3 * face + 2)};
  }

  /// Whether a ray through the origin has the directed line from `a` to `b` on its left, looking along the ray; points
  /// are in ray coordinates. Decided as if the ray were moved by (e, e^2) for an infinitely small e: never a tie.
  static bool is_left(const Vector3& a, const Vector3& b, double product)
  {
    return product != 0 ? product > 0 : a.y() != b.y() ? a.y() > b.y() : b.x() > a.x();
  }

  /// Where the ray meets `face`, at an infinite distance if it does not.
  /// Both faces of an edge evaluate the same expression for it, and ties are decided as for a ray that meets no edge or
  /// vertex: so the sum of turns is right on every closed surface.
  Hit hit_of_face(Index face, const Ray& ray) const
  {
    const std::array<Index, 3> corner = corners(face);
    std::array<Vector3, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = ray.to_ray_coordinates(m_surface.point(corner[i]));
    }
    std::array<double, 3> weight{}; // barycentric coordinates, not normalized
    std::array<bool, 3> left{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const bool is_ascending = corner[j] < corner[k];
      const Vector3& a = at[is_ascending ? j : k];
      const Vector3& b = at[is_ascending ? k : j];
      const double product = a.x() * b.y() - a.y() * b.x();
      left[i] = is_left(a, b, product) == is_ascending;
      weight[i] = std::abs(product);
    }
    if (left[0] != left[1] || left[1] != left[2]) {
      return {};
    }
    if (!(weight[0] + weight[1] + weight[2] > 0)) {
      weight = {1, 1, 1}; // seen from its edge
    }
    const double distance =
        (weight[0] * at[0].z() + weight[1] * at[1].z() + weight[2] * at[2].z()) / (weight[0] + weight[1] + weight[2]);
    // Along a negative main axis, ray coordinates are mirrored.
    return distance > 0 ? Hit{distance, left[0] == (ray.direction[ray.main_axis] > 0) ? 1 : -1} : Hit{};
  }

  const Triangulated_surface& m_surface;
  Bounding_box m_box;
  double m_offset = 0;
  Box_tree m_tree;
};

} // namespace CSCD::internal

#endif // CSCD_SURFACE_SOLID_QUERIES_H
