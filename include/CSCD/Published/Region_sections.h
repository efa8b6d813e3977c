// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes of regions in sections, and tips at the ends of limbs, on surfaces that are not cut.

#ifndef CSCD_PUBLISHED_REGION_SECTIONS_H
#define CSCD_PUBLISHED_REGION_SECTIONS_H

#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
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

/// Moves the nodes of regions towards the middle of their separators, and leads branches to the ends of limbs.
/// \tparam Triangulation a model of `SurfaceTriangulation`, or `Point_complex`
template <class Triangulation>
class Region_sections
{
public:
  Region_sections(const Triangulation& surface, const std::vector<Separator>& separators, const Region_packing& packing,
                  Skeleton_builder& builder)
      : m_surface(surface), m_separators(separators), m_packing(packing), m_builder(builder)
  {
  }

  /// \pre node i of the builder is that of region i, joined to those that it touches
  void operator()()
  {
    std::vector<Vector_3> outline;
    for (Index region = 0; region < m_packing.packed().size(); ++region) {
      curve_points(m_surface, separator(region), outline);
      const Section_disc disc = section_disc(outline);
      m_builder[region].position = region_share * m_builder[region].position + (1 - region_share) * disc.center;
      m_builder[region].radius = disc.radius();
    }
    for (const Side& side : find_ends()) {
      add_tip(side);
    }
  }

private:
  /// The share of the centroid of a region in the position of its node, as where the surface is cut.
  static constexpr double region_share = 0.5;

  /// The ends of limbs that are longer than this get nodes before the tip ...
  static constexpr double min_long_height = 1.5;
  /// ... in the middle of bands that are this high, and these as far from each other, relative to the radius at the
  /// node before.
  static constexpr double band_height = 0.5;
  /// A band may be so much wider than the radius before: its vertices are farther from its middle along the limb, too.
  static constexpr double max_thickening = 1.5;

  /// A side of a separator, beyond which there is no other.
  struct Side
  {
    Index region;
    double direction; ///< 1 where its normal points to, else -1
    Limb_end end{};
  };

  const Separator& separator(Index region) const { return m_separators[m_packing.packed()[region]]; }
  Index region_of(Index vertex) const { return m_packing.regions()[vertex]; }

  /// Positive on that side of the separator of `region` where the normal points to.
  double height(Index region, Index vertex) const
  {
    return separator(region).normal.dot(m_surface.points()[vertex] - separator(region).center);
  }

  /// For each region with a separator, how many more edges lead to others from the side that the normal points to than
  /// from the other one.
  std::vector<int> count_ways_out() const
  {
    std::vector<int> result(m_packing.packed().size(), 0);
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      const Index region = region_of(m_surface.origin(h));
      if (region < result.size() && region_of(m_surface.target(h)) != region) {
        result[region] += height(region, m_surface.origin(h)) > 0 ? 1 : -1;
      }
    }
    return result;
  }

  /// The sides of regions at which limbs end.
  std::vector<Side> find_ends() const
  {
    const std::vector<int> ways_out = count_ways_out();
    std::vector<Side> sides;
    std::vector<std::vector<Index>> sides_of_region(m_packing.regions().size());
    for (Index region = 0; region < ways_out.size(); ++region) {
      for (const int direction : {1, -1}) {
        if (m_builder.degree(region) == 0 || (m_builder.degree(region) == 1 && direction * ways_out[region] < 0)) {
          sides_of_region[region].push_back(Index(sides.size()));
          sides.push_back({region, double(direction)});
        }
      }
    }
    for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
      for (const Index i : sides_of_region[region_of(vertex)]) {
        if (sides[i].direction * height(sides[i].region, vertex) > 0) {
          sides[i].end.add(m_surface.points()[vertex], double(m_surface.vertex_area(vertex)),
                           m_packing.regions().distance(vertex));
        }
      }
    }
    return sides;
  }

  /// Leads the limb of `side` to its end: through the middle of bands as long as it gets no thicker, and not back.
  void add_tip(const Side& side)
  {
    Index last = side.region;
    Limb_end end = side.end;
    while (end.height() > min_long_height * m_builder[last].radius) {
      const double radius = m_builder[last].radius;
      double height = band_height * radius;
      while (3 * height < end.height() && !end.beyond(height).below(height).ball()) {
        height *= 2; // there are few vertices around a thin limb
      }
      const std::optional<Limb_end::Ball> ball = end.beyond(height).below(height).ball();
      if (!ball || ball->radius > max_thickening * radius || !leads_on(last, ball->center)) {
        break;
      }
      last = append(last, ball->center, std::min(ball->radius, radius), side.region);
      end = end.beyond(3 * height / 2); // the middle of the band
    }
    const std::optional<Vector_3> tip = end.tip(m_builder[last].position, m_builder[last].radius);
    if (tip && leads_on(last, *tip)) {
      append(last, *tip, m_builder[last].radius, side.region);
    }
  }

  /// Whether the branch turns by less than a right angle at `last`, if it goes on to `position`.
  bool leads_on(Index last, const Vector_3& position) const
  {
    const Skeleton_builder::Node& node = m_builder[last];
    return node.neighbors.empty() ||
           (node.position - m_builder[node.neighbors.front()].position).dot(position - node.position) > 0;
  }

  Index append(Index last, const Vector_3& position, double radius, Index region)
  {
    const Index node = m_builder.add_node(position, radius);
    m_builder[node].pieces = {region};
    m_builder.add_edge(last, node);
    return node;
  }

  const Triangulation& m_surface;
  const std::vector<Separator>& m_separators;
  const Region_packing& m_packing;
  Skeleton_builder& m_builder;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_REGION_SECTIONS_H
