// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parts of the surface have been explored, and which sources come next.

#ifndef CSCD_LOCAL_COVERAGE_H
#define CSCD_LOCAL_COVERAGE_H

#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Vertex_fan_table.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <boost/math/constants/constants.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The part of a surface that a source explores: a band around the separator that was found, or the surroundings of the
/// source. Grown on the level on which the separator was found. One object serves one thread.
class Coverage_band
{
public:
  explicit Coverage_band(const Surface_levels& levels)
      : m_levels(levels), m_front(levels.finest().surface.number_of_vertices())
  {
  }

  /// Radius of the band around a source without a cut point, as long as nothing is known of the limbs around it.
  static float max_failure_radius(const Surface_levels& levels)
  {
    const Triangulated_surface& surface = levels.finest().surface;
    const double number_of_bodies =
        levels.needs_finest() ? std::max(surface.number_of_vertices() / usual_size, 1.) : 1.;
    return float(relative_failure_radius * std::sqrt(surface.total_area() / number_of_bodies));
  }

  /// Writes the vertices of the band of `result`, that of the search from `source`, to `band`, as vertices of the level
  /// of `result`.
  /// \param failure_radius radius of the band if there was no cut point
  void operator()(Index source, const Search_result& result, float failure_radius, std::vector<Index>& band)
  {
    band.clear();
    switch (result.outcome) {
    case Search_outcome::found:
      grow_around_separator(result.separator, band);
      break;
    case Search_outcome::bump:
      grow_around_vertex(source, result.level,
                         float(band_width * result.loop_length / (2 * boost::math::double_constants::pi)), band);
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
  static constexpr double usual_size = 2000;

  void grow_around_separator(const Separator& separator, std::vector<Index>& band)
  {
    const Surface_level& level = m_levels[separator.level];
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_front.reach(level.from_finest(m_levels.finest().surface.origin(crossing.halfedge)), 0);
    }
    grow(separator.level, float(band_width * separator.radius()), band);
  }

  void grow_around_vertex(Index source, Index level, float radius, std::vector<Index>& band)
  {
    m_front.clear();
    m_front.reach(m_levels[level].from_finest(source), 0);
    grow(level, radius, band);
  }

  /// Appends the vertices of `level` that are at most `width` away from what the front has reached.
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

  /// The level on which the front of `source` should start: that of the last separator found nearby.
  Index level_hint(Index source) const
  {
    const std::uint8_t hint = m_hint[m_levels.coarsest().from_finest(source)];
    return hint == no_hint ? std::min(first_level, m_levels.finest_with_at_most(first_size)) : hint;
  }

  /// Takes note of the result of the search from `source`, which is not tried again, and of its band.
  void add(Index source, const Search_result& result, const std::vector<Index>& band)
  {
    m_is_tried[source] = 1;
    const bool is_found = result.outcome == Search_outcome::found;
    for (const Index vertex : band) {
      increase(m_count[is_found ? result.separator.level : result.level][vertex]);
    }
    if (is_found) {
      set_hints(result.separator);
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

  void set_hints(const Separator& separator)
  {
    const Surface_level& coarsest = m_levels.coarsest();
    const auto hint = std::uint8_t(separator.level);
    for (const Edge_crossing& crossing : separator.crossings) {
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

/// Goes through the vertices of a level in a scattered order, in batches of those that are not covered.
///
/// The order is scattered like a random one, but nearly the same for every seed: the seed only decides which of a few
/// dozen consecutive sources comes first. Coverage, not chance, decides where separators are sought, so there is
/// nothing to gain from a wholly different order, and a user who changes the seed or the pose of a shape gets the same
/// branches.
class Source_sequence
{
public:
  /// Scatters the vertices; the order depends on `random_seed` and the numbering of the surface alone.
  Source_sequence(const Surface_levels& levels, unsigned random_seed)
  {
    const Surface_level& level = levels[levels.finest_with_at_most(max_candidates)];
    m_candidates.resize(level.surface.number_of_vertices());
    std::iota(m_candidates.begin(), m_candidates.end(), Index(0));
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

  /// Begins again with the candidates for which `is_wanted(vertex)` holds, in the same order.
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
  /// Sources are taken from the finest level of at most this many vertices: more lie closer together than the bands of
  /// any limb that they could find.
  static constexpr Index max_candidates = 60000;
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

} // namespace CSCD::internal

#endif // CSCD_LOCAL_COVERAGE_H
