// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The handles and tunnels that closed curves on a surface belong to.

#ifndef CSCD_SRC_APPLICATION_LOOP_CLASSES_H
#define CSCD_SRC_APPLICATION_LOOP_CLASSES_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <CGAL/box_intersection_d.h>

#include <boost/dynamic_bitset.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Independent vectors over Z2.
class Independent_bits
{
public:
  using Bits = boost::dynamic_bitset<>;

  /// Inserts `bits` unless they are a sum of inserted ones. \return whether they were inserted
  bool insert(Bits bits)
  {
    for (const Bits& row : m_rows) {
      if (bits[row.find_first()]) {
        bits ^= row;
      }
    }
    if (bits.none()) {
      return false;
    }
    m_rows.push_back(std::move(bits));
    return true;
  }

  std::size_t size() const { return m_rows.size(); }

private:
  std::vector<Bits> m_rows; // no later one has the first bit of an earlier one
};

/// The classes of closed curves along the edges of a closed surface, in its homology over Z2.
///
/// A tree of edges and a tree of faces that crosses none of these leave 2 g edges over on a surface of genus g. Each
/// closes a loop along edges with the first tree, and a dual loop across edges with the second; these meet in that edge
/// alone. So the class of a curve, as a sum of the loops, follows from how often it crosses the dual loops.
///
/// What a curve bounds follows from how it is linked with the dual loops of its component, pushed outwards: not at all
/// if it bounds a surface inside the body. Pushed inwards, it is one more where both cross. Components count one by
/// one: of linked rings each has a tunnel, although the other ring passes through it.
class Loop_classes
{
public:
  using Bits = boost::dynamic_bitset<>;

  /// O(n + l log^2 l) for n vertices and l edges of the loops.
  explicit Loop_classes(const Triangulated_surface& surface)
      : m_surface(surface), m_dual_loops(surface.number_of_halfedges())
  {
    m_parent = grow_trees(surface.number_of_vertices(), [&](Index vertex, const auto& reach) {
      for (const Index h : surface.outgoing(vertex)) {
        reach(surface.target(h), surface.twin(h));
      }
    });
    m_dual_parent = grow_trees(surface.number_of_faces(), [&](Index face, const auto& reach) {
      for (const Index h : Triangulated_surface::face_halfedges(face)) {
        if (!is_in_tree(h)) {
          reach(Triangulated_surface::face(surface.twin(h)), surface.twin(h));
        }
      }
    });
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (surface.edge(h) == h && !is_in_tree(h) && !is_in_dual_tree(h)) {
        m_left_over.push_back(h);
        Index root = surface.origin(h);
        while (m_parent[root] != no_index) {
          root = surface.target(m_parent[root]);
        }
        m_component.push_back(root);
      }
    }
    for (Index i = 0; i < m_left_over.size(); ++i) {
      for (const Index h : dual_loop(m_left_over[i])) {
        m_dual_loops[m_surface.edge(h)].push_back(i);
      }
    }
    find_linking();
  }

  /// Twice the genus.
  std::size_t size() const { return m_left_over.size(); }

  /// The class of the closed curve along `halfedges`; linear.
  Bits operator()(const std::vector<Index>& halfedges) const
  {
    Bits result(size());
    for (const Index h : halfedges) {
      for (const Index i : m_dual_loops[m_surface.edge(h)]) {
        result.flip(i);
      }
    }
    return result;
  }

  /// Whether handle and tunnel loops can be told apart, each g dimensions: not where the surface intersects itself
  /// along them.
  bool is_consistent() const
  {
    Independent_bits handles;
    Independent_bits tunnels;
    for (std::size_t i = 0; i < size(); ++i) {
      Bits unit(size());
      unit.set(i);
      if (tunnel_part(m_linking[i]) != m_linking[i]) {
        return false;
      }
      tunnels.insert(m_linking[i]);
      handles.insert(m_linking[i] ^ unit);
    }
    return 2 * tunnels.size() == size() && 2 * handles.size() == size();
  }

  /// Of a class, the sum of one that bounds inside and one that bounds outside, the latter. It is nothing for handle
  /// loops, and all for tunnel loops. \pre `is_consistent()`
  Bits tunnel_part(const Bits& loop) const
  {
    Bits result(size());
    for (std::size_t i = loop.find_first(); i != Bits::npos; i = loop.find_next(i)) {
      result ^= m_linking[i];
    }
    return result;
  }

private:
  using Polygon = std::vector<Vector3>;

  /// How far a dual loop is pushed outwards where its loop crosses it, relative to the length of the edge.
  static constexpr double push = 1e-3;

  /// Grows a tree breadth first in each connected part of a graph of `size` nodes. \return the way back of each node
  /// except the roots \param for_each_neighbor `for_each_neighbor(node, reach)` calls `reach(neighbor, way back)`
  template <class ForEachNeighbor>
  static std::vector<Index> grow_trees(std::size_t size, const ForEachNeighbor& for_each_neighbor)
  {
    std::vector<Index> parent(size, no_index);
    std::vector<char> is_reached(size, 0);
    std::vector<Index> queue;
    queue.reserve(size);
    for (Index root = 0; root < size; ++root) {
      std::size_t next = queue.size();
      if (is_reached[root] == 0) {
        is_reached[root] = 1;
        queue.push_back(root);
      }
      for (; next < queue.size(); ++next) {
        for_each_neighbor(queue[next], [&](Index neighbor, Index way_back) {
          if (is_reached[neighbor] == 0) {
            is_reached[neighbor] = 1;
            parent[neighbor] = way_back;
            queue.push_back(neighbor);
          }
        });
      }
    }
    return parent;
  }

  bool is_in_tree(Index h) const
  {
    return m_parent[m_surface.origin(h)] == h || m_parent[m_surface.target(h)] == m_surface.twin(h);
  }
  bool is_in_dual_tree(Index h) const
  {
    const Index t = m_surface.twin(h);
    return m_dual_parent[Triangulated_surface::face(h)] == h || m_dual_parent[Triangulated_surface::face(t)] == t;
  }

  /// The closed path over the side `edge` from node to node of a tree and back along the tree, as the sides that it
  /// passes; `edge` comes first. \param next `next(side)` is the node that a way back leads to
  template <class Next>
  std::vector<Index> closed_path(Index edge, Index from, Index to, const std::vector<Index>& parent,
                                 const Next& next) const
  {
    const auto path_to_root = [&](Index node) {
      std::vector<Index> path;
      for (Index h = parent[node]; h != no_index; h = parent[next(h)]) {
        path.push_back(h);
      }
      return path;
    };
    std::vector<Index> first = path_to_root(from);
    std::vector<Index> second = path_to_root(to);
    while (!first.empty() && !second.empty() && first.back() == second.back()) { // their common part
      first.pop_back();
      second.pop_back();
    }
    std::vector<Index> result{edge};
    result.insert(result.end(), second.begin(), second.end());
    std::transform(first.rbegin(), first.rend(), std::back_inserter(result),
                   [this](Index h) { return m_surface.twin(h); });
    return result;
  }

  /// The points of the loop that `edge` closes.
  Polygon loop_points(Index edge) const
  {
    Polygon result;
    for (const Index h : closed_path(edge, m_surface.origin(edge), m_surface.target(edge), m_parent,
                                     [this](Index side) { return m_surface.target(side); })) {
      result.push_back(m_surface.point(m_surface.origin(h)));
    }
    return result;
  }

  /// The halfedges where the dual loop of `edge` leaves faces, in order; the first is the edge's.
  std::vector<Index> dual_loop(Index edge) const
  {
    const auto face_behind = [this](Index side) { return Triangulated_surface::face(m_surface.twin(side)); };
    return closed_path(edge, Triangulated_surface::face(edge), face_behind(edge), m_dual_parent, face_behind);
  }

  /// The points of the dual loop of `edge`: centers of faces and of edges, that of `edge` pushed outwards.
  Polygon dual_loop_points(Index edge) const
  {
    const std::vector<Index> halfedges = dual_loop(edge);
    Polygon result;
    result.reserve(2 * halfedges.size());
    for (const Index h : halfedges) {
      const Vector3& a = m_surface.point(m_surface.origin(h));
      const Vector3& b = m_surface.point(m_surface.target(h));
      result.push_back((a + b + m_surface.point(m_surface.opposite_vertex(h))) / 3);
      result.push_back((a + b) / 2);
    }
    const Vector3 outwards = m_surface.face_vector(Triangulated_surface::face(edge)).normalized() +
                             m_surface.face_vector(Triangulated_surface::face(m_surface.twin(edge))).normalized();
    result[1] += push * m_surface.length(edge) * outwards.normalized();
    return result;
  }

  /// Finds how loops and dual loops are linked: in a projection, how often the one passes above the other.
  void find_linking()
  {
    m_linking.assign(size(), Bits(size()));
    if (size() == 0) {
      return;
    }
    std::vector<Segment> loops;
    std::vector<Segment> dual_loops;
    for (Index i = 0; i < size(); ++i) {
      add_segments(loop_points(m_left_over[i]), i, loops);
      add_segments(dual_loop_points(m_left_over[i]), i, dual_loops);
    }
    std::vector<Box> boxes = make_boxes(loops);
    std::vector<Box> dual_boxes = make_boxes(dual_loops);
    CGAL::box_intersection_d(boxes.begin(), boxes.end(), dual_boxes.begin(), dual_boxes.end(),
                             [&](const Box& a, const Box& b) {
                               const Index i = a.info()->loop;
                               const Index j = b.info()->loop;
                               if (m_component[i] == m_component[j] && passes_above(*a.info(), *b.info())) {
                                 m_linking[i].flip(j);
                               }
                             });
  }

  struct Segment
  {
    std::array<Vector3, 2> ends;
    Index loop;
  };

  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, const Segment*>;

  /// Adds the sides of `polygon`, turned to a direction where no two edges of a usual mesh are seen as one.
  static void add_segments(const Polygon& polygon, Index loop, std::vector<Segment>& segments)
  {
    const Vector3 x = Vector3(0.81, 0.37, -0.23).normalized();
    const Vector3 y = x.cross(Vector3(0.39, -0.21, 0.87)).normalized();
    const Vector3 z = x.cross(y);
    const auto turned = [&](const Vector3& point) { return Vector3(x.dot(point), y.dot(point), z.dot(point)); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      segments.push_back({{turned(polygon[i]), turned(polygon[i + 1 < polygon.size() ? i + 1 : 0])}, loop});
    }
  }

  static std::vector<Box> make_boxes(const std::vector<Segment>& segments)
  {
    std::vector<Box> boxes;
    boxes.reserve(segments.size());
    for (const Segment& segment : segments) {
      const Vector3 lower = segment.ends[0].cwiseMin(segment.ends[1]);
      const Vector3 upper = segment.ends[0].cwiseMax(segment.ends[1]);
      std::array<double, 2> low{lower.x(), lower.y()};
      std::array<double, 2> high{upper.x(), upper.y()};
      boxes.emplace_back(low.data(), high.data(), &segment);
    }
    return boxes;
  }

  /// Whether the segments cross seen along z, and `a` is above `b` there.
  static bool passes_above(const Segment& a, const Segment& b)
  {
    const Vector3 u = a.ends[1] - a.ends[0];
    const Vector3 v = b.ends[1] - b.ends[0];
    const Vector3 w = b.ends[0] - a.ends[0];
    const auto cross = [](const Vector3& p, const Vector3& q) { return p.x() * q.y() - p.y() * q.x(); };
    const double denominator = cross(u, v);
    const double s = cross(w, v) / denominator;
    const double t = cross(w, u) / denominator;
    // Not a number where they are parallel.
    return s >= 0 && s < 1 && t >= 0 && t < 1 && a.ends[0].z() + s * u.z() > b.ends[0].z() + t * v.z();
  }

  const Triangulated_surface& m_surface;
  std::vector<Index> m_parent;                  // halfedge from each vertex to its parent in the tree
  std::vector<Index> m_dual_parent;             // halfedge where each face is left for its parent
  std::vector<Index> m_left_over;               // a halfedge of each edge in neither tree
  std::vector<Index> m_component;               // of each of these, a vertex that stands for it
  std::vector<std::vector<Index>> m_dual_loops; // that cross the edge of each smaller halfedge
  std::vector<Bits> m_linking;                  // of each loop with the dual loops
};

} // namespace CSCD::internal

#endif // CSCD_SRC_APPLICATION_LOOP_CLASSES_H
