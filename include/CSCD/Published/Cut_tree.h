// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cut locus of a distance field: its vertices by Laplacian and gradient angle, the ORG tree that joins them, and
// its loops around handles (G.1).

#ifndef CSCD_PUBLISHED_CUT_TREE_H
#define CSCD_PUBLISHED_CUT_TREE_H

#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/core_numbers.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

inline double dot(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.real() + a.imag() * b.imag();
}

inline bool are_converging(const Gradient_sample& a, const Gradient_sample& b)
{
  return dot(a.gradient - b.gradient, a.direction - b.direction) < 0;
}

/// The greatest angle in [0, pi] between the gradients of two samples that run towards each other. O(d^2) for d samples
/// up to a constant, beyond which an even sample of them is taken.
inline double max_convergence(const Gradient_samples& samples)
{
  // Sectors that are compared pair by pair.
  constexpr std::size_t max_samples = 32;
  const std::size_t stride = (samples.size() + max_samples - 1) / max_samples;
  double min_cosine = 1;
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    for (std::size_t j = i + stride; j < samples.size(); j += stride) {
      const double cosine = dot(samples[i].gradient, samples[j].gradient);
      if (cosine < min_cosine && are_converging(samples[i], samples[j])) {
        min_cosine = cosine;
      }
    }
  }
  return std::acos(std::clamp(min_cosine, -1., 1.));
}

/// The derivatives of a distance field at the vertices, each computed on request in their tangent frames, and which
/// vertices are points of the cut locus. O(degree) unless said otherwise.
/// \tparam FramesType `Tangent_frames` of a triangulation, or `Point_frames` of a point complex
template <class FramesType>
class Cut_locus_indicators
{
public:
  using Frames = FramesType;

  /// \param field the distance of every vertex, infinite or not a number where it is unknown; as `frames`, it is
  ///        referred to and must outlive this object
  Cut_locus_indicators(const Frames& frames, const std::vector<double>& field) : m_frames(frames), m_distances(field)
  {
    CGAL_precondition(field.size() == frames.triangulation().number_of_vertices());
  }

  const Frames& frames() const { return m_frames; }
  const std::vector<double>& distances() const { return m_distances; }
  double distance(Index vertex) const { return m_distances[vertex]; }
  bool is_reached(Index vertex) const { return std::isfinite(m_distances[vertex]); }

  /// The Laplacian times the spacing: that of the vertices around `vertex` or, if it is larger, the mean edge length,
  /// over which a heat method smooths its distances.
  double laplacian(Index vertex) const
  {
    const double result = m_frames.laplacian(vertex, m_distances);
    return std::isfinite(result) ? result : 0;
  }

  /// Collects the gradients around `vertex`, counterclockwise.
  void collect_samples(Index vertex, Gradient_samples& samples) const
  {
    m_frames.collect_samples(vertex, m_distances, samples);
  }

  /// The mean gradients around all vertices; linear for bounded degrees.
  std::vector<std::complex<double>> gradients() const
  {
    std::vector<std::complex<double>> result;
    result.reserve(m_distances.size());
    for (Index vertex = 0; vertex < m_distances.size(); ++vertex) {
      result.push_back(m_frames.mean_gradient(vertex, m_distances));
    }
    return result;
  }

  /// Whether `vertex` is a point of the cut locus. Samples beyond a constant number are thinned out evenly before they
  /// are compared pair by pair.
  /// \param gradients if given, those of all vertices: then the neighbors are compared, which lie farther away than the
  ///        faces around the vertex, where a heat method does not round off a ridge any more
  bool is_cut(Index vertex, const Cut_locus_settings& settings,
              const std::vector<std::complex<double>>* gradients = nullptr) const
  {
    if (!is_reached(vertex) || !(laplacian(vertex) <= settings.laplacian_threshold)) {
      return false;
    }
    Gradient_samples samples;
    if (gradients != nullptr) {
      collect_neighbors(
          m_frames, vertex, [gradients](Index neighbor) { return (*gradients)[neighbor]; }, samples);
    } else {
      collect_samples(vertex, samples);
    }
    return max_convergence(samples) >= settings.angle_threshold;
  }

private:
  const Frames& m_frames;
  const std::vector<double>& m_distances;
};

/// The ORG tree of the supplement (appendix G.1), which does not define it: the full, unfiltered spanning tree of the
/// vertices that have a distance, one for each component. Its root is the farthest vertex, a point of the cut locus
/// beyond doubt; it grows as Prim's tree does, from the attached vertex whose Laplacian is least, which takes all its
/// neighbors that are free. So it runs along the ridges first, and the cut locus becomes long chains from the root,
/// while everything else hangs on them as short twigs. Vertices on loops of the cut locus, if these are known, come
/// before all others: so the tree runs along the loops.
struct Org_tree
{
  std::vector<double> laplacian; ///< of every vertex, scale-free; minus infinity on a loop
  std::vector<Index> parent;     ///< `no_index` for roots, and for vertices that are not in the tree
  std::vector<Index> halfedge;   ///< between a vertex and its parent, in either direction
  std::vector<Index> order;      ///< all vertices of the tree, parents before children
};

/// Grows the ORG tree; O(n log n) for n vertices.
/// \param is_on_loop for every vertex
template <class Measures>
Org_tree grow_org_tree(const Measures& measures, const std::vector<char>& is_on_loop)
{
  const std::size_t size = is_on_loop.size();
  Org_tree tree{
      std::vector<double>(size, 0), std::vector<Index>(size, no_index), std::vector<Index>(size, no_index), {}};
  std::vector<Index> by_distance;
  for (Index vertex = 0; vertex < size; ++vertex) {
    if (measures.is_reached(vertex)) {
      tree.laplacian[vertex] =
          is_on_loop[vertex] ? -std::numeric_limits<double>::infinity() : measures.laplacian(vertex);
      by_distance.push_back(vertex);
    }
  }
  std::sort(by_distance.begin(), by_distance.end(),
            [&](Index a, Index b) { return std::pair(measures.distance(b), a) < std::pair(measures.distance(a), b); });
  std::vector<char> is_attached(size, 0);
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  const auto attach = [&](Index vertex) {
    if (!is_attached[vertex]) {
      is_attached[vertex] = 1;
      tree.order.push_back(vertex);
      queue.emplace(tree.laplacian[vertex], vertex);
      return true;
    }
    return false;
  };
  // The farthest vertex of each component is the first of it to come.
  for (const Index root : by_distance) {
    attach(root);
    while (!queue.empty()) {
      const Index vertex = queue.top().second;
      queue.pop();
      measures.frames().for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
        if (measures.is_reached(neighbor) && attach(neighbor)) {
          tree.parent[neighbor] = vertex;
          tree.halfedge[neighbor] = halfedge;
        }
      });
    }
  }
  return tree;
}

/// An ORG tree, a subtree of each of its trees with the root, and chords that close loops.
/// Vertices are added below kept ones, and removed at the leaves.
class Cut_tree : public Org_tree
{
public:
  /// Keeps the roots of `tree`; linear.
  explicit Cut_tree(Org_tree&& tree)
      : Org_tree(std::move(tree)), m_is_kept(parent.size(), 0), m_is_protected(m_is_kept),
        m_number_of_children(m_is_kept.size(), 0)
  {
    for (Index vertex : order) {
      m_is_kept[vertex] = m_is_protected[vertex] = is_root(vertex) ? 1 : 0;
    }
  }

  bool is_kept(Index vertex) const { return m_is_kept[vertex] != 0; }
  /// Whether `vertex` may not be removed: a root, or part of a loop or of its path to the root.
  bool is_protected(Index vertex) const { return m_is_protected[vertex] != 0; }
  bool is_root(Index vertex) const { return parent[vertex] == no_index; }
  /// The number of children that are kept.
  Index number_of_children(Index vertex) const { return m_number_of_children[vertex]; }
  /// Whether `vertex` is kept and can be removed.
  bool is_free_leaf(Index vertex) const
  {
    return is_kept(vertex) && !is_protected(vertex) && number_of_children(vertex) == 0;
  }

  /// Keeps `vertex` and all that are between it and kept ones.
  void keep(Index vertex)
  {
    for (; !is_kept(vertex); vertex = parent[vertex]) {
      m_is_kept[vertex] = 1;
      ++m_number_of_children[parent[vertex]];
    }
  }

  /// Removes a leaf.
  /// \pre `is_free_leaf(vertex)`
  void remove(Index vertex)
  {
    CGAL_precondition(is_free_leaf(vertex));
    m_is_kept[vertex] = 0;
    --m_number_of_children[parent[vertex]];
  }

  /// Joins the vertices `a` and `b` by a chord along a halfedge, keeps both, and protects their paths to the root.
  void add_chord(Index chord, Index a, Index b)
  {
    m_chords.push_back(chord);
    for (Index vertex : {a, b}) {
      keep(vertex);
      for (; vertex != no_index && !is_protected(vertex); vertex = parent[vertex]) {
        m_is_protected[vertex] = 1;
      }
    }
  }

  /// The halfedges of the chords.
  const std::vector<Index>& chords() const { return m_chords; }

private:
  std::vector<char> m_is_kept;
  std::vector<char> m_is_protected;
  std::vector<Index> m_number_of_children;
  std::vector<Index> m_chords;
};

/// Removes from `cut` the branches that end in a leaf and are shorter than `min_length`, the shortest first; what
/// they leave of their fork may then be one longer branch. A branch ends at a fork, at a root, or where it is
/// protected. O(n log n) for n vertices.
/// \param frames know the lengths of halfedges: `Tangent_frames` or `Point_frames`
template <class Frames>
void drop_short_branches(const Frames& frames, Cut_tree& cut, double min_length)
{
  const auto ends_at = [&](Index vertex) { return cut.is_protected(vertex) || cut.number_of_children(vertex) > 1; };
  const auto branch_length = [&](Index leaf) {
    double sum = 0;
    Index vertex = leaf;
    do {
      sum += frames.length(cut.halfedge[vertex]);
      vertex = cut.parent[vertex];
    } while (!ends_at(vertex) && sum < min_length);
    return sum;
  };
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  for (Index vertex : cut.order) {
    if (cut.is_free_leaf(vertex)) {
      queue.emplace(branch_length(vertex), vertex);
    }
  }
  while (!queue.empty() && queue.top().first < min_length) {
    const auto [known_length, leaf] = queue.top();
    queue.pop();
    const double current_length = branch_length(leaf);
    if (current_length > known_length) {
      queue.emplace(current_length, leaf);
      continue;
    }
    for (Index vertex = leaf; cut.is_free_leaf(vertex); vertex = cut.parent[vertex]) {
      cut.remove(vertex);
    }
  }
}

/// Whether the free leaf `leaf` of `cut` lies next to another branch: next to a kept vertex that is neither its parent
/// nor a child of its parent. Of two leaves side by side only the one with the greater Laplacian counts.
template <class Frames>
bool is_beside_branch(const Frames& frames, const Cut_tree& cut, Index leaf)
{
  const Index parent = cut.parent[leaf];
  bool result = false;
  frames.for_each_neighbor(leaf, [&](Index neighbor, Index) {
    if (neighbor == leaf || neighbor == parent || !cut.is_kept(neighbor) || cut.parent[neighbor] == parent) {
      return;
    }
    const bool is_weaker = std::pair(cut.laplacian[leaf], leaf) > std::pair(cut.laplacian[neighbor], neighbor);
    result = result || cut.number_of_children(neighbor) > 0 || cut.is_protected(neighbor) || is_weaker;
  });
  return result;
}

/// Removes branches that lie next to other branches from `cut`, leaf by leaf. O(n) for n vertices.
/// \param frames know the neighbors of a vertex: `Tangent_frames` or `Point_frames`
template <class Frames>
void thin_branches(const Frames& frames, Cut_tree& cut)
{
  std::vector<Index> queue;
  for (Index vertex : cut.order) {
    if (cut.is_free_leaf(vertex)) {
      queue.push_back(vertex);
    }
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (is_beside_branch(frames, cut, queue[i])) {
      const Index parent = cut.parent[queue[i]];
      cut.remove(queue[i]);
      if (cut.is_free_leaf(parent)) {
        queue.push_back(parent);
      }
    }
  }
}

/// One face of each group of neighbors among `sources`.
inline std::vector<Index> faces_of_sources(const Cut_locus_indicators<Tangent_frames>& measures,
                                           const std::vector<Index>& sources)
{
  const Tangent_frames& frames = measures.frames();
  std::vector<char> is_source(frames.triangulation().number_of_vertices(), 0);
  for (const Index source : sources) {
    is_source[source] = 1;
  }
  Disjoint_sets groups(is_source.size());
  for (const Index source : sources) {
    frames.for_each_neighbor(source, [&](Index neighbor, Index) {
      if (is_source[neighbor]) {
        groups.join(source, neighbor);
      }
    });
  }
  std::vector<Index> faces;
  for (const Index source : sources) {
    char& is_new = is_source[groups.find(source)];
    Index face = no_index;
    frames.for_each_outgoing(source, [&](Index h) { face = std::min(face, Triangle_halfedges::face(h)); });
    if (is_new) {
      faces.push_back(face);
    }
    is_new = 0;
  }
  return faces;
}

/// Unites the faces of a triangulation across its edges in order of distance, so that they make one disc around each
/// source: an edge that would close a ring of faces, or join the discs of two sources, is not crossed. So the cut locus
/// is not crossed, since there the discs meet. Borders count as closed by discs. Edges where `is_blocked(h)` holds are
/// not crossed, nor those of vertices without a distance; edges where `is_last(h)` holds come after the others.
/// O(m log m) for m faces.
/// \param sources those that are neighbors share a disc
/// \return a halfedge of each edge that was neither blocked nor crossed
template <class IsBlocked, class IsLast>
std::vector<Index> uncrossed_edges(const Cut_locus_indicators<Tangent_frames>& measures,
                                   const std::vector<Index>& sources, const IsBlocked& is_blocked,
                                   const IsLast& is_last)
{
  const Intrinsic_triangulation& triangulation = measures.frames().triangulation();
  // Of faces and, for each vertex, of the outside of the border there.
  Disjoint_sets discs(std::size_t(triangulation.number_of_faces()) + triangulation.number_of_vertices());
  const auto outside = [&](Index vertex) { return triangulation.number_of_faces() + vertex; };
  std::vector<std::tuple<bool, double, Index>> edges;
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    const Index from = triangulation.origin(h);
    const Index to = triangulation.target(h);
    if (triangulation.is_border(h)) {
      discs.join(outside(from), outside(to));
    }
    // All vertices of a face have a distance, or none has.
    if (measures.is_reached(from) && triangulation.twin(h) >= h && !is_blocked(h)) {
      edges.emplace_back(is_last(h), measures.distance(from) + measures.distance(to), h);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> has_source(discs.size(), 0);
  for (const Index face : faces_of_sources(measures, sources)) {
    has_source[discs.find(face)] = 1;
  }
  std::vector<Index> uncrossed;
  for (const auto& [is_late, distance, h] : edges) {
    const Index twin = triangulation.twin(h);
    const Index a = discs.find(Triangle_halfedges::face(h));
    const Index b = discs.find(twin != no_index ? Triangle_halfedges::face(twin) : outside(triangulation.origin(h)));
    if (a == b || (has_source[a] != 0 && has_source[b] != 0)) {
      uncrossed.push_back(h);
    } else {
      const char has_either = std::max(has_source[a], has_source[b]);
      discs.join(a, b);
      has_source[discs.find(a)] = has_either;
    }
  }
  return uncrossed;
}

/// Marks the vertices of the loops of the cut locus and of what joins these: discs grow around the sources by distance,
/// and of the edges where they meet those are taken away, one after the other, that end freely. None are left on a
/// sphere with one source. Fronts may meet there at any angle, even at one that no threshold would notice.
/// O(m log m) for m faces.
inline std::vector<char> find_loop_vertices(const Cut_locus_indicators<Tangent_frames>& measures,
                                            const std::vector<Index>& sources)
{
  const Intrinsic_triangulation& triangulation = measures.frames().triangulation();
  const auto never = [](Index) { return false; };
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(triangulation.number_of_vertices());
  for (const Index h : uncrossed_edges(measures, sources, never, never)) {
    add_edge(triangulation.origin(h), triangulation.target(h), graph);
  }
  std::vector<std::size_t> core(triangulation.number_of_vertices());
  boost::core_numbers(graph, boost::make_iterator_property_map(core.begin(), get(boost::vertex_index, graph)));
  std::vector<char> result(core.size());
  std::transform(core.begin(), core.end(), result.begin(), [](std::size_t number) { return char(number > 1); });
  return result;
}

/// Adds chords to `cut` until what it leaves of the surface is one disc around each source: the edges that the tree
/// does not take are crossed in order of distance, those along the cut locus last; those that cannot be crossed become
/// chords. On a closed connected surface of genus g, k sources make 2 g + k - 1 of them, and as many loops. Borders
/// count as closed by discs. O(m log m) for m faces.
/// \param sources the vertices at distance 0; those that are neighbors count as one source
inline void close_loops(const Cut_locus_indicators<Tangent_frames>& measures, const std::vector<Index>& sources,
                        Cut_tree& cut)
{
  const Intrinsic_triangulation& triangulation = measures.frames().triangulation();
  const auto is_tree_edge = [&](Index halfedge, Index vertex) {
    const Index own = cut.halfedge[vertex];
    return own != no_index && (own == halfedge || own == triangulation.twin(halfedge));
  };
  const auto is_in_tree = [&](Index halfedge) {
    return is_tree_edge(halfedge, triangulation.origin(halfedge)) ||
           is_tree_edge(halfedge, triangulation.target(halfedge));
  };
  const auto is_kept = [&](Index halfedge) {
    return cut.is_kept(triangulation.origin(halfedge)) && cut.is_kept(triangulation.target(halfedge));
  };
  for (Index halfedge : uncrossed_edges(measures, sources, is_in_tree, is_kept)) {
    cut.add_chord(halfedge, triangulation.origin(halfedge), triangulation.target(halfedge));
  }
}

/// Finds the cut locus of `sources` as part of the ORG tree of `measures`: cut points and their paths to the root are
/// kept, loops closed, branches made one vertex wide, and short ones dropped. O(n log n) for n vertices.
/// \param closes_loops whether there are loops to be closed, as far as is known; on a point complex none is known
template <class Frames>
Cut_tree find_cut_tree(const Cut_locus_indicators<Frames>& measures, const std::vector<Index>& sources,
                       const Cut_locus_settings& settings, bool closes_loops = true)
{
  // Of this many mean edge lengths; the triangulation alone can make shorter branches.
  constexpr double min_edges_of_branch = 3;
  const auto& frames = measures.frames();
  const auto gradients = measures.gradients();
  std::vector<char> is_on_loop(measures.distances().size(), 0);
  constexpr bool knows_loops = std::is_same_v<Frames, Tangent_frames>;
  if constexpr (knows_loops) {
    is_on_loop = closes_loops ? find_loop_vertices(measures, sources) : is_on_loop;
  }
  Cut_tree cut(grow_org_tree(measures, is_on_loop));
  for (const Index vertex : cut.order) {
    if (is_on_loop[vertex] || measures.is_cut(vertex, settings, &gradients)) {
      cut.keep(vertex);
    }
  }
  if constexpr (knows_loops) {
    if (closes_loops) {
      close_loops(measures, sources, cut);
    }
  }
  thin_branches(frames, cut);
  double max_distance = 0;
  for (const Index vertex : cut.order) {
    max_distance = std::max(max_distance, measures.distance(vertex));
  }
  const double min_length =
      std::max(settings.minimum_branch_length * max_distance, min_edges_of_branch * frames.mean_edge_length());
  drop_short_branches(frames, cut, min_length);
  return cut;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CUT_TREE_H
