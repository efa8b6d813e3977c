// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the cut graph to a graph in space: a node for each separator and each junction.

#ifndef CSCD_SKELETON_CUT_GRAPH_NODES_H
#define CSCD_SKELETON_CUT_GRAPH_NODES_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Loops_across.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton/Inside_routing.h>
#include <CSCD/Skeleton/Sheet_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Iterator_range.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// The surface cut along its packed separators. The objects that it refers to outlive it.
struct Cut_solid
{
  const Triangulated_solid& solid;
  const std::vector<Separator>& all_separators;
  const std::vector<Index>& packed;
  const Cut_graph& cut_graph;

  /// The packed separator at position `i`.
  const Separator& separator(Index i) const { return all_separators[packed[i]]; }
  /// The positions of the separators around `piece`.
  const std::vector<Index>& around(Index piece) const { return cut_graph.pieces()[piece].separators; }
  Index number_of_pieces() const { return Index(cut_graph.pieces().size()); }
};

/// The vertices of each piece, on the level of the queries.
class Piece_vertices
{
public:
  explicit Piece_vertices(const Cut_solid& cut) : m_surface(cut.solid.query_surface())
  {
    const Surface_level& level = cut.solid.query_level();
    m_vertices = Compressed_rows<Index>(cut.number_of_pieces(), [&](const auto& add) {
      for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
        add(cut.cut_graph.piece_of_vertex(level.to_finest(vertex)), vertex);
      }
    });
    m_refinement = double(cut.solid.triangulation().number_of_vertices()) / m_surface.number_of_vertices();
  }

  /// The vertices of `piece`; none in a piece that is smaller than the triangles of the level.
  CGAL::Iterator_range<const Index*> operator[](Index piece) const { return m_vertices[piece]; }
  /// About how many vertices of the finest level `piece` has.
  double number_of_vertices(Index piece) const { return m_refinement * m_vertices.size(piece); }

  const Vector3& point(Index vertex) const { return m_surface.point(vertex); }

  /// The centroid by area, if the piece has vertices.
  std::optional<Vector3> centroid(Index piece) const
  {
    Vector3 sum = Vector3::Zero();
    double weight = 0;
    for (Index vertex : m_vertices[piece]) {
      sum += double(m_surface.vertex_area(vertex)) * point(vertex);
      weight += double(m_surface.vertex_area(vertex));
    }
    return weight > 0 ? std::optional<Vector3>(sum / weight) : std::nullopt;
  }

  /// The point of `piece` that is farthest from `center`.
  Vector3 farthest(Index piece, const Vector3& center) const
  {
    Vector3 result = center;
    for (Index vertex : m_vertices[piece]) {
      if ((point(vertex) - center).squaredNorm() > (result - center).squaredNorm()) {
        result = point(vertex);
      }
    }
    return result;
  }

  /// The largest extent of `piece` from `origin` in `direction`; 0 if it does not reach beyond `origin`.
  double extent(Index piece, const Vector3& origin, const Vector3& direction) const
  {
    double result = 0;
    for (Index vertex : m_vertices[piece]) {
      result = std::max(result, direction.dot(point(vertex) - origin));
    }
    return result;
  }

private:
  const Triangulated_surface& m_surface;
  Compressed_rows<Index> m_vertices;
  double m_refinement; ///< vertices of the finest level for each one of this level
};

/// Finds cycles that pass one separator only, such as those around holes that were drilled into a body: one piece of
/// the surface has both sides of the separator.
class Handle_cycle
{
public:
  /// O(n) for n edges of the surface. \param cut is referred to
  explicit Handle_cycle(const Cut_solid& cut)
      : m_cut(cut), m_loops(cut.solid.triangulation(), cut.all_separators, cut.packed)
  {
  }

  /// Points inside the body on the cycle through the separator at position `i`, in order, the first one next to it. The
  /// cycle follows the shortest loop on the surface across the separator or, if the separator rather than this loop
  /// surrounds a hole, the separator. O(n log n) for n vertices nearer than the loop is long.
  std::vector<Vector3> operator()(Index i)
  {
    const Triangulated_surface& surface = m_cut.solid.triangulation();
    const std::vector<Edge_crossing>& crossings = m_cut.separator(i).crossings;
    m_queries = &m_cut.solid.queries(m_cut.solid.component(m_cut.separator(i).source));
    std::vector<Vector3> outline;
    crossing_points(surface, crossings, outline);
    const Loops_across::Loop loop = m_loops.find(i, false, std::numeric_limits<float>::infinity());
    if (loop.vertices.empty()) {
      return points_inside(outline);
    }
    const std::vector<Edge_crossing> curve = m_loops.curve(loop);
    std::vector<Vector3> points;
    crossing_points(surface, curve, points);
    // As the two cross once, one of them surrounds a hole. Where the surface intersects itself, their cones decide.
    const Linking linking(surface, crossings, curve);
    const bool is_along_separator =
        linking.is_consistent() ? linking.of_loop == 0 : inside_share(outline) < inside_share(points);
    return points_inside(is_along_separator ? outline : points);
  }

private:
  /// Of a cycle: fewer might not lead around the hole.
  static constexpr std::size_t number_of_nodes = 8;

  /// The share of the cone from the center of `curve` inside the body.
  double inside_share(const std::vector<Vector3>& curve) const
  {
    return span_inside_share(*m_queries, curve, measure_polygon(curve).center);
  }

  /// Points inside the body near those that divide the closed `curve` around a hole into parts of equal length; none
  /// where there would be fewer than three.
  std::vector<Vector3> points_inside(const std::vector<Vector3>& curve) const
  {
    const Polygon_measures measures = measure_polygon(curve);
    const double part_length = measures.length / double(number_of_nodes);
    std::vector<Vector3> points;
    double passed = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vector3 way = curve[(i + 1) % curve.size()] - curve[i];
      const double length = way.norm();
      while (points.size() < number_of_nodes && double(points.size()) * part_length < passed + length) {
        const double part = (double(points.size()) * part_length - passed) / length;
        points.push_back(curve[i] + part * way);
      }
      passed += length;
    }
    std::vector<Vector3> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3 way = points[(i + 1) % points.size()] - points[(i + points.size() - 1) % points.size()];
      const std::optional<Vector3> inside = point_inside(points[i], way, measures);
      if (inside) {
        result.push_back(*inside);
      }
    }
    if (result.size() < 3) {
      return {};
    }
    move_to_middle(measures, result);
    return result;
  }

  /// Moves `cycle` along the axis of `curve`, a loop anywhere along a hole, to the middle of the way that is free for
  /// all of its points, and for the center in the hole.
  void move_to_middle(const Polygon_measures& curve, std::vector<Vector3>& cycle) const
  {
    const Vector3 axis = curve.vector_area.normalized();
    if (!(axis.squaredNorm() > 0)) {
      return;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto free_way = [&](const Vector3& point, const Vector3& direction) {
      const std::optional<Surface_hit> hit = m_queries->first_hit(point, direction);
      return hit ? hit->distance : infinity;
    };
    double forth = free_way(curve.center, axis);
    double back = free_way(curve.center, -axis);
    for (const Vector3& point : cycle) {
      forth = std::min(forth, free_way(point, axis));
      back = std::min(back, free_way(point, -axis));
    }
    if (forth < infinity && back < infinity) {
      for (Vector3& point : cycle) {
        point += (forth - back) / 2 * axis;
      }
    }
  }

  /// A point inside the body near `point` of `curve`, which goes `way` there around a hole, at most as far from the
  /// surface as a circle of its length from its center. As `point` may be on the edge of the hole, it is below the
  /// surface somewhat farther out: for a circle, by half of its radius. None where the body has no depth.
  std::optional<Vector3> point_inside(const Vector3& point, const Vector3& way, const Polygon_measures& curve) const
  {
    const Vector3 outwards = way.cross(curve.vector_area).normalized();
    const Vector3 place = point + curve.vector_area.norm() / curve.length * outwards;
    const Surface_point foot = m_queries->closest_point(place);
    const Vector3 inward = m_queries->inward_direction(foot, place);
    const double radius = curve.length / (2 * boost::math::double_constants::pi);
    const std::optional<double> depth = depth_below(*m_queries, foot.point, inward, radius);
    return depth ? std::optional<Vector3>(foot.point + *depth * inward) : std::nullopt;
  }

  const Cut_solid& m_cut;
  Loops_across m_loops;
  const Solid_queries* m_queries = nullptr; ///< of the component of the cycle
};

/// Adds the nodes of separators, joins them where a piece lies between two, and adds a junction in each piece that has
/// three or more around it, and a node in each component without any. Parallel edges and loops may occur.
class Cut_graph_nodes
{
public:
  /// All are referred to.
  /// \pre `graph` is empty
  Cut_graph_nodes(const Cut_solid& cut, const Piece_vertices& pieces, Skeleton_builder& graph)
      : m_cut(cut), m_pieces(pieces), m_graph(graph), m_node_of_piece(cut.number_of_pieces(), no_index)
  {
    place_separators();
    for (Index piece = 0; piece < cut.number_of_pieces(); ++piece) {
      join_piece(piece);
    }
  }

  /// The node in the middle of `piece` or, without one, the node of its first separator.
  Index node_of_piece(Index piece) const
  {
    const Index own = m_node_of_piece[piece];
    return m_graph.last_heir(own != no_index ? own : m_cut.around(piece).front());
  }

private:
  /// The weight of the center of a separator for a junction, relative to its squared length.
  static constexpr double separator_weight = 0.1;
  /// Longer edges are bent, relative to the radius, ...
  static constexpr double min_bent_edge = 1;
  /// ... by less than this, likewise.
  static constexpr double max_bend = 0.85;
  /// The height of an arc, relative to its chord times the difference of the unit tangents at its ends: 1/8 of a flat
  /// arc, 1/4 of a half circle.
  static constexpr double arc_share = 0.2;

  /// Node i is that of the separator at position i.
  void place_separators()
  {
    std::vector<Vector3> outline;
    for (Index i = 0; i < m_cut.packed.size(); ++i) {
      const Separator& separator = m_cut.separator(i);
      crossing_points(m_cut.solid.triangulation(), separator.crossings, outline);
      const Section_disc disc = section_disc(outline);
      const Index node = m_graph.add_node(disc.center, disc.radius());
      m_graph[node].pieces = {m_cut.cut_graph.sides(i).left, m_cut.cut_graph.sides(i).right};
      m_graph[node].component = m_cut.solid.component(separator.source);
      place_on_sheet(m_cut.solid, separator, m_graph[node]);
    }
  }

  void join_piece(Index piece)
  {
    const std::vector<Index>& around = m_cut.around(piece);
    const double number_of_vertices = m_pieces.number_of_vertices(piece);
    const bool has_node = around.empty() || around.size() > 2;
    const double share = number_of_vertices / double(around.size() + (has_node ? 1 : 0));
    for (Index i : around) {
      m_graph[i].number_of_vertices += share;
    }
    if (has_node) {
      m_node_of_piece[piece] = add_middle(piece);
      m_graph[m_node_of_piece[piece]].number_of_vertices = share;
    } else if (around.size() == 2 && (around[0] != around[1] || !add_cycle(around[0], no_index))) {
      m_graph.add_edge(around[0], around[1]);
      bend_edge(around[0], around[1]);
    }
  }

  /// Adds a node in the middle of `piece`, joined to its separators.
  Index add_middle(Index piece)
  {
    Vector3 sum = Vector3::Zero();
    double weight = 0;
    double radius = 0;
    const auto add = [&](const Vector3& point, double point_weight) {
      sum += point_weight * point;
      weight += point_weight;
    };
    if (const std::optional<Vector3> centroid = m_pieces.centroid(piece)) {
      add(*centroid, m_cut.cut_graph.pieces()[piece].area);
    }
    for (Index i : m_cut.around(piece)) {
      const Separator& separator = m_cut.separator(i);
      add(separator.center, separator_weight * separator.length * separator.length);
      radius = std::max(radius, separator.radius());
    }
    const Vector3 position = weight > 0 ? Vector3(sum / weight) : m_pieces.point(*m_pieces[piece].begin());
    const Index node = m_graph.add_node(position, radius);
    m_graph[node].pieces = {piece};
    if (!m_cut.around(piece).empty()) {
      m_graph[node].component = m_graph[m_cut.around(piece).front()].component;
      join_separators(node, m_cut.around(piece));
    } else {
      const Index vertex = m_cut.solid.query_level().to_finest(*m_pieces[piece].begin());
      m_graph[node].component = m_cut.solid.component(vertex);
      m_graph[node].is_on_sheet = m_cut.solid.side_of_sheet(vertex) != 0;
      // Of a square sheet, which has two sides, half of the width.
      const double half_width = std::sqrt(m_cut.cut_graph.pieces()[piece].area / 8);
      const Solid_queries& body = m_cut.solid.queries(m_graph[node].component);
      m_graph[node].radius =
          m_graph[node].is_on_sheet ? half_width : (body.closest_point(position).point - position).norm();
    }
    return node;
  }

  /// Joins `node` to the separators `around` its piece. Where both sides of one belong to the piece, it is on a cycle.
  void join_separators(Index node, const std::vector<Index>& around)
  {
    for (std::size_t k = 0; k < around.size(); ++k) {
      const bool is_handle = k + 1 < around.size() && around[k + 1] == around[k];
      if (is_handle && add_cycle(around[k], node)) {
        ++k;
      } else {
        m_graph.add_edge(node, around[k]);
      }
    }
  }

  /// Adds the nodes of the cycle through the separator `i`. Unless `node` is `no_index`, it is joined to the nearest
  /// one. \return whether there is a cycle
  bool add_cycle(Index i, Index node)
  {
    if (m_graph[i].is_on_sheet) {
      return false;
    }
    if (!m_handle_cycle) {
      m_handle_cycle.emplace(m_cut);
    }
    const std::vector<Vector3> points = (*m_handle_cycle)(i);
    if (points.empty()) {
      return false;
    }
    m_graph[i].position = points.front();
    Index last = i;
    Index nearest = i;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Index next = m_graph.extend(last, points[k], m_graph[i].radius);
      last = next;
      if (node != no_index && m_graph.edge_length(node, next) < m_graph.edge_length(node, nearest)) {
        nearest = next;
      }
    }
    m_graph.add_edge(last, i);
    if (node != no_index) {
      m_graph.add_edge(node, nearest);
    }
    return true;
  }

  /// Leads a long edge over the middle of the arc that is perpendicular to the separators at its ends.
  void bend_edge(Index a, Index b)
  {
    const double radius = (m_graph[a].radius + m_graph[b].radius) / 2;
    const Vector3 way = m_graph[b].position - m_graph[a].position;
    const auto tangent = [&](Index i) {
      return std::copysign(1, m_cut.separator(i).normal.dot(way)) * m_cut.separator(i).normal;
    };
    const Vector3 aside = arc_share * way.norm() * (tangent(a) - tangent(b));
    const Vector3 point = (m_graph[a].position + m_graph[b].position) / 2 + aside;
    if (!m_graph[a].is_on_sheet && way.norm() >= min_bent_edge * radius && aside.norm() < max_bend * radius &&
        m_cut.solid.queries(m_graph[a].component).is_inside(point)) {
      m_graph.split_edge(a, b, point, radius);
    }
  }

  const Cut_solid& m_cut;
  const Piece_vertices& m_pieces;
  Skeleton_builder& m_graph;
  std::optional<Handle_cycle> m_handle_cycle; ///< none until there is such a cycle
  std::vector<Index> m_node_of_piece;         ///< `no_index` where only separators have nodes
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_CUT_GRAPH_NODES_H
