// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the regions of packed separators to a skeleton (algorithm 2, lines 13 to 15).

#ifndef CSCD_PUBLISHED_QUOTIENT_SKELETON_H
#define CSCD_PUBLISHED_QUOTIENT_SKELETON_H

#include <CSCD/Points/Point_solid.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

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

/// The graph of regions that touch (Alg. 2, line 14), with cliques removed and true small cycles kept. Near linear.
///
/// Regions meet in a network of curves between them. Where a connected part of the network is one closed curve, it has
/// a region on either side, which an edge joins. Where curves meet, at faces that have corners in three regions, all
/// regions around that part of the network meet, and a junction joins them in place of a clique of edges. A region
/// counts for every one of its border cycles: three regions around a thin handle, which meet in three separate curves,
/// stay a cycle. If all regions, and the neighborhoods of all parts of the network, are planar, the first Betti number
/// of the graph is the genus of the surface.
/// \tparam Surface a model of `SurfaceTriangulation`
/// \param region a function that returns the region of a vertex
/// \return for each connected part of the network, the regions of the border cycles around it, two at least; a region
///         with several cycles there stands several times
template <class Surface, class Region>
std::vector<std::vector<Index>> meetings_on_triangulation(const Surface& surface, const Region& region)
{
  Disjoint_sets networks(surface.number_of_halfedges()); // of edges between regions
  // Of halfedges that leave a region: its border cycle has a point on each of them.
  Disjoint_sets cycles(surface.number_of_halfedges());
  const auto is_between = [&](Index h) { return region(surface.origin(h)) != region(surface.target(h)); };
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Index before = Surface::previous(h);
    if (is_between(h) && is_between(before)) {
      networks.join(edge_of(surface, h), edge_of(surface, before));
      cycles.join(h, surface.twin(before));
      if (!is_between(Surface::next(h))) {
        // The corner lies alone in its region; the other two are on the other side.
        cycles.join(surface.twin(h), before);
      }
    }
  }
  return collect_meetings(surface, region, networks, cycles);
}

/// Which vertices of a surface are in the largest connected part of their region; not those without a region.
inline std::vector<char> largest_parts(const Triangulated_surface& surface, const std::vector<Index>& region)
{
  const auto n = Index(region.size());
  Index number_of_parts = 0;
  const std::vector<Index> part =
      parts_of_regions(surface, [&region](Index vertex) { return region[vertex]; }).numbers(number_of_parts);
  std::vector<Index> size(number_of_parts, 0);
  for (const Index its_part : part) {
    ++size[its_part];
  }
  std::map<Index, Index> largest; // of each region, the part; the first one, of several
  for (Index vertex = 0; vertex < n; ++vertex) {
    Index& best = largest.emplace(region[vertex], part[vertex]).first->second;
    best = size[part[vertex]] > size[best] ? part[vertex] : best;
  }
  std::vector<char> result(n, 0);
  for (Index vertex = 0; vertex < n; ++vertex) {
    result[vertex] = region[vertex] != no_index && largest[region[vertex]] == part[vertex] ? 1 : 0;
  }
  return result;
}

/// For each vertex of the closed surface of a complex, its region; each region is connected. `no_index` in components
/// where no region has its largest part. O(n log n).
/// \param region returns the region of a vertex of the complex
template <class Region>
std::vector<Index> regions_on(const Closed_complex& closed, const Region& region)
{
  const Triangulated_surface& surface = closed.surface;
  std::vector<Index> result(surface.number_of_vertices(), no_index);
  for (Index vertex = 0; vertex < result.size(); ++vertex) {
    const Index in_complex = closed.vertex_in_complex[vertex];
    result[vertex] = in_complex != no_index ? region(in_complex) : no_index;
  }
  const std::vector<char> is_kept = largest_parts(surface, result);
  Multi_source_dijkstra_search front(result.size());
  for (Index vertex = 0; vertex < result.size(); ++vertex) {
    if (is_kept[vertex] != 0) {
      front.reach(vertex, 0, result[vertex]);
    }
  }
  front.spread([&surface](Index vertex, const auto& visit) {
    for (const Index halfedge : surface.outgoing(vertex)) {
      visit(surface.target(halfedge), float(surface.length(halfedge)));
    }
  });
  for (Index vertex = 0; vertex < result.size(); ++vertex) {
    result[vertex] = front.label(vertex);
  }
  return result;
}

/// Where regions meet on the triangulation of a surface.
template <class Surface, class Region>
std::vector<std::vector<Index>> region_meetings(const Surface& surface, const Region& region)
{
  return meetings_on_triangulation(surface.triangulation(), region);
}
/// The same of points: on the closed surface that their triangles are a part of, since holes and bridges between sheets
/// would make cycles.
template <class Region>
std::vector<std::vector<Index>> region_meetings(const Point_solid& solid, const Region& region)
{
  const std::vector<Index> regions = regions_on(solid.closed(), region);
  return meetings_on_triangulation(solid.closed().surface, [&regions](Index vertex) { return regions[vertex]; });
}

/// The radius of what a vertex stands for: nothing but itself on a surface. There are overloads of this, of
/// `region_meetings()` and of `finish_skeleton()` for graphs.
template <class Triangulation>
double vertex_radius(const Triangulation& /* surface */, Index /* vertex */)
{
  return 0;
}
/// Moves nodes and edges into the body, and counts those that stay outside.
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
  routing.count_outside(report);
}
/// Builds the skeleton whose nodes are the regions of the packed separators: at their centroids by area (Alg. 2, lines
/// 13 and 14), joined where regions touch.
/// \tparam Surface a model of `SkeletonizationSurface`, or a type with the overloads above, found by its namespace
template <class Surface>
class Quotient_skeleton_builder
{
public:
  Quotient_skeleton_builder(const Surface& surface, const Separator_regions& regions)
      : m_surface(surface), m_triangulation(surface.triangulation()), m_regions(regions)
  {
  }

  Embedded_skeleton operator()(Skeletonization_report& report)
  {
    Embedded_skeleton result;
    Skeleton_builder& builder = result.graph;
    place_regions(builder);
    for (const std::vector<Index>& meeting :
         region_meetings(m_surface, [this](Index vertex) { return m_regions[vertex]; })) {
      connect(builder, meeting);
    }
    finish_skeleton(m_surface, m_regions, builder, report);
    assign_vertices(result);
    return result;
  }

private:
  /// The node of region i is node i of the builder.
  void place_regions(Skeleton_builder& builder)
  {
    std::vector<Vector3> sum(m_regions.size(), Vector3::Zero());
    std::vector<Vector3> plain_sum(m_regions.size(), Vector3::Zero());
    m_area.assign(m_regions.size(), 0);
    std::vector<std::size_t> count(m_regions.size(), 0);
    for (Index vertex = 0; vertex < m_triangulation.number_of_vertices(); ++vertex) {
      const Index region = m_regions[vertex];
      sum[region] += double(m_triangulation.vertex_area(vertex)) * m_triangulation.points()[vertex];
      m_area[region] += double(m_triangulation.vertex_area(vertex));
      plain_sum[region] += m_triangulation.points()[vertex];
      ++count[region];
    }
    for (Index region = 0; region < m_regions.size(); ++region) {
      // A region may have no area, where a border was bridged.
      const Vector3 center = m_area[region] > 0 ? Vector3(sum[region] / m_area[region])
                                                : Vector3(plain_sum[region] / double(count[region]));
      builder[builder.add_node(center, 0)].pieces = {region};
    }
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
    Vector3 sum = Vector3::Zero();
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
      for (Index region : builder[node].pieces) {
        nodes_of_region[region].push_back(node);
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
  std::vector<double> m_area;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_QUOTIENT_SKELETON_H
