// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of coarsen_triangles.h.

#ifndef CSCD_SURFACE_COARSEN_TRIANGLES_IMPL_H
#define CSCD_SURFACE_COARSEN_TRIANGLES_IMPL_H

#include <CSCD/Surface/Coarsening.h>
#include <CSCD/Surface/Halfedge_pairing.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/coarsen_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/for_each_index.h>
#include <CSCD/internal/for_each_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Divides space into cells that hold about the same number of points, by planes through medians of a sample.
class Space_partition
{
public:
  /// The logarithm of the greatest number of cells.
  static constexpr Index max_depth = 14;

  /// \param depth there are 2^depth cells
  /// \param is_turned whether the planes are across other directions, so that they cross those of a partition that is
  ///        not turned
  Space_partition(const std::vector<Vector_3>& points, Index depth, bool is_turned)
      : m_is_turned(is_turned), m_planes((std::size_t(1) << depth) - 1)
  {
    const std::size_t stride = points.size() / max_sample_size + 1;
    std::vector<Vector_3> sample;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      sample.push_back(turned(points[i]));
    }
    divide(sample.begin(), sample.end(), 0);
  }

  Index number_of_cells() const { return Index(m_planes.size() + 1); }

  Index cell(const Vector_3& point) const
  {
    const Vector_3 place = turned(point);
    std::size_t node = 0;
    while (node < m_planes.size()) {
      node = 2 * node + (place[m_planes[node].axis] < m_planes[node].position ? 1 : 2);
    }
    return Index(node - m_planes.size());
  }

private:
  using Iterator = std::vector<Vector_3>::iterator;

  struct Plane
  {
    Index axis = 0;
    double position = 0;
  };

  /// With these points for 2^14 cells, the counts of points in cells scatter by a half; for a hundred cells, by a few
  /// percent.
  static constexpr std::size_t max_sample_size = 1U << 16U;

  /// Coordinates along three directions at right angles to each other, far from those of the axes.
  Vector_3 turned(const Vector_3& p) const
  {
    return m_is_turned
               ? Vector_3(2 * p.x() + 2 * p.y() - p.z(), 2 * p.x() - p.y() + 2 * p.z(), -p.x() + 2 * p.y() + 2 * p.z())
               : p;
  }

  void divide(Iterator begin, Iterator end, std::size_t node)
  {
    if (node >= m_planes.size()) {
      return;
    }
    Iterator middle = begin;
    if (begin != end) {
      Vector_3 low = *begin;
      Vector_3 high = *begin;
      for (Iterator point = begin; point != end; ++point) {
        low = low.cwiseMin(*point);
        high = high.cwiseMax(*point);
      }
      Index axis = 0;
      for (Index i = 1; i < 3; ++i) {
        axis = high[i] - low[i] > high[axis] - low[axis] ? i : axis;
      }
      middle = begin + (end - begin) / 2;
      std::nth_element(begin, middle, end, [axis](const Vector_3& a, const Vector_3& b) { return a[axis] < b[axis]; });
      m_planes[node] = {axis, (*middle)[axis]};
    }
    divide(begin, middle, 2 * node + 1);
    divide(middle, end, 2 * node + 2);
  }

  bool m_is_turned;
  std::vector<Plane> m_planes; // a complete binary tree: below plane i are those of numbers 2 i + 1 and 2 i + 2
};

/// One pass of coarsening in blocks.
class Block_coarsening
{
public:
  /// Both are referred to.
  Block_coarsening(std::vector<Vector_3>& points, std::vector<Index>& corners) : m_points(points), m_corners(corners) {}

  /// Coarsens the triangles, of which those in each cell of `partition` are a block. May be called once.
  /// \return for each point, the number of the coarse point that it is or was collapsed into
  std::vector<Index> operator()(const Space_partition& partition, unsigned number_of_threads)
  {
    find_cells(partition, number_of_threads);
    sort_triangles(partition.number_of_cells());
    m_coarse.assign(m_points.size(), no_index);
    std::vector<std::size_t> end(m_begin.begin() + 1, m_begin.end());
    For_each_index<char> for_each([] { return '\0'; }, number_of_threads);
    for_each(partition.number_of_cells(),
             [&](Index cell, char&) { end[cell] = coarsen_block(m_begin[cell], m_begin[cell + 1]); });
    join_blocks(end);
    number_points();
    return std::move(m_coarse);
  }

private:
  using Corners = std::array<Index, 3>;

  /// What is known of a point besides its cell.
  static constexpr std::uint16_t is_fixed = 1U << 15U;
  static constexpr std::uint16_t is_removed = 1U << 14U;
  static constexpr std::uint16_t cell_mask = is_removed - 1U;
  static_assert(cell_mask + 1U == 1U << Space_partition::max_depth);

  /// The triangles of a block that can be coarsened, in numbers of their own.
  struct Block
  {
    Indexed_triangles triangles;
    std::vector<Index> point;    ///< the number of each point among all
    std::vector<char> is_fixed;  ///< of each point
    std::vector<Corners> others; ///< triangles that stay, in the numbers of all
  };

  Corners triangle(std::size_t t) const { return {m_corners[3 * t], m_corners[3 * t + 1], m_corners[3 * t + 2]}; }
  void set_triangle(std::size_t t, const Corners& corners)
  {
    std::copy(corners.begin(), corners.end(), m_corners.begin() + std::ptrdiff_t(3 * t));
  }

  void find_cells(const Space_partition& partition, unsigned number_of_threads)
  {
    m_state.resize(m_points.size());
    for_each_range(Index(m_points.size()), number_of_threads, [&](Index begin, Index end) {
      for (Index point = begin; point < end; ++point) {
        m_state[point] = std::uint16_t(partition.cell(m_points[point]));
      }
    });
  }

  /// The cell that holds all corners of a triangle, or `no_cell` where there is none or it names a point twice.
  Index cell_of(const Corners& t, Index no_cell) const
  {
    const Index cell = m_state[t[0]] & cell_mask;
    const bool is_within = cell == (m_state[t[1]] & cell_mask) && cell == (m_state[t[2]] & cell_mask) && t[0] != t[1] &&
                           t[1] != t[2] && t[2] != t[0];
    return is_within ? cell : no_cell;
  }

  /// Sorts triangles by their cells, without further memory; those of no cell come last, and fix their corners.
  void sort_triangles(Index number_of_cells)
  {
    std::vector<std::size_t> size(number_of_cells + 1, 0);
    for (std::size_t t = 0; t < m_corners.size() / 3; ++t) {
      const Corners corners = triangle(t);
      const Index cell = cell_of(corners, number_of_cells);
      ++size[cell];
      for (const Index corner : corners) {
        m_state[corner] |= cell == number_of_cells ? is_fixed : std::uint16_t(0);
      }
    }
    m_begin.assign(1, 0);
    std::partial_sum(size.begin(), size.end(), std::back_inserter(m_begin));
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for (Index cell = 0; cell <= number_of_cells; ++cell) {
      while (next[cell] < m_begin[cell + 1]) {
        // Follows a cycle of the permutation until it comes back here.
        Corners corners = triangle(next[cell]);
        for (Index to = cell_of(corners, number_of_cells); to != cell; to = cell_of(corners, number_of_cells)) {
          const Corners other = triangle(next[to]);
          set_triangle(next[to]++, corners);
          corners = other;
        }
        set_triangle(next[cell]++, corners);
      }
    }
  }

  /// Coarsens the triangles from `begin` to `end` - 1. \return the end of those that are left
  std::size_t coarsen_block(std::size_t begin, std::size_t end)
  {
    Block block = collect_block(begin, end);
    Halfedge_pairing pairing(block.triangles.faces, block.triangles.points.size());
    if (pairing.conflict() != no_index) {
      set_conflicts_aside(block);
      pairing = Halfedge_pairing(block.triangles.faces, block.triangles.points.size());
    }
    split_points(block, pairing);
    fix_borders(block, pairing);
    const Triangulated_surface surface(std::move(block.triangles), std::move(pairing), false);
    const Coarsening coarsening(surface, block.is_fixed);
    for (Index i = Index(block.point.size()); i-- > 0;) { // of the copies of a point, the first one counts
      const Index coarse = coarsening.fine_vertex()[coarsening.coarse_vertex()[i]];
      m_coarse[block.point[i]] = block.point[coarse];
      m_state[block.point[i]] |= coarse != i ? is_removed : std::uint16_t(0);
    }
    std::size_t to = begin;
    for (const Corners& face : coarsening.triangles().faces) {
      Corners corners{};
      std::transform(face.begin(), face.end(), corners.begin(),
                     [&](Index coarse) { return block.point[coarsening.fine_vertex()[coarse]]; });
      set_triangle(to++, corners);
    }
    for (const Corners& corners : block.others) {
      set_triangle(to++, corners);
    }
    return to;
  }

  /// \pre `m_coarse` is `no_index` for all points of the block; it holds their numbers in the block then
  Block collect_block(std::size_t begin, std::size_t end)
  {
    Block block;
    block.triangles.faces.reserve(end - begin);
    for (std::size_t t = begin; t < end; ++t) {
      Corners face = triangle(t);
      for (Index& corner : face) {
        if (m_coarse[corner] == no_index) {
          m_coarse[corner] = Index(block.point.size());
          block.point.push_back(corner);
          block.triangles.points.push_back(m_points[corner]);
          block.is_fixed.push_back((m_state[corner] & is_fixed) != 0 ? 1 : 0);
        }
        corner = m_coarse[corner];
      }
      block.triangles.faces.push_back(face);
    }
    block.triangles.first_hole_filling_face = block.triangles.faces.size();
    return block;
  }

  /// Sets triangles aside that have a side in common with another one in the same direction, and fixes their corners.
  static void set_conflicts_aside(Block& block)
  {
    struct Side
    {
      Index source;
      Index target;
      Index face;
      bool operator<(const Side& other) const
      {
        return std::tie(source, target, face) < std::tie(other.source, other.target, other.face);
      }
    };
    std::vector<Corners>& faces = block.triangles.faces;
    std::vector<Side> sides;
    for (Index f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        sides.push_back({faces[f][i], faces[f][(i + 1) % 3], f});
      }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<char> is_aside(faces.size(), 0);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].source == sides[i - 1].source && sides[i].target == sides[i - 1].target) {
        is_aside[sides[i].face] = is_aside[sides[i - 1].face] = 1;
      }
    }
    std::size_t kept = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (is_aside[f] == 0) {
        faces[kept++] = faces[f];
        continue;
      }
      for (Index& corner : faces[f]) {
        block.is_fixed[corner] = 1;
        corner = block.point[corner];
      }
      block.others.push_back(faces[f]);
    }
    faces.resize(kept);
    block.triangles.first_hole_filling_face = kept;
  }

  /// Makes a point of each fan of triangles, for those of several, which are fixed.
  static void split_points(Block& block, Halfedge_pairing& pairing)
  {
    for (const Index original : split_pinched_vertices(block.triangles, pairing)) {
      block.is_fixed[original] = 1;
      block.point.push_back(block.point[original]);
      block.is_fixed.push_back(1);
    }
  }

  static void fix_borders(Block& block, const Halfedge_pairing& pairing)
  {
    for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
      if (pairing.twin(h) == no_index) {
        block.is_fixed[block.triangles.faces[h / 3][h % 3]] = 1;
        block.is_fixed[block.triangles.faces[h / 3][Halfedge_pairing::next(h) % 3]] = 1;
      }
    }
  }

  /// Closes the gaps behind the triangles of each block. \param end of each block, what is left of it
  void join_blocks(const std::vector<std::size_t>& end)
  {
    std::size_t to = 0;
    for (std::size_t cell = 0; cell < end.size(); ++cell) {
      for (std::size_t t = m_begin[cell]; t < end[cell]; ++t) {
        set_triangle(to++, triangle(t));
      }
    }
    m_corners.resize(3 * to);
  }

  /// Gives the points that remain the numbers from 0 on.
  void number_points()
  {
    Index number = 0;
    for (Index point = 0; point < m_points.size(); ++point) {
      if ((m_state[point] & is_removed) == 0) {
        m_coarse[point] = number;
        m_points[number++] = m_points[point];
      }
    }
    for (Index point = 0; point < m_coarse.size(); ++point) {
      if ((m_state[point] & is_removed) != 0) {
        m_coarse[point] = m_coarse[m_coarse[point]];
      }
    }
    m_points.resize(number);
    for (Index& corner : m_corners) {
      corner = m_coarse[corner];
    }
  }

  std::vector<Vector_3>& m_points;
  std::vector<Index>& m_corners;
  std::vector<std::uint16_t> m_state; // of each point: its cell, and whether it is fixed or removed
  std::vector<std::size_t> m_begin;   // of the triangles of each cell, of those of none, and the end
  std::vector<Index> m_coarse; // of each point, that into which it is collapsed; meanwhile its number in its block
};

} // namespace CSCD::internal

namespace CSCD {

CSCD_INLINE std::vector<Index> coarsen_triangles(std::vector<Vector_3>& points, std::vector<Index>& corners,
                                                 std::size_t max_number_of_points, unsigned number_of_threads,
                                                 std::size_t block)
{
  constexpr double min_reduction = 0.8; // a pass that keeps a larger part of the points is the last one
  std::vector<Index> result;
  bool is_reduced = true;
  for (bool is_turned = false; points.size() > max_number_of_points && is_reduced; is_turned = !is_turned) {
    Index depth = 0;
    while (depth < internal::Space_partition::max_depth && points.size() >> depth > block) {
      ++depth;
    }
    const std::size_t old_size = points.size();
    std::vector<Index> coarse = internal::Block_coarsening(points, corners)(
        internal::Space_partition(points, depth, is_turned), number_of_threads);
    if (result.empty()) {
      result = std::move(coarse);
    } else {
      for (Index& point : result) {
        point = coarse[point];
      }
    }
    is_reduced = double(points.size()) <= min_reduction * double(old_size);
  }
  if (!result.empty()) {
    points.shrink_to_fit();
    corners.shrink_to_fit();
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_SURFACE_COARSEN_TRIANGLES_IMPL_H
