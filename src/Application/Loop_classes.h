// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The handles and tunnels that closed curves on a surface belong to.

#ifndef CSCD_SRC_APPLICATION_LOOP_CLASSES_H
#define CSCD_SRC_APPLICATION_LOOP_CLASSES_H

#include <CSCD/Packing/Loops_across.h>
#include <CSCD/Surface/Tree_cotree.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <boost/dynamic_bitset.hpp>

#include <cstddef>
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
/// The class of a curve, as a sum of the loops of a `Tree_cotree`, follows from how often it crosses the dual loops.
///
/// What a curve bounds follows from how it is linked with the dual loops of its component, pushed outwards: not at all
/// if it bounds a surface inside the body. Pushed inwards, it is one more where both cross. Components count one by
/// one: of linked rings each has a tunnel, although the other ring passes through it.
class Loop_classes
{
public:
  using Bits = boost::dynamic_bitset<>;

  /// O(n + l^2) for n vertices and l edges of the loops.
  explicit Loop_classes(const Triangulated_surface& surface)
      : m_surface(surface), m_trees(surface), m_dual_loops(surface.number_of_halfedges())
  {
    for (Index i = 0; i < size(); ++i) {
      const Index edge = m_trees.left_over()[i];
      m_component.push_back(m_trees.root(surface.origin(edge)));
      for (const Index h : m_trees.dual_loop(edge)) {
        m_dual_loops[surface.edge(h)].push_back(i);
      }
    }
    find_linking();
  }

  /// Twice the genus.
  std::size_t size() const { return m_trees.left_over().size(); }

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
  /// along them. As the tunnel part is a projection, handle loops have all dimensions that tunnel loops have not.
  bool is_consistent() const
  {
    Independent_bits tunnels;
    for (const Bits& tunnel : m_linking) {
      if (tunnel_part(tunnel) != tunnel) {
        return false;
      }
      tunnels.insert(tunnel);
    }
    return 2 * tunnels.size() == size();
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

  /// The points of the loop that `edge` closes.
  Polygon loop_points(Index edge) const
  {
    Polygon result;
    for (const Index h : m_trees.loop(edge)) {
      result.push_back(m_surface.point(m_surface.origin(h)));
    }
    return result;
  }

  /// The points of the dual loop of `edge`: centers of faces and of edges, that of `edge` pushed outwards.
  Polygon dual_loop_points(Index edge) const
  {
    const std::vector<Index> halfedges = m_trees.dual_loop(edge);
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

  /// Finds how loops and dual loops are linked.
  void find_linking()
  {
    m_linking.assign(size(), Bits(size()));
    std::vector<Seen_polygon> dual_loops;
    for (const Index edge : m_trees.left_over()) {
      dual_loops.emplace_back(dual_loop_points(edge));
    }
    for (Index i = 0; i < size(); ++i) {
      const Seen_polygon loop = loop_points(m_trees.left_over()[i]);
      for (Index j = 0; j < size(); ++j) {
        m_linking[i][j] = m_component[i] == m_component[j] && linking_number(loop, dual_loops[j]) % 2 != 0;
      }
    }
  }

  const Triangulated_surface& m_surface;
  Tree_cotree m_trees;
  std::vector<Index> m_component;               // of each edge left over, a vertex that stands for it
  std::vector<std::vector<Index>> m_dual_loops; // that cross the edge of each smaller halfedge
  std::vector<Bits> m_linking;                  // of each loop with the dual loops
};

} // namespace CSCD::internal

#endif // CSCD_SRC_APPLICATION_LOOP_CLASSES_H
