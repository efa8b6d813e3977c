// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators from sources drawn at random, each from a distance field of the whole surface.

#ifndef CSCD_PUBLISHED_SAMPLED_SEARCH_H
#define CSCD_PUBLISHED_SAMPLED_SEARCH_H

#include <CSCD/Options.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Field_separator_finder.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/parallel.h>

#include <CGAL/assertions.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
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
    // Vertices of this batch still have a share of the sums, and are rejected. The bound is for surfaces of few
    // vertices, where hardly another vertex may be left.
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

  /// Takes note of sources: `distance` is the geodesic distance from them, infinite where none reaches.
  void add_sources(const std::vector<float>& distance)
  {
    for (std::size_t vertex = 0; vertex < m_distance.size(); ++vertex) {
      m_distance[vertex] = std::min(m_distance[vertex], std::max(0., double(distance[vertex])));
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

/// Sources whose distances are solved for together, and the results of their searches.
struct Source_group
{
  std::vector<Index> sources; ///< vertices of the finest surface
  std::vector<Field_search_result> results;
  std::vector<float> distance; ///< for each vertex, from the nearest of the sources

  void set_distance(std::size_t number_of_vertices)
  {
    results.resize(sources.size());
    distance.assign(number_of_vertices, std::numeric_limits<float>::infinity());
  }
};

/// Fills a group for its sources. One object serves one thread.
using Group_search = std::function<void(Source_group&)>;

/// Searches on the surface itself.
/// \tparam Space a `Field_search_space`
template <class Space>
class Field_group_search
{
public:
  /// \param space is referred to
  explicit Field_group_search(const Space& space) : m_space(space), m_finder(space.make_finder()) {}

  void operator()(Source_group& group)
  {
    m_source_sets.clear();
    for (const Index source : group.sources) {
      m_source_sets.push_back({Geodesic_source::at_vertex(source)});
    }
    m_workspace(m_space.heat_method(), m_source_sets, m_distances);
    group.set_distance(m_distances.front().size());
    for (std::size_t i = 0; i < group.sources.size(); ++i) {
      const std::vector<double>& distances = m_distances[i];
      for (std::size_t vertex = 0; vertex < distances.size(); ++vertex) {
        group.distance[vertex] = std::min(group.distance[vertex], float(distances[vertex]));
      }
      (*m_finder)(group.sources[i], distances, group.results[i]);
    }
  }

private:
  const Space& m_space;
  Heat_workspace m_workspace;
  std::vector<std::vector<Geodesic_source>> m_source_sets;
  std::vector<std::vector<double>> m_distances;
  std::unique_ptr<typename Space::Finder> m_finder;
};

/// The levels of detail on which distances are computed (supplement, K.2), prepared once, shared by all threads. Of
/// several levels the finest has none.
class Multiscale_search_space
{
public:
  using Level_space = Field_search_space<Triangulated_surface>;

  /// \param levels is referred to and must outlive this object
  Multiscale_search_space(const Surface_levels& levels, const Field_search_settings& settings)
      : m_levels(levels), m_finest_triangulation(levels.finest().surface)
  {
    for (Index level = finest_level(); level <= coarsest_level(); ++level) {
      m_spaces.push_back(std::make_unique<Level_space>(levels[level].surface, settings));
    }
  }

  const Surface_levels& levels() const { return m_levels; }
  /// That of the finest surface, not flipped.
  const Intrinsic_triangulation& finest_triangulation() const { return m_finest_triangulation; }
  /// The coarsest level that has distances.
  Index coarsest_level() const { return m_levels.finest_with_at_most(coarsest_size); }
  /// The finest level that has distances.
  Index finest_level() const { return std::min<Index>(1, coarsest_level()); }
  /// \pre `level` is not below `finest_level()` nor above `coarsest_level()`
  const Level_space& operator[](Index level) const { return *m_spaces[level - finest_level()]; }

private:
  /// A level of at most so many vertices needs no coarser one: solves take little time, and estimated distances need
  /// edges that are short compared with the limbs.
  static constexpr Index coarsest_size = 6000;

  const Surface_levels& m_levels;
  Intrinsic_triangulation m_finest_triangulation;
  std::vector<std::unique_ptr<const Level_space>> m_spaces;
};

/// Searches on the coarsest level from points in its faces. Where it finds no loop, or a loop of too few edges, it
/// searches again on the next finer level. Loops are carried to the finest level, by shortest paths between their
/// vertices, and shortened there: only once, since each shortening may let a loop slide. With one level only, this is
/// the search of `Field_group_search`.
class Multiscale_group_search
{
public:
  /// \param space is referred to
  explicit Multiscale_group_search(const Multiscale_search_space& space)
      : m_space(space), m_levels(space.levels()), m_projection(m_levels),
        m_shorten(m_levels.finest().surface, space.finest_triangulation())
  {
    for (Index level = space.finest_level(); level <= space.coarsest_level(); ++level) {
      m_finders.push_back(space[level].make_finder());
    }
  }

  void operator()(Source_group& group)
  {
    group.set_distance(m_levels.finest().surface.number_of_vertices());
    m_pending.resize(group.sources.size());
    std::iota(m_pending.begin(), m_pending.end(), std::size_t(0));
    for (Index level = m_space.coarsest_level(); !m_pending.empty(); --level) {
      search_level(level, group);
    }
  }

private:
  /// The least length of a loop in mean edge lengths of its level, except on the finest level. Chosen on armadillo and
  /// warrior: with 8 errors are greater and tips fewer; with 16 nothing is gained.
  static constexpr double min_edges_of_loop = 12;

  /// A source on a level: in a face, and the corner of it that is nearest by barycentric coordinates.
  struct Level_source
  {
    Geodesic_source source;
    Index vertex;
    Vector3 point;
  };

  /// Searches from the pending sources, and leaves those pending that need a finer level.
  void search_level(Index level, Source_group& group)
  {
    const auto& space = m_space[level];
    auto& finder = *m_finders[level - m_space.finest_level()];
    m_level_sources.clear();
    m_source_sets.clear();
    for (const std::size_t i : m_pending) {
      m_level_sources.push_back(source_on_level(m_levels[level], group.sources[i]));
      m_source_sets.push_back({m_level_sources.back().source});
    }
    m_workspace(space.heat_method(), m_source_sets, m_distances);
    if (level == m_space.coarsest_level()) {
      take_distances(group);
    }
    std::vector<std::size_t> refused;
    for (std::size_t k = 0; k < m_pending.size(); ++k) {
      Field_search_result& result = group.results[m_pending[k]];
      if (level == 0) {
        finder(group.sources[m_pending[k]], m_distances[k], result);
        continue;
      }
      const Cut_loop& loop = finder.find_loop(m_level_sources[k].vertex, m_level_sources[k].point, m_distances[k]);
      const bool is_found = loop.outcome == Cut_loop_outcome::found;
      if (level > m_space.finest_level() &&
          !(is_found && 2 * loop.distance >= min_edges_of_loop * space.mean_edge_length())) {
        refused.push_back(m_pending[k]);
        continue;
      }
      result.loop = loop.outcome;
      result.shortening = Shortening_outcome::collapsed;
      if (is_found) {
        shorten_on_finest(level, loop.halfedges, group.sources[m_pending[k]], result);
      }
    }
    m_pending.swap(refused);
  }

  /// \pre `m_distances` are those of all sources on the coarsest level
  void take_distances(Source_group& group) const
  {
    const Surface_level& level = m_levels[m_space.coarsest_level()];
    std::vector<float> least(level.surface.number_of_vertices(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < group.sources.size(); ++i) {
      for (std::size_t vertex = 0; vertex < least.size(); ++vertex) {
        least[vertex] = std::min(least[vertex], float(m_distances[i][vertex]));
      }
    }
    for (Index vertex = 0; vertex < group.distance.size(); ++vertex) {
      group.distance[vertex] = least[level.from_finest(vertex)];
    }
  }

  /// The point nearest to the finest vertex `source` on the faces around the vertex that represents it.
  Level_source source_on_level(const Surface_level& level, Index source) const
  {
    const Index center = level.from_finest(source);
    const Vector3& point = m_levels.finest().surface.point(source);
    Level_source best{Geodesic_source::at_vertex(center), center, level.surface.point(center)};
    double min_distance = (best.point - point).squaredNorm();
    for (const Index halfedge : level.surface.outgoing(center)) {
      const Index face = Triangulated_surface::face(halfedge);
      const std::optional<std::array<double, 3>> weights = weights_in_face(level.surface, face, point);
      if (!weights) {
        continue;
      }
      Vector3 candidate = Vector3::Zero();
      for (Index k = 0; k < 3; ++k) {
        candidate += (*weights)[k] * level.surface.point(level.surface.origin(3 * face + k));
      }
      const double distance = (candidate - point).squaredNorm();
      if (distance < min_distance) {
        min_distance = distance;
        const auto corner = Index(std::max_element(weights->begin(), weights->end()) - weights->begin());
        best = {Geodesic_source::in_face(level.surface, face, *weights), level.surface.origin(3 * face + corner),
                candidate};
      }
    }
    return best;
  }

  /// The barycentric coordinates of the foot of `point` on the plane of `face`, those below 0 set to 0; none where the
  /// face has no area.
  static std::optional<std::array<double, 3>> weights_in_face(const Triangulated_surface& surface, Index face,
                                                              const Vector3& point)
  {
    const Vector3 normal = surface.face_vector(face);
    const double squared_norm = normal.squaredNorm();
    if (surface.is_hole_filling(face) || !(squared_norm > 0)) {
      return std::nullopt;
    }
    std::array<double, 3> weights{};
    double sum = 0;
    for (Index k = 0; k < 3; ++k) {
      const Vector3 from = surface.point(surface.origin(3 * face + (k + 1) % 3)) - point;
      const Vector3 to = surface.point(surface.origin(3 * face + (k + 2) % 3)) - point;
      weights[k] = std::max(0., from.cross(to).dot(normal) / squared_norm);
      sum += weights[k];
    }
    for (double& weight : weights) {
      weight /= sum; // the coordinates of the foot add up to 1, so that those that are left are at least that
    }
    return weights;
  }

  /// Makes the separator of the loop along `halfedges` of `level`: carries it to the finest level by shortest paths
  /// between its vertices, and shortens it there.
  void shorten_on_finest(Index level, const std::vector<Index>& halfedges, Index source, Field_search_result& result)
  {
    result.separator.source = source;
    m_loop.clear();
    for (const Index halfedge : halfedges) {
      m_loop.push_back(m_space[level].triangulation().origin(halfedge));
    }
    if (m_projection(m_levels[level], m_loop, m_fine_loop)) {
      m_halfedges.clear();
      for (std::size_t i = 0; i < m_fine_loop.size(); ++i) {
        m_halfedges.push_back(
            m_levels.finest().surface.find_halfedge(m_fine_loop[i], m_fine_loop[(i + 1) % m_fine_loop.size()]));
      }
      if (std::count(m_halfedges.begin(), m_halfedges.end(), no_index) == 0) {
        result.shortening = m_shorten(m_halfedges, source, result.separator);
      }
    }
  }

  const Multiscale_search_space& m_space;
  const Surface_levels& m_levels;
  std::vector<std::unique_ptr<Multiscale_search_space::Level_space::Finder>>
      m_finders; ///< of the levels that have distances
  Heat_workspace m_workspace;
  Loop_projection m_projection;
  Separator_flip_shortening<Triangulated_surface> m_shorten; ///< on the finest level
  std::vector<std::size_t> m_pending;                        ///< places in the group
  std::vector<Level_source> m_level_sources;
  std::vector<std::vector<Geodesic_source>> m_source_sets;
  std::vector<std::vector<double>> m_distances;
  Vertex_loop m_loop;
  Vertex_loop m_fine_loop;
  std::vector<Index> m_halfedges;
};

/// The first stage as published (Alg. 2, lines 1 to 9): sources are drawn by their distance from earlier ones; the heat
/// method gives the distance field of each, and that its separator.
///
/// Sources are drawn in rounds, each after all earlier ones are done; so the answer does not depend on the number of
/// threads. A thread takes a group of sources at a time, whose distances are solved for together.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Sampled_search
{
public:
  /// \pre `field_settings.is_multiscale` only if `surface` is a `Triangulated_solid`
  Sampled_search(const Surface& surface, const Options& settings, const Field_search_settings& field_settings)
      : m_group_size(field_settings.is_multiscale ? multiscale_group_size : Heat_workspace::batch_size),
        m_round_size(field_settings.sampling_rule == Sampling_rule::one_by_one ? 1 : m_group_size * max_groups),
        m_sampling(shares(surface.triangulation(), field_settings.sampling_rule), settings.random_seed),
        m_for_each(make_search_factory(surface, field_settings), settings.number_of_threads)
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
      m_sampling.draw(std::min(m_round_size, number_of_sources - report.number_of_sources), m_sources);
      if (m_sources.empty()) {
        break;
      }
      search_round();
      for (Index group = 0; group < number_of_groups(); ++group) {
        take_results(m_groups[group], separators, report);
      }
      progress(double(report.number_of_sources) / double(number_of_sources));
    }
    return separators;
  }

private:
  /// So many that those which need a finer level fill batches there.
  static constexpr std::size_t multiscale_group_size = 4 * Heat_workspace::batch_size;
  /// A round is enough for a few threads, and little against the number of all sources.
  static constexpr std::size_t max_groups = 4;

  using Triangulation = std::decay_t<decltype(std::declval<const Surface&>().triangulation())>;

  /// The probability of each vertex before its distance is known.
  static std::vector<double> shares(const Triangulation& surface, Sampling_rule rule)
  {
    std::vector<double> result(surface.number_of_vertices());
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      const auto area = double(surface.vertex_area(vertex));
      result[vertex] = rule == Sampling_rule::one_by_one && area > 0 ? 1 : area;
    }
    return result;
  }

  /// Prepares what all threads share. \return a function that makes the search of a thread
  static std::function<Group_search()> make_search_factory(const Surface& surface,
                                                           const Field_search_settings& settings)
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      if (settings.is_multiscale) {
        return share<Multiscale_search_space, Multiscale_group_search>(surface.levels(), settings);
      }
    }
    CGAL_precondition(!settings.is_multiscale);
    using Space = Field_search_space<Triangulation>;
    return share<Space, Field_group_search<Space>>(surface.triangulation(), settings);
  }

  template <class Space, class Search, class Domain>
  static std::function<Group_search()> share(const Domain& domain, const Field_search_settings& settings)
  {
    return [space = std::make_shared<const Space>(domain, settings)]() -> Group_search {
      return [search = std::make_shared<Search>(*space)](Source_group& group) { (*search)(group); };
    };
  }

  Index number_of_groups() const { return Index((m_sources.size() + m_group_size - 1) / m_group_size); }

  void search_round()
  {
    for (Index group = 0; group < number_of_groups(); ++group) {
      const auto begin = m_sources.begin() + std::ptrdiff_t(group * m_group_size);
      const auto size = std::min(std::ptrdiff_t(m_group_size), m_sources.end() - begin);
      m_groups[group].sources.assign(begin, begin + size);
    }
    m_for_each(number_of_groups(), [this](Index group, const Group_search& search) { search(m_groups[group]); });
    for (Index group = 0; group < number_of_groups(); ++group) {
      m_sampling.add_sources(m_groups[group].distance);
    }
  }

  static void take_results(const Source_group& group, std::vector<Separator>& separators,
                           Skeletonization_report& report)
  {
    for (const Field_search_result& result : group.results) {
      ++report.number_of_sources;
      if (result.loop != Cut_loop_outcome::found) {
        ++report.number_of_sources_without_cut;
        ++report.number_of_rejections[std::size_t(result.loop)];
      } else if (result.shortening == Shortening_outcome::collapsed) {
        ++report.number_of_collapsed_loops;
      } else {
        separators.push_back(result.separator);
        report.number_of_held_loops += result.shortening == Shortening_outcome::held ? 1 : 0;
        report.number_of_unfinished_loops += result.shortening == Shortening_outcome::unfinished ? 1 : 0;
      }
    }
  }

  std::size_t m_group_size;
  std::size_t m_round_size;
  Distance_sampling m_sampling;
  For_each_index<Group_search> m_for_each;
  std::vector<Index> m_sources;
  std::array<Source_group, max_groups> m_groups;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SAMPLED_SEARCH_H
