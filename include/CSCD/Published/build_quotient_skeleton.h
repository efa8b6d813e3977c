// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the regions of packed separators to a skeleton.

#ifndef CSCD_PUBLISHED_BUILD_QUOTIENT_SKELETON_H
#define CSCD_PUBLISHED_BUILD_QUOTIENT_SKELETON_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Points/Closed_complex.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The sides of `face`, one after the other.
/// \tparam Triangulation a model of `SurfaceTriangulation`
template <class Triangulation>
std::array<Index, 3> face_halfedges(const Triangulation& /* surface */, Index face)
{
  return {3 * face, 3 * face + 1, 3 * face + 2};
}
inline std::array<Index, 3> face_halfedges(const Point_complex& surface, Index face)
{
  return surface.face_halfedges(face);
}

/// For each part of the network between regions, the regions of the border cycles around it; linear.
/// \param networks of edges, joined where they are connected between regions
/// \param cycles of halfedges that leave a region, joined around its borders
template <class Surface, class Region>
std::vector<std::vector<Index>> collect_meetings(const Surface& surface, const Region& region, Disjoint_sets& networks,
                                                 Disjoint_sets& cycles)
{
  std::vector<std::vector<Index>> meetings;
  std::vector<Index> meeting_of_network(surface.number_of_halfedges(), no_index);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    if (region(surface.origin(h)) == region(surface.target(h)) || cycles.find(h) != h) {
      continue;
    }
    Index& meeting = meeting_of_network[networks.find(edge_of(surface, h))];
    if (meeting == no_index) {
      meeting = Index(meetings.size());
      meetings.emplace_back();
    }
    meetings[meeting].push_back(region(surface.origin(h)));
  }
  return meetings;
}

/// The graph of regions that touch (Alg. 2, line 14), with cliques removed and true small cycles kept.
///
/// Regions meet in a network of curves between them. Where a connected part of the network is one closed curve, it has
/// a region on either side, which an edge joins. Where curves meet, at faces that have corners in three regions, all
/// regions around that part of the network meet, and a junction joins them in place of a clique of edges. A region
/// counts for every one of its border cycles: three regions around a thin handle, which meet in three separate curves,
/// stay a cycle. Curves that end at a hole of the surface go on across it, two and two where they are between the same
/// regions. If all regions, and the neighborhoods of all parts of the network, are planar, the first Betti number of
/// the graph is the genus of the surface.
class Quotient_graph
{
public:
  /// Computes the graph; near linear.
  /// \param region a function that returns the region of a vertex
  template <class Surface, class Region>
  Quotient_graph(const Surface& surface, const Region& region)
      : m_networks(surface.number_of_halfedges()), m_cycles(surface.number_of_halfedges())
  {
    const auto is_between = [&](Index h) { return region(surface.origin(h)) != region(surface.target(h)); };
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      const std::array<Index, 3> sides = face_halfedges(surface, face);
      for (std::size_t k = 0; k < 3; ++k) {
        join_at_corner(surface, is_between, sides[(k + 2) % 3], sides[k], sides[(k + 1) % 3]);
      }
    }
    join_at_holes(surface, region, is_between);
    m_meetings = collect_meetings(surface, region, m_networks, m_cycles);
  }

  /// For each connected part of the network, the regions of the border cycles around it, two at least; a region with
  /// several cycles there stands several times.
  const std::vector<std::vector<Index>>& meetings() const { return m_meetings; }

private:
  /// Joins what is connected within a face, at the corner that its side `h` leaves. The border cycle of a region has a
  /// point on every halfedge that leaves the region, named after it.
  template <class Surface, class Predicate>
  void join_at_corner(const Surface& surface, const Predicate& is_between, Index before, Index h, Index after)
  {
    if (is_between(h) && is_between(before)) {
      m_networks.join(edge_of(surface, h), edge_of(surface, before));
      m_cycles.join(h, surface.twin(before));
      if (!is_between(after)) {
        // The corner lies alone in its region; the other two are on the other side.
        m_cycles.join(surface.twin(h), before);
      }
    }
  }

  /// An edge of a hole between two regions, where a curve of the network ends, seen from one of them.
  struct Hole_end
  {
    Index hole; ///< a vertex that stands for it
    Index from; ///< a region
    Index to;   ///< the other one
    Index halfedge;
  };
  using Hole_ends = std::vector<Hole_end>;

  /// All ends, by hole and regions; holes that touch are one.
  template <class Surface, class Region, class Predicate>
  static Hole_ends find_hole_ends(const Surface& surface, const Region& region, const Predicate& is_between)
  {
    std::vector<Index> number_of_faces(surface.number_of_halfedges(), 0);
    for (Index face = 0; face < surface.number_of_faces(); ++face) {
      for (const Index h : face_halfedges(surface, face)) {
        ++number_of_faces[edge_of(surface, h)];
      }
    }
    Disjoint_sets holes(surface.number_of_vertices());
    Hole_ends ends;
    for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
      if (number_of_faces[edge_of(surface, h)] == 1) {
        holes.join(surface.origin(h), surface.target(h));
        if (is_between(h)) {
          ends.push_back({0, region(surface.origin(h)), region(surface.target(h)), h});
        }
      }
    }
    for (Hole_end& end : ends) {
      end.hole = holes.find(surface.origin(end.halfedge));
    }
    std::sort(ends.begin(), ends.end(), [](const Hole_end& a, const Hole_end& b) {
      return std::tie(a.hole, a.from, a.to, a.halfedge) < std::tie(b.hole, b.from, b.to, b.halfedge);
    });
    return ends;
  }

  template <class Surface, class Region, class Predicate>
  void join_at_holes(const Surface& surface, const Region& region, const Predicate& is_between)
  {
    const Hole_ends ends = find_hole_ends(surface, region, is_between);
    for (auto begin = ends.begin(); begin != ends.end();) {
      const auto end = std::find_if(begin, ends.end(), [&](const Hole_end& e) { return e.hole != begin->hole; });
      join_at_hole(surface, Hole_ends(begin, end));
      begin = end;
    }
  }

  /// Joins what ends at one hole. A region that has only one other beside it there is a finger of it into the hole, and
  /// the curve between the two goes on around its tip; without it, its neighbor may be one. What cannot be taken away
  /// like that meets in a point.
  template <class Surface>
  void join_at_hole(const Surface& surface, Hole_ends ends)
  {
    for (auto finger = find_finger(ends); finger != ends.end(); finger = find_finger(ends)) {
      const Index tip = finger->from;
      const auto rest = std::stable_partition(ends.begin(), ends.end(),
                                              [tip](const Hole_end& end) { return end.from != tip && end.to != tip; });
      join_ends(surface, Hole_ends(rest, ends.end()));
      ends.erase(rest, ends.end());
    }
    join_ends(surface, ends);
  }

  /// The first end of a region all of whose ends lead to the same other one. \pre `ends` are sorted
  static Hole_ends::iterator find_finger(Hole_ends& ends)
  {
    for (auto begin = ends.begin(); begin != ends.end();) {
      const auto end = std::find_if(begin, ends.end(), [&](const Hole_end& e) { return e.from != begin->from; });
      if (begin->to == std::prev(end)->to) {
        return begin;
      }
      begin = end;
    }
    return ends.end();
  }

  /// Joins all of `ends`, and the border cycles of each region there. \pre they are sorted
  template <class Surface>
  void join_ends(const Surface& surface, const Hole_ends& ends)
  {
    for (std::size_t i = 1; i < ends.size(); ++i) {
      m_networks.join(edge_of(surface, ends[i - 1].halfedge), edge_of(surface, ends[i].halfedge));
      if (ends[i - 1].from == ends[i].from) {
        m_cycles.join(ends[i - 1].halfedge, ends[i].halfedge);
      }
    }
  }

  Disjoint_sets m_networks; ///< of edges between regions
  Disjoint_sets m_cycles;   ///< of halfedges that leave a region
  std::vector<std::vector<Index>> m_meetings;
};

/// The regions that meet at each part of the network between them, two at least.
template <class Triangulation, class Region>
std::vector<std::vector<Index>> region_meetings(const Triangulation& surface, const Region& region)
{
  return Quotient_graph(surface, region).meetings();
}

/// The first Betti number of the graph that joins regions where they meet.
inline std::size_t count_cycles(const std::vector<std::vector<Index>>& meetings)
{
  Index number_of_regions = 0;
  for (const std::vector<Index>& meeting : meetings) {
    number_of_regions = std::max(number_of_regions, *std::max_element(meeting.begin(), meeting.end()) + 1);
  }
  Disjoint_sets joined(number_of_regions + meetings.size());
  std::size_t result = 0;
  for (Index i = 0; i < meetings.size(); ++i) {
    for (const Index region : meetings[i]) {
      result += joined.join(number_of_regions + i, region) ? 0 : 1;
    }
  }
  return result;
}

/// The same of points. Where there are cycles, those of the closed surface that the complex is a part of are counted
/// too: if they are fewer, holes or bridges between sheets have made some, and regions meet as they do there.
template <class Region>
std::vector<std::vector<Index>> region_meetings(const Point_complex& complex, const Region& region)
{
  std::vector<std::vector<Index>> meetings = Quotient_graph(complex, region).meetings();
  const std::size_t number_of_cycles = count_cycles(meetings);
  if (number_of_cycles == 0) {
    return meetings;
  }
  const Closed_complex closed(complex);
  const std::vector<Index> regions = closed.regions(region);
  std::vector<std::vector<Index>> closed_meetings =
      Quotient_graph(closed.surface(), [&regions](Index vertex) { return regions[vertex]; }).meetings();
  return count_cycles(closed_meetings) < number_of_cycles ? closed_meetings : meetings;
}

/// The same in a graph, which has no faces: its cycles of three or four edges take their place.
class Graph_region_meetings
{
public:
  template <class Region>
  Graph_region_meetings(const Spatial_graph& graph, const Region& region)
      : m_graph(graph), m_networks(graph.number_of_halfedges()), m_cycles(graph.number_of_halfedges()),
        m_halfedge_to(graph.number_of_vertices(), no_index)
  {
    for (Index a = 0; a < graph.number_of_vertices(); ++a) {
      join_at_vertex(region, a);
    }
    m_meetings = collect_meetings(graph, region, m_networks, m_cycles);
  }

  std::vector<std::vector<Index>> meetings() && { return std::move(m_meetings); }

private:
  /// Joins what is connected by cycles of three or four edges with two edges at `a`.
  template <class Region>
  void join_at_vertex(const Region& region, Index a)
  {
    for (const Index h : m_graph.outgoing(a)) {
      m_halfedge_to[m_graph.target(h)] = h;
    }
    for (const Index h : m_graph.outgoing(a)) {
      const Index b = m_graph.target(h);
      for (const Index side : m_graph.outgoing(b)) {
        const Index c = m_graph.target(side);
        if (m_halfedge_to[c] != no_index && b < c) {
          join(region, {h, side, m_graph.twin(m_halfedge_to[c])});
        }
        for (const Index opposite : m_graph.outgoing(c)) {
          const Index d = m_graph.target(opposite);
          if (a < c && b < d && m_halfedge_to[d] != no_index && m_halfedge_to[c] == no_index &&
              !m_graph.is_adjacent(b, d)) {
            join_square(region, {h, side, opposite, m_graph.twin(m_halfedge_to[d])});
          }
        }
      }
    }
    for (const Index h : m_graph.outgoing(a)) {
      m_halfedge_to[m_graph.target(h)] = no_index;
    }
  }

  /// As `join()`; where two opposite corners are in one region, and the others in two, these do not meet: it is
  /// between.
  template <class Region>
  void join_square(const Region& region, const std::array<Index, 4>& sides)
  {
    std::array<Index, 4> corner{};
    std::transform(sides.begin(), sides.end(), corner.begin(), [&](Index h) { return region(m_graph.origin(h)); });
    if (corner[0] == corner[2] && corner[1] != corner[3]) {
      join(region, {sides[0], sides[1]});
      join(region, {sides[2], sides[3]});
    } else if (corner[1] == corner[3] && corner[0] != corner[2]) {
      join(region, {sides[1], sides[2]});
      join(region, {sides[3], sides[0]});
    } else {
      join(region, {sides[0], sides[1], sides[2], sides[3]});
    }
  }

  /// Joins the edges between regions among those of a cycle, and the halfedges among them that leave one region.
  template <class Region>
  void join(const Region& region, std::initializer_list<Index> cycle)
  {
    Index first = no_index;
    std::array<Index, 8> leaving{}; // two for each edge
    std::size_t size = 0;
    for (const Index h : cycle) {
      if (region(m_graph.origin(h)) == region(m_graph.target(h))) {
        continue;
      }
      if (first == no_index) {
        first = h;
      }
      m_networks.join(edge_of(m_graph, first), edge_of(m_graph, h));
      for (const Index leaves : {h, m_graph.twin(h)}) {
        for (std::size_t i = 0; i < size; ++i) {
          if (region(m_graph.origin(leaving[i])) == region(m_graph.origin(leaves))) {
            m_cycles.join(leaving[i], leaves);
          }
        }
        leaving[size++] = leaves;
      }
    }
  }

  const Spatial_graph& m_graph;
  Disjoint_sets m_networks;         ///< of edges between regions
  Disjoint_sets m_cycles;           ///< of halfedges that leave a region
  std::vector<Index> m_halfedge_to; ///< from the vertex that is looked at to its neighbors
  std::vector<std::vector<Index>> m_meetings;
};

template <class Region>
std::vector<std::vector<Index>> region_meetings(const Spatial_graph& graph, const Region& region)
{
  return Graph_region_meetings(graph, region).meetings();
}

/// The radius of what a vertex stands for: nothing but itself on a surface.
template <class Triangulation>
double vertex_radius(const Triangulation& /* surface */, Index /* vertex */)
{
  return 0;
}
inline double vertex_radius(const Spatial_graph& graph, Index vertex)
{
  return graph.radius(vertex);
}

/// What is particular to graphs, once regions are joined.
class Graph_skeleton_finishing
{
public:
  Graph_skeleton_finishing(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder)
      : m_graph(graph), m_regions(regions), m_builder(builder)
  {
  }

  void operator()()
  {
    prune_bumps();
    center();
    m_builder.compact();
  }

private:
  /// How far a tip reaches from the junction that it hangs on if it is only a bump, in radii of the junction. Chosen on
  /// dino, elephant and a torus of nine handles: with 1.3 tubes have tips aside, with 2 blunt limbs are lost.
  static constexpr double bump_reach = 1.6;
  /// The part that the separator has in the place of a node inside a branch; the region has the rest. The region of a
  /// separator between oblique ones is a wedge, whose centroid is off the axis; chosen on the same shapes.
  static constexpr double separator_part = 0.5;

  void prune_bumps()
  {
    std::vector<char> is_wire_end(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_graph.number_of_vertices(); ++vertex) {
      if (m_graph.outgoing(vertex).size() == 1) {
        is_wire_end[m_regions[vertex]] = 1;
      }
    }
    for (Index node = 0; node < m_regions.size(); ++node) {
      if (m_builder.degree(node) != 1 || is_wire_end[node] != 0) {
        continue;
      }
      const Index junction = m_builder[node].neighbors.front();
      if (m_builder.is_junction(junction) &&
          m_builder.edge_length(node, junction) + m_builder[node].radius < bump_reach * m_builder[junction].radius) {
        m_builder.contract(node, junction);
      }
    }
    // Nodes between regions that no longer join three.
    for (Index node = m_regions.size(); node < m_builder.size(); ++node) {
      const std::vector<Index>& neighbors = m_builder[node].neighbors;
      if (neighbors.size() == 2 && neighbors[0] != neighbors[1]) {
        m_builder.bypass(node);
      }
    }
  }

  void center()
  {
    std::vector<Vector_3> sum(m_regions.size(), Vector_3::Zero());
    std::vector<double> length(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_graph.number_of_vertices(); ++vertex) {
      if (m_regions.is_on_separator(vertex)) {
        const double extent = std::sqrt(m_graph.vertex_area(vertex));
        sum[m_regions[vertex]] += extent * m_graph.points()[vertex];
        length[m_regions[vertex]] += extent;
      }
    }
    for (Index node = 0; node < m_regions.size(); ++node) {
      if (m_builder.is_regular(node) && length[node] > 0) {
        Vector_3& position = m_builder[node].position;
        position = (1 - separator_part) * position + separator_part * (sum[node] / length[node]);
      }
    }
  }

  const Spatial_graph& m_graph;
  const Separator_regions& m_regions;
  Skeleton_builder& m_builder;
};

/// Moves into the body what is outside, and counts the rest.
template <class Surface>
void finish_skeleton(const Surface& surface, const Separator_regions& /* regions */, Skeleton_builder& builder,
                     Skeletonization_report& report)
{
  make_simple(builder);
  Inside_routing routing(surface, builder);
  routing.bring_inside();
  routing.route_edges();
  routing.route_edges(true);
  builder.compact();
  const auto outside = routing.count_outside();
  report.number_of_nodes_outside = outside.number_of_nodes;
  report.number_of_edges_outside = outside.number_of_edges;
}
/// A graph bounds no body.
inline void finish_skeleton(const Spatial_graph& graph, const Separator_regions& regions, Skeleton_builder& builder,
                            Skeletonization_report& /* report */)
{
  Graph_skeleton_finishing(graph, regions, builder)();
  make_simple(builder);
}

/// Builds the skeleton whose nodes are the regions of the packed separators: at their centroids by area (Alg. 2, lines
/// 13 and 14), joined where regions touch.
/// \tparam Surface a model of `SkeletonizationSurface`, or `Spatial_graph`
template <class Surface>
class Quotient_skeleton_builder
{
public:
  /// \param place_nodes is called with the nodes of all regions, joined, to place some of them otherwise
  Quotient_skeleton_builder(const Surface& surface, const Separator_regions& regions,
                            std::function<void(Skeleton_builder&)> place_nodes = nullptr)
      : m_surface(surface), m_triangulation(surface.triangulation()), m_regions(regions),
        m_place_nodes(std::move(place_nodes))
  {
  }

  Embedded_skeleton operator()(Skeletonization_report& report)
  {
    Embedded_skeleton result;
    Skeleton_builder& builder = result.graph;
    place_regions(builder);
    for (const std::vector<Index>& meeting :
         region_meetings(m_triangulation, [this](Index vertex) { return m_regions[vertex]; })) {
      connect(builder, meeting);
    }
    if (m_place_nodes) {
      m_place_nodes(builder);
    }
    finish_skeleton(m_surface, m_regions, builder, report);
    assign_vertices(result);
    return result;
  }

private:
  /// The node of region i is node i of the builder.
  void place_regions(Skeleton_builder& builder)
  {
    std::vector<Vector_3> sum(m_regions.size(), Vector_3::Zero());
    std::vector<Vector_3> plain_sum(m_regions.size(), Vector_3::Zero());
    std::vector<double> area(m_regions.size(), 0);
    std::vector<std::size_t> count(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_triangulation.number_of_vertices(); ++vertex) {
      const Index region = m_regions[vertex];
      sum[region] += double(m_triangulation.vertex_area(vertex)) * m_triangulation.points()[vertex];
      area[region] += double(m_triangulation.vertex_area(vertex));
      plain_sum[region] += m_triangulation.points()[vertex];
      ++count[region];
    }
    for (Index region = 0; region < m_regions.size(); ++region) {
      // A region may have no area, where a border was bridged.
      const Vector_3 center =
          area[region] > 0 ? Vector_3(sum[region] / area[region]) : Vector_3(plain_sum[region] / double(count[region]));
      builder[builder.add_node(center, 0)].separators = {region};
    }
    m_area = std::move(area);
    const std::vector<double> radius = radii([this](Index vertex) { return m_regions[vertex]; }, builder);
    for (Index region = 0; region < m_regions.size(); ++region) {
      builder[region].radius = radius[region];
    }
  }

  void connect(Skeleton_builder& builder, const std::vector<Index>& meeting)
  {
    if (meeting.size() == 2) {
      builder.add_edge(meeting[0], meeting[1]);
      return;
    }
    Vector_3 sum = Vector_3::Zero();
    double radius = 0;
    double area = 0;
    for (Index region : meeting) {
      sum += m_area[region] * builder[region].position;
      radius += m_area[region] * builder[region].radius;
      area += m_area[region];
    }
    const Index junction =
        area > 0 ? builder.add_node(sum / area, radius / area) : builder.add_node(builder[meeting.front()].position, 0);
    for (Index region : meeting) {
      builder.add_edge(junction, region);
    }
  }

  /// Each vertex belongs to the node of its region, or to the tip of that, if it is nearer.
  void assign_vertices(Embedded_skeleton& skeleton) const
  {
    const Skeleton_builder& builder = skeleton.graph;
    std::vector<std::vector<Index>> nodes_of_region(m_regions.size());
    for (Index node = 0; node < builder.size(); ++node) {
      for (const std::vector<Index>* regions : {&builder[node].separators, &builder[node].pieces}) {
        for (Index region : *regions) {
          nodes_of_region[region].push_back(node);
        }
      }
    }
    skeleton.node_of_vertex.resize(m_triangulation.number_of_vertices());
    for (Index vertex = 0; vertex < m_triangulation.number_of_vertices(); ++vertex) {
      const std::vector<Index>& nodes = nodes_of_region[m_regions[vertex]];
      const auto distance = [&](Index node) {
        return (m_triangulation.points()[vertex] - builder[node].position).squaredNorm();
      };
      skeleton.node_of_vertex[vertex] =
          *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
    }
    skeleton.radius = radii([&](Index vertex) { return skeleton.node_of_vertex[vertex]; }, builder);
  }

  /// For each node, the median by area of the distances of its vertices; what the builder has where a node has no
  /// vertices.
  template <class NodeOfVertex>
  std::vector<double> radii(const NodeOfVertex& node_of_vertex, const Skeleton_builder& builder) const
  {
    std::vector<std::vector<std::pair<double, double>>> distances(builder.size());
    for (Index vertex = 0; vertex < m_triangulation.number_of_vertices(); ++vertex) {
      const Index node = node_of_vertex(vertex);
      distances[node].emplace_back((m_triangulation.points()[vertex] - builder[node].position).norm() +
                                       vertex_radius(m_triangulation, vertex),
                                   double(m_triangulation.vertex_area(vertex)));
    }
    std::vector<double> result(builder.size());
    for (Index node = 0; node < builder.size(); ++node) {
      result[node] = distances[node].empty() ? builder[node].radius : weighted_median(distances[node]);
    }
    return result;
  }

  /// The median of values with their weights; sorts them. \pre there is one
  static double weighted_median(std::vector<std::pair<double, double>>& values)
  {
    std::sort(values.begin(), values.end());
    double half = 0;
    for (const auto& value : values) {
      half += value.second / 2;
    }
    for (const auto& [value, weight] : values) {
      half -= weight;
      if (half <= 0) {
        return value;
      }
    }
    return values.back().first;
  }

  using Triangulation = std::decay_t<decltype(std::declval<const Surface&>().triangulation())>;

  const Surface& m_surface;
  const Triangulation& m_triangulation;
  const Separator_regions& m_regions;
  std::function<void(Skeleton_builder&)> m_place_nodes;
  std::vector<double> m_area;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_BUILD_QUOTIENT_SKELETON_H
