// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a distance field to the closed curve around the limb of its source (algorithms 3 and 4).

#ifndef CSCD_PUBLISHED_CUT_LOOP_FINDER_H
#define CSCD_PUBLISHED_CUT_LOOP_FINDER_H

#include <CSCD/Published/Cut_tree.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Appends to `path` the halfedges of a path from `vertex` to `source`, each step to the nearest neighbor (supplement,
/// Alg. 4). Unlike there, a step must lead down: so no vertex is passed twice. O(k) for k steps and their edges.
/// \return false, with steps to a minimum of the distance, if `source` is not reached
template <class Measures>
bool descend(const Measures& measures, Index vertex, Index source, std::vector<Index>& path)
{
  while (vertex != source) {
    Index best = no_index;
    double min_distance = measures.distance(vertex);
    measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
      if (neighbor == source || measures.distance(neighbor) < min_distance) {
        min_distance = neighbor == source ? -std::numeric_limits<double>::infinity() : measures.distance(neighbor);
        best = halfedge;
      }
    });
    if (best == no_index) {
      return false;
    }
    path.push_back(best);
    vertex = measures.frames().triangulation().target(best);
  }
  return true;
}

/// The gradients, of length 1, of the two fronts that meet at the cut point `vertex`: the cycle of the samples around
/// it is split into two arcs with the greatest angle between the sums of their gradients that converge. Nothing if
/// no arcs converge. O(d^2) for degree d up to 32, O(d) beyond.
template <class Measures>
std::optional<std::array<std::complex<double>, 2>> front_gradients(const Measures& measures, Index vertex)
{
  // Samples that are sorted into arcs one by one; of more, several go together.
  constexpr std::size_t max_samples = 32;
  Gradient_samples samples;
  measures.collect_samples(vertex, samples);
  const std::size_t size = samples.size();
  // The sums up to each sample. The cycle is passed twice, so that arcs need not wrap around.
  boost::container::small_vector<Gradient_sample, 33> sums(1);
  for (std::size_t i = 0; i < 2 * size; ++i) {
    const Gradient_sample& sample = samples[i % size];
    sums.push_back({sums.back().direction + sample.direction, sums.back().gradient + sample.gradient});
  }
  const auto arc = [&sums](std::size_t begin, std::size_t end) {
    const std::complex<double> gradient = sums[end].gradient - sums[begin].gradient;
    return Gradient_sample{sums[end].direction - sums[begin].direction, gradient / std::abs(gradient)};
  };
  const std::size_t stride = (size + max_samples - 1) / max_samples;
  double min_cosine = std::numeric_limits<double>::max();
  std::optional<std::array<std::complex<double>, 2>> result;
  for (std::size_t begin = 0; begin < size; begin += stride) {
    for (std::size_t end = begin + stride; end < size; end += stride) {
      const Gradient_sample a = arc(begin, end);
      const Gradient_sample b = arc(end, begin + size);
      const double cosine = dot(a.gradient, b.gradient); // not a number where a sum is 0
      if (cosine < min_cosine && are_converging(a, b)) {
        min_cosine = cosine;
        result = {a.gradient, b.gradient};
      }
    }
  }
  return result;
}

/// The edges from `vertex` to the two nearest vertices in the ring around it that are nearer to the source than their
/// neighbors in the ring; nothing where fewer than two are. Where equal distances follow each
/// other, the first counts.
template <class Measures>
std::optional<std::array<Index, 2>> ring_minima(const Measures& measures, Index vertex)
{
  boost::container::small_vector<Index, 16> halfedges;
  boost::container::small_vector<std::pair<double, std::size_t>, 16> ring;
  measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
    ring.emplace_back(measures.distance(neighbor), ring.size());
    halfedges.push_back(halfedge);
  });
  boost::container::small_vector<std::pair<double, std::size_t>, 16> minima;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] < ring[(i + ring.size() - 1) % ring.size()] && ring[i] < ring[(i + 1) % ring.size()]) {
      minima.push_back(ring[i]);
    }
  }
  if (minima.size() < 2) {
    return std::nullopt;
  }
  std::sort(minima.begin(), minima.end());
  return std::array<Index, 2>{halfedges[minima[0].second], halfedges[minima[1].second]};
}

/// The edges along which to leave the cut point `vertex` towards the source, one on each side of the cut locus (section
/// 3.1.4, which is missing): the edges to two minima of the distance in the ring around it. They need not lead down,
/// since the cut locus may run between. Where there is one minimum only, the edges that are closest in direction to the
/// geodesics of the two fronts. Nothing if the fronts have no two sides, or one edge serves both.
template <class Measures>
std::optional<std::array<Index, 2>> incoming_directions(const Measures& measures, Index vertex)
{
  if (const auto minima = ring_minima(measures, vertex)) {
    return minima;
  }
  const auto gradients = front_gradients(measures, vertex);
  if (!gradients) {
    return std::nullopt;
  }
  std::array<Index, 2> result{no_index, no_index};
  std::array<double, 2> least{2, 2}; // of the cosines with the gradients
  measures.frames().for_each_neighbor(vertex, [&](Index, Index halfedge) {
    const std::complex<double> direction = std::polar(1., measures.frames().direction_at_origin(halfedge));
    for (std::size_t side = 0; side < 2; ++side) {
      const double cosine = dot((*gradients)[side], direction);
      if (cosine < least[side]) {
        least[side] = cosine;
        result[side] = halfedge;
      }
    }
  });
  return result[0] != result[1] ? std::optional(result) : std::nullopt;
}

/// A simple closed curve along edges, and how it was found.
struct Cut_loop
{
  /// `found`, or why there is none: `no_cut_point`, else what the last candidate was rejected for.
  Cut_loop_outcome outcome = Cut_loop_outcome::no_cut_point;
  /// From the target to the base and back, if there is a curve.
  std::vector<Index> halfedges;
  /// Distance of the target along the surface.
  double distance = 0;
};

/// Finds closed curves from distance fields as published (supplement, Alg. 3, lines 2 to 6): selects the target of a
/// source among its cut points, by the thresholds of Laplacian and gradient angle or on the cut locus, traces the two
/// paths back from it, and joins them. Cut points are tried in the order of the rule until one passes all tests, so
/// that only vertices that come before the target are looked at. One object serves one thread, and keeps working memory
/// of the size of the surface. \tparam Space a `Field_search_space`
template <class Space>
class Cut_loop_finder
{
public:
  /// \param space is referred to, as \param settings: which cut point is the target, and what cut points are
  Cut_loop_finder(const Space& space, const Field_search_settings& settings)
      : m_frames(space.frames), m_triangulation(space.frames.triangulation()), m_points(space.surface.points()),
        m_settings(settings), m_cut_locus(is_of_points ? point_cut_locus_settings() : Cut_locus_settings()),
        m_on_first(m_points.size())
  {
    m_cut_locus.laplacian_threshold = settings.laplacian_threshold.value_or(m_cut_locus.laplacian_threshold);
    m_cut_locus.angle_threshold = settings.angle_threshold.value_or(m_cut_locus.angle_threshold);
    m_cut_locus.minimum_branch_length = settings.minimum_branch_length;
    if constexpr (!is_of_points) {
      m_has_handles =
          genus_of_closed_surface(space.heat_method.elements.number_of_components(),
                                  m_triangulation.number_of_vertices(), m_triangulation.number_of_faces()) > 0;
    }
  }

  /// Finds the loop of a source at `source_point`, in a face at the vertex `source`, the end of its paths; `distances`
  /// has the distance of every vertex from there. The loop is valid until the next call. O(n + k log n) for n vertices
  /// if k vertices come before the target; O(n log n) where the tree of the cut locus is built.
  const Cut_loop& operator()(Index source, const Vector3& source_point, const std::vector<double>& distances)
  {
    const Measures measures(m_frames, distances);
    std::optional<Cut_tree> cut;
    if (m_settings.cut_locus_rule == Cut_locus_rule::tree) {
      cut.emplace(find_cut_tree(measures, {source}, m_cut_locus, m_has_handles));
    }
    m_source_point = source_point;
    m_loop.outcome = Cut_loop_outcome::no_cut_point;
    m_loop.halfedges.clear();
    collect_candidates(measures);
    while (!m_candidates.empty() && m_loop.outcome != Cut_loop_outcome::found) {
      std::pop_heap(m_candidates.begin(), m_candidates.end(), std::greater<>());
      const Index vertex = m_candidates.back().second;
      m_candidates.pop_back();
      if (cut ? cut->is_kept(vertex) : measures.is_cut(vertex, m_cut_locus)) {
        m_loop.outcome = try_target(measures, source, vertex);
      }
    }
    return m_loop;
  }

private:
  using Frames = typename Space::Frames;
  using Measures = Cut_locus_indicators<Frames>;
  using Triangulation = std::decay_t<decltype(std::declval<const Frames&>().triangulation())>;
  static constexpr bool is_of_points = std::is_same_v<Frames, Point_frames>;

  /// A target is farther from its source than this many mean edge lengths: nearer, the field of the heat method is
  /// inaccurate.
  static constexpr double min_distance = 4;
  /// The minimum distance of a target, relative to that in space: below 1 it is an error, but some error is tolerated.
  static constexpr double min_distance_to_chord = 0.98;
  /// The minimum distance in space between the two paths half way down, relative to that of the target along the
  /// surface: it is 0.64 on a round tube, about 0 around a bump. This decides about more targets than any other test.
  static constexpr double min_path_separation = 0.3;

  /// Makes a heap of the vertices that are far enough from the source, the nearest by the rule of targets first.
  void collect_candidates(const Measures& measures)
  {
    const bool is_in_space = m_settings.target_rule == Target_rule::nearest_in_space;
    m_candidates.clear();
    const double min_key = min_distance * m_frames.mean_edge_length();
    for (Index vertex = 0; vertex < m_points.size(); ++vertex) {
      if (measures.is_reached(vertex) && measures.distance(vertex) >= min_key) {
        m_candidates.emplace_back(is_in_space ? (m_points[vertex] - m_source_point).norm() : measures.distance(vertex),
                                  vertex);
      }
    }
    std::make_heap(m_candidates.begin(), m_candidates.end(), std::greater<>());
  }

  /// Traces the loop of `source` through `target`.
  Cut_loop_outcome try_target(const Measures& measures, Index source, Index target)
  {
    m_loop.distance = measures.distance(target);
    if (m_loop.distance < min_distance_to_chord * (m_points[target] - m_source_point).norm()) {
      return Cut_loop_outcome::distance_below_chord;
    }
    const std::optional<std::array<Index, 2>> directions = incoming_directions(measures, target);
    if (!directions) {
      return Cut_loop_outcome::one_direction;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      m_path[side].assign(1, (*directions)[side]);
      if (!descend(measures, m_triangulation.target(m_path[side].front()), source, m_path[side])) {
        return Cut_loop_outcome::not_connected;
      }
    }
    cut_where_paths_join();
    if (!is_loop(target)) {
      return Cut_loop_outcome::meets_at_once;
    }
    const double separation = (half_way(measures, m_path[0]) - half_way(measures, m_path[1])).norm();
    if (separation < min_path_separation * m_loop.distance) {
      return Cut_loop_outcome::narrow;
    }
    m_loop.halfedges = m_path[0];
    for (auto h = m_path[1].rbegin(); h != m_path[1].rend(); ++h) {
      m_loop.halfedges.push_back(m_triangulation.twin(*h));
    }
    return Cut_loop_outcome::found;
  }

  /// Ends both paths at the first vertex of the second path that is on the first path too. Since each path passes a
  /// vertex once, the remaining loop is simple: it has no steps back and forth, and no vertex comes twice. That vertex
  /// is the source, or near it.
  void cut_where_paths_join()
  {
    m_on_first.clear();
    for (const Index h : m_path[0]) {
      m_on_first.mark(m_triangulation.target(h));
    }
    const auto is_joined = [&](Index h) { return m_on_first.is_marked(m_triangulation.target(h)); };
    // Both end at the source.
    const auto second_end = std::find_if(m_path[1].begin(), m_path[1].end(), is_joined);
    const Index base = m_triangulation.target(*second_end);
    m_path[1].erase(second_end + 1, m_path[1].end());
    const auto ends_at_base = [&](Index h) { return m_triangulation.target(h) == base; };
    const auto first_end = std::find_if(m_path[0].begin(), m_path[0].end(), ends_at_base);
    m_path[0].erase(first_end + 1, m_path[0].end());
  }

  /// Whether the paths have more than an edge each, and do not return to the target.
  bool is_loop(Index target) const
  {
    const auto is_at_target = [&](Index h) { return m_triangulation.target(h) == target; };
    return std::all_of(m_path.begin(), m_path.end(), [&](const std::vector<Index>& path) {
      return path.size() > 1 && std::none_of(path.begin(), path.end(), is_at_target);
    });
  }

  /// The point of `path`, which begins at the target, at half the distance of the target.
  Vector3 half_way(const Measures& measures, const std::vector<Index>& path) const
  {
    const double goal = measures.distance(m_triangulation.origin(path.front())) / 2;
    for (const Index h : path) {
      const Index from = m_triangulation.origin(h);
      const Index to = m_triangulation.target(h);
      if (measures.distance(to) <= goal) {
        const double drop = measures.distance(from) - measures.distance(to);
        const double part = drop > 0 ? std::clamp((measures.distance(from) - goal) / drop, 0., 1.) : 1;
        return (1 - part) * m_points[from] + part * m_points[to];
      }
    }
    return m_points[m_triangulation.target(path.back())];
  }

  const Frames& m_frames;
  const Triangulation& m_triangulation;
  const std::vector<Vector3>& m_points;
  const Field_search_settings& m_settings;
  Cut_locus_settings m_cut_locus;
  bool m_has_handles = false;                         ///< around which cut loci have loops
  std::vector<std::pair<double, Index>> m_candidates; ///< a heap, the nearest first
  std::array<std::vector<Index>, 2> m_path;           ///< from the target down
  Epoch_marks m_on_first;                             ///< the vertices of the first path
  Vector3 m_source_point = Vector3::Zero();
  Cut_loop m_loop;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOOP_FINDER_H
