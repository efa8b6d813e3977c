// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of Graph_policies.h.

#ifndef CSCD_GRAPH_POLICIES_IMPL_H
#define CSCD_GRAPH_POLICIES_IMPL_H

#include <CSCD/Graph/Graph_separator_finder.h>
#include <CSCD/Graph/graph_regions.h>
#include <CSCD/Graph_policies.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Quotient_skeleton.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The first stage for graphs: separators of vertices in random order. A vertex that is part of x separators already is
/// taken with probability 4^-x: half as often as Baerentzen and Rotenberg do, which costs no detail. Sources are drawn
/// in rounds, and each round knows all earlier ones; so the answer does not depend on the number of threads.
class Graph_search
{
public:
  Graph_search(const Spatial_graph& graph, const Options& settings)
      : m_graph(graph), m_settings(settings), m_generator(settings.random_seed),
        m_order(all_indices(graph.number_of_vertices())), m_touches(graph.number_of_vertices(), 0),
        m_for_each([this] { return std::make_unique<Graph_separator_finder>(m_graph); }, settings.number_of_threads)
  {
    // std::shuffle may differ between standard libraries; Boost's distribution does not.
    for (std::size_t i = m_order.size(); i > 1; --i) {
      std::swap(m_order[i - 1], m_order[boost::random::uniform_int_distribution<std::size_t>(0, i - 1)(m_generator)]);
    }
  }

  std::vector<Separator> operator()(Skeletonization_report& report, const Progress& progress)
  {
    report.number_of_threads = m_for_each.number_of_threads();
    std::vector<Separator> separators;
    while (draw_round(m_settings.maximum_number_of_sources - report.number_of_sources)) {
      m_for_each(Index(m_sources.size()), [this](Index i, std::unique_ptr<Graph_separator_finder>& finder) {
        (*finder)(m_sources[i], m_found[i]);
      });
      for (std::size_t i = 0; i < m_sources.size(); ++i) {
        ++report.number_of_sources;
        if (m_found[i].empty()) {
          ++report.number_of_sources_without_cut;
        } else {
          add_separator(m_sources[i], m_found[i], separators);
        }
      }
      progress(double(m_next) / double(m_order.size()));
    }
    return separators;
  }

private:
  /// Sources of a round: enough for a few threads, and few against the number of all.
  static constexpr std::size_t round_size = 32;
  /// A vertex of this many separators is not a source any more.
  static constexpr unsigned max_touches = 8;

  bool draw_round(std::size_t limit)
  {
    m_sources.clear();
    for (; m_next < m_order.size() && m_sources.size() < std::min(limit, round_size); ++m_next) {
      const unsigned touches = m_touches[m_order[m_next]];
      if (touches < max_touches && (m_generator() & ((1U << (2 * touches)) - 1)) == 0) {
        m_sources.push_back(m_order[m_next]);
      }
    }
    return !m_sources.empty();
  }

  void add_separator(Index source, const std::vector<Index>& vertices, std::vector<Separator>& separators)
  {
    Separator& separator = separators.emplace_back();
    separator.source = source;
    separator.crossings.reserve(vertices.size());
    for (const Index vertex : vertices) {
      separator.crossings.push_back({*m_graph.outgoing(vertex).begin(), 0});
      ++m_touches[vertex];
    }
    crossing_points(m_graph, separator.crossings, m_points);
    set_measures(separator, m_points);
  }

  const Spatial_graph& m_graph;
  const Options& m_settings;
  boost::random::mt19937 m_generator;
  std::vector<Index> m_order;      ///< of the vertices, at random
  std::size_t m_next = 0;          ///< in this order
  std::vector<unsigned> m_touches; ///< for each vertex, the number of its separators
  For_each_index<std::unique_ptr<Graph_separator_finder>> m_for_each;
  std::vector<Index> m_sources;
  std::array<std::vector<Index>, round_size> m_found;
  std::vector<Vector3> m_points;
};

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE std::vector<Separator> Graph_policies::find_separators(const Spatial_graph& graph, const Options& settings,
                                                                   Skeletonization_report& report,
                                                                   const Progress& progress) const
{
  return internal::Graph_search(graph, settings)(report, progress);
}

CSCD_INLINE Graph_policies::Packing Graph_policies::pack_separators(const Spatial_graph& graph,
                                                                    const std::vector<Separator>& separators,
                                                                    Skeletonization_report& /* report */) const
{
  internal::Graph_separator_finder finder(graph);
  std::vector<double> weights;
  weights.reserve(separators.size());
  std::vector<Index> vertices;
  for (const Separator& separator : separators) {
    vertices.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      vertices.push_back(graph.origin(crossing.halfedge));
    }
    weights.push_back(finder.evenness(vertices));
  }
  const internal::Separator_overlaps overlaps(graph, separators, Overlap_rule::nearest_vertex);
  return Packing(graph, separators, internal::pack_by_overlap(overlaps, weights));
}

CSCD_INLINE Embedded_skeleton Graph_policies::build_skeleton(const Spatial_graph& graph,
                                                             const std::vector<Separator>& /* separators */,
                                                             const Packing& packing,
                                                             Skeletonization_report& report) const
{
  return internal::Quotient_skeleton_builder<Spatial_graph>(graph, packing.regions())(report);
}

} // namespace CSCD

#endif // CSCD_GRAPH_POLICIES_IMPL_H
