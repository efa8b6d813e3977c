// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarser and coarser levels of detail of a surface, by edge collapses.

#ifndef CSCD_SURFACE_SURFACE_LEVELS_H
#define CSCD_SURFACE_SURFACE_LEVELS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>
#include <CSCD/internal/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Coarsens a surface by half-edge collapses into a maximal independent set of vertices, which leaves about 2/7 of
/// them. The coarse vertices are a subset of the fine ones, the coarse surface is a closed oriented manifold of the
/// same topology, and the result depends on the numbering of the fine surface alone. Linear.
class Coarsening
{
public:
  /// The squared cosine of the maximal turn of a face's normal in a collapse: of about 78 degrees.
  static constexpr double usual_squared_cosine = 0.04;

  /// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
  /// \param min_squared_cosine that of the maximal turn of a face's normal in a collapse
  explicit Coarsening(const Triangulated_surface& fine, unsigned number_of_threads = 1,
                      double min_squared_cosine = usual_squared_cosine)
      : m_fine(fine), m_min_squared_cosine(min_squared_cosine)
  {
    freeze_wide_stars();
    freeze_bridges();
    for_each_vertex(number_of_threads, [this](Index vertex, const Block& block, Scratch&) {
      return m_status[vertex] != Status::open || keep_if_free(vertex, block);
    });
    copy_rings();
    collapse_others(number_of_threads);
    number_coarse_vertices();
  }

  /// The coarse surface as points and faces.
  Indexed_triangles triangles() const
  {
    Indexed_triangles result;
    result.points.reserve(m_fine_vertex.size());
    for (Index vertex : m_fine_vertex) {
      result.points.push_back(m_fine.point(vertex));
    }
    result.faces.reserve(2 * m_fine_vertex.size());
    std::vector<std::array<Index, 3>> bridging;
    for (Index vertex : m_fine_vertex) {
      append_faces_of(vertex, result.faces, bridging);
    }
    result.first_hole_filling_face = result.faces.size();
    result.faces.insert(result.faces.end(), bridging.begin(), bridging.end());
    return result;
  }

  /// For each coarse vertex, its fine vertex.
  const std::vector<Index>& fine_vertex() const { return m_fine_vertex; }
  /// Hands over these and, for each fine vertex, the coarse vertex that it is or was collapsed into.
  void move_to(std::vector<Index>& fine, std::vector<Index>& coarse) &&
  {
    fine = std::move(m_fine_vertex);
    coarse = std::move(m_coarse_vertex);
  }

private:
  enum class Status : std::uint8_t
  {
    open,    ///< undecided, or could not be collapsed: stays
    kept,    ///< in the independent set
    removed, ///< collapsed into a kept vertex
    frozen   ///< stays, and so do its faces
  };

  /// Vertices of higher degree are frozen. A bound keeps the working memory of a collapse small.
  static constexpr Index max_degree = 20;

  /// Consecutive vertices.
  struct Block
  {
    bool contains(Index vertex) const { return begin <= vertex && vertex < end; }

    Index begin;
    Index end;
  };

  /// Vectors around a vertex, twice one after the other, so that no index has to be wrapped around.
  using Star = std::array<Vector3, 2 * std::size_t(max_degree)>;
  /// Working memory of a thread, which need not be set to zero for each vertex.
  struct Scratch
  {
    Star incident_edge;
    Star face_vector;
  };

  /// The size of a block. Numbers go round the surface, so that most neighbors of a vertex are in its block; a smaller
  /// surface is one block.
  static constexpr Index block_size = 1U << 16U;
  /// A collapse may not make a degree higher than this; leaves room for later collapses into the same vertex.
  static constexpr Index max_degree_after = 16;
  /// Weight of the turn of the normals against the squared length in the cost of a collapse.
  static constexpr double turn_weight = 3;
  /// Faces of less area count as without area: rounding alone gives them a direction. Relative to the squared length of
  /// the edge that is collapsed.
  static constexpr double min_relative_area = 1e-9;

  Index* ring(Index vertex) { return m_ring.data() + m_ring_begin[vertex]; }
  const Index* ring(Index vertex) const { return m_ring.data() + m_ring_begin[vertex]; }

  void freeze_wide_stars()
  {
    m_status.assign(m_fine.number_of_vertices(), Status::open);
    for (Index vertex = 0; vertex < m_status.size(); ++vertex) {
      if (m_fine.degree(vertex) > max_degree) {
        m_status[vertex] = Status::frozen;
        for (Index halfedge : m_fine.outgoing(vertex)) {
          m_status[m_fine.target(halfedge)] = Status::frozen;
        }
      }
    }
  }

  /// The ring of a kept vertex has room to grow; no other ring grows.
  void copy_rings()
  {
    const Index n = m_fine.number_of_vertices();
    m_degree.assign(n, 0);
    m_ring_begin.resize(n);
    Index size = 0;
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index degree = m_fine.degree(vertex);
      m_degree[vertex] = std::uint8_t(degree <= max_degree ? degree : 0);
      m_ring_begin[vertex] = size;
      size += m_status[vertex] == Status::kept ? std::max(degree, max_degree_after) : Index(m_degree[vertex]);
    }
    m_ring.resize(size);
    for (Index vertex = 0; vertex < n; ++vertex) {
      if (m_degree[vertex] > 0) {
        const auto outgoing = m_fine.outgoing(vertex);
        std::transform(outgoing.begin(), outgoing.end(), ring(vertex), [this](Index h) { return m_fine.target(h); });
      }
    }
  }

  /// Faces without weight stay as they are, so that every level has them.
  void freeze_bridges()
  {
    for (Index h = 3 * m_fine.first_hole_filling_face(); h < m_fine.number_of_halfedges(); ++h) {
      m_status[m_fine.origin(h)] = Status::frozen;
    }
  }

  /// Calls `treat(vertex, block, scratch)` for all vertices of each block, in order, and then again, with a block of
  /// all vertices, for vertices where it has returned false. Where it returns true, it may have changed the data of
  /// vertices of the block only.
  template <class Treat>
  void for_each_vertex(unsigned number_of_threads, const Treat& treat)
  {
    const auto n = Index(m_status.size());
    std::vector<std::vector<Index>> postponed(n / block_size + 1);
    For_each_index<Scratch> for_each([] { return Scratch(); }, postponed.size() > 1 ? number_of_threads : 1);
    for_each(Index(postponed.size()), [&](Index i, Scratch& scratch) {
      const Block block{i * block_size, std::min((i + 1) * block_size, n)};
      for (Index vertex = block.begin; vertex < block.end; ++vertex) {
        if (!treat(vertex, block, scratch)) {
          postponed[i].push_back(vertex);
        }
      }
    });
    Scratch scratch;
    for (const std::vector<Index>& vertices : postponed) {
      for (const Index vertex : vertices) {
        treat(vertex, Block{0, n}, scratch);
      }
    }
  }

  /// Keeps `vertex` unless a neighbor is kept. \return false if it has a neighbor outside `block`
  bool keep_if_free(Index vertex, const Block& block)
  {
    bool is_free = true;
    for (const Index halfedge : m_fine.outgoing(vertex)) {
      const Index neighbor = m_fine.target(halfedge);
      if (!block.contains(neighbor)) {
        return false;
      }
      is_free = is_free && m_status[neighbor] != Status::kept;
    }
    m_status[vertex] = is_free ? Status::kept : Status::open;
    return true;
  }

  void collapse_others(unsigned number_of_threads)
  {
    m_parent = all_indices(m_status.size());
    for_each_vertex(number_of_threads, [this](Index vertex, const Block& block, Scratch& scratch) {
      return m_status[vertex] != Status::open || m_degree[vertex] < 3 || collapse_if_possible(vertex, block, scratch);
    });
  }

  /// \return false if `vertex` has a neighbor outside `block`
  bool collapse_if_possible(Index vertex, const Block& block, Scratch& scratch)
  {
    bool has_frozen_neighbor = false;
    for (const Index* neighbor = ring(vertex); neighbor != ring(vertex) + m_degree[vertex]; ++neighbor) {
      if (!block.contains(*neighbor)) {
        return false;
      }
      has_frozen_neighbor = has_frozen_neighbor || m_status[*neighbor] == Status::frozen;
    }
    const Index side = has_frozen_neighbor ? no_index : best_collapse(vertex, scratch);
    if (side != no_index) {
      collapse(vertex, side);
    }
    return true;
  }

  /// The position in the ring of `vertex` of the kept neighbor that it is best collapsed into, or `no_index`.
  Index best_collapse(Index vertex, Scratch& scratch) const
  {
    const Index degree = m_degree[vertex];
    const Index* neighbors = ring(vertex);
    auto& [incident_edge, face_vector] = scratch;
    for (Index i = 0; i < degree; ++i) {
      incident_edge[i] = incident_edge[i + degree] = m_fine.point(neighbors[i]) - m_fine.point(vertex);
    }
    for (Index i = 0; i < degree; ++i) {
      face_vector[i] = face_vector[i + degree] = incident_edge[i].cross(incident_edge[i + 1]);
    }
    // Costs are rounded to single precision, so that rounding does not choose between equal ones.
    Index best = no_index;
    std::pair best_cost(std::numeric_limits<float>::max(), std::numeric_limits<std::uint32_t>::max());
    for (Index i = 0; i < degree; ++i) {
      if (m_status[neighbors[i]] != Status::kept || float(incident_edge[i].squaredNorm()) > best_cost.first) {
        continue;
      }
      const double cosine = least_turn_squared_cosine(incident_edge, face_vector, degree, i);
      const std::pair cost(float(incident_edge[i].squaredNorm() * (1 + turn_weight * (1 - cosine))),
                           scattered(vertex, neighbors[i]));
      if (cosine >= m_min_squared_cosine && cost < best_cost && is_collapsible(vertex, i)) {
        best = i;
        best_cost = cost;
      }
    }
    return best;
  }

  /// The squared cosine of the maximal turn of a normal when the center moves along incident edge `side`; -1 if one
  /// turns by 90 degrees or more.
  double least_turn_squared_cosine(const Star& incident_edge, const Star& face_vector, Index degree, Index side) const
  {
    const double min_area = min_relative_area * incident_edge[side].squaredNorm();
    const double min_squared_area = min_area * min_area;
    double least = 1;
    for (Index a = side + 1; a + 1 < side + degree; ++a) {
      const Vector3 moved = (incident_edge[a] - incident_edge[side]).cross(incident_edge[a + 1] - incident_edge[side]);
      const double product = moved.dot(face_vector[a]);
      const double squared_area = moved.squaredNorm();
      const double old_squared_area = face_vector[a].squaredNorm();
      if (product <= 0 || squared_area <= min_squared_area || old_squared_area <= min_squared_area) {
        return -1;
      }
      const double norms = squared_area * old_squared_area;
      least = std::min(least, product * product / norms);
      if (least < m_min_squared_cosine) {
        return -1;
      }
    }
    return least;
  }

  /// Whether collapsing `vertex` into its ring neighbor at `side` keeps a manifold: the link condition, and no vertex
  /// left with fewer than three neighbors.
  bool is_collapsible(Index vertex, Index side) const
  {
    const Index degree = m_degree[vertex];
    const Index* neighbors = ring(vertex);
    const Index into = neighbors[side];
    if (m_degree[into] + degree - 4 > max_degree_after) {
      return false;
    }
    if (m_degree[neighbors[(side + 1) % degree]] <= 3 || m_degree[neighbors[(side + degree - 1) % degree]] <= 3) {
      return false;
    }
    const Index* others = ring(into);
    Index common = 0;
    for (Index i = 0; i < m_degree[into]; ++i) {
      common += Index(std::count(neighbors, neighbors + degree, others[i]));
    }
    return common == 2;
  }

  void collapse(Index vertex, Index side)
  {
    const Index degree = m_degree[vertex];
    const Index* neighbors = ring(vertex);
    const Index into = neighbors[side];
    splice_ring(vertex, side);
    for (Index j = 2; j + 1 < degree; ++j) {
      const Index other = neighbors[(side + j) % degree];
      std::replace(ring(other), ring(other) + m_degree[other], vertex, into);
    }
    for (Index j : {Index(1), degree - 1}) {
      const Index other = neighbors[(side + j) % degree];
      // No ring holds a vertex twice.
      Index* const end = std::remove(ring(other), ring(other) + m_degree[other], vertex);
      m_degree[other] = std::uint8_t(end - ring(other));
    }
    m_status[vertex] = Status::removed;
    m_parent[vertex] = into;
  }

  /// In the ring of the target of the collapse, puts the far side of the ring of `vertex` in its place.
  void splice_ring(Index vertex, Index side)
  {
    const Index degree = m_degree[vertex];
    const Index* neighbors = ring(vertex);
    const Index into = neighbors[side];
    const Index* old_ring = ring(into);
    std::array<Index, 2 * std::size_t(max_degree)> spliced;
    Index size = 0;
    for (Index i = 0; i < m_degree[into]; ++i) {
      if (old_ring[i] != vertex) {
        spliced[size++] = old_ring[i];
        continue;
      }
      for (Index j = 2; j + 1 < degree; ++j) {
        spliced[size++] = neighbors[(side + j) % degree];
      }
    }
    std::copy(spliced.begin(), spliced.begin() + size, ring(into));
    m_degree[into] = std::uint8_t(size);
  }

  void number_coarse_vertices()
  {
    m_coarse_vertex.assign(m_status.size(), no_index);
    for (Index vertex = 0; vertex < m_status.size(); ++vertex) {
      if (m_status[vertex] != Status::removed) {
        m_coarse_vertex[vertex] = Index(m_fine_vertex.size());
        m_fine_vertex.push_back(vertex);
      }
    }
    for (Index vertex = 0; vertex < m_status.size(); ++vertex) {
      if (m_status[vertex] == Status::removed) {
        m_coarse_vertex[vertex] = m_coarse_vertex[m_parent[vertex]];
      }
    }
  }

  /// Appends the faces whose smallest corner is `vertex`.
  void append_faces_of(Index vertex, std::vector<std::array<Index, 3>>& faces,
                       std::vector<std::array<Index, 3>>& bridging) const
  {
    const auto append = [&](Index a, Index b, std::vector<std::array<Index, 3>>& to) {
      if (vertex < a && vertex < b) {
        to.push_back({m_coarse_vertex[vertex], m_coarse_vertex[a], m_coarse_vertex[b]});
      }
    };
    if (m_status[vertex] == Status::frozen) {
      // Nothing around a frozen vertex has changed.
      for (Index h : m_fine.outgoing(vertex)) {
        append(m_fine.target(h), m_fine.opposite_vertex(h),
               m_fine.is_hole_filling(Triangulated_surface::face(h)) ? bridging : faces);
      }
      return;
    }
    const Index degree = m_degree[vertex];
    const Index* neighbors = ring(vertex);
    for (Index i = 0; i < degree; ++i) {
      append(neighbors[i], neighbors[(i + 1) % degree], faces);
    }
  }

  const Triangulated_surface& m_fine;
  double m_min_squared_cosine;
  std::vector<Index> m_ring; // of all vertices, one after the other
  std::vector<Index> m_ring_begin;
  std::vector<std::uint8_t> m_degree; // 0 where it is too high
  std::vector<Status> m_status;
  std::vector<Index> m_parent;
  std::vector<Index> m_fine_vertex;
  std::vector<Index> m_coarse_vertex;
};

} // namespace CSCD::internal

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

/// The levels of detail of a surface: level 0 is the surface itself, each further one has about 2/7 of its vertices. A
/// front runs on the level where the limb that it explores is a few tens of edges around; so its cost does not depend
/// on the number of vertices (supplement K.2 has the idea).
class Surface_levels
{
public:
  /// Coarsens `finest` until a level has at most `coarsest_size` vertices, or the next one would lose limbs. Linear.
  /// \param number_of_threads 0 for as many as TBB allows; the levels are the same for any number
  /// \param needs_finest whether coarser levels lose limbs, so that none is a substitute for the finest one
  explicit Surface_levels(Triangulated_surface&& finest, unsigned number_of_threads = 1, bool needs_finest = false)
      : m_number_of_threads(number_of_threads), m_needs_finest(needs_finest)
  {
    m_levels.emplace_back(std::move(finest));
    while (m_levels.back().surface.number_of_vertices() > coarsest_size && add_level()) {
    }
    m_precise = finest_with_at_most(usual_precise_size);
    while (m_precise > 0 && share_of_bent_stars(m_levels[m_precise].surface) > max_share_of_bent_stars) {
      --m_precise;
    }
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
  /// The level that is as good as the surface itself for queries, and has sources enough for the thinnest limbs: the
  /// finest one of at most 60000 vertices or, where limbs have too few of these around them, a finer one.
  const Surface_level& precise() const { return m_levels[m_precise]; }

private:
  /// Finer faces than those of this number of vertices differ from the surface by less than the precision of the
  /// skeleton, and more sources lie closer together than the bands of any limb that they could find, unless most of the
  /// surface is that of hundreds of thin limbs.
  static constexpr Index usual_precise_size = 60000;
  /// A star is bent if its area vector is at most this long, relative to its area: a tube of six edges around has .85,
  /// of four .7, of three .5.
  static constexpr double bent_star = 0.6;
  /// Of the vertices of a precise level, at most this part has bent stars. Measured at the usual size: bodies 0.001,
  /// with noise of a quarter of an edge 0.025, vessels of two to three edges around 0.2 to 0.4.
  static constexpr double max_share_of_bent_stars = 0.05;
  /// Of the vertices of any coarser level; where it would be more, coarsening ends, as limbs would be lost. Measured:
  /// bodies at most 0.2, a plate with hundreds of pins 0.5 and more.
  static constexpr double max_share_on_levels = 0.3;
  /// Coarsening ends at this number of vertices: on further levels no limb is enough edges around for its front. Of 800
  /// to 6000, found on 63 odd-numbered Princeton meshes: the search takes three fifths of the time for 6000, and at 800
  /// no less, while errors grow.
  static constexpr Index coarsest_size = 1500;
  /// A pass that keeps a larger part of the vertices than this does not justify a level.
  static constexpr double min_reduction = 0.8;

  static double share_of_bent_stars(const Triangulated_surface& surface)
  {
    Index number = 0;
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      Vector3 sum = Vector3::Zero();
      double area = 0;
      for (const Index halfedge : surface.outgoing(vertex)) {
        const Vector3 face_vector = surface.face_vector(Triangulated_surface::face(halfedge));
        sum += face_vector;
        area += face_vector.norm();
      }
      number += sum.norm() < bent_star * area ? 1 : 0;
    }
    return double(number) / surface.number_of_vertices();
  }

  bool add_level()
  {
    Surface_level& fine = m_levels.back();
    std::optional<internal::Coarsening> coarsening(std::in_place, fine.surface, m_number_of_threads);
    if (double(coarsening->fine_vertex().size()) > min_reduction * fine.surface.number_of_vertices()) {
      return false;
    }
    Indexed_triangles triangles = coarsening->triangles();
    std::vector<Index> finest_vertex;
    std::vector<Index> coarse_vertex;
    std::move(*coarsening).move_to(finest_vertex, coarse_vertex);
    coarsening.reset(); // before memory is allocated for the surface
    Triangulated_surface coarse(std::move(triangles), m_number_of_threads);
    if (coarse.has_defect() || share_of_bent_stars(coarse) > max_share_on_levels) {
      return false;
    }
    Surface_level level(std::move(coarse));
    for (Index& vertex : finest_vertex) {
      vertex = fine.to_finest(vertex);
    }
    level.finest_vertex = std::move(finest_vertex);
    const Index n = m_levels.front().surface.number_of_vertices();
    level.level_vertex.resize(n);
    for (Index vertex = 0; vertex < n; ++vertex) {
      level.level_vertex[vertex] = coarse_vertex[fine.from_finest(vertex)];
    }
    m_levels.push_back(std::move(level));
    return true;
  }

  unsigned m_number_of_threads;
  bool m_needs_finest;
  Index m_precise = 0;
  std::vector<Surface_level> m_levels;
};

} // namespace CSCD

#endif // CSCD_SURFACE_SURFACE_LEVELS_H
