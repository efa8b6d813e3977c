// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators from sources drawn at random, each from a distance field of the whole surface.

#ifndef CSCD_SELECTION_SAMPLED_SEARCH_H
#define CSCD_SELECTION_SAMPLED_SEARCH_H

#include <CSCD/Geodesic/Heat_method.h>
#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Separator/Field_search_settings.h>
#include <CSCD/Separator/Field_separator_finder.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_index.h>

#include <CGAL/assertions.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Draws vertices at random, with a probability in proportion to the area that a vertex stands for and to its geodesic
/// distance from the nearest vertex drawn before (section 3.1.7). So sources spread over the surface, however finely
/// parts of it are triangulated, and limbs that have not been visited come first.
class Distance_sampling
{
public:
  /// \param areas for each vertex, the area that it stands for; vertices of no area are never drawn
  Distance_sampling(std::vector<double> areas, unsigned random_seed)
      : m_areas(std::move(areas)), m_distance(m_areas.size(), std::numeric_limits<double>::infinity()),
        m_sums(m_areas.size()), m_generator(random_seed)
  {
  }

  /// Draws up to `size` different vertices to `batch`; fewer if hardly more have an area. Linear.
  void draw(std::size_t size, std::vector<Index>& batch)
  {
    batch.clear();
    const double total = sum_probabilities();
    // What was drawn in this batch has a share of the sums still, and is rejected. The bound is for surfaces of few
    // vertices, where hardly another one may be left.
    constexpr std::size_t max_rejections = 64;
    std::size_t rejections = 0;
    while (batch.size() < size && rejections < max_rejections && total > 0) {
      const double position = boost::random::uniform_01<double>()(m_generator) * total;
      const auto vertex = Index(std::upper_bound(m_sums.begin(), m_sums.end(), position) - m_sums.begin());
      if (vertex < m_sums.size() && std::find(batch.begin(), batch.end(), vertex) == batch.end()) {
        batch.push_back(vertex);
      } else {
        ++rejections;
      }
    }
  }

  /// Takes note of a source: `distance(vertex)` is the geodesic distance from it, infinite where it does not reach.
  template <class Distance>
  void add_source(const Distance& distance)
  {
    for (std::size_t vertex = 0; vertex < m_distance.size(); ++vertex) {
      m_distance[vertex] = std::min(m_distance[vertex], std::max(0., double(distance(Index(vertex)))));
    }
  }

private:
  /// Vertices that no source reaches count as far as the farthest that is reached; where all have been drawn, each
  /// counts alike. \return the sum of all
  double sum_probabilities()
  {
    double farthest = 0;
    for (double distance : m_distance) {
      if (std::isfinite(distance)) {
        farthest = std::max(farthest, distance);
      }
    }
    double sum = 0;
    for (std::size_t vertex = 0; vertex < m_areas.size(); ++vertex) {
      sum += m_areas[vertex] * (farthest > 0 ? std::min(m_distance[vertex], farthest) : 1.);
      m_sums[vertex] = sum;
    }
    return sum;
  }

  std::vector<double> m_areas;
  std::vector<double> m_distance;
  std::vector<double> m_sums;
  boost::random::mt19937 m_generator;
};

/// The first stage as published (Alg. 2, lines 1 to 9): sources are drawn by their distance from earlier ones; the heat
/// method gives the distance field of each, and that its separator.
///
/// Sources are drawn in rounds, of which each knows all earlier ones; so the answer does not depend on the number of
/// threads. A thread takes a group of sources at a time, whose distances are solved for together.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Sampled_search
{
public:
  Sampled_search(const Surface& surface, const Search_settings& settings, const Field_search_settings& field_settings)
      : m_space(surface.triangulation(), field_settings),
        m_sampling(areas(surface.triangulation()), settings.random_seed),
        m_for_each([this] { return std::make_unique<Worker>(m_space); }, settings.number_of_threads)
  {
  }

  /// Seeks a separator from each of `number_of_sources` sources, and counts in `report`; `progress(fraction)` is called
  /// after each round and may throw.
  std::vector<Separator> operator()(std::size_t number_of_sources, Skeletonization_report& report,
                                    const Progress& progress)
  {
    report.number_of_threads = m_for_each.number_of_threads();
    std::vector<Separator> separators;
    while (report.number_of_sources < number_of_sources) {
      m_sampling.draw(std::min(round_size, number_of_sources - report.number_of_sources), m_sources);
      if (m_sources.empty()) {
        break;
      }
      search_round();
      take_results(separators, report);
      progress(double(report.number_of_sources) / double(number_of_sources));
    }
    return separators;
  }

private:
  static constexpr std::size_t group_size = Heat_method::batch_size;
  static constexpr std::size_t max_groups = 4;
  /// Sources of a round: enough for a few threads, and few against the number of all.
  static constexpr std::size_t round_size = group_size * max_groups;

  using Triangulation = std::decay_t<decltype(std::declval<const Surface&>().triangulation())>;
  using Space = Field_search_space<Triangulation>;

  struct Worker
  {
    explicit Worker(const Space& space) : finder(space.make_finder()) {}

    Heat_method::Workspace workspace;
    std::vector<std::vector<Geodesic_source>> source_sets;
    std::vector<Heat_field> fields;
    typename Space::Finder finder;
  };

  static std::vector<double> areas(const Triangulation& surface)
  {
    std::vector<double> result(surface.number_of_vertices());
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      result[vertex] = double(surface.vertex_area(vertex));
    }
    return result;
  }

  std::size_t end_of_group(Index group) const { return std::min((group + 1) * group_size, m_sources.size()); }

  void search_round()
  {
    const auto number_of_groups = Index((m_sources.size() + group_size - 1) / group_size);
    m_for_each(number_of_groups,
               [this](Index group, std::unique_ptr<Worker>& worker) { search_group(group, *worker); });
    for (Index group = 0; group < number_of_groups; ++group) {
      m_sampling.add_source([&](Index vertex) { return m_distance[group][vertex]; });
    }
  }

  void search_group(Index group, Worker& worker)
  {
    const std::size_t begin = group * group_size;
    const std::size_t end = end_of_group(group);
    worker.source_sets.clear();
    for (std::size_t i = begin; i < end; ++i) {
      worker.source_sets.push_back({Geodesic_source::at_vertex(m_sources[i])});
    }
    m_space.heat_method()(worker.source_sets, worker.fields, worker.workspace);
    std::vector<float>& distance = m_distance[group];
    distance.assign(worker.fields.front().distances.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<double>& distances = worker.fields[i - begin].distances;
      for (std::size_t vertex = 0; vertex < distance.size(); ++vertex) {
        distance[vertex] = std::min(distance[vertex], float(distances[vertex]));
      }
      worker.finder(m_sources[i], distances, m_results[i]);
    }
  }

  void take_results(std::vector<Separator>& separators, Skeletonization_report& report) const
  {
    for (std::size_t i = 0; i < m_sources.size(); ++i) {
      const Field_search_result& result = m_results[i];
      ++report.number_of_sources;
      if (result.outcome == Search_outcome::found) {
        separators.push_back(result.separator);
        report.number_of_held_loops += result.shortening == Shortening_outcome::held ? 1 : 0;
        report.number_of_unfinished_loops += result.shortening == Shortening_outcome::unfinished ? 1 : 0;
      } else if (result.outcome == Search_outcome::degenerate) {
        ++report.number_of_collapsed_loops;
      } else {
        ++report.number_of_sources_without_cut;
        ++report.number_of_rejections[std::size_t(result.loop)];
      }
    }
  }

  Space m_space;
  Distance_sampling m_sampling;
  For_each_index<std::unique_ptr<Worker>> m_for_each;
  std::vector<Index> m_sources;
  std::array<Field_search_result, round_size> m_results;
  std::array<std::vector<float>, max_groups> m_distance; ///< from the nearest source of a group
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_SAMPLED_SEARCH_H
