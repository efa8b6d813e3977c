// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ways inside the body for edges that leave it.

#ifndef CSCD_SKELETON_INSIDE_ROUTING_H
#define CSCD_SKELETON_INSIDE_ROUTING_H

#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CSCD::internal {

/// How deep the middle of the body is below `point` of the surface, at most `max_depth`; none at a face without area,
/// or where two lie upon each other. \param inward the direction, of unit length, or zero without an area
inline std::optional<double> depth_below(const Solid_queries& queries, const Vector3& point, const Vector3& inward,
                                         double max_depth)
{
  constexpr double relative_offset = 1e-9; // of the ray from the surface, in the unit of its area
  const std::optional<Surface_hit> hit =
      inward.squaredNorm() > 0 ? queries.first_hit(point + relative_offset * inward, inward) : std::nullopt;
  return hit ? std::optional<double>(std::min(hit->distance / 2, max_depth)) : std::nullopt;
}

/// Finds ways inside a body around its notches and holes: along its surface, and as far below it as there is room.
class Way_inside
{
public:
  /// \param solid is referred to
  explicit Way_inside(const Triangulated_solid& solid)
      : m_solid(solid), m_surface(solid.query_surface()), m_search(m_surface.number_of_faces()),
        m_entered(m_surface.number_of_faces(), no_index),
        m_work_left(free_work + max_work * m_surface.number_of_faces())
  {
  }

  /// Points inside such that each sees the next, the first one `from` and the last one `to`; none, where no way was
  /// found, or the ways before took too much work. \pre both are inside `component`
  std::vector<Vector3> find(const Vector3& from, const Vector3& to, Index component)
  {
    m_queries = &m_solid.queries(component);
    if (m_work_left == 0 || !trace_surface(from, to)) {
      return {};
    }
    m_max_depth = (to - from).norm();
    std::vector<Vector3> way;
    Vector3 here = from;
    std::size_t first = 0; // the start that the way has come to, ...
    int level = -1;        // ... halvings of the depth there
    while (!sees(here, to)) {
      // The deepest point that can be seen from here, far ones first, and always the next one; of the last start, a
      // point nearer to the surface.
      std::optional<Vector3> next;
      for (int halvings = 0; !next && halvings <= max_halvings; ++halvings) {
        for (std::size_t step = m_starts.size() - first; !next && step > 0;
             step = step > 2 ? (step + 1) / 2 : step - 1) {
          const std::optional<Vector3> point = below(m_starts[first + step - 1], halvings);
          if (point && (step > 1 || halvings > level) && sees(here, *point)) {
            next = point;
            first += step - 1;
            level = halvings;
          }
        }
      }
      if (!next || way.size() > max_number_of_nodes || m_work_left == 0) {
        return {};
      }
      way.push_back(*next);
      here = *next;
    }
    return way;
  }

private:
  /// Faces passed and lines traced, over all ways, for each face of the surface.
  static constexpr std::size_t max_work = 8;
  /// Further faces and lines on any surface: about a second where each line meets thousands of faces.
  static constexpr std::size_t free_work = 1 << 12;
  /// A way of more nodes would not be a good skeleton.
  static constexpr std::size_t max_number_of_nodes = 64;
  /// Halvings of the depth below the surface, where the way is not free.
  static constexpr int max_halvings = 12;

  /// A point of the surface, from where one goes inwards.
  struct Start
  {
    Vector3 point;
    Vector3 inward; ///< of unit length
  };

  void count_work() { m_work_left -= m_work_left > 0 ? 1 : 0; }

  /// Writes the way on the surface from where the segment leaves the body first to where it enters it last to
  /// `m_starts`. \return false if there is none
  bool trace_surface(const Vector3& from, const Vector3& to)
  {
    m_starts.clear();
    m_queries->crossings(from, to, m_crossings);
    if (m_crossings.size() < 2) {
      return false;
    }
    const Vector3 direction = (to - from).normalized();
    const Surface_point leaving = m_queries->closest_point(from + m_crossings.front() * direction);
    const Surface_point entering = m_queries->closest_point(from + m_crossings.back() * direction);
    if (!search_faces(entering.face, leaving.face)) {
      return false;
    }
    m_starts.push_back({leaving.point, inward_of(leaving.face)});
    for (Index face = leaving.face; face != entering.face;) {
      m_starts.push_back({center_of(face), inward_of(face)});
      const Index h = m_entered[face]; // of the next face
      const Index next = Triangulated_surface::face(h);
      m_starts.push_back({(m_surface.point(m_surface.origin(h)) + m_surface.point(m_surface.target(h))) / 2,
                          (inward_of(face) + inward_of(next)).normalized()});
      face = next;
    }
    m_starts.push_back({center_of(entering.face), inward_of(entering.face)});
    m_starts.push_back({entering.point, inward_of(entering.face)});
    return true;
  }

  /// Searches for the shortest way over centers of faces, backwards, so that `m_entered` has for each face on it the
  /// halfedge of the next one. \return whether there is one
  bool search_faces(Index first, Index last)
  {
    bool is_found = false;
    m_search.clear();
    m_search.reach(first, 0);
    m_search.spread([&](Index face, float distance) {
      count_work();
      is_found = face == last;
      if (is_found || m_work_left == 0) {
        m_search.clear();
        return;
      }
      const Vector3 center = center_of(face);
      for (const Index h : Triangulated_surface::face_halfedges(face)) {
        const Index neighbor = Triangulated_surface::face(m_surface.twin(h));
        if (m_search.reach(neighbor, distance + float((center_of(neighbor) - center).norm()))) {
          m_entered[neighbor] = h;
        }
      }
    });
    return is_found;
  }

  /// The middle of the body below `start`, or a point as far away as the ends of the way are from each other, where the
  /// body is thicker; or as many times nearer.
  std::optional<Vector3> below(const Start& start, int halvings)
  {
    count_work();
    const std::optional<double> depth = depth_below(*m_queries, start.point, start.inward, m_max_depth);
    return depth ? std::optional<Vector3>(start.point + std::ldexp(*depth, -halvings) * start.inward) : std::nullopt;
  }

  /// Whether the segment is free in both directions: along faces that touch, the answers may differ.
  bool sees(const Vector3& from, const Vector3& to)
  {
    count_work();
    m_queries->crossings(from, to, m_crossings);
    if (m_crossings.empty()) {
      m_queries->crossings(to, from, m_crossings);
    }
    return m_crossings.empty();
  }

  Vector3 center_of(Index face) const
  {
    return (m_surface.point(m_surface.origin(3 * face)) + m_surface.point(m_surface.target(3 * face)) +
            m_surface.point(m_surface.opposite_vertex(3 * face))) /
           3;
  }

  Vector3 inward_of(Index face) const { return -m_surface.face_normal(face); }

  const Triangulated_solid& m_solid;
  const Triangulated_surface& m_surface;
  const Solid_queries* m_queries = nullptr; ///< of the component of the way
  Dijkstra_search m_search;                 ///< over faces
  std::vector<Index> m_entered;             ///< for every face, the halfedge of the next one on the way
  std::vector<Start> m_starts;              ///< along the way on the surface
  std::vector<double> m_crossings;          ///< working memory
  double m_max_depth = 0;                   ///< of points of the way below the surface
  std::size_t m_work_left;
};

/// Keeps the nodes and edges of a skeleton inside the body.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Inside_routing
{
public:
  /// Both are referred to.
  Inside_routing(const Surface& surface, Skeleton_builder& graph)
      : m_surface(surface), m_graph(graph),
        m_offset(relative_offset * Bounding_box(surface.triangulation().points()).diagonal())
  {
  }

  /// Moves nodes that are outside to the middle of the body nearby; a junction, such as the one between a handle and
  /// the wall of a cup, to the middle of its neighbors or of the body behind them.
  void bring_inside()
  {
    for (Index node = 0; node < m_graph.size(); ++node) {
      if (is_outside(node)) {
        const Vector3 start = m_graph.is_junction(node) ? m_graph.middle_of_neighbors(node) : m_graph[node].position;
        const std::optional<Vector3> place =
            m_graph.is_junction(node) && body(node).is_inside(start) ? start : middle_behind(start, node);
        m_graph[node].position = place.value_or(m_graph[node].position);
      }
    }
  }

  /// Leads all edges inside, as far as that is possible; if `is_on_sheets`, exactly the edges of sheets, else all
  /// others.
  void route_edges(bool is_on_sheets = false)
  {
    for (const auto& [a, b] : m_graph.edges()) {
      if (is_on_sheets == (m_graph[a].is_on_sheet || m_graph[b].is_on_sheet)) {
        route(a, b);
      }
    }
  }

  /// Whether the segment stays inside the component of `node`, if it starts there.
  bool is_free(Index node, const Vector3& from, const Vector3& to)
  {
    body(node).crossings(from, to, m_crossings);
    return m_crossings.empty();
  }
  /// Whether the edge stays inside. At an opening, where no surface decides, it does.
  bool is_free(Index a, Index b)
  {
    // Along a face, the answer may depend on the direction: it is always the same one.
    const auto [first, second] = std::minmax(a, b);
    return m_graph[a].is_opening || m_graph[b].is_opening ||
           is_free(a, m_graph[first].position, m_graph[second].position);
  }

  /// Writes to `report` how many nodes and edges are not wholly inside.
  void count_outside(Skeletonization_report& report)
  {
    report.number_of_nodes_outside = 0;
    report.number_of_edges_outside = 0;
    std::vector<char> is_node_outside(m_graph.size());
    for (Index node = 0; node < m_graph.size(); ++node) {
      is_node_outside[node] = is_outside(node) ? 1 : 0;
      report.number_of_nodes_outside += is_node_outside[node] != 0 ? 1 : 0;
    }
    for (const auto& [a, b] : m_graph.edges()) {
      report.number_of_edges_outside += first_stretch_outside(a, b, is_node_outside[a] != 0) ? 1 : 0;
    }
  }

private:
  /// The body that `node` is to be inside: its component, where the surface has components.
  const auto& body([[maybe_unused]] Index node) const
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      return m_surface.queries(m_graph[node].component);
    } else {
      return m_surface;
    }
  }

  /// How often an edge is bisected at points behind the surface that it meets: at a crease of a sheet, until its parts
  /// are about as short as the sheet is thick.
  static constexpr int max_bends = 7;
  /// Shorter stretches outside count as rounding; relative to the diagonal of the bounding box.
  static constexpr double relative_offset = 1e-7;

  /// Whether `node` is the only one of a component without thickness, such as a single triangle. That has no inside:
  /// rays would find another component.
  bool is_flat(Index node) const { return m_graph.degree(node) == 0 && m_graph[node].radius <= m_offset; }

  bool is_outside(Index node) const
  {
    const Skeleton_builder::Node& its = m_graph[node];
    return !its.is_removed() && !its.is_opening && (is_flat(node) || !body(node).is_inside(its.position));
  }

  /// The middle of the body behind `point`, which is at `node` or on an edge there.
  std::optional<Vector3> middle_behind(const Vector3& point, Index node) const
  {
    if (m_graph[node].is_on_sheet) {
      return middle_of_sheet(body(node), point, m_graph[node].radius);
    }
    return is_flat(node) ? std::nullopt : body(node).middle_behind(point);
  }

  /// The middle of the first stretch of the edge that is outside.
  std::optional<Vector3> first_stretch_outside(Index a, Index b, bool starts_outside)
  {
    if (is_free(a, b) && (!starts_outside || m_graph[b].is_opening)) {
      return std::nullopt;
    }
    const Vector3& from = m_graph[a].position;
    const Vector3& to = m_graph[b].position;
    const double length = (to - from).norm();
    body(a).crossings(from, to, m_crossings);
    m_crossings.push_back(length);
    bool is_stretch_outside = starts_outside;
    double last = 0;
    for (double crossing : m_crossings) {
      if (is_stretch_outside && crossing - last > m_offset) {
        return Vector3(from + (last + crossing) / (2 * length) * (to - from));
      }
      is_stretch_outside = !is_stretch_outside;
      last = crossing;
    }
    return std::nullopt;
  }

  /// Leads the edge from `a` to `b` along the surface where it leaves the body or, where that fails, straight ahead
  /// from a branch, or over the middle of the body behind its first stretch outside.
  void route(Index a, Index b, int level = 0)
  {
    if (is_free(a, b)) {
      return;
    }
    const std::optional<Vector3> stretch = first_stretch_outside(a, b, is_outside(a));
    if (!stretch) {
      return;
    }
    const bool is_in_body = !m_graph[a].is_on_sheet && !m_graph[b].is_on_sheet && !is_outside(a) && !is_outside(b);
    if ((is_in_body && (follow_surface(a, b) || go_ahead(a, b) || go_ahead(b, a))) || level == max_bends) {
      return;
    }
    if (const std::optional<Vector3> middle = middle_behind(*stretch, a)) {
      const Index node = m_graph.split_edge(a, b, *middle, mean_radius(a, b));
      route(a, node, level + 1);
      route(node, b, level + 1);
    }
  }

  /// Leads the edge over a point ahead of the branch that comes to `b`, if the ways there and on to `a` are free.
  /// \pre its ends are inside
  bool go_ahead(Index a, Index b)
  {
    if (!m_graph.is_regular(b)) {
      return false;
    }
    const Vector3 here = m_graph[b].position;
    const Vector3 there = m_graph[a].position;
    const Vector3 ahead = (here - m_graph[m_graph.other_neighbor(b, a)].position).normalized();
    const double length = m_graph.edge_length(a, b);
    for (double way = m_graph[b].radius; way > 0 && way < length; way *= 2) {
      const Vector3 point = here + way * ahead;
      if (!is_free(a, here, point)) {
        return false;
      }
      if (is_free(a, point, there)) {
        m_graph.split_edge(a, b, point, mean_radius(a, b));
        return true;
      }
    }
    return false;
  }

  /// Leads the edge along the surface, if there is a free way. \pre its ends are inside
  bool follow_surface([[maybe_unused]] Index a, [[maybe_unused]] Index b)
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      if (!m_way) {
        m_way.emplace(m_surface);
      }
      const std::vector<Vector3> points = m_way->find(m_graph[a].position, m_graph[b].position, m_graph[a].component);
      const double radius = mean_radius(a, b);
      for (const Vector3& point : points) {
        a = m_graph.split_edge(a, b, point, radius);
      }
      return !points.empty();
    } else {
      return false;
    }
  }

  double mean_radius(Index a, Index b) const { return (m_graph[a].radius + m_graph[b].radius) / 2; }

  const Surface& m_surface;
  Skeleton_builder& m_graph;
  double m_offset;
  std::optional<Way_inside> m_way; ///< none until an edge needs it
  std::vector<double> m_crossings; ///< working memory
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_ROUTING_H
