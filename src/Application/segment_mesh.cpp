// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shape diameters, and parts of a surface: it is cut into slices, and neighboring ones that belong together are merged.

#include "Measure/skeleton_tools.h"
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Averages values of the vertices along the surface: in each step, half of a value becomes the mean of the neighbors.
void smooth_along_surface(const Triangulated_surface& surface, std::size_t number_of_steps, std::vector<double>& values)
{
  for (std::size_t step = 0; step < number_of_steps; ++step) {
    std::vector<double> sum(values.size(), 0); // an edge counts once for each of its faces
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      sum[surface.origin(h)] += values[surface.target(h)] + values[surface.opposite_vertex(h)];
    }
    for (Index v = 0; v < values.size(); ++v) {
      values[v] = (values[v] + sum[v] / (2. * surface.degree(v))) / 2;
    }
  }
}

/// The shape diameters of the vertices of the surface.
std::vector<double> vertex_shape_diameters(const Skeletonized_surface& input, std::size_t number_of_smoothing_steps)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(input.skeleton);
  std::vector<double> diameters;
  for (Index v = 0; v < input.node.size(); ++v) {
    diameters.push_back(2 * distance_to_edges(input.skeleton, neighbors, input.node[v], input.surface.point(v)));
  }
  smooth_along_surface(input.surface, number_of_smoothing_steps, diameters);
  return diameters;
}

} // namespace

std::vector<double> shape_diameters(const Skeletonized_surface& input, std::size_t number,
                                    std::size_t number_of_smoothing_steps)
{
  const std::vector<double> values = vertex_shape_diameters(input, number_of_smoothing_steps);
  std::vector<double> result(number, 0.);
  for (std::size_t v = 0; v < values.size(); ++v) {
    result[input.number[v]] = values[v];
  }
  return result;
}

std::vector<double> face_shape_diameters(const Skeletonized_surface& input, std::size_t number_of_smoothing_steps)
{
  const std::vector<double> values = vertex_shape_diameters(input, number_of_smoothing_steps);
  std::vector<double> means;
  means.reserve(input.surface.number_of_faces());
  for (Index face = 0; face < input.surface.number_of_faces(); ++face) {
    const auto value = [&](Index corner) { return values[input.surface.origin(3 * face + corner)]; };
    means.push_back((value(0) + value(1) + value(2)) / 3);
  }
  return means;
}

namespace {

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
constexpr std::size_t number_of_merge_features = 15;

/// In the order of `Part_merging::features()`.
using Merge_features = std::array<double, number_of_merge_features>;

/// \name Weights of the score of two parts
/// Fitted by logistic regression to the segmentations by people of the odd-numbered meshes of the Princeton benchmark;
/// see `doc/applications.md`.
/// @{

/// The value that is subtracted from each feature.
constexpr std::array<double, number_of_merge_features> feature_means{
    -0.00663, 0.11, 0.445, 0.55, 0.163, 0.268, 0.798, -5.42, -1.61, -0.941, 0.108, -0.31, 0.392, 0.155, 0.137};

/// The divisor of each difference.
constexpr std::array<double, number_of_merge_features> feature_deviations{
    0.118, 0.161, 0.57, 0.468, 0.362, 0.293, 1.59, 2.87, 1.62, 1.26, 0.633, 2.48, 0.25, 0.202, 0.344};

/// The score of two parts that are average in all features: 0.6 more than the odds say, so that doubtful parts are one
/// part. Of -0.25 to 1.5 more, the Rand index is best between 0.5 and 0.75 on odd-numbered meshes.
constexpr double mean_score = 0.0423;

/// Of the normalized features.
constexpr std::array<double, number_of_merge_features> linear_weights{
    -0.208, -0.965, -0.127, -0.319, 0.00289, 0.307, 0.804, 0.677, -1.59, -0.467, -0.164, -0.395, -0.0525, 0.583, 0.214};

/// Of their products: of the first with all, of the second with all from the second on, and so on.
constexpr std::array<double, number_of_merge_features*(number_of_merge_features + 1) / 2> quadratic_weights{
    0.0578,  0.0584,  -0.099,  0.0511,  0.0322,  0.0266,  0.176,    0.0736, 0.0139,  -0.315,  -0.0559, 0.22,
    0.0151,  -0.0358, 0.0136,  0.306,   0.385,   -0.0745, -0.228,   0.0471, -0.0637, -0.163,  0.265,   0.154,
    -0.0632, -0.0538, -0.0931, -0.0357, 0.00423, 0.012,   -0.162,   -0.163, 0.233,   -0.247,  0.00641, 0.383,
    -0.12,   0.0505,  0.111,   0.0424,  0.0993,  0.00513, 0.163,    0.0871, -0.159,  0.0506,  -0.321,  0.145,
    -0.159,  0.114,   0.343,   -0.0323, -0.0864, 0.127,   -0.0757,  -0.156, 0.323,   0.109,   -0.134,  -0.172,
    0.0456,  0.0204,  -0.171,  -0.0827, 0.0345,  0.194,   0.117,    0.424,  0.0284,  -0.0961, -0.0859, -0.156,
    0.0214,  -0.0888, 0.0522,  0.0257,  -0.141,  0.466,   -0.0272,  -0.227, 0.344,   0.114,   -0.0255, 0.043,
    0.305,   1.09,    -0.294,  -0.304,  -0.365,  -0.44,   -0.0503,  0.135,  -0.347,  -0.166,  -0.0927, -0.577,
    -0.121,  -0.134,  0.0448,  0.0407,  0.329,   0.261,   0.0522,   -0.238, 0.138,   0.0167,  -0.177,  0.15,
    0.0941,  0.104,   0.177,   -0.0766, -0.205,  -0.34,   -0.00541, 0.373,  -0.0663, -0.0745, -0.0363, -0.106};

/// @}

/// The logarithm of the odds that two parts are one for people.
double merge_score(const Merge_features& features)
{
  constexpr double greatest = 3; // normalized features beyond this were too rare to be fitted
  Merge_features normalized{};
  for (std::size_t i = 0; i < number_of_merge_features; ++i) {
    normalized[i] = std::clamp((features[i] - feature_means[i]) / feature_deviations[i], -greatest, greatest);
  }
  double score = mean_score;
  std::size_t product = 0;
  for (std::size_t i = 0; i < number_of_merge_features; ++i) {
    score += linear_weights[i] * normalized[i];
    for (std::size_t j = i; j < number_of_merge_features; ++j) {
      score += quadratic_weights[product++] * normalized[i] * normalized[j];
    }
  }
  return score;
}

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

/// Cuts a surface into slices and measures their boundaries. Near linear.
class Slice_cutting
{
public:
  Slice_cutting(const Skeletonized_surface& input, const std::vector<double>& diameters)
      : m_input(input), m_surface(input.surface)
  {
    find_slices();
    measure_slices(diameters);
    find_boundaries();
    add_turning_inside();
    shorten_boundaries(); // measures stay as the weights of the score were fitted to them
  }

  Slice_graph release() { return std::move(m_graph); }

private:
  Vector3 vector(Index halfedge) const
  {
    return m_surface.point(m_surface.target(halfedge)) - m_surface.point(m_surface.origin(halfedge));
  }
  Index face_behind(Index halfedge) const { return Triangulated_surface::face(m_surface.twin(halfedge)); }

  /// By how much the normal turns across the edge of `halfedge`, in radians; positive where the surface is concave.
  double turning(Index halfedge) const
  {
    const Vector3 here = m_surface.face_vector(Triangulated_surface::face(halfedge)).normalized();
    const Vector3 there = m_surface.face_vector(face_behind(halfedge)).normalized();
    return -std::atan2(here.cross(there).dot(vector(halfedge).normalized()), here.dot(there));
  }

  /// Calls `use(h)` for one halfedge of each edge between two faces.
  template <class Use>
  void for_each_inner_edge(const Use& use) const
  {
    for (Index h = 0; h < m_surface.number_of_halfedges(); ++h) {
      if (m_surface.twin(h) != no_index && h < m_surface.twin(h)) {
        use(h);
      }
    }
  }

  /// The node of two corners of a face, else the nearest of three.
  Index node_of_face(Index face) const
  {
    const std::array<Index, 3> corners{m_surface.origin(3 * face), m_surface.target(3 * face),
                                       m_surface.opposite_vertex(3 * face)};
    const std::array<Index, 3> nodes{m_input.node[corners[0]], m_input.node[corners[1]], m_input.node[corners[2]]};
    if (nodes[1] == nodes[2]) {
      return nodes[1];
    }
    if (nodes[0] == nodes[1] || nodes[0] == nodes[2]) {
      return nodes[0];
    }
    const Vector3 center =
        (m_surface.point(corners[0]) + m_surface.point(corners[1]) + m_surface.point(corners[2])) / 3;
    const auto distance = [&](Index node) { return (m_input.skeleton.points[node] - center).squaredNorm(); };
    return *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  }

  void find_slices()
  {
    std::vector<Index> nodes;
    for (Index f = 0; f < m_surface.number_of_faces(); ++f) {
      nodes.push_back(node_of_face(f));
    }
    Disjoint_sets sets(nodes.size());
    for_each_inner_edge([&](Index h) {
      if (nodes[Triangulated_surface::face(h)] == nodes[face_behind(h)]) {
        sets.join(Triangulated_surface::face(h), face_behind(h));
      }
    });
    Index number_of_slices = 0;
    m_graph.slice = sets.numbers(number_of_slices);
    const std::vector<std::vector<Index>> neighbors = node_neighbors(m_input.skeleton);
    for (Index f = 0; f < nodes.size(); ++f) {
      if (m_graph.slice[f] == m_graph.slices.size()) {
        m_graph.slices.push_back({m_input.skeleton.points[nodes[f]], 0, 0, neighbors[nodes[f]].size() > 2});
      }
    }
  }

  /// Where a face has two sides on one other slice, it goes over to that, the greatest gain first: so boundaries have
  /// no teeth. Slices and unions of slices stay connected, and none is lost. There are at most as many steps as
  /// boundaries have edges.
  void shorten_boundaries()
  {
    std::priority_queue<std::pair<double, Index>> candidates;
    const auto propose = [&](Index face) {
      if (const double gain = better_slice(face).first; gain > 0) {
        candidates.emplace(gain, face);
      }
    };
    for (Index face = 0; face < m_graph.slice.size(); ++face) {
      propose(face);
    }
    while (!candidates.empty()) {
      const auto [gain, face] = candidates.top();
      candidates.pop();
      if (const auto [current_gain, slice] = better_slice(face); current_gain == gain) {
        m_graph.slice[face] = slice;
        for (Index h = 3 * face; h < 3 * face + 3; ++h) {
          propose(face_behind(h));
        }
      }
    }
  }

  /// By how much boundaries get shorter if the face goes over to the slice that is on two of its sides, and that slice;
  /// 0 if there is none, or no side is on its own.
  std::pair<double, Index> better_slice(Index face) const
  {
    constexpr std::pair<double, Index> none{0, no_index};
    double gain = 0;
    Index other = no_index;
    int number_of_own = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (m_surface.twin(h) == no_index) {
        return none;
      }
      const Index slice = m_graph.slice[face_behind(h)];
      if (slice != m_graph.slice[face] && other != no_index && slice != other) {
        return none;
      }
      const bool is_own = slice == m_graph.slice[face];
      number_of_own += is_own ? 1 : 0;
      gain += (is_own ? -1 : 1) * vector(h).norm();
      other = is_own ? other : slice;
    }
    return number_of_own == 1 ? std::pair(gain, other) : none;
  }

  void measure_slices(const std::vector<double>& diameters)
  {
    // A zero area or thickness counts as a negligible one, so that all logarithms are finite.
    constexpr double negligible = 1e-9;
    const double min_area = negligible * m_surface.total_area() / double(diameters.size());
    const double min_diameter = negligible * std::sqrt(m_surface.total_area());
    for (Index f = 0; f < diameters.size(); ++f) {
      Surface_slice& slice = m_graph.slices[m_graph.slice[f]];
      const double area = std::max(m_surface.face_vector(f).norm() / 2, min_area);
      slice.area += area;
      slice.log_diameter += area * std::log(std::max(diameters[f], min_diameter));
      m_graph.area += area;
    }
    for (Surface_slice& slice : m_graph.slices) {
      slice.log_diameter /= slice.area;
    }
  }

  /// Adds the turning of the surface across an edge, so far as it turns along `direction`.
  void add_turning(Index halfedge, const Vector3& direction, double share, Part_boundary& boundary) const
  {
    const Vector3 edge = vector(halfedge);
    const double length = edge.norm();
    const double along = edge.normalized().dot(direction);
    const double its_turning = turning(halfedge) * length * share * (1 - along * along);
    boundary.turning += its_turning;
    boundary.concave_turning += std::max(0., its_turning);
  }

  Vector3 direction(Index from, Index to) const
  {
    return (m_graph.slices[to].point - m_graph.slices[from].point).normalized();
  }

  void find_boundaries()
  {
    m_inner_edges.resize(m_graph.slices.size());
    std::map<std::array<Index, 2>, Index> number_of;
    for_each_inner_edge([&](Index h) {
      const Index first = m_graph.slice[Triangulated_surface::face(h)];
      const Index second = m_graph.slice[face_behind(h)];
      if (first == second) {
        m_inner_edges[first].push_back(h);
        return;
      }
      const std::array<Index, 2> pair{std::min(first, second), std::max(first, second)};
      const auto [place, is_new] = number_of.emplace(pair, Index(m_graph.borders.size()));
      if (is_new) {
        m_graph.borders.push_back({pair});
      }
      Part_boundary& boundary = m_graph.borders[place->second].boundary;
      const double length = std::max(vector(h).norm(), std::numeric_limits<double>::min());
      boundary.length += length;
      boundary.moment += length * (m_surface.point(m_surface.origin(h)) + vector(h) / 2);
      boundary.log_diameter += length * (m_graph.slices[first].log_diameter + m_graph.slices[second].log_diameter) / 2;
      add_turning(h, direction(pair[0], pair[1]), 1, boundary);
    });
  }

  /// Shares the turning inside each slice among its boundaries: creases run next to boundaries as often as along them.
  void add_turning_inside()
  {
    std::vector<double> whole_length(m_graph.slices.size(), 0);
    for (const Part_border& border : m_graph.borders) {
      for (const Index s : border.parts) {
        whole_length[s] += border.boundary.length;
      }
    }
    for (auto& [parts, boundary, score] : m_graph.borders) {
      for (const Index s : parts) {
        for (const Index h : m_inner_edges[s]) {
          add_turning(h, direction(parts[0], parts[1]), boundary.length / whole_length[s], boundary);
        }
      }
    }
  }

  const Skeletonized_surface& m_input;
  const Triangulated_surface& m_surface;
  Slice_graph m_graph;
  std::vector<std::vector<Index>> m_inner_edges; // of each slice
};

} // namespace

std::vector<Index> segment_surface(const Skeletonized_surface& input, std::size_t number_of_parts)
{
  const std::vector<double> diameters = face_shape_diameters(input, default_number_of_diameter_smoothing_steps);
  const Slice_graph graph = Slice_cutting(input, diameters).release();
  Part_merging merging(graph);
  merging.run(number_of_parts);
  const std::vector<Index> part_of_slices = merging.part_of_slices();
  std::vector<Index> number(graph.slices.size(), no_index); // of the parts, in the order of their first faces
  Index next = 0;
  std::vector<Index> result;
  result.reserve(graph.slice.size());
  for (const Index slice : graph.slice) {
    Index& its_number = number[part_of_slices[slice]];
    its_number = its_number == no_index ? next++ : its_number;
    result.push_back(its_number);
  }
  return result;
}

} // namespace CSCD::internal
