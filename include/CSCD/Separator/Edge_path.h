// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A path along the edges of a triangulation, and in which order it runs several times along the same edge.

#ifndef CSCD_SEPARATOR_EDGE_PATH_H
#define CSCD_SEPARATOR_EDGE_PATH_H

#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A path of segments, each along a halfedge, open or closed, as a linked list. Where several segments run along one
/// edge, they lie side by side in an order that is kept: so the path has a left and a right also where it touches
/// itself. Segments keep their numbers while edges of the triangulation are flipped.
/// \tparam Patch the triangulation; its `twin(h)` may add faces
template <class Patch>
class Edge_path
{
public:
  explicit Edge_path(Patch& patch) : m_patch(patch) {}

  void clear()
  {
    m_segments.clear();
    m_outermost.clear();
  }

  /// \name Segments
  /// @{
  /// The number of segments that were added, removed ones included.
  Index number_of_added_segments() const { return Index(m_segments.size()); }
  Index halfedge(Index segment) const { return m_segments[segment].halfedge; }
  /// `no_index` at the ends of an open path.
  Index next(Index segment) const { return m_segments[segment].next; }
  Index previous(Index segment) const { return m_segments[segment].previous; }
  bool is_removed(Index segment) const { return m_segments[segment].halfedge == no_index; }
  /// How often what follows the segment has changed.
  Index version(Index segment) const { return m_segments[segment].version; }

  /// Makes `second`, or nothing, follow `first`, or nothing.
  void link(Index first, Index second)
  {
    if (first != no_index) {
      m_segments[first].next = second;
      ++m_segments[first].version;
    }
    if (second != no_index) {
      m_segments[second].previous = first;
    }
  }
  /// @}

  /// \name Strands
  /// @{
  /// The segment on the edge of `halfedge` that lies nearest to the face of `halfedge`, or `no_index`.
  Index outermost(Index halfedge) const { return halfedge < m_outermost.size() ? m_outermost[halfedge] : no_index; }
  bool is_on_edge(Index halfedge) const { return outermost(halfedge) != no_index; }
  /// Whether `a` and `b` lie side by side on one edge.
  bool are_side_by_side(Index a, Index b) const { return m_segments[a].left == b || m_segments[a].right == b; }

  /// Adds a segment along `halfedge`, nearer than all others on its edge to the face of `side`, which is `halfedge` or
  /// its twin. It has no neighbors in the path yet.
  Index add(Index halfedge, Index side)
  {
    const Index segment = Index(m_segments.size());
    const Index inner = outermost(side);
    m_segments.push_back({halfedge, no_index, no_index, no_index, no_index, 0});
    (halfedge == side ? m_segments[segment].right : m_segments[segment].left) = inner;
    if (inner == no_index) {
      set_outermost(m_patch.twin(side), segment);
    } else {
      neighbor(inner, side) = segment;
    }
    set_outermost(side, segment);
    return segment;
  }

  /// Takes `segment` off its edge for good.
  void remove(Index segment)
  {
    const Index h = m_segments[segment].halfedge;
    const Index t = m_patch.twin(h);
    const Index left = m_segments[segment].left;
    const Index right = m_segments[segment].right;
    if (left == no_index) {
      set_outermost(h, right);
    } else {
      neighbor(left, t) = right;
    }
    if (right == no_index) {
      set_outermost(t, left);
    } else {
      neighbor(right, h) = left;
    }
    m_segments[segment].halfedge = no_index;
  }

  /// Follows a flip of the edge of `h` and `t`, on which no segment lies, see `Intrinsic_triangulation::flip()`.
  void follow_flip(Index h, Index t)
  {
    const Index from_left = outermost(Patch::previous(h));
    const Index from_right = outermost(Patch::previous(t));
    renumber(from_left, Patch::previous(h), t);
    renumber(from_right, Patch::previous(t), h);
    set_outermost(Patch::previous(h), no_index);
    set_outermost(Patch::previous(t), no_index);
    set_outermost(t, from_left);
    set_outermost(h, from_right);
  }
  /// @}

private:
  struct Segment
  {
    Index halfedge;
    Index previous;
    Index next;
    Index left;  // the next strand on the left of the halfedge
    Index right; // and on its right
    Index version;
  };

  /// The next strand beside `segment` on the side of the face of `halfedge`, which is that of the segment or its twin.
  Index& neighbor(Index segment, Index halfedge)
  {
    return m_segments[segment].halfedge == halfedge ? m_segments[segment].left : m_segments[segment].right;
  }

  void set_outermost(Index halfedge, Index segment)
  {
    if (halfedge >= m_outermost.size()) {
      if (segment == no_index) {
        return;
      }
      m_outermost.resize(m_patch.number_of_halfedges(), no_index);
    }
    m_outermost[halfedge] = segment;
  }

  /// Renames the halfedge `from` to `to` in all strands of its edge, of which the outermost one is `segment`.
  void renumber(Index segment, Index from, Index to)
  {
    while (segment != no_index) {
      Segment& strand = m_segments[segment];
      const bool is_same_way = strand.halfedge == from || strand.halfedge == to;
      strand.halfedge = strand.halfedge == from ? to : strand.halfedge;
      segment = is_same_way ? strand.right : strand.left;
    }
  }

  std::vector<Segment> m_segments;
  std::vector<Index> m_outermost;
  Patch& m_patch;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_EDGE_PATH_H
