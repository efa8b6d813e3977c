// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From slices of a surface to parts: which neighboring parts belong together.

#ifndef CSCD_SRC_APPLICATION_PART_MERGING_H
#define CSCD_SRC_APPLICATION_PART_MERGING_H

#include <CSCD/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// A slice: connected faces that belong to the same node.
struct Surface_slice
{
  Vector3 point; ///< of its node
  double area = 0;
  double log_diameter = 0; ///< mean by area of the logarithm of the shape diameter
  bool is_at_junction = false;
};

/// Sums over the edges between two slices or parts, weighted by length.
struct Part_boundary
{
  double length = 0;
  double turning = 0;               ///< of the surface across the boundary, positive where it is concave, in radians
  double concave_turning = 0;       ///< the concave part of it alone
  Vector3 moment = Vector3::Zero(); ///< of the midpoints
  double log_diameter = 0;

  void add(const Part_boundary& other)
  {
    length += other.length;
    turning += other.turning;
    concave_turning += other.concave_turning;
    moment += other.moment;
    log_diameter += other.log_diameter;
  }
};

/// Where two slices or parts touch.
struct Part_border
{
  std::array<Index, 2> parts; ///< the smaller number first
  Part_boundary boundary{};
  double score = 0; ///< of the parts, see `merge_score()`

  bool operator<(const Part_border& other) const { return std::tie(score, other.parts) < std::tie(other.score, parts); }
};

/// Slices, the slice of each face, and the borders between slices.
struct Slice_graph
{
  std::vector<Surface_slice> slices;
  std::vector<Index> slice; ///< of each face
  std::vector<Part_border> borders;
  double area = 0; ///< of all slices
};

/// The number of features of two neighboring parts.
inline constexpr std::size_t number_of_merge_features = 15;

/// In the order of `Part_merging::features()`.
using Merge_features = std::array<double, number_of_merge_features>;

/// The logarithm of the odds that two parts are one for people.
double merge_score(const Merge_features& features);

/// Merges neighboring slices, and the parts that come of it, the most probable first.
class Part_merging
{
public:
  explicit Part_merging(const Slice_graph& graph) : m_graph(graph), m_borders(graph.borders)
  {
    for (Index s = 0; s < graph.slices.size(); ++s) {
      const Surface_slice& slice = graph.slices[s];
      m_parts.push_back({{s}, slice.area, slice.area * slice.log_diameter});
    }
    for (const Part_border& border : m_borders) {
      for (const Index s : border.parts) {
        m_parts[s].boundary_length += border.boundary.length;
      }
    }
  }

  /// Merges until no two parts have a positive score, or, if `number_of_parts` is not 0, until there are so many.
  /// O(s^2) for s slices where parts have few neighbors.
  void run(std::size_t number_of_parts)
  {
    for (Part_border& border : m_borders) {
      border.score = merge_score(features(border));
    }
    for (std::size_t left = m_parts.size(); left > number_of_parts && !m_borders.empty(); --left) {
      const Part_border best = *std::max_element(m_borders.begin(), m_borders.end());
      if (number_of_parts == 0 && best.score <= 0) {
        break;
      }
      merge(best);
    }
  }

  /// The part of each slice, by the number of one of its slices.
  std::vector<Index> part_of_slices() const
  {
    std::vector<Index> result(m_parts.size());
    for (Index p = 0; p < m_parts.size(); ++p) {
      for (const Index s : m_parts[p].slices) {
        result[s] = p;
      }
    }
    return result;
  }

private:
  struct Part
  {
    std::vector<Index> slices; // none if it went into another one
    double area = 0;
    double log_diameter = 0; // integral over the area
    double boundary_length = 0;

    double mean_log_diameter() const { return log_diameter / area; }
  };

  /// The mean place of the nodes of a part near a boundary, and the mean logarithm of its diameter there.
  struct Vicinity
  {
    Vector3 center = Vector3::Zero();
    double log_diameter = 0;
    bool has_junction = false;
  };

  // Of the local radius: how far the vicinity of a boundary reaches, and how far a junction there may be.
  static constexpr double vicinity_reach = 3;
  static constexpr double junction_reach = 1.5;

  Vicinity vicinity(const Part& part, const Vector3& center, double radius) const
  {
    const double reach = vicinity_reach * radius;
    const double reach_of_junction = junction_reach * radius;
    Vicinity result;
    double area = 0;
    for (const Index s : part.slices) {
      const Surface_slice& slice = m_graph.slices[s];
      const double squared_distance = (slice.point - center).squaredNorm();
      if (squared_distance < reach * reach) {
        area += slice.area;
        result.center += slice.area * slice.point;
        result.log_diameter += slice.area * slice.log_diameter;
        result.has_junction =
            result.has_junction || (slice.is_at_junction && squared_distance < reach_of_junction * reach_of_junction);
      }
    }
    if (area > 0) {
      result.center /= area;
      result.log_diameter /= area;
    } else {
      result.center = m_graph.slices[part.slices.front()].point;
      result.log_diameter = part.mean_log_diameter();
    }
    return result;
  }

  /// The features of the parts at a border. Of the two, the smaller one has less area.
  Merge_features features(const Part_border& border) const
  {
    const Part& first = m_parts[border.parts[0]];
    const Part& second = m_parts[border.parts[1]];
    const Part_boundary& boundary = border.boundary;
    const bool is_first_smaller = first.area < second.area;
    const Part& smaller = is_first_smaller ? first : second;
    const Part& larger = is_first_smaller ? second : first;
    const double length = boundary.length;
    const Vector3 center = boundary.moment / length;
    const double log_diameter = boundary.log_diameter / length;
    const double radius = std::exp(log_diameter) / 2;
    const Vicinity near_smaller = vicinity(smaller, center, radius);
    const Vicinity near_larger = vicinity(larger, center, radius);
    const double ratio = larger.mean_log_diameter() - smaller.mean_log_diameter();
    const double near_ratio = near_larger.log_diameter - near_smaller.log_diameter;
    constexpr double log_pi = 1.1447298858494002;
    const double straightness =
        (center - near_smaller.center).normalized().dot((near_larger.center - center).normalized());
    const bool has_junction = near_smaller.has_junction || near_larger.has_junction;
    Merge_features result{
        boundary.turning / length, // mean, of the surface
        boundary.concave_turning / length,
        ratio, // of the mean diameters, a logarithm as the others
        std::abs(ratio),
        near_ratio, // within three radii of the boundary
        std::abs(near_ratio),
        std::log(length * length / smaller.area),
        std::log(smaller.area / m_graph.area),
        std::log(larger.area / m_graph.area),
        std::log(length) - log_pi - log_diameter,                 // length over the girth of a limb as thick
        straightness,                                             // of the skeleton across the boundary, a cosine
        std::log(smaller.area) - 2 * smaller.mean_log_diameter(), // slenderness
        length / smaller.boundary_length,
        length / larger.boundary_length,
        has_junction ? 1. : 0.,
    };
    for (double& feature : result) { // of parts without extent
      feature = std::isfinite(feature) ? feature : 0;
    }
    return result;
  }

  /// Merges both parts of `border` into the first.
  void merge(const Part_border& border)
  {
    const auto [to, from] = border.parts;
    Part& result = m_parts[to];
    Part& other = m_parts[from];
    result.slices.insert(result.slices.end(), other.slices.begin(), other.slices.end());
    result.area += other.area;
    result.log_diameter += other.log_diameter;
    result.boundary_length += other.boundary_length - 2 * border.boundary.length;
    other.slices.clear();
    // The borders of the result with its neighbors; where both parts had one, the sums of both.
    std::map<Index, Part_boundary> boundaries;
    const auto is_merged = [to = to, from = from](Index part) { return part == to || part == from; };
    const auto first = std::partition(m_borders.begin(), m_borders.end(), [&](const Part_border& its) {
      return !is_merged(its.parts[0]) && !is_merged(its.parts[1]);
    });
    std::for_each(first, m_borders.end(), [&](const Part_border& its) {
      const Index neighbor = its.parts[is_merged(its.parts[0]) ? 1 : 0];
      if (!is_merged(neighbor)) {
        boundaries[neighbor].add(its.boundary);
      }
    });
    m_borders.erase(first, m_borders.end());
    for (const auto& [neighbor, boundary] : boundaries) {
      m_borders.push_back({{std::min(to, neighbor), std::max(to, neighbor)}, boundary});
      m_borders.back().score = merge_score(features(m_borders.back()));
    }
  }

  const Slice_graph& m_graph;
  std::vector<Part> m_parts; // by their first slice
  std::vector<Part_border> m_borders;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_APPLICATION_PART_MERGING_H
