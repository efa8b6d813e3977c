// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The graph of neighboring points of a scan, distances from the root in it, and which pieces belong to one object.

#ifndef CSCD_SRC_TREE_NEIGHBOR_GRAPH_H
#define CSCD_SRC_TREE_NEIGHBOR_GRAPH_H

#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A gap between two pieces of a graph: the points that are nearest to each other.
struct Point_gap
{
  double length;
  Index a;
  Index b;
  bool operator<(const Point_gap& other) const
  {
    return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
  }
};

/// An undirected graph on points, and the spacing of the points at each of them. Scans are dense on trunks and sparse
/// on twigs: nearness is relative to the spacing there.
class Neighbor_graph
{
public:
  /// Joins each of `points` to those among its nearest neighbors, or of whose it is one, that are not far for the
  /// spacing at both. O(n log n).
  explicit Neighbor_graph(const std::vector<Vector3>& points)
  {
    const Neighbor_table table(points, number_of_neighbors);
    measure_spacing(table);
    for (Index a = 0; a < points.size(); ++a) {
      for (Index i = 0; i < table.number(); ++i) {
        const Index b = table.neighbors(a).begin()[i];
        if (table.distances(a).begin()[i] <= longest_edge * std::min(m_spacing[a], m_spacing[b])) {
          m_edges.emplace_back(std::minmax(a, b));
        }
      }
    }
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
    m_number_of_own_edges = m_edges.size();
    index_edges();
  }

  CGAL::Iterator_range<const Index*> neighbors(Index point) const { return m_neighbors[point]; }
  /// The mean distance of the nearest points, a median over the neighborhood.
  double spacing(Index point) const { return m_spacing[point]; }

  /// Adds edges across `bridges`, which are not there yet, in the place of those added before. Linear.
  void set_bridges(const std::vector<Point_gap>& bridges)
  {
    m_edges.resize(m_number_of_own_edges);
    for (const Point_gap& gap : bridges) {
      m_edges.emplace_back(gap.a, gap.b);
    }
    index_edges();
  }

private:
  /// With fewer neighbors, random samplings fall apart; more reach over to the next twig.
  static constexpr Index number_of_neighbors = 16;
  /// Of an edge, relative to the lesser spacing at its ends.
  static constexpr double longest_edge = 2.5;

  void measure_spacing(const Neighbor_table& table)
  {
    const std::vector<double> mean = spacings(table);
    m_spacing.resize(mean.size());
    std::vector<double> around;
    for (Index point = 0; point < mean.size(); ++point) {
      around.assign(1, mean[point]);
      for (Index neighbor : table.neighbors(point)) {
        around.push_back(mean[neighbor]);
      }
      m_spacing[point] = quantile(around, 0.5);
    }
  }

  void index_edges()
  {
    m_neighbors = Compressed_rows<Index>(m_spacing.size(), [this](const auto& add) {
      for (const auto& [a, b] : m_edges) {
        add(a, b);
        add(b, a);
      }
    });
  }

  std::vector<double> m_spacing;
  std::vector<std::pair<Index, Index>> m_edges; // bridges last
  std::size_t m_number_of_own_edges = 0;
  Compressed_rows<Index> m_neighbors;
};

/// Distances along a neighbor graph, and the tree of the shortest paths.
class Root_distances
{
public:
  /// Measures from the roots of each object all that is connected with them. O(n log n).
  Root_distances(const std::vector<Vector3>& points, const Neighbor_graph& graph,
                 const std::vector<std::vector<Index>>& roots_of_objects)
      : m_front(points.size()), m_distance(points.size(), 0.F), m_parent(points.size(), no_index)
  {
    // Shortest paths must not leap from limb to limb: edges longer than the spacing cost more than their length.
    const auto cost_of_edge = [&](Index a, Index b) {
      constexpr double leap_exponent = 0.5; // how much more, as the power of the length relative to the spacing
      const double length = (points[a] - points[b]).norm();
      const double spacing = std::min(graph.spacing(a), graph.spacing(b));
      return spacing > 0 ? length * std::pow(std::max(1., length / spacing), leap_exponent) : length;
    };
    for (const std::vector<Index>& roots : roots_of_objects) {
      for (Index root : roots) {
        m_front.reach(root, 0);
      }
      m_front.spread([&](Index point, float cost) {
        if (m_parent[point] != no_index) {
          m_distance[point] = m_distance[m_parent[point]] + float((points[point] - points[m_parent[point]]).norm());
        }
        for (Index neighbor : graph.neighbors(point)) {
          if (m_front.reach(neighbor, cost + float(cost_of_edge(point, neighbor)))) {
            m_parent[neighbor] = point;
          }
        }
      });
    }
  }

  /// The cost of the shortest path to the root. \pre there is one
  float cost(Index point) const { return m_front.distance(point); }
  /// The length of that path.
  float distance(Index point) const { return m_distance[point]; }
  /// The next point on the shortest path to the root; `no_index` for a root.
  Index parent(Index point) const { return m_parent[point]; }

private:
  Dijkstra_search m_front;
  std::vector<float> m_distance;
  std::vector<Index> m_parent;
};

/// Joins the pieces of a neighbor graph across gaps, the shortest first, as far as they can be missing data of one
/// object. Pieces are joined
/// - across a gap of a few spacings: twigs are hit by few points;
/// - across any gap that is not longer than the smaller piece, unless both stand on the ground, by their lowest points:
///   then they are two objects.
class Gap_bridging
{
public:
  /// \param points in an order where near numbers are near in space
  Gap_bridging(const std::vector<Vector3>& points, const Neighbor_graph& graph)
      : m_points(points), m_graph(graph), m_pieces(points.size())
  {
    for (Index a = 0; a < points.size(); ++a) {
      m_moments.push_back({1, points[a], points[a].squaredNorm(), points[a].z(), points[a].z()});
      for (Index b : graph.neighbors(a)) {
        m_pieces.join(a, b);
      }
    }
    for (Index a = 0; a < points.size(); ++a) {
      m_piece.push_back(m_pieces.find(a));
      if (m_piece[a] != a) {
        m_moments[m_piece[a]].add(m_moments[a]);
      }
    }
    const std::vector<Point_gap> gaps = find_gaps();
    std::vector<Point_gap> joints; // the gaps that pieces are joined across
    for (const Point_gap& gap : gaps) {
      const Index a = m_pieces.find(gap.a);
      const Index b = m_pieces.find(gap.b);
      if (a != b && is_one_object(gap, m_moments[a], m_moments[b])) {
        m_pieces.join(a, b);
        const Index joined = m_pieces.find(a);
        const Index other = joined == a ? b : a;
        m_moments[joined].add(m_moments[other]);
        joints.push_back(gap);
      }
    }
    find_objects();
    choose_bridges(gaps, joints);
  }

  /// The gaps that may be bridged, the shortest first: between two pieces there may be several.
  const std::vector<Point_gap>& bridges() const { return m_bridges; }
  /// The bridges where the shortest paths `distances` enter each piece first, the shortest first. So every piece except
  /// one hangs on one other.
  std::vector<Point_gap> entries(const Root_distances& distances) const
  {
    std::vector<Index> first(m_points.size(), no_index); // of every piece, the point that is reached first: a root
    for (Index point = 0; point < m_points.size(); ++point) {
      const Index parent = distances.parent(point);
      if (m_object[point] != no_index && (parent == no_index || m_piece[parent] != m_piece[point])) {
        Index& of_piece = first[m_piece[point]];
        if (of_piece == no_index || distances.cost(point) < distances.cost(of_piece)) {
          of_piece = point;
        }
      }
    }
    std::vector<Point_gap> result;
    for (const Point_gap& gap : m_bridges) {
      const auto is_entry = [&](Index from, Index to) {
        return first[m_piece[to]] == to && distances.parent(to) == from;
      };
      if (is_entry(gap.a, gap.b) || is_entry(gap.b, gap.a)) {
        result.push_back(gap);
      }
    }
    return result;
  }
  Index number_of_objects() const { return m_number_of_objects; }
  /// The object of a point, the one of most points first; `no_index` for debris.
  Index object(Index point) const { return m_object[point]; }

private:
  /// A gap of so many spacings may be chance.
  static constexpr double chance_gap = 6;
  /// Of a gap that may be bridged, relative to the shortest gap around the more isolated piece.
  static constexpr double longest_alternative = 3;
  /// Two pieces stand on the ground if their lowest points differ by at most this part of the lesser height.
  static constexpr double ground_tolerance = 0.15;
  /// Pieces of fewer points, or of a lesser part of the points of the largest object, that nothing joins are debris.
  static constexpr double min_object = 20;
  static constexpr double min_object_part = 0.005;

  /// The properties of a piece that add up.
  struct Moments
  {
    double number;
    Vector3 sum;
    double sum_of_squares;
    double bottom;
    double top;

    void add(const Moments& other)
    {
      number += other.number;
      sum += other.sum;
      sum_of_squares += other.sum_of_squares;
      bottom = std::min(bottom, other.bottom);
      top = std::max(top, other.top);
    }
    /// The length of a stick of the same scatter.
    double extent() const
    {
      constexpr double stick = 12; // squared length over variance of points that are uniform on a segment
      return std::sqrt(stick * std::max(0., sum_of_squares / number - (sum / number).squaredNorm()));
    }
  };

  /// The edges of the Delaunay triangulation between pieces, among which are the shortest ways between any two parts.
  /// O(n log n) for points on surfaces or in volumes.
  /// \throw Input_error if there would be as many tetrahedra as only points along curves have
  std::vector<Point_gap> find_gaps()
  {
    std::vector<Point_gap> result;
    if (std::all_of(m_piece.begin(), m_piece.end(), [this](Index piece) { return piece == m_piece.front(); })) {
      return result;
    }
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
    using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base>>;
    // Points on surfaces have about 7 tetrahedra each, in volumes as many; two straight lines of n points have n^2.
    constexpr std::size_t max_cells_per_point = 32;
    constexpr std::size_t max_cells_of_few_points = 1 << 18; // which take no time and no memory
    Triangulation triangulation;
    Triangulation::Vertex_handle last; // near the next one
    for (Index i = 0; i < m_points.size(); ++i) {
      last = triangulation.insert({m_points[i].x(), m_points[i].y(), m_points[i].z()}, last);
      last->info() = i;
      if (triangulation.tds().number_of_cells() > max_cells_per_point * m_points.size() + max_cells_of_few_points) {
        throw Input_error("the points lie along curves, not on a surface: their triangulation would fill the memory; "
                          "join the points by edges and skeletonize these as a graph, or thin the points along the "
                          "curves");
      }
    }
    for (const auto& edge : triangulation.finite_edges()) {
      const auto [a, b] = std::minmax(edge.first->vertex(edge.second)->info(), edge.first->vertex(edge.third)->info());
      if (m_pieces.find(a) != m_pieces.find(b)) {
        result.push_back({(m_points[a] - m_points[b]).norm(), a, b});
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// \param a, b the pieces at the ends of `gap`
  bool is_one_object(const Point_gap& gap, const Moments& a, const Moments& b) const
  {
    if (gap.length <= chance_gap * std::max(m_graph.spacing(gap.a), m_graph.spacing(gap.b))) {
      return true;
    }
    const double lesser_height = std::min(a.top - a.bottom, b.top - b.bottom);
    const bool both_stand = std::abs(a.bottom - b.bottom) <= ground_tolerance * lesser_height;
    return !both_stand && gap.length <= std::min(a.extent(), b.extent());
  }

  /// Where a piece is joined is not decided by its shortest gap alone, which may be that between two twigs that nearly
  /// touch: gaps that are not much longer are alternatives. \param gaps, joints the shortest first
  void choose_bridges(const std::vector<Point_gap>& gaps, const std::vector<Point_gap>& joints)
  {
    Disjoint_sets joined(m_points.size()); // pieces, across joints that are much shorter than the gap
    auto joint = joints.begin();
    for (const Point_gap& gap : gaps) {
      for (; joint != joints.end() && longest_alternative * joint->length < gap.length; ++joint) {
        joined.join(m_piece[joint->a], m_piece[joint->b]);
      }
      if (m_object[gap.a] == m_object[gap.b] && m_object[gap.a] != no_index &&
          joined.find(m_piece[gap.a]) != joined.find(m_piece[gap.b])) {
        m_bridges.push_back(gap);
      }
    }
  }

  void find_objects()
  {
    std::vector<Index> roots;
    for (Index point = 0; point < m_points.size(); ++point) {
      if (m_pieces.find(point) == point) {
        roots.push_back(point);
      }
    }
    std::stable_sort(roots.begin(), roots.end(),
                     [this](Index a, Index b) { return m_moments[a].number > m_moments[b].number; });
    const double least = std::max(min_object, min_object_part * m_moments[roots.front()].number);
    std::vector<Index> object_of_root(m_points.size(), no_index);
    for (Index root : roots) {
      if (root == roots.front() || m_moments[root].number >= least) {
        object_of_root[root] = m_number_of_objects++;
      }
    }
    m_object.resize(m_points.size());
    for (Index point = 0; point < m_points.size(); ++point) {
      m_object[point] = object_of_root[m_pieces.find(point)];
    }
  }

  const std::vector<Vector3>& m_points;
  const Neighbor_graph& m_graph;
  Disjoint_sets m_pieces;
  std::vector<Index> m_piece;     // of every point, before any gap was bridged: named by a point of it
  std::vector<Moments> m_moments; // of every piece, at the point that represents it
  std::vector<Point_gap> m_bridges;
  std::vector<Index> m_object;
  Index m_number_of_objects = 0;
};

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_NEIGHBOR_GRAPH_H
