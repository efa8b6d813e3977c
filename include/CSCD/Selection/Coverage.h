// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parts of the surface have been explored, and on which level of detail.

#ifndef CSCD_SELECTION_COVERAGE_H
#define CSCD_SELECTION_COVERAGE_H

#include <CSCD/Separator/Local_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Traits/Corner_table.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/internal/Distance_front.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// Counts how often each part of the surface lies in a band around a separator that was found, or next to a source
/// whose search failed. A source that is covered often enough need not be tried: so the number of sources follows the
/// shape, not the number of vertices. Bands are grown on the level on which the separator was found.
class Coverage
{
public:
  explicit Coverage(const Surface_levels& levels)
      : m_levels(levels), m_is_tried(levels.finest().surface.number_of_vertices(), 0), m_count(levels.size()),
        m_hint(levels.coarsest().surface.number_of_vertices(), no_hint),
        m_failure_radius(float(relative_failure_radius * std::sqrt(levels.finest().surface.total_area()))),
        m_front(levels.finest().surface.number_of_vertices())
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
    return hint == no_hint ? std::min(first_level, m_levels.top()) : hint;
  }

  /// Takes note of the result of the search from `source`, which is not tried again.
  void add(Index source, const Search_result& result)
  {
    m_is_tried[source] = 1;
    switch (result.outcome) {
    case Search_outcome::found:
      cover_separator(result.separator);
      break;
    case Search_outcome::bump:
      cover_vertex(source, result.level,
                   float(band_width * result.loop_length / (2 * boost::math::double_constants::pi)));
      break;
    case Search_outcome::no_cut:
      cover_vertex(source, result.level, m_failure_radius);
      break;
    case Search_outcome::degenerate:
      break;
    }
  }

private:
  /// At first, a source is covered when this many bands hold it.
  static constexpr unsigned first_required_count = 1;
  /// Width of the band around a separator, relative to its radius.
  static constexpr double band_width = 0.2;
  /// Radius of the band around a source without a cut point, relative to the square root of the surface's area.
  static constexpr double relative_failure_radius = 0.05;
  /// Where nothing is known yet, fronts start on this level: most limbs are found there.
  static constexpr Index first_level = 1;
  static constexpr std::uint8_t no_hint = std::numeric_limits<std::uint8_t>::max();

  static void increase(std::uint8_t& count)
  {
    if (count < std::numeric_limits<std::uint8_t>::max()) {
      ++count;
    }
  }

  void cover_separator(const Separator& separator)
  {
    const Surface_level& level = m_levels[separator.level];
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_front.reach(level.from_finest(m_levels.finest().surface.origin(crossing.halfedge)), 0);
    }
    grow_band(separator.level, float(band_width * separator.radius()));
    set_hints(separator);
  }

  void cover_vertex(Index source, Index level, float radius)
  {
    m_front.clear();
    m_front.reach(m_levels[level].from_finest(source), 0);
    grow_band(level, radius);
  }

  /// Counts the vertices of `level` that are at most `width` away from what the front has reached.
  void grow_band(Index level, float width)
  {
    m_front.spread([&](Index vertex, float vertex_distance) {
      increase(m_count[level][vertex]);
      for (const Corner& corner : m_levels[level].corners.neighbors(vertex)) {
        const float distance = vertex_distance + corner.length;
        if (distance <= width) {
          m_front.reach(corner.neighbor, distance);
        }
      }
    });
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
      for (const Corner& corner : coarsest.corners.neighbors(vertex)) {
        m_hint[corner.neighbor] = hint;
      }
    }
  }

  const Surface_levels& m_levels;
  unsigned m_required_count = first_required_count;
  std::vector<std::uint8_t> m_is_tried;
  std::vector<std::vector<std::uint8_t>> m_count;
  std::vector<std::uint8_t> m_hint;
  float m_failure_radius;
  Distance_front m_front;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_COVERAGE_H
