// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a skeleton lies in the body, and how its tips belong to the limbs of the surface.

#ifndef CSCD_SRC_MEASURE_BODY_MEASURES_H
#define CSCD_SRC_MEASURE_BODY_MEASURES_H

#include "Measure/skeleton_tools.h"
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Measures of rays from a point across a skeleton.
struct Ray_star
{
  double deviation = 0; ///< standard deviation of the rays' lengths over their mean
  double offset = 0;    ///< length of the mean of the rays as vectors, over their mean length
};

/// Casts rays from `point`, evenly spread in the plane across `tangent`, to where they first meet the surface.
/// \return nothing if less than half of them meet it
/// \pre `tangent` has unit length
inline std::optional<Ray_star> cast_ray_star(const Solid_queries& queries, const Vector3& point, const Vector3& tangent)
{
  constexpr int number_of_rays = 32; // twice as many change means over a skeleton by less than one percent
  const Vector3 u = tangent.unitOrthogonal();
  const Vector3 v = tangent.cross(u);
  double sum = 0;
  double sum_of_squares = 0;
  Vector3 moment = Vector3::Zero();
  int number_of_hits = 0;
  for (int i = 0; i < number_of_rays; ++i) {
    const double angle = boost::math::double_constants::two_pi * i / number_of_rays;
    const Vector3 direction = std::cos(angle) * u + std::sin(angle) * v;
    if (const std::optional<Surface_hit> hit = queries.first_hit(point, direction)) {
      sum += hit->distance;
      sum_of_squares += hit->distance * hit->distance;
      moment += hit->distance * direction;
      ++number_of_hits;
    }
  }
  if (2 * number_of_hits < number_of_rays || !(sum > 0)) {
    return std::nullopt;
  }
  const double mean = sum / number_of_hits;
  const double variance = std::max(sum_of_squares / number_of_hits - mean * mean, 0.);
  return Ray_star{std::sqrt(variance) / mean, moment.norm() / sum};
}

/// Measures where a skeleton lies in a body in whose coordinates it is given. Measures of the body alone are left out.
inline Position_measures measure_position(const Solid_queries& queries, const Skeleton& skeleton)
{
  constexpr double spacing = 1. / 300; // of the samples, in diagonals: some ten of them in the radius of a thin limb
  // Means over more would not be better, and take minutes. Skeletons of bodies have fewer samples.
  constexpr std::size_t max_number_of_samples = 1 << 16;
  Position_measures result;
  result.max_distance_outside = 0;
  const auto is_inside = [&](const Vector3& point) {
    if (queries.is_inside(point)) {
      return true;
    }
    const double distance = (queries.closest_point(point).point - point).norm();
    result.max_distance_outside = std::max(result.max_distance_outside, distance);
    return false;
  };
  const auto nodes_inside = std::count_if(skeleton.points.begin(), skeleton.points.end(), is_inside);
  result.fraction_of_nodes_inside = double(nodes_inside) / double(skeleton.number_of_nodes());
  const std::vector<Edge_sample> samples = sample_edges(skeleton, spacing, max_number_of_samples);
  std::size_t samples_inside = 0;
  std::size_t number_of_stars = 0;
  double deviation = 0;
  double offset = 0;
  for (const Edge_sample& sample : samples) {
    if (!is_inside(sample.point)) {
      continue;
    }
    ++samples_inside;
    if (const std::optional<Ray_star> star = cast_ray_star(queries, sample.point, sample.tangent)) {
      deviation += star->deviation;
      offset += star->offset;
      ++number_of_stars;
    }
  }
  if (!samples.empty()) {
    result.fraction_of_length_inside = double(samples_inside) / double(samples.size());
  }
  if (number_of_stars > 0) {
    result.deviation_by_length = deviation / double(number_of_stars);
    result.offset_by_length = offset / double(number_of_stars);
  }
  return result;
}

/// For every vertex, the mean of its distances along edges from up to 32 vertices of its component. The first of these
/// is the one with the smallest number, the others the farthest from those before; so they are spread evenly.
/// O(n log n).
inline std::vector<float> mean_distances(const Triangulated_surface& surface)
{
  // The first ones are tips of limbs; this many cover the body too.
  constexpr int max_number_of_sources = 32;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> result(surface.number_of_vertices(), 0.f);
  std::vector<float> from_nearest(result.size(), infinity);
  Dijkstra_search search(result.size());
  std::vector<Index> component;
  for (Index root = 0; root < result.size(); ++root) {
    if (from_nearest[root] < infinity) {
      continue;
    }
    int number_of_sources = 0;
    for (Index source = root; number_of_sources < max_number_of_sources && from_nearest[source] > 0;
         ++number_of_sources) {
      component.clear();
      search.clear();
      search.reach(source, 0);
      search.spread([&](Index vertex, float distance) {
        component.push_back(vertex);
        result[vertex] += distance;
        from_nearest[vertex] = std::min(from_nearest[vertex], distance);
        for (const Index h : surface.outgoing(vertex)) {
          search.reach(surface.target(h), distance + float(surface.length(h)));
        }
      });
      source = *std::max_element(component.begin(), component.end(),
                                 [&](Index a, Index b) { return from_nearest[a] < from_nearest[b]; });
    }
    for (const Index vertex : component) {
      result[vertex] /= float(number_of_sources);
    }
  }
  return result;
}

/// A part of a surface that reaches out of the rest.
struct Found_limb
{
  Index tip = no_index; ///< the vertex of greatest level
  float height = 0;     ///< how much greater that level is than the one where the limb begins
};

/// Finds limbs by persistence: the level of a vertex is its mean distance from the component. As the level sinks, the
/// set of vertices above it grows; its connected parts appear at tips, and end where they meet a part with a higher
/// tip. A part is a limb from any level on where it is a disc, high enough, and slender enough. A part with a handle is
/// not a limb, since a skeleton has a cycle there and no tip. The limb begins at the last of the levels where it was
/// one and met another part or itself.
class Surface_limbs
{
public:
  /// Of a limb: 2 pi length^2 / area. It is about the length over the radius for a cylinder, and 1 for a half sphere
  /// whose pole is a radius from the rim. On odd-numbered shapes of the Princeton benchmark and FAUST, heads of
  /// people have 1.8 to 3.5, stubs of teddies from 1.2 on, bulges of ants' bodies up to 0.8.
  static constexpr float min_slenderness = 1;
  /// Relative to the least level of the component, which is of the order of the whole body's radius or half its length:
  /// fingers of people, thumbs included, have 0.049 to 0.12, toes and unevenness of meshes up to 0.035 (as above).
  static constexpr float min_relative_height = 0.04F;

  /// O(n log n).
  /// \param surface closed; referred to. Area counts without hole-filling faces.
  explicit Surface_limbs(const Triangulated_surface& surface)
      : m_surface(surface), m_level(mean_distances(surface)), m_components(m_level.size()), m_component(m_level.size()),
        m_part(m_level.size(), no_index)
  {
    std::vector<Index> order = all_indices(m_level.size());
    std::stable_sort(order.begin(), order.end(), [this](Index a, Index b) { return m_level[a] > m_level[b]; });
    measure_components(order);
    for (const Index vertex : order) {
      add(vertex);
    }
    for (Part& part : m_parts) {
      if (part.parent == no_index && part.limb == no_index) {
        try_limb(part, component(part.tip).least_level);
      }
    }
  }

  const std::vector<Found_limb>& limbs() const { return m_limbs; }

  /// The limb that has the highest corner of `face` in its upper half; `no_index` if there is none. Where limbs stand
  /// on limbs, the outermost.
  Index limb_near_tip(Index face) const
  {
    Index vertex = m_surface.origin(3 * face);
    for (const Index h : Triangulated_surface::face_halfedges(face)) {
      vertex = m_level[m_surface.origin(h)] > m_level[vertex] ? m_surface.origin(h) : vertex;
    }
    Index part = m_part[vertex];
    while (part != no_index && m_parts[part].limb == no_index) {
      part = m_parts[part].parent;
    }
    if (part == no_index) {
      return no_index;
    }
    const Found_limb& limb = m_limbs[m_parts[part].limb];
    return m_level[limb.tip] - m_level[vertex] <= limb.height / 2 ? m_parts[part].limb : no_index;
  }

private:
  /// A connected component of the surface.
  struct Component
  {
    float least_level = 0;
    float area = 0;
  };

  /// A connected part of the surface above a level.
  struct Part
  {
    Index tip;
    Index parent = no_index; ///< the part that it has met, and that has the higher tip
    Index limb = no_index;   ///< the limb that it is
    int euler_characteristic = 0;
    float area = 0;
  };

  void measure_components(const std::vector<Index>& order)
  {
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      m_components.join(m_surface.origin(h), m_surface.target(h));
    }
    for (const Index vertex : order) {
      component(vertex).least_level = m_level[vertex];
      component(vertex).area += m_surface.vertex_area(vertex);
    }
  }

  Component& component(Index vertex) { return m_component[m_components.find(vertex)]; }

  /// Takes note of it if `part`, as it is above `level`, is a limb.
  void try_limb(Part& part, float level)
  {
    const float height = m_level[part.tip] - level;
    // Along a limb with the part a of the area, the level grows by 1 - 2 a for each unit of length where it begins, and
    // by 1 at its tip.
    const float length = height / (1 - std::min(part.area / component(part.tip).area, 0.5F));
    if (part.euler_characteristic == 1 && height > min_relative_height * component(part.tip).least_level &&
        boost::math::float_constants::two_pi * length * length > min_slenderness * part.area) {
      if (part.limb == no_index) {
        part.limb = Index(m_limbs.size());
        m_limbs.emplace_back();
      }
      m_limbs[part.limb] = {part.tip, height};
    }
  }

  /// Adds `vertex` to the part above the level. \pre all higher vertices have been added, and no others
  void add(Index vertex)
  {
    m_met.clear();
    int change = 1; // of the Euler characteristic
    for (const Index h : m_surface.outgoing(vertex)) {
      if (is_added(m_surface.target(h))) {
        m_met.push_back(whole_part(m_part[m_surface.target(h)]));
        change -= is_added(m_surface.opposite_vertex(h)) ? 0 : 1;
      }
    }
    // Parts are numbered by their tips, the highest first.
    std::sort(m_met.begin(), m_met.end());
    m_met.erase(std::unique(m_met.begin(), m_met.end()), m_met.end());
    if (m_met.empty()) {
      m_met.push_back(Index(m_parts.size()));
      m_parts.push_back({vertex});
    } else if (change != 0) { // parts meet, or one meets itself
      for (const Index part : m_met) {
        try_limb(m_parts[part], m_level[vertex]);
      }
    }
    join_met(vertex);
    m_parts[m_met.front()].euler_characteristic += change;
  }

  bool is_added(Index vertex) const { return m_part[vertex] != no_index; }

  /// The part that `part` belongs to by now. It is few joins away, as the part with the higher tip goes on.
  Index whole_part(Index part) const
  {
    while (m_parts[part].parent != no_index) {
      part = m_parts[part].parent;
    }
    return part;
  }

  /// Joins the parts that `vertex` meets.
  void join_met(Index vertex)
  {
    Part& highest = m_parts[m_met.front()];
    for (auto i = m_met.begin() + 1; i != m_met.end(); ++i) {
      Part& part = m_parts[*i];
      part.parent = m_met.front();
      highest.area += part.area;
      highest.euler_characteristic += part.euler_characteristic;
    }
    highest.area += m_surface.vertex_area(vertex);
    m_part[vertex] = m_met.front();
  }

  const Triangulated_surface& m_surface;
  std::vector<float> m_level;         // of every vertex
  Disjoint_sets m_components;         // of vertices
  std::vector<Component> m_component; // by the representative of the set
  std::vector<Index> m_part;          // the part that a vertex was added to
  std::vector<Index> m_met;           // working memory
  std::vector<Part> m_parts;
  std::vector<Found_limb> m_limbs;
};

/// The limbs whose upper half may contain the end of a branch: the limb nearest to the end, and the limb that the
/// branch points to unless that is more than twice as far. `no_index` where there is none.
inline std::array<Index, 2> limbs_near_tip(const Surface_limbs& limbs, const Solid_queries& queries, const Vector3& end,
                                           const Vector3& direction)
{
  constexpr double max_ratio = 2; // skeletons end about a radius before the end of a limb
  const Surface_point nearest = queries.closest_point(end);
  std::array<Index, 2> result{limbs.limb_near_tip(nearest.face), no_index};
  if (direction.squaredNorm() > 0) {
    const std::optional<Surface_hit> hit = queries.first_hit(end, direction);
    if (hit && hit->distance <= max_ratio * (nearest.point - end).norm()) {
      result[1] = limbs.limb_near_tip(hit->face);
    }
  }
  return result;
}

/// Compares the tips of `skeleton` with the limbs of the surface, in the same coordinates. A tip and a limb of
/// `limbs_near_tip()` belong together unless one of them belongs to a nearer one. O(n log n).
inline Limb_measures measure_limbs(const Triangulated_surface& surface, const Solid_queries& queries,
                                   const Skeleton& skeleton)
{
  const Surface_limbs limbs(surface);
  Limb_measures result;
  for (const Found_limb& limb : limbs.limbs()) {
    result.limbs.push_back({surface.point(limb.tip), limb.height, false});
  }
  std::vector<std::tuple<double, Index, Index>> pairs; // distance, limb, tip
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  std::size_t number_of_tips = 0;
  for (Index tip = 0; tip < neighbors.size(); ++tip) {
    if (neighbors[tip].size() != 1) {
      continue;
    }
    ++number_of_tips;
    const Vector3& end = skeleton.points[tip];
    for (const Index limb : limbs_near_tip(limbs, queries, end, end - skeleton.points[neighbors[tip].front()])) {
      if (limb != no_index) {
        pairs.emplace_back((end - result.limbs[limb].tip).norm(), limb, tip);
      }
    }
  }
  const std::vector<std::array<Index, 2>> taken = take_nearest_pairs(std::move(pairs));
  for (const auto& [limb, tip] : taken) {
    result.limbs[limb].has_tip = true;
  }
  const std::size_t number_of_pairs = taken.size();
  result.number_of_limbs_without_tip = result.limbs.size() - number_of_pairs;
  result.number_of_tips_without_limb = number_of_tips - number_of_pairs;
  if (!result.limbs.empty()) {
    result.tip_recall = double(number_of_pairs) / double(result.limbs.size());
  }
  if (number_of_tips > 0) {
    result.tip_precision = double(number_of_pairs) / double(number_of_tips);
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_SRC_MEASURE_BODY_MEASURES_H
