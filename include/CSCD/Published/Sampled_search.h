// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeks separators from sources drawn at random, each from a distance field of the whole surface.

#ifndef CSCD_PUBLISHED_SAMPLED_SEARCH_H
#define CSCD_PUBLISHED_SAMPLED_SEARCH_H

#include <CSCD/Options.h>
#include <CSCD/Published/Cut_loop_finder.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Field_search_space.h>
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
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <CGAL/assertions.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
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

  /// Takes note of sources: the geodesic distance of a vertex from them is `distance[place(vertex)]`, infinite where
  /// none reaches.
  template <class Place>
  void add_sources(const std::vector<float>& distance, const Place& place)
  {
    for (Index vertex = 0; vertex < m_distance.size(); ++vertex) {
      m_distance[vertex] = std::min(m_distance[vertex], std::max(0., double(distance[place(vertex)])));
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

/// The result of the search for the separator of one source by its distance field.
struct Field_search_result
{
  /// `found`, or the reason why there is none.
  Cut_loop_outcome loop = Cut_loop_outcome::no_cut_point;
  /// Where a loop was found, how its shortening ended; `collapsed` otherwise.
  Shortening_outcome shortening = Shortening_outcome::collapsed;
  Separator separator; ///< where a loop was found that did not collapse
};

/// Sources whose distances are solved for together, and the results of their searches.
struct Source_group
{
  std::vector<Index> sources; ///< vertices of the finest surface
  std::vector<Field_search_result> results;
  std::vector<float> distance; ///< for each vertex of the coarsest level, from the nearest of the sources
};

/// A source on a level of detail: in a face, and the corner of it that is nearest by barycentric coordinates.
struct Level_source
{
  Geodesic_source source;
  Index vertex;
  Vector3 point;
};

/// The barycentric coordinates of the foot of `point` on the plane of `face`, those below 0 set to 0; none where the
/// face has no area.
inline std::optional<std::array<double, 3>> weights_in_face(const Triangulated_surface& surface, Index face,
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

/// The point nearest to `point` on the faces around `center`, a vertex of a level.
inline Level_source source_on_level(const Triangulated_surface& surface, Index center, const Vector3& point)
{
  Level_source best{Geodesic_source::at_vertex(center), center, surface.point(center)};
  double min_distance = (best.point - point).squaredNorm();
  for (const Index halfedge : surface.outgoing(center)) {
    const Index face = Triangulated_surface::face(halfedge);
    const std::optional<std::array<double, 3>> weights = weights_in_face(surface, face, point);
    if (!weights) {
      continue;
    }
    Vector3 candidate = Vector3::Zero();
    for (Index k = 0; k < 3; ++k) {
      candidate += (*weights)[k] * surface.point(surface.origin(3 * face + k));
    }
    const double distance = (candidate - point).squaredNorm();
    if (distance < min_distance) {
      min_distance = distance;
      const auto corner = Index(std::max_element(weights->begin(), weights->end()) - weights->begin());
      best = {Geodesic_source::in_face(surface, face, *weights), surface.origin(3 * face + corner), candidate};
    }
  }
  return best;
}

/// The levels of detail on which distances are computed, prepared once, shared by all threads: those of a multiscale
/// search (supplement, K.2), which leaves the finest out if there are coarser ones, or the surface alone.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Search_levels
{
public:
  using Triangulation = std::decay_t<decltype(std::declval<const Surface&>().triangulation())>;
  using Space = Field_search_space<Triangulation>;

  /// \param surface is referred to and must outlive this object
  Search_levels(const Surface& surface, bool is_multiscale) : m_surface(surface)
  {
    CGAL_precondition(has_levels || !is_multiscale);
    if constexpr (has_levels) {
      m_coarsest = is_multiscale ? surface.levels().finest_with_at_most(coarsest_size) : 0;
      if (m_coarsest > 0) {
        m_unflipped.emplace(surface.triangulation());
      }
      for (Index level = finest(); level <= m_coarsest; ++level) {
        m_spaces.push_back(std::make_unique<Space>(surface.levels()[level].surface));
      }
    } else {
      m_spaces.push_back(std::make_unique<Space>(surface.triangulation()));
    }
  }

  /// The coarsest level that has distances.
  Index coarsest() const { return m_coarsest; }
  /// The finest level that has distances.
  Index finest() const { return std::min<Index>(1, m_coarsest); }
  /// \pre `level` is not below `finest()` nor above `coarsest()`
  const Space& operator[](Index level) const { return *m_spaces[level - finest()]; }

  /// The vertex of the coarsest level that represents `vertex` of the surface.
  Index on_coarsest([[maybe_unused]] Index vertex) const
  {
    if constexpr (has_levels) {
      return m_surface.levels()[m_coarsest].from_finest(vertex);
    } else {
      return vertex;
    }
  }

  /// Where the source at `vertex` of the surface is on `level`.
  Level_source source([[maybe_unused]] Index level, Index vertex) const
  {
    const Vector3& point = m_surface.triangulation().points()[vertex];
    if constexpr (has_levels) {
      if (level > 0) {
        const Surface_level& coarse = m_surface.levels()[level];
        return source_on_level(coarse.surface, coarse.from_finest(vertex), point);
      }
    }
    return {Geodesic_source::at_vertex(vertex), vertex, point};
  }

  const Surface& surface() const { return m_surface; }
  /// That of the surface, not flipped; none if its finest level has distances.
  const std::optional<Intrinsic_triangulation>& unflipped() const { return m_unflipped; }

private:
  static constexpr bool has_levels = std::is_same_v<Surface, Triangulated_solid>;
  /// A level of at most so many vertices needs no coarser one: solves take little time, and estimated distances need
  /// edges that are short compared with the limbs.
  static constexpr Index coarsest_size = 6000;

  const Surface& m_surface;
  Index m_coarsest = 0;
  std::vector<std::unique_ptr<const Space>> m_spaces;
  std::optional<Intrinsic_triangulation> m_unflipped;
};

/// Carries loops from coarse levels to the finest, by shortest paths between their vertices, and shortens them there.
/// One object serves one thread.
class Coarse_loop_shortening
{
public:
  /// \param triangulation that of the finest level, not flipped; as `levels`, it is referred to
  Coarse_loop_shortening(const Surface_levels& levels, const Intrinsic_triangulation& triangulation)
      : m_levels(levels), m_projection(levels), m_shorten(levels.finest().surface, triangulation)
  {
  }

  /// As `Separator_flip_shortening`, for the loop of these vertices of `level`.
  Shortening_outcome operator()(Index level, const Vertex_loop& loop, Index source, Separator& separator)
  {
    if (!m_projection(m_levels[level], loop, m_fine_loop)) {
      return Shortening_outcome::collapsed;
    }
    m_halfedges.clear();
    for (std::size_t i = 0; i < m_fine_loop.size(); ++i) {
      m_halfedges.push_back(
          m_levels.finest().surface.find_halfedge(m_fine_loop[i], m_fine_loop[(i + 1) % m_fine_loop.size()]));
    }
    return std::count(m_halfedges.begin(), m_halfedges.end(), no_index) == 0 ? m_shorten(m_halfedges, source, separator)
                                                                             : Shortening_outcome::collapsed;
  }

private:
  const Surface_levels& m_levels;
  Loop_projection m_projection;
  Separator_flip_shortening<Triangulated_surface> m_shorten;
  Vertex_loop m_fine_loop;
  std::vector<Index> m_halfedges;
};

/// Searches from the sources of a group, on the coarsest level first. Where that finds no loop, or a loop of too few
/// edges, it searches again on the next finer level. Loops of coarse levels are shortened on the finest level only,
/// since each shortening may let a loop slide. One object serves one thread.
template <class Surface>
class Group_search
{
public:
  /// \param levels is referred to, as `settings`
  Group_search(const Search_levels<Surface>& levels, const Field_search_settings& settings) : m_levels(levels)
  {
    for (Index level = levels.finest(); level <= levels.coarsest(); ++level) {
      m_finders.push_back(std::make_unique<Cut_loop_finder<Space>>(levels[level], settings));
    }
    if (levels.finest() == 0) {
      m_shorten = levels[0].make_shortening();
    } else if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      m_shorten_coarse.emplace(levels.surface().levels(), *levels.unflipped());
    }
  }

  void operator()(Source_group& group)
  {
    group.results.resize(group.sources.size());
    m_pending = all_indices(group.sources.size());
    for (Index level = m_levels.coarsest(); !m_pending.empty(); --level) {
      search_level(level, group);
    }
  }

private:
  using Space = typename Search_levels<Surface>::Space;

  /// The least length of a loop in mean edge lengths of its level, except on the finest level. Chosen on armadillo and
  /// warrior: with 8 errors are greater and tips fewer; with 16 nothing is gained.
  static constexpr double min_edges_of_loop = 12;

  /// Searches from the pending sources, and leaves those pending that need a finer level.
  void search_level(Index level, Source_group& group)
  {
    const Space& space = m_levels[level];
    Cut_loop_finder<Space>& find_loop = *m_finders[level - m_levels.finest()];
    std::vector<Level_source> sources;
    std::vector<std::vector<Geodesic_source>> source_sets;
    for (const Index i : m_pending) {
      sources.push_back(m_levels.source(level, group.sources[i]));
      source_sets.push_back({sources.back().source});
    }
    if (level == m_levels.coarsest()) {
      group.distance.assign(space.surface.number_of_vertices(), std::numeric_limits<float>::infinity());
    }
    std::vector<Index> refused;
    m_workspace(space.heat_method, source_sets, [&](std::size_t k, const std::vector<double>& distances) {
      if (level == m_levels.coarsest()) {
        std::transform(distances.begin(), distances.end(), group.distance.begin(), group.distance.begin(),
                       [](double distance, float least) { return std::min(least, float(distance)); });
      }
      const Cut_loop& loop = find_loop(sources[k].vertex, sources[k].point, distances);
      const bool is_found = loop.outcome == Cut_loop_outcome::found;
      if (level > m_levels.finest() &&
          !(is_found && 2 * loop.distance >= min_edges_of_loop * space.frames.mean_edge_length())) {
        refused.push_back(m_pending[k]);
        return;
      }
      Field_search_result& result = group.results[m_pending[k]];
      result.loop = loop.outcome;
      result.separator.source = group.sources[m_pending[k]];
      result.shortening = is_found ? shorten(level, loop.halfedges, result.separator) : Shortening_outcome::collapsed;
    });
    m_pending.swap(refused);
  }

  /// Shortens the loop along `halfedges` of `level` to the separator of its source.
  Shortening_outcome shorten(Index level, const std::vector<Index>& halfedges, Separator& separator)
  {
    if (level == 0) {
      return (*m_shorten)(halfedges, separator.source, separator);
    }
    Vertex_loop loop;
    for (const Index halfedge : halfedges) {
      loop.push_back(m_levels[level].frames.triangulation().origin(halfedge));
    }
    return (*m_shorten_coarse)(level, loop, separator.source, separator);
  }

  const Search_levels<Surface>& m_levels;
  std::vector<std::unique_ptr<Cut_loop_finder<Space>>> m_finders; ///< of the levels that have distances
  std::unique_ptr<typename Space::Shortening> m_shorten;          ///< on the finest level, if that has distances
  std::optional<Coarse_loop_shortening> m_shorten_coarse;         ///< of other levels
  Heat_workspace m_workspace;
  std::vector<Index> m_pending; ///< places in the group
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
        m_settings(field_settings), m_levels(surface, field_settings.is_multiscale),
        m_sampling(shares(surface.triangulation(), field_settings.sampling_rule), settings.random_seed),
        m_for_each([this] { return std::make_unique<Group_search<Surface>>(m_levels, m_settings); },
                   settings.number_of_threads)
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

  /// The probability of each vertex before its distance is known.
  template <class Triangulation>
  static std::vector<double> shares(const Triangulation& surface, Sampling_rule rule)
  {
    std::vector<double> result(surface.number_of_vertices());
    for (Index vertex = 0; vertex < result.size(); ++vertex) {
      const auto area = double(surface.vertex_area(vertex));
      result[vertex] = rule == Sampling_rule::one_by_one && area > 0 ? 1 : area;
    }
    return result;
  }

  Index number_of_groups() const { return Index((m_sources.size() + m_group_size - 1) / m_group_size); }

  void search_round()
  {
    for (Index group = 0; group < number_of_groups(); ++group) {
      const auto begin = m_sources.begin() + std::ptrdiff_t(group * m_group_size);
      const auto size = std::min(std::ptrdiff_t(m_group_size), m_sources.end() - begin);
      m_groups[group].sources.assign(begin, begin + size);
    }
    m_for_each(number_of_groups(), [this](Index group, const auto& search) { (*search)(m_groups[group]); });
    for (Index group = 0; group < number_of_groups(); ++group) {
      m_sampling.add_sources(m_groups[group].distance, [this](Index vertex) { return m_levels.on_coarsest(vertex); });
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
  const Field_search_settings m_settings;
  Search_levels<Surface> m_levels;
  Distance_sampling m_sampling;
  For_each_index<std::unique_ptr<Group_search<Surface>>> m_for_each;
  std::vector<Index> m_sources;
  std::array<Source_group, max_groups> m_groups;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SAMPLED_SEARCH_H
