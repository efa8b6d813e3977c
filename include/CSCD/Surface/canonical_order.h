// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Renumbers a surface so that the numbers depend on its shape alone, and neighbors have near numbers.

#ifndef CSCD_SURFACE_CANONICAL_ORDER_H
#define CSCD_SURFACE_CANONICAL_ORDER_H

#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// An order of the vertices of a surface, component by component.
struct Canonical_order
{
  std::vector<Index> vertices;        ///< the old number of every new vertex
  std::vector<Index> component_begin; ///< the first new vertex of every component, and their number at the end
};

/// Finds the canonical order: breadth-first over the rings, in counterclockwise order, which the root and its first
/// halfedge determine. Root is the vertex farthest from the centroid of its component, and its first halfedge leads to
/// the farthest neighbor; components come in order of decreasing area.
class Canonical_ordering
{
public:
  Canonical_ordering(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                     const Surface_components& components)
      : m_triangles(triangles), m_pairing(pairing), m_components(components)
  {
    find_roots();
  }

  /// \param number_of_threads 0 for as many as TBB allows
  Canonical_order order(unsigned number_of_threads) const
  {
    std::vector<Index> sorted(m_components.number());
    std::iota(sorted.begin(), sorted.end(), Index(0));
    std::sort(sorted.begin(), sorted.end(), [this](Index c, Index d) { return key(c) < key(d); });
    Numbering numbering(m_triangles.points.size(), number_of_threads);
    Canonical_order result;
    for (Index component : sorted) {
      result.component_begin.push_back(numbering.size);
      append_component(m_first[component], numbering);
    }
    result.component_begin.push_back(numbering.size);
    numbering.vertices.pop_back();
    result.vertices = std::move(numbering.vertices);
    return result;
  }

private:
  /// Distances that differ by less, relatively, are equal: they differ by rounding only, which depends on the order.
  static constexpr double distance_tolerance = 1e-9;
  /// Vertices ahead for which memory is asked for.
  static constexpr std::size_t prefetch_distance = 8;
  /// Vertices whose rings one thread reads at once: enough that the loop itself hardly counts.
  static constexpr std::size_t chunk_size = 256;
  /// Chunks that are read before their neighbors are numbered: no more, so that what is read stays in the cache.
  static constexpr std::size_t max_chunks = 16;

  /// A vertex that may be the next one, and the neighbor whose ring it is in.
  struct Candidate
  {
    Index vertex;
    Index parent;
  };
  /// What the rings of consecutive vertices of the order have of vertices without a number, and possibly more.
  struct Chunk
  {
    std::vector<Candidate> candidates; // longer than is used
    std::size_t size = 0;
  };
  /// Vertices in the order so far. There is room for one more than there are: what may be the next one is written
  /// before it is known whether it is, as a branch would be taken at random.
  struct Numbering
  {
    Numbering(std::size_t number_of_vertices, unsigned number_of_threads)
        : vertices(number_of_vertices + 1), parent(number_of_vertices + 1), is_numbered(number_of_vertices, 0),
          for_each_chunk([] { return std::vector<Index>(); }, number_of_threads), chunks(max_chunks)
    {
    }

    void append(Index vertex, Index its_parent)
    {
      vertices[size] = vertex;
      parent[size] = its_parent;
      size += is_numbered[vertex] ? 0 : 1;
      is_numbered[vertex] = 1;
    }

    std::vector<Index> vertices;
    std::vector<Index> parent; // of each of them, the neighbor at which its ring begins
    Index size = 0;
    std::vector<char> is_numbered;
    For_each_index<std::vector<Index>> for_each_chunk; // with working memory for a ring
    std::vector<Chunk> chunks;                         // which are read at the same time
  };

  Index origin(Index h) const { return m_triangles.faces[h / 3][h % 3]; }
  Index target(Index h) const { return m_triangles.faces[h / 3][(h + 1) % 3]; }
  const Vector_3& origin_point(Index h) const { return m_triangles.points[origin(h)]; }
  double squared_distance(Index vertex, Index component) const
  {
    return (m_triangles.points[vertex] - m_components.measures[component].centroid).squaredNorm();
  }

  /// The sums are rounded to single precision, so that the order of their terms does not matter.
  std::tuple<float, float, double, double, double> key(Index component) const
  {
    const Vector_3& root = origin_point(m_first[component]);
    return {-float(m_components.measures[component].area), -float(m_greatest[component]), root.x(), root.y(), root.z()};
  }

  /// Among equally far vertices the lexicographically smallest is the root; likewise for its neighbors.
  void find_roots()
  {
    const std::size_t n = m_triangles.points.size();
    m_greatest.assign(m_components.number(), 0.);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      m_greatest[component] = std::max(m_greatest[component], squared_distance(vertex, component));
    }
    m_first.assign(m_components.number(), no_index);
    for (Index vertex = 0; vertex < n; ++vertex) {
      const Index component = m_components.component_of_vertex(m_pairing, vertex);
      Index& first = m_first[component];
      if (squared_distance(vertex, component) >= (1 - distance_tolerance) * m_greatest[component] &&
          (first == no_index || is_lexicographically_less(m_triangles.points[vertex], origin_point(first)))) {
        first = *m_pairing.outgoing()[vertex].begin();
      }
    }
    for (Index component = 0; component < m_components.number(); ++component) {
      m_first[component] = first_halfedge(m_first[component], component);
    }
  }

  /// The halfedge around the origin of `start` that leads farthest from the centroid.
  Index first_halfedge(Index start, Index component) const
  {
    double greatest = 0;
    Index halfedge = start;
    do {
      greatest = std::max(greatest, squared_distance(target(halfedge), component));
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    Index result = no_index;
    do {
      if (squared_distance(target(halfedge), component) >= (1 - distance_tolerance) * greatest &&
          (result == no_index ||
           is_lexicographically_less(m_triangles.points[target(halfedge)], m_triangles.points[target(result)]))) {
        result = halfedge;
      }
      halfedge = next_around_origin(halfedge);
    } while (halfedge != start);
    return result;
  }

  Index next_around_origin(Index h) const { return m_pairing.twin(Halfedge_pairing::previous(h)); }

  /// Asks for what the vertices that come soon need: where their numbers are scattered, most of the time goes to
  /// waiting.
  void prefetch_rows([[maybe_unused]] const Numbering& numbering, [[maybe_unused]] std::size_t i) const
  {
#ifdef __GNUC__
    if (i + 2 * prefetch_distance < numbering.size) {
      __builtin_prefetch(m_pairing.outgoing()[numbering.vertices[i + 2 * prefetch_distance]].begin());
      const auto row = m_pairing.outgoing()[numbering.vertices[i + prefetch_distance]];
      for (std::size_t j = 0; j < row.size(); j += 2) {
        __builtin_prefetch(&m_triangles.faces[row.begin()[j] / 3]);
      }
    }
#endif
  }

  /// Writes the neighbors of `vertex` to `ring`, counterclockwise. Every other face is read, as each has two of them.
  /// \return their number
  std::size_t read_ring(Index vertex, std::vector<Index>& ring) const
  {
    const auto row = m_pairing.outgoing()[vertex];
    if (ring.size() < row.size() + 1) {
      ring.resize(row.size() + 1);
    }
    for (std::size_t i = 0; i < row.size(); i += 2) {
      const Index halfedge = row.begin()[i];
      ring[i] = target(halfedge);
      ring[i + 1] = target(Halfedge_pairing::next(halfedge));
    }
    return row.size();
  }

  /// Reads the rings of the vertices from `begin` to `end` - 1 of the order, each from the parent of the vertex on.
  void read_chunk(const Numbering& numbering, std::size_t begin, std::size_t end, std::vector<Index>& ring,
                  Chunk& chunk) const
  {
    chunk.size = 0;
    for (std::size_t i = begin; i < end; ++i) {
      prefetch_rows(numbering, i);
      const Index vertex = numbering.vertices[i];
      const std::size_t degree = read_ring(vertex, ring);
      if (chunk.candidates.size() < chunk.size + degree + 1) {
        chunk.candidates.resize(2 * (chunk.size + degree + 1));
      }
      const auto append = [&](std::size_t from, std::size_t to) {
        for (std::size_t j = from; j < to; ++j) {
          chunk.candidates[chunk.size] = {ring[j], vertex};
          chunk.size += numbering.is_numbered[ring[j]] ? 0 : 1;
        }
      };
      const auto start = std::size_t(std::find(ring.begin(), ring.end(), numbering.parent[i]) - ring.begin());
      append(start, degree);
      append(0, start);
    }
  }

  void append_component(Index first, Numbering& numbering) const
  {
    std::size_t begin = numbering.size;
    numbering.append(origin(first), target(first));
    while (begin < numbering.size) {
      const std::size_t end = std::min(begin + chunk_size * max_chunks, std::size_t(numbering.size));
      const std::size_t number_of_chunks = (end - begin + chunk_size - 1) / chunk_size;
      numbering.for_each_chunk(Index(number_of_chunks), [&](Index chunk, std::vector<Index>& ring) {
        const std::size_t from = begin + chunk * chunk_size;
        read_chunk(numbering, from, std::min(from + chunk_size, end), ring, numbering.chunks[chunk]);
      });
      for (std::size_t i = 0; i < number_of_chunks; ++i) {
        const Chunk& chunk = numbering.chunks[i];
        for (std::size_t j = 0; j < chunk.size; ++j) {
          numbering.append(chunk.candidates[j].vertex, chunk.candidates[j].parent);
        }
      }
      begin = end;
    }
  }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
  const Surface_components& m_components;
  std::vector<double> m_greatest; // squared distance from the centroid, of every component
  std::vector<Index> m_first;     // the halfedge with which every component begins
};

/// Finds an order of the vertices that does not depend on their numbers nor, up to rounding and symmetry, on the pose
/// of the surface. O(n + c log c) for c components.
/// \param number_of_threads 0 for as many as TBB allows; the order is the same for any number
/// \pre `triangles` is closed, without isolated vertices; `pairing` and `components` are those of its faces
inline Canonical_order canonical_order(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                       const Surface_components& components, unsigned number_of_threads = 1)
{
  return Canonical_ordering(triangles, pairing, components).order(number_of_threads);
}

} // namespace CSCD::internal

#endif // CSCD_SURFACE_CANONICAL_ORDER_H
