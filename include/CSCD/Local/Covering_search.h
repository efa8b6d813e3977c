// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators until they cover the surface, and looks closer where they leave much of it.

#ifndef CSCD_LOCAL_COVERING_SEARCH_H
#define CSCD_LOCAL_COVERING_SEARCH_H

#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Options.h>
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <boost/math/constants/constants.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The part of a surface that a source explores: a band around the separator that was found, or the surroundings of the
/// source. Grown on the level of the separator. One object serves one thread.
class Coverage_band
{
public:
  explicit Coverage_band(const Surface_levels& levels)
      : m_levels(levels), m_front(levels.finest().surface.number_of_vertices())
  {
  }

  /// Radius of the band around a source without a cut point, as long as nothing is known of the limbs around it. Where
  /// the levels keep more vertices than a body needs, there are many bodies or limbs.
  static float max_failure_radius(const Surface_levels& levels)
  {
    const Surface_level& level = levels[levels.finest_with_at_most(usual_size)];
    const double number_of_bodies = std::max(double(level.surface.number_of_vertices()) / usual_size, 1.);
    return float(relative_failure_radius * std::sqrt(levels.finest().surface.total_area() / number_of_bodies));
  }

  /// Writes the vertices of the band of `result`, that of the search from `source`, to `band`, as vertices of the level
  /// of `result`.
  /// \param failure_radius radius of the band if there was no cut point
  void operator()(Index source, const Search_result& result, float failure_radius, std::vector<Index>& band)
  {
    band.clear();
    switch (result.outcome) {
    case Search_outcome::found:
      grow_around_separator(result.separator, result.level, band);
      break;
    case Search_outcome::bump:
      grow_around_vertex(source, result.level,
                         float(band_width * result.separator.length / (2 * boost::math::double_constants::pi)), band);
      break;
    case Search_outcome::no_cut:
      grow_around_vertex(source, result.level, failure_radius, band);
      break;
    case Search_outcome::degenerate:
      break;
    }
  }

private:
  /// Width of the band around a separator, relative to its radius.
  static constexpr double band_width = 0.2;
  /// `max_failure_radius()`, relative to the square root of the surface's area.
  static constexpr double relative_failure_radius = 0.05;
  /// Vertices of a body that the failure radius suits.
  static constexpr Index usual_size = 2000;

  void grow_around_separator(const Separator& separator, Index level, std::vector<Index>& band)
  {
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_front.reach(m_levels[level].from_finest(m_levels.finest().surface.origin(crossing.halfedge)), 0);
    }
    grow(level, float(band_width * separator.radius()), band);
  }

  void grow_around_vertex(Index source, Index level, float radius, std::vector<Index>& band)
  {
    m_front.clear();
    m_front.reach(m_levels[level].from_finest(source), 0);
    grow(level, radius, band);
  }

  /// Appends the vertices of `level` that are at most `width` away from the vertices that the front has reached.
  void grow(Index level, float width, std::vector<Index>& band)
  {
    const Vertex_fan_table& corners = m_levels[level].corners();
    m_front.spread([&](Index vertex, float vertex_distance) {
      band.push_back(vertex);
      for (const Corner& corner : corners.neighbors(vertex)) {
        const float distance = vertex_distance + corner.length;
        if (distance <= width && m_front.reach(corner.neighbor, distance)) {
          corners.prefetch(corner.neighbor);
        }
      }
    });
  }

  const Surface_levels& m_levels;
  Dijkstra_search m_front;
};

/// Counts how often each part of the surface lies in a band around a separator that was found, or next to a source
/// whose search failed. A source that is covered often enough need not be tried: so the number of sources follows the
/// shape, not the number of vertices.
class Coverage
{
public:
  explicit Coverage(const Surface_levels& levels)
      : m_levels(levels), m_is_tried(levels.finest().surface.number_of_vertices(), 0), m_count(levels.size()),
        m_hint(levels.coarsest().surface.number_of_vertices(), no_hint)
  {
    for (Index level = 0; level < levels.size(); ++level) {
      m_count[level].assign(levels[level].surface.number_of_vertices(), 0);
    }
  }

  /// Whether vertex `source` of the finest level is covered.
  bool is_covered(Index source) const
  {
    if (m_is_tried[source] != 0) {
      return true;
    }
    unsigned count = 0;
    for (Index level = 0; level < m_levels.size(); ++level) {
      count += m_count[level][m_levels[level].from_finest(source)];
    }
    return count >= m_required_count;
  }

  /// From now on, a source is covered only when `factor` times as many bands as before hold it.
  void require_more(unsigned factor) { m_required_count *= factor; }

  /// The level where the front of `source` should start: the level of the last separator found nearby.
  Index level_hint(Index source) const
  {
    const std::uint8_t hint = m_hint[m_levels.coarsest().from_finest(source)];
    return hint == no_hint ? std::min(first_level, m_levels.finest_with_at_most(first_size)) : hint;
  }

  /// Takes note of the result of the search from `source`, which is not tried again, and of its band.
  void add(Index source, const Search_result& result, const std::vector<Index>& band)
  {
    m_is_tried[source] = 1;
    for (const Index vertex : band) {
      increase(m_count[result.level][vertex]);
    }
    if (result.outcome == Search_outcome::found) {
      set_hints(result);
    }
  }

private:
  /// At first, a source is covered when this many bands hold it.
  static constexpr unsigned first_required_count = 1;
  /// Where nothing is known yet, fronts start on this level: most limbs are found there ...
  static constexpr Index first_level = 1;
  /// ... or on the surface itself if it has at most this many vertices: the smallest limbs of coarse surfaces are found
  /// there alone.
  static constexpr Index first_size = 6000;
  static constexpr std::uint8_t no_hint = std::numeric_limits<std::uint8_t>::max();

  static void increase(std::uint8_t& count)
  {
    if (count < std::numeric_limits<std::uint8_t>::max()) {
      ++count;
    }
  }

  void set_hints(const Search_result& result)
  {
    const Surface_level& coarsest = m_levels.coarsest();
    const auto hint = std::uint8_t(result.level);
    for (const Edge_crossing& crossing : result.separator.crossings) {
      const Index vertex = coarsest.from_finest(m_levels.finest().surface.origin(crossing.halfedge));
      if (m_hint[vertex] == hint) {
        continue;
      }
      m_hint[vertex] = hint;
      for (const Corner& corner : coarsest.corners().neighbors(vertex)) {
        m_hint[corner.neighbor] = hint;
      }
    }
  }

  const Surface_levels& m_levels;
  unsigned m_required_count = first_required_count;
  std::vector<std::uint8_t> m_is_tried;
  std::vector<std::vector<std::uint8_t>> m_count;
  std::vector<std::uint8_t> m_hint;
};

/// Goes through the vertices of a level in a scattered order, in batches of uncovered ones.
///
/// The order is scattered like a random one, but nearly the same for every seed: the seed only decides which of a few
/// dozen consecutive sources comes first. Coverage, not chance, decides where separators are sought, so a wholly
/// different order gains nothing, and a user who changes the seed or the pose of a shape gets the same branches.
class Source_sequence
{
public:
  /// Scatters the vertices; the order depends on `random_seed` and the numbering of the surface alone.
  Source_sequence(const Surface_levels& levels, unsigned random_seed)
  {
    const Surface_level& level = levels.precise();
    m_candidates = all_indices(level.surface.number_of_vertices());
    boost::random::mt19937 scatter;
    shuffle(0, m_candidates.size(), scatter);
    boost::random::mt19937 generator(random_seed);
    for (std::size_t begin = 0; begin < m_candidates.size(); begin += block_size) {
      shuffle(begin, std::min(begin + block_size, m_candidates.size()), generator);
    }
    for (Index& candidate : m_candidates) {
      candidate = level.to_finest(candidate);
    }
  }

  /// Writes the next sources that `coverage` does not cover to `batch`, at most `size`; none at the end.
  void next_batch(const Coverage& coverage, std::size_t size, std::vector<Index>& batch)
  {
    batch.clear();
    while (m_next < m_candidates.size() && batch.size() < size) {
      const Index candidate = m_candidates[m_next++];
      if (!coverage.is_covered(candidate)) {
        batch.push_back(candidate);
      }
    }
  }

  /// Begins again with the candidates that satisfy `is_wanted(vertex)`, in the same order.
  template <class Predicate>
  void restart(const Predicate& is_wanted)
  {
    m_next = 0;
    m_candidates.erase(std::remove_if(m_candidates.begin(), m_candidates.end(),
                                      [&](Index candidate) { return !is_wanted(candidate); }),
                       m_candidates.end());
  }

  /// The part of the vertices that has been visited, in [0, 1].
  double progress() const { return m_candidates.empty() ? 1. : double(m_next) / double(m_candidates.size()); }

private:
  /// Sources among which the seed decides.
  static constexpr std::size_t block_size = 32;

  /// Shuffles the candidates from `begin` to `end`.
  void shuffle(std::size_t begin, std::size_t end, boost::random::mt19937& generator)
  {
    // std::shuffle may differ between standard libraries; Boost's distribution does not.
    for (std::size_t i = end; i > begin + 1; --i) {
      const std::size_t j = boost::random::uniform_int_distribution<std::size_t>(begin, i - 1)(generator);
      std::swap(m_candidates[i - 1], m_candidates[j]);
    }
  }

  std::vector<Index> m_candidates;
  std::size_t m_next = 0;
};

/// Takes sources in batches of fixed size. The separators of a batch are found independently, from the state before the
/// batch, and taken over in the order of the sources; a source that a separator before it in the batch covers is
/// dropped, so that it does not matter whether its separator was computed. The answer is that of a single thread.
class Separator_search
{
public:
  /// \param solid is referred to
  Separator_search(const Triangulated_solid& solid, const Options& options)
      : m_solid(solid), m_coverage(solid.levels()), m_sources(solid.levels(), options.random_seed),
        m_failure_radius([radius = Coverage_band::max_failure_radius(solid.levels())](Index) { return radius; }),
        m_for_each(
            [&solid, min_area_ratio = Detail(options.detail).min_loop_area_ratio()] {
              return Worker{Local_separator_finder(solid, min_area_ratio), Coverage_band(solid.levels())};
            },
            options.number_of_threads)
  {
  }

  /// Seeks separators until the surface is covered or `max_sources` have been tried; appends them to `separators` and
  /// counts in `report`. `progress(fraction)` is called after each batch and may throw.
  void operator()(std::size_t max_sources, std::vector<Separator>& separators, Skeletonization_report& report,
                  const Progress& progress)
  {
    report.number_of_threads = m_for_each.number_of_threads();
    while (report.number_of_sources < max_sources) {
      m_sources.next_batch(m_coverage, std::min(batch_size, max_sources - report.number_of_sources), m_batch);
      if (m_batch.empty()) {
        return;
      }
      search_batch(separators, report);
      progress(m_sources.progress());
    }
  }

  /// Lets the search continue among the vertices of the finest level that satisfy `is_wanted(vertex)`, which count as
  /// covered only when `factor` times as many separators pass them. From now on, a source without a cut point covers
  /// the surface at most `failure_radius(source)` away from it; several threads call that function at once.
  template <class Predicate>
  void explore(const Predicate& is_wanted, unsigned factor, std::function<float(Index)> failure_radius)
  {
    m_coverage.require_more(factor);
    m_sources.restart(is_wanted);
    m_failure_radius = std::move(failure_radius);
  }

private:
  /// Sources in a batch: enough for a few threads, while the share of dropped ones stays below a tenth.
  static constexpr std::size_t batch_size = 16;

  /// The working memory of one thread.
  struct Worker
  {
    Local_separator_finder finder;
    Coverage_band band;
  };

  void search_batch(std::vector<Separator>& separators, Skeletonization_report& report)
  {
    std::array<Index, batch_size> hints{};
    for (std::size_t i = 0; i < m_batch.size(); ++i) {
      hints[i] = m_coverage.level_hint(m_batch[i]);
    }
    const auto search = [&](Index i, Worker& worker) {
      worker.finder(m_batch[i], hints[i], m_results[i]);
      if (m_solid.number_of_sheets() > 0) {
        mark_open(m_solid, m_results[i].separator);
      }
      worker.band(m_batch[i], m_results[i], m_failure_radius(m_batch[i]), m_bands[i]);
    };
    const auto take = [&](Index i) { take_result(i, separators, report); };
    const auto size = Index(m_batch.size());
    if (m_for_each.number_of_threads() == 1) {
      // The separator of a dropped source need not be computed.
      m_for_each(size, [&](Index i, Worker& worker) {
        if (!m_coverage.is_covered(m_batch[i])) {
          search(i, worker);
          take(i);
        }
      });
      return;
    }
    m_for_each(size, search);
    for (Index i = 0; i < size; ++i) {
      if (!m_coverage.is_covered(m_batch[i])) {
        take(i);
      }
    }
  }

  void take_result(Index i, std::vector<Separator>& separators, Skeletonization_report& report)
  {
    const Search_result& result = m_results[i];
    m_coverage.add(m_batch[i], result, m_bands[i]);
    ++report.number_of_sources;
    switch (result.outcome) {
    case Search_outcome::found:
      ++(result.is_section ? report.number_of_plane_sections : report.number_of_straightened_loops);
      separators.push_back(result.separator);
      break;
    case Search_outcome::bump:
      ++report.number_of_bumps;
      break;
    case Search_outcome::no_cut:
    case Search_outcome::degenerate:
      ++report.number_of_sources_without_cut;
      break;
    }
  }

  const Triangulated_solid& m_solid;
  Coverage m_coverage;
  Source_sequence m_sources;
  std::function<float(Index)> m_failure_radius;
  For_each_index<Worker> m_for_each;
  std::vector<Index> m_batch;
  std::array<Search_result, batch_size> m_results;
  std::array<std::vector<Index>, batch_size> m_bands;
};

/// The separators that would be packed so far, except separators of bumps.
inline std::vector<Index> pack_for_trial(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                                         double min_branch_area_ratio)
{
  Disjoint_separators disjoint(surface, separators);
  disjoint.pack([](Index) { return true; });
  const Cut_graph cut_graph(surface, disjoint.arrangement());
  const Spurious_branches bumps(cut_graph, separators, disjoint.packed(), min_branch_area_ratio);
  std::vector<char> is_bump(separators.size(), 0);
  for (Index separator : bumps.separators()) {
    is_bump[separator] = 1;
  }
  std::vector<Index> packed = disjoint.packed();
  packed.erase(std::remove_if(packed.begin(), packed.end(), [&](Index separator) { return is_bump[separator] != 0; }),
               packed.end());
  return packed;
}

/// Seeks separators from sources all over the surface until they cover it, packs them for trial, and looks closer at
/// the ends of limbs and where limbs meet: small limbs that grow from there, as toes from a foot, are easily missed at
/// first. Ends early where the bound of `options` on the number of sources is reached. Counts in `report`;
/// `progress(fraction)` is called often and may throw.
inline std::vector<Separator> cover_by_separators(const Triangulated_solid& solid, const Options& options,
                                                  Skeletonization_report& report, const Progress& progress)
{
  // The part of the search that its first pass is, for the progress.
  constexpr double first_pass_share = 0.75;
  // Surface farther than this from the nearest packed separator is explored again, relative to the separator's radius.
  constexpr double unexplored_distance = 0.6;
  // This many times as many separators are sought there.
  constexpr unsigned exploration_factor = 3;
  // How far a source without a cut point covers the surface there, relative to its distance from the nearest packed
  // separator: limbs that grow from an end, as toes from a foot, are much thinner than the end is long. From 0.1 to
  // 0.4, nearly all tips on 100 poses of people were the same; the largest value tries the fewest sources.
  constexpr float failure_radius_per_distance = 0.3F;

  const Surface_levels& levels = solid.levels();
  Separator_search search(solid, options);
  std::vector<Separator> separators;
  search(options.maximum_number_of_sources, separators, report,
         [&](double fraction) { progress(first_pass_share * fraction); });
  const std::vector<Index> packed =
      pack_for_trial(solid.triangulation(), separators, Detail(options.detail).min_branch_area_ratio());
  const Surface_regions regions(levels, separators, packed);
  search.explore(
      [&](Index vertex) {
        const Index separator = regions.separator(vertex);
        return separator != no_index &&
               double(regions.distance(vertex)) > unexplored_distance * separators[packed[separator]].radius();
      },
      exploration_factor,
      [&regions, max_radius = Coverage_band::max_failure_radius(levels)](Index vertex) {
        return std::min(max_radius, failure_radius_per_distance * regions.distance(vertex));
      });
  search(options.maximum_number_of_sources, separators, report,
         [&](double fraction) { progress(first_pass_share + (1 - first_pass_share) * fraction); });
  return separators;
}

/// The same without separators around a hollow.
inline std::vector<Separator> find_local_separators(const Triangulated_solid& solid, const Options& options,
                                                    Skeletonization_report& report, const Progress& progress)
{
  std::vector<Separator> separators = cover_by_separators(solid, options, report, progress);
  const auto first_tunnel = std::remove_if(separators.begin(), separators.end(), [&solid](const Separator& separator) {
    return is_around_hollow(solid, separator);
  });
  report.number_of_tunnels = std::size_t(separators.end() - first_tunnel);
  separators.erase(first_tunnel, separators.end());
  return separators;
}

} // namespace CSCD::internal

#endif // CSCD_LOCAL_COVERING_SEARCH_H
