// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of an ORG tree that is kept as the cut locus.

#ifndef CSCD_CUT_LOCUS_CUT_TREE_H
#define CSCD_CUT_LOCUS_CUT_TREE_H

#include <CSCD/Cut_locus/Org_tree.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CSCD::internal {

/// A subtree of every tree of an ORG tree, each with its root, and chords that close loops.
/// Vertices are added below kept ones, and removed at the leaves.
class Cut_tree
{
public:
  /// Keeps the roots of `tree`, which is referred to and must outlive this object; linear.
  explicit Cut_tree(const Org_tree& tree)
      : m_tree(tree), m_is_kept(num_vertices(tree.graph()), 0), m_is_protected(m_is_kept),
        m_number_of_children(m_is_kept.size(), 0)
  {
    for (Index root : tree.roots()) {
      m_is_kept[root] = 1;
      m_is_protected[root] = 1;
    }
  }
  explicit Cut_tree(Org_tree&&) = delete;

  const Org_tree& tree() const { return m_tree; }
  bool is_kept(Index vertex) const { return m_is_kept[vertex] != 0; }
  /// Whether `vertex` may not be removed: a root, or part of a loop or of its way to the root.
  bool is_protected(Index vertex) const { return m_is_protected[vertex] != 0; }
  bool is_root(Index vertex) const { return m_tree.parent(vertex) == no_index; }
  /// Those that are kept.
  Index number_of_children(Index vertex) const { return m_number_of_children[vertex]; }
  /// Whether `vertex` is kept and can be removed.
  bool is_free_leaf(Index vertex) const
  {
    return is_kept(vertex) && !is_protected(vertex) && number_of_children(vertex) == 0;
  }

  /// Keeps `vertex` and all that are between it and kept ones.
  void keep(Index vertex)
  {
    for (; !is_kept(vertex); vertex = m_tree.parent(vertex)) {
      m_is_kept[vertex] = 1;
      ++m_number_of_children[m_tree.parent(vertex)];
    }
  }

  /// Removes a leaf.
  /// \pre `is_free_leaf(vertex)`
  void remove(Index vertex)
  {
    CGAL_precondition(is_free_leaf(vertex));
    m_is_kept[vertex] = 0;
    --m_number_of_children[m_tree.parent(vertex)];
  }

  /// Joins the ends `a` and `b` of `halfedge` by a chord, keeps both, and protects their ways to the root.
  void add_chord(Index halfedge, Index a, Index b)
  {
    m_chords.push_back(halfedge);
    for (Index vertex : {a, b}) {
      keep(vertex);
      for (; vertex != no_index && !is_protected(vertex); vertex = m_tree.parent(vertex)) {
        m_is_protected[vertex] = 1;
      }
    }
  }

  /// The halfedges of the chords.
  const std::vector<Index>& chords() const { return m_chords; }

private:
  const Org_tree& m_tree;
  std::vector<char> m_is_kept;
  std::vector<char> m_is_protected;
  std::vector<Index> m_number_of_children;
  std::vector<Index> m_chords;
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_CUT_TREE_H
