// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a distance field to the closed curve around the limb of its source.

#ifndef CSCD_PUBLISHED_CUT_LOOP_FINDER_H
#define CSCD_PUBLISHED_CUT_LOOP_FINDER_H

#include <CSCD/Published/Descent.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/incoming_directions.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Epoch_marks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A simple closed curve along edges, and how it was found.
struct Cut_loop
{
  /// `found`, or why there is none: `no_cut_point`, else what the last candidate was rejected for.
  Cut_loop_outcome outcome = Cut_loop_outcome::no_cut_point;
  /// From the target to the base and back, if there is a curve.
  Edge_steps steps;
  Index target = no_index;
  /// Where the two paths to the source join: the source or a vertex near it.
  Index base = no_index;
  /// Distance of the target along the surface.
  double distance = 0;
  /// Distance in space between the two paths half way down, relative to that of the target along the surface: 0.64 on a
  /// round tube, about 0 around a bump.
  double path_separation = 0;
};

/// Selects the target of a source among its cut points, traces the two paths back from it, and joins them (supplement,
/// Alg. 3, lines 3 to 6). Cut points are tried in the order of the rule until one passes all tests, so that only
/// vertices that come before the target are looked at. One object serves one thread, and keeps working memory of the
/// size of the surface.
/// \tparam Measures `Cut_locus_indicators` of a triangulation, or `Point_cut_locus_indicators`
template <class Measures>
class Cut_loop_finder
{
public:
  using Frames = typename Measures::Frames;
  using Triangulation = std::decay_t<decltype(std::declval<const Frames&>().triangulation())>;

  /// \param points the positions of the vertices; as `frames`, it is referred to and must outlive this object
  Cut_loop_finder(const Frames& frames, const std::vector<Vector_3>& points)
      : m_frames(frames), m_triangulation(frames.triangulation()), m_points(points), m_descent(frames),
        m_on_first(points.size())
  {
    CGAL_precondition(points.size() == m_triangulation.number_of_vertices());
  }

  /// Finds the loop of a source at `source_point`, in a face at the vertex `source`, to which the paths lead, with the
  /// cut points for which `is_cut(vertex)` holds. O(n log n) for n vertices: where the field has minima everywhere, as
  /// on faces of extreme shape, it gives up.
  template <class Predicate>
  void find(const Measures& measures, Index source, const Vector_3& source_point, Target_rule rule,
            const Predicate& is_cut, Cut_loop& loop)
  {
    m_source_point = source_point;
    loop.outcome = Cut_loop_outcome::no_cut_point;
    loop.steps.clear();
    m_descent.set_budget(max_steps_per_vertex * m_points.size());
    double begin = 0;
    double end = first_shell * m_frames.mean_edge_length();
    bool has_more = true;
    for (; has_more && begin < end && loop.outcome != Cut_loop_outcome::found && !m_descent.is_exhausted();
         begin = std::exchange(end, 2 * end)) {
      has_more = collect_candidates(measures, rule, begin, end);
      while (!m_candidates.empty() && loop.outcome != Cut_loop_outcome::found && !m_descent.is_exhausted()) {
        std::pop_heap(m_candidates.begin(), m_candidates.end(), std::greater<>());
        const Index vertex = m_candidates.back().second;
        m_candidates.pop_back();
        if (is_cut(vertex)) {
          loop.outcome = try_target(measures, source, vertex, loop);
        }
      }
    }
  }

  /// The halfedges of a loop in order, from the target on.
  /// \pre no edge of the loop is on a border
  std::vector<Index> halfedges(const Cut_loop& loop) const
  {
    std::vector<Index> result;
    for (const Edge_step& step : loop.steps) {
      CGAL_precondition(!step.is_reversed);
      result.push_back(step.halfedge);
    }
    return result;
  }

private:
  /// The steps of all paths of a source, for each vertex of the surface. On meshes of 10,000 and 50,000 vertices no
  /// source took more than 2 and 4; on faces of extreme shape it can be thousands.
  static constexpr std::size_t max_steps_per_vertex = 16;
  /// Candidates are ordered shell by shell, each twice as thick as all before; the first one, in mean edge lengths, has
  /// the targets of limbs of usual meshes.
  static constexpr double first_shell = 16;
  /// A target is farther from its source than this many mean edge lengths: nearer, the field of the heat method is
  /// inaccurate.
  static constexpr double min_distance = 4;
  /// The minimum distance of a target, relative to that in space: below 1 it is an error, of which some is tolerated.
  static constexpr double min_distance_to_chord = 0.98;
  /// The minimum of `path_separation`: half of that of a round tube. It decides about more targets than any other test.
  static constexpr double min_path_separation = 0.3;
  /// The maximum distance of the base from the source, relative to that of the target ...
  static constexpr double max_stem = 0.1;
  /// ... or to the mean edge length: paths along edges join a few edges before the source, wherever they come from.
  static constexpr double max_edges_of_stem = 3;

  /// Makes a heap of the vertices that are far enough from the source, and at a distance in [begin, end) by the rule.
  /// \return whether there are vertices at `end` or beyond
  bool collect_candidates(const Measures& measures, Target_rule rule, double begin, double end)
  {
    m_candidates.clear();
    bool has_more = false;
    const double min_key = min_distance * m_frames.mean_edge_length();
    for (Index vertex = 0; vertex < m_points.size(); ++vertex) {
      if (!(measures.is_reached(vertex) && measures.distance(vertex) >= min_key)) {
        continue;
      }
      const double key = rule == Target_rule::nearest_in_space ? (m_points[vertex] - m_source_point).norm()
                                                               : measures.distance(vertex);
      has_more = has_more || key >= end;
      if (key >= begin && key < end) {
        m_candidates.emplace_back(key, vertex);
      }
    }
    std::make_heap(m_candidates.begin(), m_candidates.end(), std::greater<>());
    return has_more;
  }

  /// Traces the loop of `source` through `target`.
  Cut_loop_outcome try_target(const Measures& measures, Index source, Index target, Cut_loop& loop)
  {
    loop.target = target;
    loop.distance = measures.distance(target);
    if (loop.distance < min_distance_to_chord * (m_points[target] - m_source_point).norm()) {
      return Cut_loop_outcome::distance_below_chord;
    }
    const std::optional<std::array<Edge_step, 2>> directions = incoming_directions(measures, target);
    if (!directions) {
      return Cut_loop_outcome::one_direction;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      m_path[side].assign(1, (*directions)[side]);
      if (!m_descent(measures, end_of(m_triangulation, m_path[side].front()), source, m_path[side])) {
        return Cut_loop_outcome::not_connected;
      }
    }
    if (!cut_where_paths_join(target, loop)) {
      return Cut_loop_outcome::meets_at_once;
    }
    if (measures.distance(loop.base) >
        std::max(max_stem * loop.distance, max_edges_of_stem * m_frames.mean_edge_length())) {
      return Cut_loop_outcome::long_stem;
    }
    loop.path_separation = (half_way(measures, m_path[0]) - half_way(measures, m_path[1])).norm() / loop.distance;
    if (loop.path_separation < min_path_separation) {
      return Cut_loop_outcome::narrow;
    }
    join_paths(loop);
    return Cut_loop_outcome::found;
  }

  /// Ends both paths at the first vertex of the second one that is on the first one too. Since each path passes a
  /// vertex once, what is left is simple: there are no steps back and forth, and no vertex comes twice.
  /// \return false if this is next to the target, or a path returns to the target
  bool cut_where_paths_join(Index target, Cut_loop& loop)
  {
    m_on_first.clear();
    for (const Edge_step& step : m_path[0]) {
      m_on_first.mark(end_of(m_triangulation, step));
    }
    const auto is_joined = [&](const Edge_step& step) { return m_on_first.is_marked(end_of(m_triangulation, step)); };
    // Both end at the source.
    const auto second_end = std::find_if(m_path[1].begin(), m_path[1].end(), is_joined);
    loop.base = end_of(m_triangulation, *second_end);
    m_path[1].erase(second_end + 1, m_path[1].end());
    const auto ends_at_base = [&](const Edge_step& step) { return end_of(m_triangulation, step) == loop.base; };
    const auto first_end = std::find_if(m_path[0].begin(), m_path[0].end(), ends_at_base);
    m_path[0].erase(first_end + 1, m_path[0].end());
    const auto is_at_target = [&](const Edge_step& step) { return end_of(m_triangulation, step) == target; };
    return m_path[0].size() > 1 && m_path[1].size() > 1 &&
           std::none_of(m_path[0].begin(), m_path[0].end(), is_at_target) &&
           std::none_of(m_path[1].begin(), m_path[1].end(), is_at_target);
  }

  /// The point of `path`, which begins at the target, at half the distance of the target.
  Vector_3 half_way(const Measures& measures, const Edge_steps& path) const
  {
    const double goal = measures.distance(begin_of(m_triangulation, path.front())) / 2;
    for (const Edge_step& step : path) {
      const Index from = begin_of(m_triangulation, step);
      const Index to = end_of(m_triangulation, step);
      if (measures.distance(to) <= goal) {
        const double drop = measures.distance(from) - measures.distance(to);
        const double part = drop > 0 ? std::clamp((measures.distance(from) - goal) / drop, 0., 1.) : 1;
        return (1 - part) * m_points[from] + part * m_points[to];
      }
    }
    return m_points[end_of(m_triangulation, path.back())];
  }

  void join_paths(Cut_loop& loop) const
  {
    loop.steps = m_path[0];
    for (auto step = m_path[1].rbegin(); step != m_path[1].rend(); ++step) {
      loop.steps.push_back(reversed(m_triangulation, *step));
    }
  }

  const Frames& m_frames;
  const Triangulation& m_triangulation;
  const std::vector<Vector_3>& m_points;
  Descent<Frames> m_descent;
  std::vector<std::pair<double, Index>> m_candidates; ///< a heap, the nearest first
  std::array<Edge_steps, 2> m_path;                   ///< from the target down
  Epoch_marks m_on_first;                             ///< the vertices of the first path
  Vector_3 m_source_point = Vector_3::Zero();
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_LOOP_FINDER_H
