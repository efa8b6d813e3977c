// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of match_skeletons.h.

#ifndef CSCD_APPLICATION_MATCH_SKELETONS_IMPL_H
#define CSCD_APPLICATION_MATCH_SKELETONS_IMPL_H

#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Application/estimate_shape_diameters.h>
#include <CSCD/Application/match_skeletons.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The main limbs of a skeleton.
class Skeleton_limbs
{
public:
  explicit Skeleton_limbs(const Indexed_skeleton& skeleton)
      : m_skeleton(skeleton), m_neighbors(node_neighbors(skeleton))
  {
    find_ends();
    m_from_end.reserve(m_ends.size());
    for (const Index end : m_ends) {
      m_from_end.push_back(distances_from({end}));
    }
    m_limbs.reserve(m_ends.size());
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
      m_limbs.push_back(find_limb(i));
    }
  }

  std::size_t size() const { return m_ends.size(); }
  Index end(std::size_t i) const { return m_ends[i]; }
  const std::vector<Index>& ends() const { return m_ends; }

  /// The distance of `node` from an end, relative to the length of the paths between all ends.
  double distance(std::size_t end, Index node) const
  {
    return std::min(m_from_end[end].distance[node] / m_length, max_distance);
  }

  /// So many places stand for where a limb begins: one alone moves too much with the pose.
  static constexpr std::size_t number_of_roots = 3;

  /// Half a radius, a radius, and one and a half before the limb meets others; relative to the same length.
  std::array<Vector_3, number_of_roots> roots(std::size_t i) const
  {
    std::array<Vector_3, number_of_roots> result;
    const std::vector<Index>& limb = m_limbs[i];
    const double to_joint = m_from_end[i].distance[limb.back()];
    const double radius = m_skeleton.has_radii() ? m_skeleton.radii[limb.back()] : 0;
    for (std::size_t k = 0; k < number_of_roots; ++k) {
      const double wanted = to_joint - double(k + 1) / 2 * radius;
      const auto place = std::find_if(limb.rbegin(), limb.rend() - 1,
                                      [&](Index node) { return m_from_end[i].distance[node] <= wanted; });
      result[k] = m_skeleton.points[*place] / m_length;
    }
    return result;
  }

  /// The radii at so many places of a limb, from the end on.
  static constexpr std::size_t number_of_radii = 8;

  /// Relative to the same length; 0 where radii are unknown.
  std::array<double, number_of_radii> radii(std::size_t i) const
  {
    std::array<double, number_of_radii> result{};
    const std::vector<Index>& limb = m_limbs[i];
    const std::vector<double>& distance = m_from_end[i].distance;
    for (std::size_t k = 0; m_skeleton.has_radii() && k < number_of_radii; ++k) {
      const double wanted = distance[limb.back()] * double(k + 1) / double(number_of_radii + 1);
      const auto place = std::find_if(limb.begin(), limb.end() - 1, [&](Index v) { return distance[v] >= wanted; });
      result[k] = m_skeleton.radii[*place] / m_length;
    }
    return result;
  }

private:
  /// An end is one if it is further from the paths between others, relative to the distance of the first two. On human
  /// bodies, heads are so by 0.2, fingers by 0.05.
  static constexpr double min_distance = 0.1;
  /// So many ends at most: an octopus has nine. The assignments are as many as their permutations.
  static constexpr std::size_t max_ends = 9;
  /// What is further, in another component too, counts as being so far, relative to the length of the paths.
  static constexpr double max_distance = 2;

  Skeleton_distances distances_from(const std::vector<Index>& starts) const
  {
    return distances_along(m_skeleton, m_neighbors, starts);
  }

  /// Of `nodes`, the one that is furthest among those that can be reached; the first if none can.
  static Index furthest(const std::vector<Index>& nodes, const Skeleton_distances& distances)
  {
    const auto key = [&](Index v) {
      return distances.distance[v] < Skeleton_distances::unreachable ? distances.distance[v] : -1.;
    };
    return *std::max_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return key(a) < key(b); });
  }

  /// Tips; all nodes if there are fewer than two of them.
  std::vector<Index> possible_ends() const
  {
    std::vector<Index> tips;
    std::vector<Index> all;
    all.reserve(m_skeleton.number_of_nodes());
    for (Index v = 0; v < m_skeleton.number_of_nodes(); ++v) {
      all.push_back(v);
      if (m_neighbors[v].size() == 1) {
        tips.push_back(v);
      }
    }
    return tips.size() < 2 ? all : tips;
  }

  /// Where the component with the longest edges in all has a possible end.
  Index start(const std::vector<Index>& possible) const
  {
    Multi_source_dijkstra_search components(m_skeleton.number_of_nodes());
    for (const Index v : possible) {
      if (components.label(v) == no_index) {
        components.reach(v, 0, v);
        components.spread([&](Index node, const auto& visit) {
          for (const Index next : m_neighbors[node]) {
            visit(next, 0.F);
          }
        });
      }
    }
    std::vector<double> length(m_skeleton.number_of_nodes(), 0);
    for (const std::array<Index, 2>& edge : m_skeleton.edges) {
      if (components.label(edge[0]) != no_index) {
        length[components.label(edge[0])] += m_skeleton.length(edge);
      }
    }
    return *std::max_element(possible.begin(), possible.end(), [&](Index a, Index b) { return length[a] < length[b]; });
  }

  void find_ends()
  {
    const std::vector<Index> possible = possible_ends();
    const Index first = furthest(possible, distances_from({start(possible)}));
    m_ends.push_back(first);
    std::vector<Index> paths{first};
    double least = 0;
    while (m_ends.size() < max_ends) {
      const Skeleton_distances distances = distances_from(paths);
      const Index next = furthest(possible, distances);
      const double length = distances.distance[next];
      if (!(length > least) || !(length < Skeleton_distances::unreachable)) {
        break;
      }
      least = std::max(least, min_distance * length);
      m_length += length;
      m_ends.push_back(next);
      for (Index v = next; v != no_index && distances.distance[v] > 0; v = distances.previous[v]) {
        paths.push_back(v);
      }
    }
    m_length = m_length > 0 ? m_length : 1;
  }

  /// The nodes from an end to where the paths to the other ends part.
  std::vector<Index> find_limb(std::size_t i) const
  {
    std::vector<std::size_t> count(m_skeleton.number_of_nodes(), 0);
    for (const Index other : m_ends) {
      for (Index v = other; v != no_index; v = m_from_end[i].previous[v]) {
        ++count[v];
      }
    }
    // The path to the end itself counts once more, there alone.
    --count[m_ends[i]];
    std::vector<Index> limb;
    for (Index v = m_ends[i == 0 ? size() - 1 : 0]; v != no_index; v = m_from_end[i].previous[v]) {
      if (count[v] + 1 == size()) {
        limb.push_back(v);
      }
    }
    if (limb.empty()) {
      limb.push_back(m_ends[i]);
    }
    std::reverse(limb.begin(), limb.end());
    return limb;
  }

  const Indexed_skeleton& m_skeleton;
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<Index> m_ends;
  std::vector<Skeleton_distances> m_from_end;
  std::vector<std::vector<Index>> m_limbs; // nodes of each, from its end on
  double m_length = 0;                     // of the paths between all ends
};

/// Finds which limbs may correspond.
class Limb_assignments
{
public:
  /// \pre `few` has no more ends than `many`
  Limb_assignments(const Skeleton_limbs& few, const Skeleton_limbs& many)
      : m_few(few), m_many(many), m_is_taken(many.size(), 0), m_chosen(few.size())
  {
    m_radius_costs.reserve(few.size() * many.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
      for (std::size_t j = 0; j < many.size(); ++j) {
        const auto a = few.radii(i);
        const auto b = many.radii(j);
        double sum = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
          sum += std::abs(a[k] - b[k]);
        }
        m_radius_costs.push_back(sum / double(a.size()));
      }
    }
    measure_pairs(few, m_few_pairs);
    measure_pairs(many, m_many_pairs);
    choose(0, 0);
  }

  struct Assignment
  {
    double cost;
    std::vector<std::size_t> ends; ///< for each end of the skeleton with few, that of the other
  };

  /// Those of the least cost, the best first.
  const std::vector<Assignment>& best() const { return m_best; }

private:
  /// So many are kept: of a body with five limbs, arms and legs alone can be exchanged in four ways.
  static constexpr std::size_t max_assignments = 8;

  /// How much straight distances of where limbs begin count, in those along the skeleton. On odd-numbered poses of
  /// FAUST it is better than 0.5, and 5 is no better.
  static constexpr double root_weight = 2;

  struct End_pair
  {
    double along;                                                 // the distance of the ends along the skeleton
    std::array<double, Skeleton_limbs::number_of_roots> straight; // those of where their limbs begin
  };

  static void measure_pairs(const Skeleton_limbs& limbs, std::vector<End_pair>& pairs)
  {
    pairs.reserve(limbs.size() * limbs.size());
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      for (std::size_t j = 0; j < limbs.size(); ++j) {
        End_pair pair{limbs.distance(i, limbs.end(j)), {}};
        const auto first = limbs.roots(i);
        const auto second = limbs.roots(j);
        for (std::size_t k = 0; k < first.size(); ++k) {
          pair.straight[k] = (first[k] - second[k]).norm();
        }
        pairs.push_back(pair);
      }
    }
  }

  /// Tries all ends for the `i`-th that can still be better than the best ones so far.
  void choose(std::size_t i, double cost)
  {
    if (i == m_few.size()) {
      keep(cost);
      return;
    }
    for (std::size_t j = 0; j < m_many.size(); ++j) {
      if (m_is_taken[j] != 0) {
        continue;
      }
      double sum = 0;
      for (std::size_t k = 0; k < i; ++k) {
        const End_pair& a = m_few_pairs[i * m_few.size() + k];
        const End_pair& b = m_many_pairs[j * m_many.size() + m_chosen[k]];
        sum += std::abs(a.along - b.along);
        for (std::size_t m = 0; m < a.straight.size(); ++m) {
          sum += root_weight / double(a.straight.size()) * std::abs(a.straight[m] - b.straight[m]);
        }
      }
      const double next_cost =
          cost + m_radius_costs[i * m_many.size() + j] + sum / double(std::max<std::size_t>(m_few.size() - 1, 1));
      if (m_best.size() < max_assignments || next_cost < m_best.back().cost) {
        m_is_taken[j] = 1;
        m_chosen[i] = j;
        choose(i + 1, next_cost);
        m_is_taken[j] = 0;
      }
    }
  }

  /// Keeps what is chosen, among the best in order of cost.
  void keep(double cost)
  {
    const auto place = std::upper_bound(m_best.begin(), m_best.end(), cost,
                                        [](double value, const Assignment& other) { return value < other.cost; });
    m_best.insert(place, {cost, m_chosen});
    m_best.resize(std::min(m_best.size(), max_assignments));
  }

  const Skeleton_limbs& m_few;
  const Skeleton_limbs& m_many;
  std::vector<double> m_radius_costs; // of each end of the few with each of the many
  std::vector<End_pair> m_few_pairs;
  std::vector<End_pair> m_many_pairs;
  std::vector<char> m_is_taken;
  std::vector<std::size_t> m_chosen;
  std::vector<Assignment> m_best;
};

/// Finds ends that may correspond, in the first and in the second skeleton; the most probable ones first.
class Limb_matching
{
public:
  Limb_matching(const Indexed_skeleton& first, const Indexed_skeleton& second)
      : m_first(first), m_second(second), m_is_few_first(m_first.size() <= m_second.size()),
        m_assignments(m_is_few_first ? Limb_assignments(m_first, m_second) : Limb_assignments(m_second, m_first))
  {
  }

  /// How many ways there are to match the limbs.
  std::size_t size() const { return m_assignments.best().size(); }

  /// See Limb_assignments.
  double cost(std::size_t way) const { return m_assignments.best()[way].cost; }

  const Skeleton_limbs& first() const { return m_first; }
  const Skeleton_limbs& second() const { return m_second; }

  /// The numbers of the ends that correspond in the `way`-th way.
  std::vector<std::array<std::size_t, 2>> numbers(std::size_t way) const
  {
    std::vector<std::array<std::size_t, 2>> result;
    const std::vector<std::size_t>& ends = m_assignments.best()[way].ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      result.push_back(m_is_few_first ? std::array<std::size_t, 2>{i, ends[i]}
                                      : std::array<std::size_t, 2>{ends[i], i});
    }
    return result;
  }

  /// The ends that correspond in the `way`-th way.
  std::vector<std::array<Index, 2>> ends(std::size_t way) const
  {
    std::vector<std::array<Index, 2>> result;
    for (const auto& [i, j] : numbers(way)) {
      result.push_back({m_first.end(i), m_second.end(j)});
    }
    return result;
  }

  /// For each node of the second skeleton, the one of the first at the most similar distances from the ends.
  std::vector<Index> nodes(std::size_t number_of_first, std::size_t number_of_second) const
  {
    const std::vector<std::array<std::size_t, 2>> pairs = numbers(0);
    std::vector<Index> result;
    result.reserve(number_of_second);
    for (Index v = 0; v < number_of_second; ++v) {
      double least = std::numeric_limits<double>::infinity();
      Index nearest = 0;
      for (Index u = 0; u < number_of_first; ++u) {
        double sum = 0;
        for (const auto& [i, j] : pairs) {
          sum += std::abs(m_first.distance(i, u) - m_second.distance(j, v));
        }
        if (sum < least) {
          least = sum;
          nearest = u;
        }
      }
      result.push_back(nearest);
    }
    return result;
  }

private:
  Skeleton_limbs m_first;
  Skeleton_limbs m_second;
  bool m_is_few_first;
  Limb_assignments m_assignments;
};

CSCD_INLINE Skeleton_match match_skeletons(const Indexed_skeleton& first, const Indexed_skeleton& second)
{
  const Limb_matching matching(first, second);
  return {matching.ends(0), matching.nodes(first.number_of_nodes(), second.number_of_nodes())};
}

/// For each vertex of a surface, how far it is from the ends of limbs. Parts of limbs keep these numbers in other
/// poses.
class End_distances
{
public:
  End_distances(const Skeletonized_surface& surface, const std::vector<Index>& ends)
      : m_surface(surface), m_number_of_ends(ends.size()), m_values(2 * ends.size() * surface.node.size())
  {
    const std::vector<std::vector<Index>> neighbors = node_neighbors(surface.skeleton);
    const std::vector<std::vector<Index>> edges = vertex_neighbors();
    std::vector<Skeleton_distances> along;
    along.reserve(ends.size());
    std::vector<std::size_t> all;
    for (const Index end : ends) {
      along.push_back(distances_along(surface.skeleton, neighbors, {end}));
      for (const Index other : ends) {
        m_between.push_back(along.back().distance[other]);
      }
      all.push_back(all.size());
    }
    const double greatest = max_distance * mean_distance(all);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      std::vector<double> values;
      values.reserve(surface.node.size());
      for (const Index node : surface.node) {
        values.push_back(std::min(along[i].distance[node], greatest));
      }
      smooth_along_surface(surface, number_of_smoothing_steps, values);
      const std::vector<double> on_surface = surface_distances(ends[i], edges);
      for (std::size_t v = 0; v < values.size(); ++v) {
        double* const of_vertex = m_values.data() + 2 * (m_number_of_ends * v + i);
        of_vertex[0] = values[v];
        of_vertex[1] = surface_weight * std::min(on_surface[v], greatest);
      }
    }
  }

  /// Of each vertex, one after the other, two numbers for each of the ends with these numbers, relative to the mean
  /// distance between them.
  std::vector<double> relative(const std::vector<std::size_t>& numbers) const
  {
    const double unit = mean_distance(numbers);
    std::vector<double> result;
    result.reserve(2 * numbers.size() * m_surface.node.size());
    for (std::size_t v = 0; v < m_surface.node.size(); ++v) {
      for (const std::size_t i : numbers) {
        const double* const values = m_values.data() + 2 * (m_number_of_ends * v + i);
        result.push_back(values[0] / unit);
        result.push_back(values[1] / unit);
      }
    }
    return result;
  }

private:
  /// Nodes are some way apart, and a skeleton is not where it was in another pose: so often, values are averaged along
  /// the surface. On odd-numbered poses of FAUST, more is no better.
  static constexpr std::size_t number_of_smoothing_steps = 10;
  /// How much distances along the edges of the surface count in those along the skeleton; likewise better than none, or
  /// as much.
  static constexpr double surface_weight = 0.5;
  /// What is further, in another component too, counts as being so far, relative to the mean distance of the ends.
  static constexpr double max_distance = 4;

  std::vector<std::vector<Index>> vertex_neighbors() const
  {
    std::vector<std::vector<Index>> result(m_surface.node.size());
    for (const std::array<Index, 3>& face : m_surface.triangles.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        result[face[k]].push_back(face[(k + 1) % 3]);
        result[face[(k + 1) % 3]].push_back(face[k]); // twice where two faces meet, which does no harm
      }
    }
    return result;
  }

  /// Between those of the ends with these numbers that are connected; 1 if none are.
  double mean_distance(const std::vector<std::size_t>& numbers) const
  {
    double sum = 0;
    double number = 0;
    for (const std::size_t i : numbers) {
      for (const std::size_t j : numbers) {
        const double distance = m_between[m_number_of_ends * i + j];
        if (distance > 0 && distance < Skeleton_distances::unreachable) {
          sum += distance;
          number += 1;
        }
      }
    }
    return sum > 0 ? sum / number : 1;
  }

  /// Along edges, from the vertices that belong to a node, or from the nearest to it.
  std::vector<double> surface_distances(Index end, const std::vector<std::vector<Index>>& edges) const
  {
    const std::vector<Vector_3>& points = m_surface.triangles.points;
    std::vector<Index> starts;
    Index nearest = 0;
    for (Index v = 0; v < points.size(); ++v) {
      if (m_surface.node[v] == end) {
        starts.push_back(v);
      }
      const auto squared_distance = [&](Index u) { return (points[u] - m_surface.skeleton.points[end]).squaredNorm(); };
      nearest = squared_distance(v) < squared_distance(nearest) ? v : nearest;
    }
    if (starts.empty()) {
      starts.push_back(nearest);
    }
    Dijkstra_search front(points.size());
    for (const Index start : starts) {
      front.reach(start, 0);
    }
    std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
    front.spread([&](Index vertex, float distance) {
      result[vertex] = distance;
      for (const Index next : edges[vertex]) {
        front.reach(next, distance + float((points[next] - points[vertex]).norm()));
      }
    });
    return result;
  }

  const Skeletonized_surface& m_surface;
  std::size_t m_number_of_ends;
  std::vector<double> m_between; // distances of each end from all of them, along the skeleton
  std::vector<double> m_values;  // of each vertex one after the other: for each end, along the skeleton and the surface
};

/// Finds the vertex of a surface that is at the most similar distances from the ends.
class Similar_vertex_search
{
public:
  /// \param distances as many for each vertex, one vertex after the other
  Similar_vertex_search(const Skeletonized_surface& surface, std::vector<double> distances)
      : m_distances(std::move(distances)), m_size(m_distances.size() / surface.node.size()),
        m_neighbors(node_neighbors(surface.skeleton)), m_vertices(m_neighbors.size()),
        m_means(m_neighbors.size() * m_size, 0)
  {
    for (Index v = 0; v < surface.node.size(); ++v) {
      m_vertices[surface.node[v]].push_back(v);
    }
    for (Index node = 0; node < m_vertices.size(); ++node) {
      for (const Index v : m_vertices[node]) {
        for (std::size_t i = 0; i < m_size; ++i) {
          m_means[node * m_size + i] += m_distances[v * m_size + i] / double(m_vertices[node].size());
        }
      }
    }
  }

  /// Among the vertices of the node whose vertices are the most similar in the mean, and of its neighbors.
  /// Linear in the number of nodes. \param wanted the distances
  /// \return the vertex, and the sum of the differences of its distances
  std::pair<Index, double> operator()(const double* wanted) const
  {
    double least = std::numeric_limits<double>::infinity();
    Index best_node = 0;
    for (Index node = 0; node < m_vertices.size(); ++node) {
      if (!m_vertices[node].empty()) {
        keep_less(m_means.data() + node * m_size, wanted, node, least, best_node);
      }
    }
    least = std::numeric_limits<double>::infinity();
    Index best = m_vertices[best_node].front();
    const auto look_among = [&](Index node) {
      for (const Index v : m_vertices[node]) {
        keep_less(m_distances.data() + v * m_size, wanted, v, least, best);
      }
    };
    look_among(best_node);
    std::for_each(m_neighbors[best_node].begin(), m_neighbors[best_node].end(), look_among);
    return {best, least};
  }

private:
  /// Makes `candidate` the best if the distances `found` differ by less than `least` from those that are wanted.
  void keep_less(const double* found, const double* wanted, Index candidate, double& least, Index& best) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_size && sum < least; ++i) {
      sum += std::abs(found[i] - wanted[i]);
    }
    if (sum < least) {
      least = sum;
      best = candidate;
    }
  }

  std::vector<double> m_distances;
  std::size_t m_size; // how many numbers a vertex has
  std::vector<std::vector<Index>> m_neighbors;
  std::vector<std::vector<Index>> m_vertices; // of each node
  std::vector<double> m_means;                // over them
};

/// The label of the greatest area around each vertex.
inline std::vector<std::size_t> labels_of_vertices(const Skeletonized_surface& surface,
                                                   const std::vector<std::size_t>& labels)
{
  std::vector<std::map<std::size_t, double>> areas(surface.node.size());
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const auto& [a, b, c] = surface.triangles.faces[f];
    const auto& points = surface.triangles.points;
    const double area = triangle_area(points[a], points[b], points[c]);
    for (const Index v : {a, b, c}) {
      areas[v][labels[f]] += area;
    }
  }
  std::vector<std::size_t> greatest;
  greatest.reserve(areas.size());
  for (const std::map<std::size_t, double>& areas_of_labels : areas) {
    greatest.push_back(
        std::max_element(areas_of_labels.begin(), areas_of_labels.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first);
  }
  return greatest;
}

/// Normals at the vertices, by the areas of the faces.
inline std::vector<Vector_3> vertex_normals(const Indexed_triangles& triangles)
{
  std::vector<Vector_3> normals(triangles.points.size());
  for (const auto& [a, b, c] : triangles.faces) {
    const Vector_3 vector = triangle_vector(triangles.points[a], triangles.points[b], triangles.points[c]);
    for (const Index v : {a, b, c}) {
      normals[v] += vector;
    }
  }
  std::transform(normals.begin(), normals.end(), normals.begin(), [](const Vector_3& v) { return v.normalized(); });
  return normals;
}

/// Finds, for each vertex of a surface, the one of another surface to which it corresponds.
class Vertex_matching
{
public:
  Vertex_matching(const Skeletonized_surface& first, const Skeletonized_surface& second)
      : m_first(first), m_second(second), m_limbs(first.skeleton, second.skeleton),
        m_first_distances(first, m_limbs.first().ends()), m_second_distances(second, m_limbs.second().ends()),
        m_first_normals(vertex_normals(first.triangles))
  {
  }

  /// By the way to match limbs of the least cost and difference which keeps the orientation best.
  std::vector<Index> best() const
  {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Index> result;
    for (std::size_t way = 0; way < m_limbs.size(); ++way) {
      auto [vertices, difference] = match(way);
      const double badness = cost_weight * m_limbs.cost(way) + difference_weight * difference - orientation(vertices);
      if (badness < least) {
        least = badness;
        result = std::move(vertices);
      }
    }
    return result;
  }

private:
  /// How much costs and differences count in the orientation. On odd-numbered poses of FAUST, half or twice as much is
  /// as good.
  static constexpr double cost_weight = 4;
  static constexpr double difference_weight = 16;

  /// For each vertex of the second surface, that of the first one, and the mean difference of their distances from
  /// ends.
  std::pair<std::vector<Index>, double> match(std::size_t way) const
  {
    std::array<std::vector<std::size_t>, 2> numbers;
    for (const auto& [first, second] : m_limbs.numbers(way)) {
      numbers[0].push_back(first);
      numbers[1].push_back(second);
    }
    const Similar_vertex_search similar_vertex(m_first, m_first_distances.relative(numbers[0]));
    const std::vector<double> wanted = m_second_distances.relative(numbers[1]);
    std::pair<std::vector<Index>, double> result;
    result.first.reserve(m_second.node.size());
    for (std::size_t i = 0; i < wanted.size(); i += wanted.size() / m_second.node.size()) {
      const auto [vertex, sum] = similar_vertex(wanted.data() + i);
      result.first.push_back(vertex);
      result.second += sum / double(wanted.size());
    }
    return result;
  }

  /// From -1 to 1: 1 if what is counterclockwise, seen from outside, is so on the other surface. A body and its mirror
  /// image have the same distances; where they tell its front from its back, this tells its left from its right.
  double orientation(const std::vector<Index>& vertices) const
  {
    double sum = 0;
    double area = 0;
    const std::vector<Vector_3>& first_points = m_first.triangles.points;
    const std::vector<Vector_3>& second_points = m_second.triangles.points;
    for (const auto& [a, b, c] : m_second.triangles.faces) {
      const auto [i, j, k] = std::array<Index, 3>{vertices[a], vertices[b], vertices[c]};
      const double turn = triangle_vector(first_points[i], first_points[j], first_points[k])
                              .dot(m_first_normals[i] + m_first_normals[j] + m_first_normals[k]);
      if (turn != 0) { // most corners of many faces correspond to the same vertex
        const double weight = triangle_area(second_points[a], second_points[b], second_points[c]);
        sum += turn > 0 ? weight : -weight;
        area += weight;
      }
    }
    return area > 0 ? sum / area : 0;
  }

  const Skeletonized_surface& m_first;
  const Skeletonized_surface& m_second;
  Limb_matching m_limbs;
  End_distances m_first_distances;
  End_distances m_second_distances;
  std::vector<Vector_3> m_first_normals;
};

/// Gives each vertex the label that most of the surface around it has.
inline void smooth_labels(const Skeletonized_surface& surface, std::vector<std::size_t>& labels)
{
  // On odd-numbered poses of FAUST and TOSCA, 5 and 50 steps are a little worse.
  constexpr std::size_t number_of_steps = 20;
  const std::vector<std::size_t> old_labels = labels;
  std::vector<double> greatest(labels.size(), -1);
  for (const std::size_t label : std::set<std::size_t>(labels.begin(), labels.end())) {
    std::vector<double> shares;
    shares.reserve(labels.size());
    for (const std::size_t old_label : old_labels) {
      shares.push_back(old_label == label ? 1 : 0);
    }
    smooth_along_surface(surface, number_of_steps, shares);
    for (std::size_t v = 0; v < labels.size(); ++v) {
      if (shares[v] > greatest[v]) {
        greatest[v] = shares[v];
        labels[v] = label;
      }
    }
  }
}

CSCD_INLINE std::vector<std::size_t> carry_labels(const Skeletonized_surface& first,
                                                  const std::vector<std::size_t>& labels,
                                                  const Skeletonized_surface& second)
{
  const std::vector<std::size_t> of_first = labels_of_vertices(first, labels);
  std::vector<std::size_t> of_second;
  of_second.reserve(second.node.size());
  for (const Index vertex : Vertex_matching(first, second).best()) {
    of_second.push_back(of_first[vertex]);
  }
  smooth_labels(second, of_second);
  std::vector<std::size_t> result;
  result.reserve(second.triangles.faces.size());
  for (const auto& [a, b, c] : second.triangles.faces) {
    result.push_back(of_second[b] == of_second[c] ? of_second[b] : of_second[a]);
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_APPLICATION_MATCH_SKELETONS_IMPL_H
