// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface at several levels of detail.

#ifndef CSCD_SURFACE_SURFACE_LEVELS_H
#define CSCD_SURFACE_SURFACE_LEVELS_H

#include <CSCD/Surface/Coarsening.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/Vertex_fan_table.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_range.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD {

/// One level of detail.
struct Surface_level
{
  /// Takes over `level_surface`.
  explicit Surface_level(Triangulated_surface&& level_surface) : surface(std::move(level_surface)) {}

  /// The vertex of the finest level that `vertex` of this level is.
  Index to_finest(Index vertex) const { return finest_vertex.empty() ? vertex : finest_vertex[vertex]; }
  /// The vertex of this level that represents `vertex` of the finest level.
  Index from_finest(Index vertex) const { return level_vertex.empty() ? vertex : level_vertex[vertex]; }

  /// The triangles around each vertex, as fronts read them. The first call builds them, which is linear: on large
  /// surfaces no front runs on the finest levels. May be called by several threads at once.
  const Vertex_fan_table& corners() const
  {
    std::call_once(m_fans->is_built, [this] { m_fans->corners = Vertex_fan_table(surface); });
    return m_fans->corners;
  }

  /// The triangles of the level.
  Triangulated_surface surface;
  std::vector<Index> finest_vertex; ///< empty on the finest level
  std::vector<Index> level_vertex;  ///< empty on the finest level

private:
  struct Fans
  {
    std::once_flag is_built;
    Vertex_fan_table corners;
  };

  std::unique_ptr<Fans> m_fans = std::make_unique<Fans>(); // in a place of its own: a flag cannot be moved
};

/// The levels of detail of a surface: level 0 is the surface itself, each further one has about 2/7 of its vertices.
/// A front runs on the level on which the limb that it explores is a few tens of edges around; so its cost does not
/// depend on the number of vertices (supplement K.2 has the idea).
class Surface_levels
{
public:
  /// Coarsens `finest`, which need not be measured yet, until a level has at most `coarsest_size` vertices. Linear.
  /// \param number_of_threads 0 for as many as TBB allows; the levels are the same for any number
  /// \param needs_finest whether coarser levels lose limbs, so that none is a substitute for the finest one
  explicit Surface_levels(Triangulated_surface&& finest, unsigned number_of_threads = 1, bool needs_finest = false)
      : m_number_of_threads(number_of_threads), m_needs_finest(needs_finest)
  {
    m_levels.emplace_back(std::move(finest));
    while (m_levels.back().surface.number_of_vertices() > coarsest_size && add_level()) {
    }
    m_levels.back().surface.measure();
  }

  /// The number of levels.
  Index size() const { return Index(m_levels.size()); }
  /// The level of index `level`.
  const Surface_level& operator[](Index level) const { return m_levels[level]; }
  /// The level of index 0.
  const Surface_level& finest() const { return m_levels.front(); }
  /// The last level.
  const Surface_level& coarsest() const { return m_levels.back(); }
  /// The index of the coarsest level.
  Index top() const { return size() - 1; }

  /// Whether coarser levels lose limbs.
  bool needs_finest() const { return m_needs_finest; }
  /// The index of the finest level that has at most `limit` vertices, or of the coarsest; of the finest if limbs need
  /// it.
  Index finest_with_at_most(Index limit) const
  {
    Index level = 0;
    while (!m_needs_finest && level < top() && m_levels[level].surface.number_of_vertices() > limit) {
      ++level;
    }
    return level;
  }

private:
  /// Vertices at which coarsening ends: on further levels no limb is enough edges around for its front. Of 800 to 6000,
  /// found on 63 odd-numbered Princeton meshes: the search takes three fifths of the time that it takes at 6000, and at
  /// 800 no less, while errors grow.
  static constexpr Index coarsest_size = 1500;
  /// A pass that keeps a larger part of the vertices than this does not justify a level.
  static constexpr double min_reduction = 0.8;

  bool add_level()
  {
    Surface_level& fine = m_levels.back();
    // Coarsening needs no areas and no normals.
    std::optional<internal::Coarsening> coarsening;
    internal::call_both(
        m_number_of_threads, [&] { coarsening.emplace(fine.surface, m_number_of_threads); },
        [&] { fine.surface.measure(); });
    if (double(coarsening->fine_vertex().size()) > min_reduction * fine.surface.number_of_vertices()) {
      return false;
    }
    Indexed_triangles triangles = coarsening->triangles();
    std::vector<Index> finest_vertex;
    std::vector<Index> coarse_vertex;
    std::move(*coarsening).move_to(finest_vertex, coarse_vertex);
    coarsening.reset(); // before memory is taken for the surface
    Triangulated_surface coarse(std::move(triangles), m_number_of_threads);
    if (coarse.defect()) {
      return false;
    }
    Surface_level level(std::move(coarse));
    for (Index& vertex : finest_vertex) {
      vertex = fine.to_finest(vertex);
    }
    level.finest_vertex = std::move(finest_vertex);
    const Index n = m_levels.front().surface.number_of_vertices();
    level.level_vertex.resize(n);
    internal::for_each_range(n, m_number_of_threads, [&](Index begin, Index end) {
      for (Index vertex = begin; vertex < end; ++vertex) {
        level.level_vertex[vertex] = coarse_vertex[fine.from_finest(vertex)];
      }
    });
    m_levels.push_back(std::move(level));
    return true;
  }

  unsigned m_number_of_threads;
  bool m_needs_finest;
  std::vector<Surface_level> m_levels;
};

} // namespace CSCD

#endif // CSCD_SURFACE_SURFACE_LEVELS_H
