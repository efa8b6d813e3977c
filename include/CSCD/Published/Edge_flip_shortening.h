// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortens curves along edges to geodesics by flipping the edges next to them (appendix E).

#ifndef CSCD_PUBLISHED_EDGE_FLIP_SHORTENING_H
#define CSCD_PUBLISHED_EDGE_FLIP_SHORTENING_H

#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// An intrinsic triangulation that takes its flips back: so curves on one surface are shortened one after the other,
/// and each costs nothing of the size of the surface. One object serves one thread.
class Revertible_triangulation : public Intrinsic_triangulation
{
public:
  explicit Revertible_triangulation(Intrinsic_triangulation&& triangulation)
      : Intrinsic_triangulation(std::move(triangulation))
  {
  }

  /// Flips the edge if its two faces form a strictly convex quadrilateral. \return whether it did
  bool flip(Index halfedge)
  {
    const std::optional<double> diagonal = other_diagonal(halfedge);
    if (diagonal) {
      const Index t = twin(halfedge);
      const Index moved[] = {previous(halfedge), previous(t)};
      for (const Index h : {halfedge, t, moved[0], moved[1], twin(moved[0]), twin(moved[1])}) {
        m_log.emplace_back(h, m_halfedges[h]);
      }
      replace_diagonal(halfedge, *diagonal);
    }
    return diagonal.has_value();
  }

  /// Takes all flips back. Linear in their number.
  void revert()
  {
    for (; !m_log.empty(); m_log.pop_back()) {
      m_halfedges[m_log.back().first] = m_log.back().second;
    }
  }

private:
  std::vector<std::pair<Index, Halfedge>> m_log; // halfedges before they were overwritten, the last at the end
};

/// A path of segments, each along a halfedge, open or closed, as a linked list. Where several segments run along one
/// edge, they lie side by side in an order that is kept: so the path has a left and a right also where it touches
/// itself. Segments keep their numbers while edges of the triangulation are flipped.
class Edge_path
{
public:
  explicit Edge_path(const Intrinsic_triangulation& triangulation)
      : m_outermost(triangulation.number_of_halfedges(), no_index), m_triangulation(triangulation)
  {
  }

  void clear()
  {
    m_segments.clear();
    for (const Index halfedge : m_touched) {
      m_outermost[halfedge] = no_index;
    }
    m_touched.clear();
  }

  /// A part of the path.
  struct Segment
  {
    Index halfedge; ///< `no_index` where the segment is removed
    Index previous; ///< `no_index` at the ends of an open path
    Index next;
    Index left;    ///< the next strand on the left of the halfedge
    Index right;   ///< and on its right
    Index version; ///< how often the next segment has changed
  };

  /// \name Segments
  /// @{
  const Segment& operator[](Index segment) const { return m_segments[segment]; }

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
  Index outermost(Index halfedge) const { return m_outermost[halfedge]; }
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
      set_outermost(m_triangulation.twin(side), segment);
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
    const Index t = m_triangulation.twin(h);
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

  /// Follows a flip of the edge of `h` and `t`, on which no segment lies, see
  /// `Intrinsic_triangulation::replace_diagonal()`.
  void follow_flip(Index h, Index t)
  {
    const Index from_left = outermost(Triangle_halfedges::previous(h));
    const Index from_right = outermost(Triangle_halfedges::previous(t));
    renumber(from_left, Triangle_halfedges::previous(h), t);
    renumber(from_right, Triangle_halfedges::previous(t), h);
    set_outermost(Triangle_halfedges::previous(h), no_index);
    set_outermost(Triangle_halfedges::previous(t), no_index);
    set_outermost(t, from_left);
    set_outermost(h, from_right);
  }
  /// @}

private:
  /// The strand next to `segment` on the side of the face of `halfedge`, the halfedge of the segment or its twin.
  Index& neighbor(Index segment, Index halfedge)
  {
    return m_segments[segment].halfedge == halfedge ? m_segments[segment].left : m_segments[segment].right;
  }

  void set_outermost(Index halfedge, Index segment)
  {
    if (m_outermost[halfedge] == no_index) {
      m_touched.push_back(halfedge);
    }
    m_outermost[halfedge] = segment;
  }

  /// Renames the halfedge `from` to `to` in all strands of its edge; `segment` is the outermost strand.
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
  std::vector<Index> m_outermost; // of every halfedge
  std::vector<Index> m_touched;   // halfedges that may have one
  const Intrinsic_triangulation& m_triangulation;
};

/// Shortens curves along edges, closed or open, by flipping edges of the triangulation next to them: where the curve
/// makes an angle of less than pi, the edges within the angle are flipped until the curve can go along the far side
/// (Sharp, Crane: You can find geodesic paths in triangle meshes by just flipping edges, 2020; appendix E of the
/// paper).
///
/// One object serves one thread, and holds its own intrinsic triangulation of the surface. Reuse it.
class Edge_flip_shortening
{
public:
  /// A bend counts as straight if the angle on either side is at least pi less this, in radians.
  static constexpr double angle_tolerance = 1e-5;
  /// A closed curve has collapsed when it is shorter than this part of its first length.
  static constexpr double collapsed_part = 0.15;

  /// Curves are given along the edges of `triangulation`, which has no borders. They never cross the input's faces from
  /// `number_of_faces` on: where these are in the way, curves go along their edges. So borders are kept that were
  /// bridged, see `first_hole_filling_face()`. Linear.
  explicit Edge_flip_shortening(Intrinsic_triangulation triangulation, Index number_of_faces = no_index)
      : m_triangulation(std::move(triangulation)), m_path(m_triangulation), m_number_of_faces(number_of_faces)
  {
  }

  Edge_flip_shortening(const Edge_flip_shortening&) = delete;
  Edge_flip_shortening& operator=(const Edge_flip_shortening&) = delete;
  ~Edge_flip_shortening() = default;

  /// Shortens the curve along `halfedges` and writes it to `result`, as a path over the surface that is never longer.
  /// The ends of an open curve stay where they are. Time is proportional to the number of flips, which is about the
  /// number of faces between the curve before and after.
  /// \param halfedges of the triangulation; each begins where the last one ends, in a cycle if the curve is closed
  /// \param is_pinned whether the curve must not be moved off a vertex; it may be moved onto it (E.2); by default, none
  /// \return the outcome; `collapsed` leaves no points
  /// \pre the curve neither crosses itself nor runs along one edge twice, except straight back
  Shortening_outcome operator()(
      const std::vector<Index>& halfedges, bool is_closed, Surface_path& result,
      std::function<bool(Index)> is_pinned = [](Index) { return false; })
  {
    m_is_pinned = std::move(is_pinned);
    run(halfedges, is_closed, std::numeric_limits<std::size_t>::max());
    if (m_length > m_length_of_single) {
      // Taken off its vertex for the last time, it has become longer.
      run(halfedges, is_closed, m_number_of_single_steps - 1);
    }
    write(result);
    return outcome();
  }

private:
  static constexpr double pi = boost::math::constants::pi<double>();

  /// A curve is given up after so many steps for each of its first segments: hundreds of times what it takes.
  static constexpr std::size_t max_steps_per_segment = 1000;

  /// An angle of less than pi between a segment and the next one.
  struct Bend
  {
    double angle;
    Index segment;
    Index version; // of the segment
    bool is_left;  // of the path

    /// The smallest angle comes first out of the queue.
    bool operator<(const Bend& other) const
    {
      return std::tie(other.angle, other.segment, other.is_left) < std::tie(angle, segment, is_left);
    }
  };

  /// Shortens the curve; one of a single segment is taken off its vertex at most `max_single_steps` times.
  void run(const std::vector<Index>& halfedges, bool is_closed, std::size_t max_single_steps)
  {
    start(halfedges, is_closed);
    m_max_single_steps = max_single_steps;
    for_each_segment([&](Index segment) { queue(segment); });
    std::size_t steps_left = max_steps_per_segment * (halfedges.size() + 1);
    while (!m_bends.empty() && !m_is_collapsed && steps_left > 0) {
      const Bend bend = m_bends.top();
      m_bends.pop();
      if (m_path[bend.segment].halfedge != no_index && m_path[bend.segment].version == bend.version) {
        straighten(bend);
        m_is_collapsed = m_is_collapsed || (is_closed && m_length < collapsed_part * m_first_length);
        --steps_left;
      }
    }
  }

  void start(const std::vector<Index>& halfedges, bool is_closed)
  {
    m_triangulation.revert();
    m_path.clear();
    m_bends = {};
    m_blocked.clear();
    m_is_closed = is_closed;
    m_number_of_single_steps = 0;
    m_length_of_single = std::numeric_limits<double>::max();
    m_length = 0;
    m_first = 0;
    m_is_collapsed = halfedges.empty();
    Index last = no_index;
    for (const Index h : halfedges) {
      CGAL_precondition(last == no_index || vertex_behind(last) == m_triangulation.origin(h));
      const Index segment = m_path.add(h, h);
      m_path.link(last, segment);
      m_length += m_triangulation.length(h);
      last = segment;
    }
    if (is_closed && last != no_index) {
      CGAL_precondition(vertex_behind(last) == m_triangulation.origin(m_path[m_first].halfedge));
      m_path.link(last, m_first);
    }
    m_first_length = m_length;
  }

  template <class Function>
  void for_each_segment(const Function& function) const
  {
    Index segment = m_is_collapsed ? no_index : m_first;
    while (segment != no_index) {
      function(segment);
      segment = m_path[segment].next;
      if (segment == m_first) {
        return;
      }
    }
  }

  /// \name Bends
  /// @{
  Index vertex_behind(Index segment) const { return m_triangulation.target(m_path[segment].halfedge); }

  bool is_backtrack(Index segment) const
  {
    return m_triangulation.twin(m_path[segment].halfedge) == m_path[m_path[segment].next].halfedge;
  }

  /// The halfedges from the vertex behind `segment` between which the angle on one side lies, counterclockwise.
  std::pair<Index, Index> sides(Index segment, bool is_left)
  {
    const Index back = m_triangulation.twin(m_path[segment].halfedge);
    const Index forth = m_path[m_path[segment].next].halfedge;
    return is_left ? std::make_pair(forth, back) : std::make_pair(back, forth);
  }

  /// Whether the face of `halfedge` is closed to curves. No edge of it is ever flipped.
  bool is_closed_face(Index halfedge) const
  {
    return Triangle_halfedges::face(m_triangulation.input_halfedge(halfedge)) >= m_number_of_faces;
  }

  /// The angle behind `segment` on one side, or a part of it that is not a bend any more; endless over closed faces.
  double angle_behind(Index segment, bool is_left)
  {
    const auto [first, last] = sides(segment, is_left);
    double sum = 0;
    Index h = first;
    do {
      if (is_closed_face(h)) {
        return std::numeric_limits<double>::max();
      }
      sum += m_triangulation.angle(h);
      h = m_triangulation.next_around_origin(h);
    } while (h != last && !is_straight(sum));
    return sum;
  }

  static bool is_straight(double angle) { return angle >= pi - angle_tolerance; }

  /// Queues the bends behind `segment`. Parts straight back are taken out even where vertices are pinned.
  void queue(Index segment)
  {
    if (m_path[segment].next == no_index) {
      return;
    }
    if (is_backtrack(segment)) {
      m_bends.push({0., segment, m_path[segment].version, true});
    } else if (!m_is_pinned(vertex_behind(segment))) {
      for (const bool is_left : {true, false}) {
        const double angle = angle_behind(segment, is_left);
        if (!is_straight(angle)) {
          m_bends.push({angle, segment, m_path[segment].version, is_left});
        }
      }
    }
  }
  /// @}

  /// \name Straightening
  /// @{
  void straighten(const Bend& bend)
  {
    if (is_backtrack(bend.segment)) {
      take_out_backtrack(bend);
    } else if (m_path[bend.segment].next == bend.segment) {
      take_off_vertex(bend);
    } else {
      pass_over_vertex(bend);
    }
  }

  void take_out_backtrack(const Bend& bend)
  {
    if (!m_path.are_side_by_side(bend.segment, m_path[bend.segment].next)) {
      m_blocked.push_back(bend);
      return;
    }
    m_arc.clear();
    replace_segments_at(bend);
  }

  /// Takes the path over the vertex behind a segment to the far side of the faces within the angle.
  void pass_over_vertex(const Bend& bend)
  {
    if (!is_clear(bend)) {
      m_blocked.push_back(bend);
      return;
    }
    flip_incident_edges(bend);
    collect_arc(bend);
    double length = 0;
    for (const Index side : m_arc) {
      length += m_triangulation.length(side);
    }
    const Index next = m_path[bend.segment].next;
    if (length <
        m_triangulation.length(m_path[bend.segment].halfedge) + m_triangulation.length(m_path[next].halfedge)) {
      replace_segments_at(bend);
    }
  }

  /// Whether no other part of the path lies within the angle.
  bool is_clear(const Bend& bend)
  {
    const auto [first, last] = sides(bend.segment, bend.is_left);
    const Index next = m_path[bend.segment].next;
    if (m_path.outermost(first) != (bend.is_left ? next : bend.segment) ||
        m_path.outermost(m_triangulation.twin(last)) != (bend.is_left ? bend.segment : next)) {
      return false;
    }
    for (Index h = m_triangulation.next_around_origin(first); h != last; h = m_triangulation.next_around_origin(h)) {
      if (m_path.is_on_edge(h)) {
        return false;
      }
    }
    return true;
  }

  /// Flips the edges within the angle until none can be: the far side is then convex.
  void flip_incident_edges(const Bend& bend)
  {
    auto [first, last] = sides(bend.segment, bend.is_left);
    Index h = m_triangulation.next_around_origin(first);
    while (h != last) {
      const Index t = m_triangulation.twin(h);
      if (!m_triangulation.flip(h)) {
        h = m_triangulation.next_around_origin(h);
        continue;
      }
      m_path.follow_flip(h, t);
      std::tie(first, last) = sides(bend.segment, bend.is_left);
      // The edge before may now be flippable.
      const Index before = Triangle_halfedges::next(t);
      h = before == first ? m_triangulation.next_around_origin(first) : before;
    }
  }

  /// Writes the far side of the faces within the angle to `m_arc`, in the direction of the path.
  void collect_arc(const Bend& bend)
  {
    const auto [first, last] = sides(bend.segment, bend.is_left);
    m_arc.clear();
    for (Index h = first; h != last; h = m_triangulation.next_around_origin(h)) {
      m_arc.push_back(Triangle_halfedges::next(h));
    }
    if (bend.is_left) {
      std::reverse(m_arc.begin(), m_arc.end());
    }
  }

  /// Takes a closed path of one segment off its vertex, on the side of `bend`: the path is led along the two other
  /// sides of the face there, and then taken over the vertex. It may be longer for a while, hence what it was is kept.
  void take_off_vertex(const Bend& bend)
  {
    const Index along = m_path[bend.segment].halfedge;
    const Index h = bend.is_left ? along : m_triangulation.twin(along);
    const Index after = Triangle_halfedges::next(h);
    const Index before = Triangle_halfedges::previous(h);
    if (m_triangulation.twin(before) == after) {
      // The path goes round a single vertex, towards which it becomes ever shorter.
      m_is_collapsed = true;
      return;
    }
    if (m_number_of_single_steps == m_max_single_steps || m_length >= m_length_of_single) {
      return;
    }
    ++m_number_of_single_steps;
    m_length_of_single = m_length;
    if (bend.is_left) {
      m_arc = {before, after};
    } else {
      m_arc = {after, before};
    }
    replace_segments_at(bend);
    const Index last = m_path[m_first].previous;
    pass_over_vertex({0., last, m_path[last].version, bend.is_left});
  }

  /// Replaces the segment of `bend` and the next one, which may be the same, by `m_arc`, and queues the bends that this
  /// makes.
  void replace_segments_at(const Bend& bend)
  {
    const Index segment = bend.segment;
    const Index next = m_path[segment].next;
    const Index before = m_path[segment].previous;
    const Index after = m_path[next].next;
    const bool is_all = before == next; // of a closed path
    remove(segment);
    if (next != segment) {
      remove(next);
    }
    m_added.clear();
    for (const Index side : m_arc) {
      m_added.push_back(m_path.add(bend.is_left ? m_triangulation.twin(side) : side, side));
      m_length += m_triangulation.length(side);
    }
    connect(is_all ? no_index : before, is_all ? no_index : after);
    if (is_all && !m_added.empty()) {
      m_path.link(m_added.back(), m_added.front());
    }
    if (m_is_collapsed) {
      return;
    }
    if (!is_all && before != no_index) {
      queue(before);
    }
    for (const Index added : m_added) {
      queue(added);
    }
    for (const Bend& blocked : m_blocked) {
      m_bends.push(blocked);
    }
    m_blocked.clear();
  }

  void remove(Index segment)
  {
    m_length -= m_triangulation.length(m_path[segment].halfedge);
    m_path.remove(segment);
  }

  /// Links the added segments between `before` and `after`; each of these two may be nothing.
  void connect(Index before, Index after)
  {
    if (m_path[m_first].halfedge == no_index || before == no_index) {
      m_first = !m_added.empty() ? m_added.front() : after != no_index ? after : before;
    }
    m_is_collapsed = m_first == no_index;
    Index last = before;
    for (const Index added : m_added) {
      m_path.link(last, added);
      last = added;
    }
    m_path.link(last, after);
  }
  /// @}

  /// \name Result
  /// @{
  void write(Surface_path& path)
  {
    path.points.clear();
    path.length = 0;
    Index last = no_index;
    for_each_segment([&](Index segment) {
      last = m_path[segment].halfedge;
      path.length += m_triangulation.length(last);
      path.points.push_back({m_triangulation.input_halfedge(last), 0.});
      const std::vector<Edge_crossing> crossings = m_triangulation.trace(last);
      path.points.insert(path.points.end(), crossings.begin(), crossings.end());
    });
    if (!m_is_closed && last != no_index) {
      path.points.push_back({m_triangulation.input_halfedge(m_triangulation.twin(last)), 0.});
    }
  }

  Shortening_outcome outcome()
  {
    Shortening_outcome result = m_is_collapsed ? Shortening_outcome::collapsed : Shortening_outcome::straight;
    for_each_segment([&](Index segment) {
      const bool is_end = m_path[segment].next == no_index;
      if (!is_end && (!is_straight(angle_behind(segment, true)) || !is_straight(angle_behind(segment, false)))) {
        if (!m_is_pinned(vertex_behind(segment))) {
          result = Shortening_outcome::unfinished;
        } else if (result == Shortening_outcome::straight) {
          result = Shortening_outcome::held;
        }
      }
    });
    return result;
  }
  /// @}

  Revertible_triangulation m_triangulation;
  Edge_path m_path;
  std::function<bool(Index)> m_is_pinned;
  std::priority_queue<Bend> m_bends;
  std::vector<Bend> m_blocked; // which other parts of the path are in the way of
  std::vector<Index> m_arc;    // the sides of faces that segments are replaced by
  std::vector<Index> m_added;
  Index m_first = 0; // segment of an open path, some segment of a closed one
  Index m_number_of_faces;
  double m_length = 0;
  double m_first_length = 0;
  double m_length_of_single = 0; // when it was a single segment and taken off its vertex for the last time
  std::size_t m_number_of_single_steps = 0;
  std::size_t m_max_single_steps = 0;
  bool m_is_closed = true;
  bool m_is_collapsed = false;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_EDGE_FLIP_SHORTENING_H
