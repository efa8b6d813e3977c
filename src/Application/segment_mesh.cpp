// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of estimate_shape_diameters.h, segment_mesh.h and Part_merging.h.

#include "Application/Part_merging.h"
#include "Measure/skeleton_tools.h"
#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/segment_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// Averages values of the vertices along the surface: in each step, half of a value becomes the mean of the neighbors.
void smooth_along_surface(const Skeletonized_surface& surface, std::size_t number_of_steps, std::vector<double>& values)
{
  const std::size_t n = values.size();
  std::vector<double> sum;
  std::vector<double> weight; // an edge counts once for each of its faces
  for (std::size_t step = 0; step < number_of_steps; ++step) {
    sum.assign(n, 0);
    weight.assign(n, 0);
    for (const std::array<Index, 3>& face : surface.triangles.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[face[k]] += values[face[(k + 1) % 3]] + values[face[(k + 2) % 3]];
        weight[face[k]] += 2;
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      values[v] = (values[v] + sum[v] / weight[v]) / 2;
    }
  }
}

/// The shape diameters of the vertices of the triangles.
std::vector<double> vertex_shape_diameters(const Skeletonized_surface& surface, std::size_t number_of_smoothing_steps)
{
  const std::vector<std::vector<Index>> neighbors = node_neighbors(surface.skeleton);
  std::vector<double> diameters;
  for (std::size_t v = 0; v < surface.node.size(); ++v) {
    diameters.push_back(2 *
                        distance_to_edges(surface.skeleton, neighbors, surface.node[v], surface.triangles.points[v]));
  }
  smooth_along_surface(surface, number_of_smoothing_steps, diameters);
  return diameters;
}

} // namespace

std::vector<double> shape_diameters(const Skeletonized_surface& surface, std::size_t number,
                                    std::size_t number_of_smoothing_steps)
{
  const std::vector<double> values = vertex_shape_diameters(surface, number_of_smoothing_steps);
  std::vector<double> result(number, 0.);
  for (std::size_t v = 0; v < values.size(); ++v) {
    result[surface.number[v]] = values[v];
  }
  return result;
}

std::vector<double> face_shape_diameters(const Skeletonized_surface& surface, std::size_t number_of_smoothing_steps)
{
  const std::vector<double> values = vertex_shape_diameters(surface, number_of_smoothing_steps);
  std::vector<double> means;
  means.reserve(surface.triangles.faces.size());
  for (const auto& [a, b, c] : surface.triangles.faces) {
    means.push_back((values[a] + values[b] + values[c]) / 3);
  }
  return means;
}

namespace {

/// Cuts a surface into slices and measures their boundaries. Near linear.
class Slice_cutting
{
public:
  Slice_cutting(const Skeletonized_surface& surface, const std::vector<double>& diameters)
      : m_surface(surface), m_areas(face_areas(surface.triangles)),
        m_area(std::accumulate(m_areas.begin(), m_areas.end(), 0.))
  {
    find_slices();
    measure_slices(diameters);
    find_boundaries();
    add_turning_inside();
    shorten_boundaries(); // measures stay as the weights of the score were fitted to them
  }

  Slice_graph release() { return std::move(m_graph); }

private:
  const Vector3& corner(Index face, std::size_t i) const
  {
    return m_surface.triangles.points[m_surface.triangles.faces[face][i]];
  }
  const Vector3& origin(Index halfedge) const { return corner(Halfedge_pairing::face(halfedge), halfedge % 3); }
  Vector3 vector(Index halfedge) const { return origin(Halfedge_pairing::next(halfedge)) - origin(halfedge); }
  Index face_behind(Index halfedge) const { return Halfedge_pairing::face(m_surface.pairing.twin(halfedge)); }

  /// By how much the normal turns across the edge of `halfedge`, in radians; positive where the surface is concave.
  double turning(Index halfedge) const
  {
    const auto normal = [this](Index face) {
      return triangle_vector(corner(face, 0), corner(face, 1), corner(face, 2)).normalized();
    };
    const Vector3 here = normal(Halfedge_pairing::face(halfedge));
    const Vector3 there = normal(face_behind(halfedge));
    return -std::atan2(here.cross(there).dot(vector(halfedge).normalized()), here.dot(there));
  }

  /// Calls `use(h)` for one halfedge of each edge between two faces.
  template <class Use>
  void for_each_inner_edge(const Use& use) const
  {
    for (Index h = 0; h < m_surface.pairing.number_of_halfedges(); ++h) {
      const Index twin = m_surface.pairing.twin(h);
      if (twin != no_index && h < twin) {
        use(h);
      }
    }
  }

  /// The node of two corners of a face, else the nearest of three.
  Index node_of_face(Index face) const
  {
    const std::array<Index, 3>& corners = m_surface.triangles.faces[face];
    const std::array<Index, 3> nodes{m_surface.node[corners[0]], m_surface.node[corners[1]],
                                     m_surface.node[corners[2]]};
    if (nodes[1] == nodes[2]) {
      return nodes[1];
    }
    if (nodes[0] == nodes[1] || nodes[0] == nodes[2]) {
      return nodes[0];
    }
    const Vector3 center = (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3;
    const auto distance = [&](Index node) { return (m_surface.skeleton.points[node] - center).squaredNorm(); };
    return *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  }

  void find_slices()
  {
    const auto number_of_faces = Index(m_surface.triangles.faces.size());
    std::vector<Index> nodes;
    nodes.reserve(number_of_faces);
    for (Index f = 0; f < number_of_faces; ++f) {
      nodes.push_back(node_of_face(f));
    }
    Disjoint_sets sets(number_of_faces);
    for_each_inner_edge([&](Index h) {
      const Index face = Halfedge_pairing::face(h);
      const Index other = face_behind(h);
      if (nodes[face] == nodes[other]) {
        sets.join(face, other);
      }
    });
    Index number_of_slices = 0;
    m_graph.slice = sets.numbers(number_of_slices);
    const std::vector<std::vector<Index>> neighbors = node_neighbors(m_surface.skeleton);
    for (Index f = 0; f < number_of_faces; ++f) {
      if (m_graph.slice[f] == m_graph.slices.size()) {
        m_graph.slices.push_back({m_surface.skeleton.points[nodes[f]], 0, 0, neighbors[nodes[f]].size() > 2});
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
      const Index twin = m_surface.pairing.twin(h);
      if (twin == no_index) {
        return none;
      }
      const Index slice = m_graph.slice[Halfedge_pairing::face(twin)];
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
    const double min_area = negligible * m_area / double(diameters.size());
    const double min_diameter = negligible * std::sqrt(m_area);
    for (Index f = 0; f < diameters.size(); ++f) {
      Surface_slice& slice = m_graph.slices[m_graph.slice[f]];
      const double area = std::max(m_areas[f], min_area);
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
      const Index first = m_graph.slice[Halfedge_pairing::face(h)];
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
      boundary.moment += length * (origin(h) + vector(h) / 2);
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

  const Skeletonized_surface& m_surface;
  std::vector<double> m_areas; // of the faces
  double m_area;               // of all of them
  Slice_graph m_graph;
  std::vector<std::vector<Index>> m_inner_edges; // of each slice
};

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

} // namespace

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

std::vector<Index> segment_surface(const Skeletonized_surface& surface, std::size_t number_of_parts)
{
  const std::vector<double> diameters = face_shape_diameters(surface, default_number_of_diameter_smoothing_steps);
  const Slice_graph graph = Slice_cutting(surface, diameters).release();
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
