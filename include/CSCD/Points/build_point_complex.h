// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a cloud to the triangles that its neighborhoods agree on (appendix G.2).

#ifndef CSCD_POINTS_BUILD_POINT_COMPLEX_H
#define CSCD_POINTS_BUILD_POINT_COMPLEX_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Triangle_selection.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/close_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/config.h>
#include <CSCD/internal/flat_arrays.h>

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A vector with coordinates in [-1, 1] that depends on the number of the point alone. Not linearly: else the corners
/// of a grid's squares would stay in one plane.
inline Vector3 pseudo_random_vector(Index point)
{
  const auto coordinate = [point](Index axis) {
    return 2 * double(scattered(point, axis)) / double(std::numeric_limits<std::uint32_t>::max()) - 1;
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// The normal that a point at direction `edge` has if both lie on a circular arc, and the other has `normal`. On flat
/// ground it is the same; across an edge of a body it is that of the other side.
inline Vector3 mirrored_normal(const Vector3& normal, const Vector3& edge)
{
  return normal - 2 * edge.dot(normal) / edge.squaredNorm() * edge;
}

/// Turns normals so that they agree with those of neighbors, starting from the first vertex of each component of some
/// triangles: along a spanning tree of the edges at which they differ least from what an arc would have (after H. Hoppe
/// et al., "Surface reconstruction from unorganized points", 1992; S. König, S. Gumhold, "Consistent propagation of
/// normal orientations in point clouds", 2009), but of edges of triangles only, which do not lead from one sheet to the
/// next. O(n log n).
inline void orient_normals(const std::vector<Vector3>& points, const std::vector<std::array<Index, 3>>& triangles,
                           std::vector<Vector3>& normals)
{
  const Compressed_rows<Index> neighbors = vertex_neighbors(points.size(), triangles);
  const auto cosine = [&](Index a, Index b) {
    return mirrored_normal(normals[a], points[b] - points[a]).dot(normals[b]);
  };
  using Step = std::tuple<double, Index, Index>; // what the normals differ by, from where, and where to
  std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
  std::vector<char> is_oriented(points.size(), 0);
  const auto orient = [&](Index a) {
    is_oriented[a] = 1;
    for (const Index b : neighbors[a]) {
      if (is_oriented[b] == 0) {
        steps.emplace(1 - std::abs(cosine(a, b)), a, b);
      }
    }
  };
  for (Index seed = 0; seed < points.size(); ++seed) {
    if (is_oriented[seed] == 0) {
      orient(seed);
    }
    while (!steps.empty()) {
      const auto [difference, a, b] = steps.top();
      steps.pop();
      if (is_oriented[b] == 0) {
        normals[b] = cosine(a, b) < 0 ? Vector3(-normals[b]) : normals[b];
        orient(b);
      }
    }
  }
}

/// The triangles of the convex hull of `points`, outwards; none if some points are inside, or all nearly lie in a
/// plane. O(n^4).
/// \pre no four lie in a plane exactly; the mean squared distance from the centroid is about 1
inline std::vector<std::array<Index, 3>> hull_of_few(const std::vector<Vector3>& points)
{
  constexpr double min_thickness = 1e-3;
  const auto n = Index(points.size());
  std::vector<std::array<Index, 3>> result;
  std::vector<double> depth(points.size(), 1); // below the nearest side of the hull
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      for (Index c = b + 1; c < n; ++c) {
        const Vector3 normal = triangle_vector(points[a], points[b], points[c]).normalized();
        std::vector<double> height;
        for (Index d = 0; d < n; ++d) {
          height.push_back(d == a || d == b || d == c ? 0. : normal.dot(points[d] - points[a]));
        }
        const auto [lowest, highest] = std::minmax_element(height.begin(), height.end());
        if (*lowest < 0 && *highest > 0) {
          continue;
        }
        if (*highest - *lowest < min_thickness) {
          return {};
        }
        for (Index d = 0; d < n; ++d) {
          depth[d] = std::min(depth[d], std::abs(height[d]));
        }
        result.push_back({a, *highest > 0 ? c : b, *highest > 0 ? b : c});
      }
    }
  }
  if (*std::max_element(depth.begin(), depth.end()) > min_thickness) {
    return {};
  }
  return result;
}

/// The triangles between the points of a cloud that its neighborhoods agree on.
struct Triangulated_cloud
{
  std::vector<Vector3> points;                 ///< those of the cloud, in the same order; moved if they are smoothed
  std::vector<Vector3> normals;                ///< of unit length, outwards
  std::vector<std::array<Index, 3>> triangles; ///< oriented; no two have a side in the same direction
  double spacing = 0;                          ///< the median over the points of the mean distance to the nearest six
  double noise = 0;         ///< the lower quartile of the deviations from quadrics, relative to the spacing
  bool is_smoothed = false; ///< whether the noise was so large that triangles between the points would fold
};

/// Triangulates a cloud, step by step (supplement, appendix G.2: the neighborhoods of the points, pruned of what
/// connects regions that are not connected). Outliers and points that nothing fits to have no triangles. O(n log n).
class Cloud_triangulation
{
public:
  explicit Cloud_triangulation(const Point_cloud& cloud)
      : m_cloud(cloud), m_points(cloud.pose.places_of(cloud.points)), m_neighbors(m_points, quadric_neighbors)
  {
    m_result.points = cloud.points;
  }

  Triangulated_cloud operator()()
  {
    smooth();
    if (is_small() && m_cloud.normals.empty()) {
      take_hull();
    }
    if (m_result.triangles.empty()) {
      take_sheets();
    }
    for (const Vector3& normal : m_normals) {
      m_result.normals.push_back(m_cloud.pose.turn_back(normal));
    }
    return std::move(m_result);
  }

private:
  /// How far points are moved, for the choice of triangles only, relative to the reach of their neighborhoods: far more
  /// than rounding, far less than matters.
  static constexpr double jitter = 1e-6;

  /// The squared radius of a triangle's circumcircle, relative to that of the neighborhood: in a circle that is much
  /// larger there may be points outside the neighborhood, and an empty one is a hole. Neither half nor twice as much
  /// makes a difference: of 104 clouds, the skeletons of 71, 70 and 69 have the right topology with 1, 2 and 4.
  static constexpr double max_circle = 2;
  /// The sine of the angle between an edge and the tangent plane of an end: an edge that is steeper at both ends leads
  /// to another sheet.
  static constexpr double max_slope = 0.7;
  /// Up to this slope, an edge is taken whatever the normals say.
  static constexpr double min_doubtful_slope = 0.25;
  /// By how much the cosine between the normals may exceed that on a circular arc.
  static constexpr double arc_tolerance = 0.2;
  /// The minimal cosine between oriented normals; one of them is carried over along an arc.
  static constexpr double min_agreement = 0;
  /// The part of the points whose deviation is the noise: where limbs are thin, quadrics deviate without noise.
  static constexpr double noise_quantile = 0.25;
  /// Heights over a tangent plane that noise makes, relative to its deviation.
  static constexpr double noise_height = 3;
  /// Points are moved for good if their deviation, relative to their spacing, exceeds this. Below, moving them does
  /// more harm to thin limbs than good.
  static constexpr double max_noise = 0.19;

  /// Whether the neighborhoods reach around the body, and have no tangent planes.
  bool is_small() const { return m_points.size() <= std::size_t(2) * quadric_neighbors; }

  /// Measures the noise, and moves the points to the quadrics of their neighborhoods if triangles between them would
  /// fold; again if these still would.
  void smooth()
  {
    constexpr int max_number_of_rounds = 2; // a third changes nothing
    const double scale = m_cloud.pose.scale();
    for (int round = 0; round <= max_number_of_rounds; ++round) {
      const double spacing = quantile(spacings(m_neighbors), 0.5);
      const double noise = fit_sheets() / spacing;
      m_noise = noise_height * noise * spacing;
      if (round == 0) {
        m_result.spacing = spacing / scale;
        m_result.noise = noise;
      }
      if (noise <= max_noise || is_small() || round == max_number_of_rounds) {
        return;
      }
      m_result.is_smoothed = true;
      std::vector<Vector3> projections;
      for (Index point = 0; point < m_points.size(); ++point) {
        projections.push_back(fit_neighborhood(point).projection);
        m_result.points[point] += m_cloud.pose.turn_back(projections[point] - m_points[point]) / scale;
      }
      m_points = std::move(projections);
      m_neighbors = Neighbor_table(m_points, quadric_neighbors);
    }
  }

  /// Fits a quadric to the sheet of each point. \return the noise: where a wall is so thin that neighbors are on both
  /// of its sides, a quadric through all of them would deviate without noise
  double fit_sheets()
  {
    m_fits.clear();
    std::vector<double> deviations;
    for (Index point = 0; point < m_points.size(); ++point) {
      m_fits.push_back(fit_sheet(m_points, m_neighbors, point));
      const double deviation = m_fits[point].deviation;
      deviations.push_back(deviation > 0 ? deviation : fit_neighborhood(point).deviation);
    }
    return quantile(std::move(deviations), noise_quantile);
  }

  Quadric_fit fit_neighborhood(Index point) const
  {
    return fit_quadric(m_points, point, m_neighbors.neighbors(point), m_neighbors.reach(point));
  }

  /// Takes the convex hull of the points, if they do not lie in a plane.
  void take_hull()
  {
    std::vector<Vector3> shaken = m_points;
    Vector3 center = Vector3::Zero();
    for (Index point = 0; point < m_points.size(); ++point) {
      shaken[point] += tie_breaker(point);
      center += m_points[point] / double(m_points.size());
    }
    m_result.triangles = hull_of_few(shaken);
    m_normals.clear();
    for (const Vector3& point : shaken) {
      m_normals.push_back((point - center).normalized());
    }
  }

  void take_sheets()
  {
    move_points();
    take_normals();
    std::vector<std::array<Index, 3>>& triangles = m_result.triangles;
    for (const bool is_oriented : {false, true}) { // oriented normals separate more sheets
      m_is_oriented = is_oriented;
      triangles = Triangle_selection(m_points, m_normals, propose_triangles())();
      orient_normals(m_points, triangles, m_normals);
    }
    orient(triangles);
    turn_outwards(triangles);
  }

  /// Triangles are found between points that are moved to the surfaces fitted to them, but not farther than noise can
  /// have moved them: where limbs are thin, the surfaces do not fit. Ties are broken.
  void move_points()
  {
    for (Index point = 0; point < m_points.size(); ++point) {
      const Vector3 offset = m_fits[point].projection - m_points[point];
      const double length = offset.norm();
      m_points[point] += length > m_noise ? Vector3(m_noise / length * offset) : offset;
      m_points[point] += tie_breaker(point);
    }
  }

  Vector3 tie_breaker(Index point) const { return jitter * m_neighbors.reach(point) * pseudo_random_vector(point); }

  void take_normals()
  {
    m_normals.clear();
    for (Index point = 0; point < m_points.size(); ++point) {
      const bool is_known = !m_cloud.normals.empty() && m_cloud.normals[point] != Vector3::Zero();
      m_normals.push_back(is_known ? m_cloud.pose.turn(m_cloud.normals[point]) : m_fits[point].surface_normal);
    }
  }

  /// Whether two points are on different sheets that are near each other.
  bool are_two_sheets(Index p, Index q) const
  {
    const Vector3 edge = m_points[q] - m_points[p];
    const double slope = std::min(std::abs(edge.dot(m_normals[p])), std::abs(edge.dot(m_normals[q]))) / edge.norm();
    const double height = slope * edge.norm();
    if (m_is_oriented && mirrored_normal(m_normals[p], edge).dot(m_normals[q]) < min_agreement) {
      return true;
    }
    if (slope <= min_doubtful_slope || height < m_noise) {
      return false;
    }
    return slope > max_slope || std::abs(m_normals[p].dot(m_normals[q])) > 1 - 2 * slope * slope + arc_tolerance;
  }

  std::vector<Local_triangle> propose_triangles() const
  {
    std::vector<Local_triangle> proposals;
    proposals.reserve(7 * m_points.size());
    Delaunay_star star;
    for (Index p = 0; p < m_points.size(); ++p) {
      const Vector3 x = m_normals[p].unitOrthogonal();
      const Vector3 y = m_normals[p].cross(x);
      star.clear();
      for (const Index q : m_neighbors.neighbors(p)) {
        if (!are_two_sheets(p, q)) {
          const Vector3 edge = m_points[q] - m_points[p];
          star.add({x.dot(edge), y.dot(edge)}, q);
        }
      }
      star();
      const double reach = m_neighbors.reach(p);
      const std::vector<Index>& ring = star.neighbors();
      for (std::size_t i = star.is_closed() ? 0 : 1; i < ring.size(); ++i) {
        const Index q = ring[i == 0 ? ring.size() - 1 : i - 1];
        const double size = squared_circumradius(m_points[p], m_points[q], m_points[ring[i]]);
        if (size <= max_circle * reach * reach) {
          proposals.push_back({{p, q, ring[i]}, 1, size});
          std::sort(proposals.back().begin(), proposals.back().end());
        }
      }
    }
    return count_votes(std::move(proposals));
  }

  static std::vector<Local_triangle> count_votes(std::vector<Local_triangle>&& proposals)
  {
    std::sort(proposals.begin(), proposals.end());
    std::vector<Local_triangle> result;
    for (const Local_triangle& proposal : proposals) {
      if (!result.empty() && result.back() == proposal) {
        ++result.back().votes;
      } else {
        result.push_back(proposal);
      }
    }
    return result;
  }

  /// Turns triangles as the normals say, and drops triangles whose normals do not agree: they join two sheets.
  void orient(std::vector<std::array<Index, 3>>& triangles) const
  {
    const auto is_contradictory = [&](std::array<Index, 3>& triangle) {
      const Vector3 vector = triangle_vector(m_points[triangle[0]], m_points[triangle[1]], m_points[triangle[2]]);
      const auto against = std::count_if(triangle.begin(), triangle.end(),
                                         [&](Index corner) { return vector.dot(m_normals[corner]) < 0; });
      if (against == 3) {
        std::swap(triangle[1], triangle[2]);
      }
      return against % 3 != 0;
    };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), is_contradictory), triangles.end());
  }

  /// Turns components that enclose a negative volume. Rounding does not turn flat ones.
  void turn_outwards(std::vector<std::array<Index, 3>>& triangles)
  {
    constexpr double rounding = 1e-9; // relative to the volume of the vectors to the corners
    Disjoint_sets sets = sets_of_vertices(triangles, m_points.size());
    std::vector<Vector3> center(m_points.size(), Vector3::Zero()); // sums of corners, of every root
    std::vector<double> count(m_points.size(), 0);
    for (const auto& triangle : triangles) {
      for (const Index vertex : triangle) {
        center[sets.find(vertex)] += m_points[vertex];
        ++count[sets.find(vertex)];
      }
    }
    std::vector<double> volume(m_points.size(), 0); // of every root
    for (const auto& [a, b, c] : triangles) {
      const Index root = sets.find(a);
      const Vector3 origin = center[root] / count[root];
      const std::array<Vector3, 3> arms{m_points[a] - origin, m_points[b] - origin, m_points[c] - origin};
      volume[root] += arms[0].dot(arms[1].cross(arms[2])) + rounding * arms[0].norm() * arms[1].norm() * arms[2].norm();
    }
    for (auto& triangle : triangles) {
      if (volume[sets.find(triangle[0])] < 0) {
        std::swap(triangle[1], triangle[2]);
      }
    }
    for (Index v = 0; v < m_points.size(); ++v) {
      if (volume[sets.find(v)] < 0) {
        m_normals[v] = -m_normals[v];
      }
    }
  }

  const Point_cloud& m_cloud;
  std::vector<Vector3> m_points; // in the canonical pose, moved
  Neighbor_table m_neighbors;
  std::vector<Quadric_fit> m_fits; // in the canonical pose
  double m_noise = 0;              // how far noise moves points off the surface, in the canonical pose
  std::vector<Vector3> m_normals;  // in the canonical pose
  bool m_is_oriented = false;      // the normals
  Triangulated_cloud m_result;
};

/// Fills the gaps of a few edges between triangles: voids of random samples are not holes.
class Gap_closing
{
public:
  explicit Gap_closing(Triangulated_cloud& cloud)
      : m_cloud(cloud), m_surface{cloud.points, cloud.triangles, cloud.triangles.size()},
        m_pairing(cloud.triangles, cloud.points.size()), m_is_met(m_pairing.number_of_halfedges(), 0)
  {
  }

  /// Adds triangles to the cloud that look as the normals say; O(n log n).
  void operator()()
  {
    Border_bridge bridge(m_surface, m_pairing);
    for (Index h = 0; h < m_is_met.size(); ++h) {
      if (m_pairing.twin(h) == no_index && m_is_met[h] == 0) {
        std::vector<Index> corners = gap_at(h);
        if (!corners.empty()) {
          bridge.close(corners);
        }
      }
    }
    const auto fits = [this](const std::array<Index, 3>& face) {
      const std::vector<Vector3>& points = m_surface.points;
      const Vector3 vector = triangle_vector(points[face[0]], points[face[1]], points[face[2]]);
      return std::all_of(face.begin(), face.end(), [&](Index corner) {
        return corner < m_cloud.points.size() && vector.dot(m_cloud.normals[corner]) > 0;
      });
    };
    std::copy_if(m_surface.faces.begin() + std::ptrdiff_t(m_surface.first_hole_filling_face), m_surface.faces.end(),
                 std::back_inserter(m_cloud.triangles), fits);
  }

private:
  /// The most edges of a gap: at random, seven points lie no more evenly than that.
  static constexpr std::size_t longest_gap = 7;

  /// The corners of the gap to the right of a halfedge on the border, clockwise; none if they are too many.
  std::vector<Index> gap_at(Index first)
  {
    std::vector<Index> border;
    Index h = first;
    do {
      border.push_back(h);
      h = next(h);
    } while (h != first && m_is_met[h] == 0 && border.size() < longest_gap);
    if (h != first || border.size() < 3) {
      return {};
    }
    for (Index& side : border) {
      m_is_met[side] = 1;
      side = m_surface.origin(side);
    }
    return {border.rbegin(), border.rend()};
  }

  /// The halfedge on the other side of the gap at the end of a halfedge on the border.
  Index next(Index halfedge) const
  {
    const Index center = m_surface.target(halfedge);
    const std::vector<Vector3>& points = m_surface.points;
    std::pair<double, Index> result{boost::math::double_constants::two_pi, no_index}; // by the angle of the gap
    for (const Index h : m_pairing.outgoing()[center]) {
      if (m_pairing.twin(h) == no_index) {
        const double angle = angle_around(m_cloud.normals[center], points[m_surface.origin(halfedge)] - points[center],
                                          points[m_surface.target(h)] - points[center]);
        result = std::min(result, {angle > 0 ? angle : angle + boost::math::double_constants::two_pi, h});
      }
    }
    return result.second;
  }

  Triangulated_cloud& m_cloud;
  Indexed_triangles m_surface;
  Halfedge_pairing m_pairing;
  std::vector<char> m_is_met; ///< the halfedges around gaps
};

CSCD_INLINE Point_complex build_point_complex(const Point_cloud& cloud)
{
  Triangulated_cloud triangulated = Cloud_triangulation(cloud)();
  if (triangulated.triangles.empty()) {
    throw Input_error(
        "no triangle could be made between the points: they do not sample a surface; sample it more densely");
  }
  Gap_closing{triangulated}();
  return {std::move(triangulated.points), std::move(triangulated.normals), triangulated.triangles};
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_BUILD_POINT_COMPLEX_H
