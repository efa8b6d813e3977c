// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where limbs end: at openings or by tips, and not in rims.

#ifndef CSCD_SKELETON_LIMB_ENDS_H
#define CSCD_SKELETON_LIMB_ENDS_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Cut_graph_nodes.h>
#include <CSCD/Skeleton/Limb_openings.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Leads branches to the ends of limbs. Those on sheets go on later, once they are centered.
class Limb_ends
{
public:
  /// All are referred to.
  Limb_ends(const Cut_solid& cut, const Piece_vertices& pieces, const Cut_graph_nodes& nodes, Skeleton_builder& graph)
      : m_cut(cut), m_pieces(pieces), m_nodes(nodes), m_graph(graph), m_openings(cut, pieces, graph)
  {
  }

  void operator()()
  {
    for (Index piece = 0; piece < m_cut.number_of_pieces(); ++piece) {
      m_openings.open(piece, m_nodes.node_of_piece(piece));
      add_tips(piece);
    }
  }

private:
  /// A component of a smaller radius, relative to the root of the area of the surface, is flat: inside tests are
  /// unreliable there.
  static constexpr double min_thickness = 1e-7;
  /// Tips stay this far below the surface, relative to the radius.
  static constexpr double tip_depth = 0.65;
  /// An edge to a tip has at least this length, likewise.
  static constexpr double min_tip_length = 0.3;
  /// The distance of the far end of a piece from its base, relative to the length of the ray and to the radius, from
  /// which on the ray does not decide.
  static constexpr double max_reach_of_end = 2;
  /// The part of a piece beyond this distance is far, relative to its farthest point.
  static constexpr double far_part = 0.6;
  /// A limb ends in a thin part if the surface is nearer to the tip than this, relative to its depth.
  static constexpr double max_thin_end = 0.6;

  void add_tips(Index piece)
  {
    const std::vector<Bridged_border>& openings = m_openings.of(piece);
    const std::size_t number_of_ways = m_cut.around(piece).size() + openings.size();
    const Index base = m_nodes.node_of_piece(piece);
    const Vector_3 start = m_graph[base].position;
    // From outside, tips would lead somewhere into the wall of a hollow body; from a component without thickness, into
    // another component.
    if (number_of_ways > 1 || !(m_graph[base].radius > min_thickness) || !m_cut.solid.is_inside(start)) {
      return;
    }
    if (!openings.empty()) {
      add_tip(piece, base, -openings.front().normal);
    } else if (number_of_ways == 1) {
      if (!m_graph[base].is_on_sheet) {
        end_limb(piece, base);
      }
    } else {
      const Vector_3 direction = (m_pieces.farthest(piece, start) - start).normalized();
      add_tip(piece, base, direction);
      add_tip(piece, base, -direction);
    }
  }

  /// The normal of the only separator of `piece`, into the piece.
  Vector_3 outward_normal(Index piece, Index base) const
  {
    const Vector_3& start = m_graph[base].position;
    const Vector_3& normal = m_cut.separator(m_cut.around(piece).front()).normal;
    Vector_3 way = normal;
    if (const std::optional<Vector_3> centroid = m_pieces.centroid(piece)) {
      way = *centroid - start;
    } else if (m_graph.degree(base) > 0) {
      way = start - m_graph[m_graph[base].neighbors[0]].position;
    }
    return normal.dot(way) < 0 ? Vector_3(-normal) : normal;
  }

  /// Adds a tip in the direction of the only separator of `piece`; where that meets a wall early, as in a cup, one
  /// towards the far part of the piece.
  void end_limb(Index piece, Index base)
  {
    const Vector_3& start = m_graph[base].position;
    const Vector_3 direction = outward_normal(piece, base);
    const double reach = std::max(distance_to_end(piece, base, direction), m_graph[base].radius);
    std::optional<Vector_3> far_end;
    if ((m_pieces.farthest(piece, start) - start).norm() > max_reach_of_end * reach) {
      far_end = far_end_of(piece, base);
    }
    if (far_end) {
      join_tip(piece, base, *far_end);
    } else {
      add_tip(piece, base, direction);
    }
  }

  /// Adds a tip in `direction` from `base`; if that is as near to the end, it becomes the tip.
  void add_tip(Index piece, Index base, const Vector_3& direction)
  {
    const double radius = m_graph[base].radius;
    const Vector_3 start = m_graph[base].position;
    const double reach = distance_to_end(piece, base, direction);
    const double length = reach - depth_of_tip(piece, start, direction, reach, radius);
    if (length >= min_tip_length * radius) {
      join_tip(piece, base, start + length * direction);
    } else if (length > 0 && m_graph.degree(base) == 1) {
      m_graph[base].position = start + length * direction;
    }
  }

  void join_tip(Index piece, Index base, const Vector_3& position)
  {
    const Index tip = m_graph.add_node(position, m_graph[base].radius);
    m_graph[tip].pieces = {piece};
    m_graph[tip].is_on_sheet = m_graph[base].is_on_sheet;
    m_graph.add_edge(base, tip);
  }

  double distance_to_end(Index piece, Index base, const Vector_3& direction) const
  {
    const Vector_3& start = m_graph[base].position;
    if (m_graph[base].is_on_sheet) {
      return m_pieces.extent(piece, start, direction); // the sheet may bend away from a ray
    }
    const std::optional<Surface_hit> hit = m_cut.solid.first_hit(start, direction);
    return hit ? hit->distance : 0;
  }

  Index component_of_face(Index face) const
  {
    return m_cut.solid.component(m_cut.solid.query_level().to_finest(m_cut.solid.query_surface().origin(3 * face)));
  }
  Index component_of_piece(Index piece) const
  {
    return m_cut.solid.component(m_cut.solid.query_level().to_finest(*m_pieces[piece].begin()));
  }

  /// How far below the surface a tip is: less where the limb ends in a thin part. Walls of other components that reach
  /// into the limb do not count.
  double depth_of_tip(Index piece, const Vector_3& start, const Vector_3& direction, double reach, double radius) const
  {
    const double depth = tip_depth * radius;
    if (reach <= depth) {
      return depth / 2;
    }
    const Vector_3 point = start + (reach - depth) * direction;
    const Surface_point nearest = m_cut.solid.closest_point(point);
    const double distance = (nearest.point - point).norm();
    const bool is_thin =
        distance < max_thin_end * depth && component_of_face(nearest.face) == component_of_piece(piece);
    return is_thin ? std::max(distance, depth / 2) : depth;
  }

  /// A place inside below the surface of `piece` that is far from `base`, in the direction of the mean of that.
  std::optional<Vector_3> far_end_of(Index piece, Index base) const
  {
    const Vector_3& start = m_graph[base].position;
    const double far = far_part * (m_pieces.farthest(piece, start) - start).norm();
    Vector_3 sum = Vector_3::Zero();
    for (Index vertex : m_pieces[piece]) {
      const Vector_3 way = m_pieces.point(vertex) - start;
      sum += way.norm() > far ? way : Vector_3(Vector_3::Zero());
    }
    const Vector_3 direction = sum.normalized();
    const double length = m_pieces.extent(piece, start, direction) - tip_depth * m_graph[base].radius;
    const Vector_3 place = start + length * direction;
    const std::optional<Vector_3> result =
        m_cut.solid.is_inside(place) ? std::optional<Vector_3>(place) : m_cut.solid.middle_behind(place);
    return result && m_cut.solid.is_inside(*result) ? result : std::nullopt;
  }

  const Cut_solid& m_cut;
  const Piece_vertices& m_pieces;
  const Cut_graph_nodes& m_nodes;
  Skeleton_builder& m_graph;
  Limb_openings m_openings;
};

/// Cuts off short ends of branches that turn aside where the body lies all around the branch: in a rim, they lead to no
/// point more than to others.
class Rim_trimming
{
public:
  /// Both are referred to.
  Rim_trimming(const Triangulated_solid& solid, Skeleton_builder& builder) : m_solid(solid), m_builder(builder) {}

  void operator()()
  {
    for (Index tip = 0; tip < m_builder.size(); ++tip) {
      const Skeleton_builder::Node& node = m_builder[tip];
      if (!node.is_removed && node.neighbors.size() == 1 && !node.is_opening && !node.is_on_sheet) {
        trim(tip);
      }
    }
  }

private:
  /// The greatest length of an end that is cut off, relative to the radius where it starts ...
  static constexpr double max_length = 1.5;
  /// ... and the greatest cosine of the turn there.
  static constexpr double max_cosine = 0.5;

  void trim(Index tip)
  {
    Index outer_neighbor = tip;
    Index base = m_builder[tip].neighbors[0];
    while (m_builder.is_regular(base) && m_builder.edge_length(tip, base) < max_length * m_builder[base].radius) {
      if (leads_into_rim(tip, base, m_builder.other_neighbor(base, outer_neighbor))) {
        contract_until(tip, base);
        return;
      }
      outer_neighbor = std::exchange(base, m_builder.other_neighbor(base, outer_neighbor));
    }
  }

  void contract_until(Index tip, Index base)
  {
    while (tip != base) {
      const Index next = m_builder[tip].neighbors[0];
      m_builder.contract(tip, next);
      tip = next;
    }
  }

  /// Whether the way from `base` to `tip` turns aside from the branch that comes from `inner_neighbor`, in a body that
  /// lies around that as far out.
  bool leads_into_rim(Index tip, Index base, Index inner_neighbor) const
  {
    const Vector_3& position = m_builder[base].position;
    Index last = base;
    Index node = inner_neighbor;
    while (m_builder.is_regular(node) && m_builder.edge_length(node, base) < m_builder[base].radius) {
      last = std::exchange(node, m_builder.other_neighbor(node, last));
    }
    const Vector_3 axis = (position - m_builder[node].position).normalized();
    const Vector_3 way = m_builder[tip].position - position;
    const double along = way.dot(axis);
    if (along > max_cosine * way.norm()) {
      return false;
    }
    const Vector_3 aside = way - along * axis;
    const Vector_3 across = axis.cross(aside);
    const Vector_3 center = position + along * axis;
    return m_solid.is_inside(center - aside) && m_solid.is_inside(center + across) &&
           m_solid.is_inside(center - across);
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_LIMB_ENDS_H
