// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where limbs end: at openings, the borders of the input, which faces without area close; or by tips.

#ifndef CSCD_SKELETON_LIMB_ENDS_H
#define CSCD_SKELETON_LIMB_ENDS_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Cut_graph_nodes.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// A closed curve of edges between faces of the surface and hole-filling faces.
struct Bridged_border
{
  Vector3 centroid = Vector3::Zero(); ///< by length
  Vector3 normal = Vector3::Zero();   ///< out of the opening: along the area vector
  double length = 0;                  ///< of the curve
  double radius = 0;                  ///< mean distance of the curve from its centroid
  std::vector<Index> pieces;          ///< of the cut surface, that it passes, in ascending order
};

/// The border along the halfedges of `curve`.
inline Bridged_border measure_border(const Triangulated_surface& surface, const Cut_graph& cut_graph,
                                     const std::vector<Index>& curve)
{
  Bridged_border border;
  std::vector<Vector3> points;
  for (Index h : curve) {
    points.push_back(surface.point(surface.origin(h)));
    border.pieces.push_back(cut_graph.piece_of_vertex(surface.origin(h)));
  }
  std::sort(border.pieces.begin(), border.pieces.end());
  border.pieces.erase(std::unique(border.pieces.begin(), border.pieces.end()), border.pieces.end());
  const Polygon_measures measures = measure_polygon(points);
  border.centroid = measures.center;
  border.normal = measures.vector_area.normalized();
  border.length = measures.length;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3& next = points[(i + 1) % points.size()];
    const double distance = ((points[i] - border.centroid).norm() + (next - border.centroid).norm()) / 2;
    border.radius += (next - points[i]).norm() / border.length * distance;
  }
  return border;
}

/// The borders of `surface` that were bridged, in the order of their first halfedges; linear in the number of
/// hole-filling faces.
inline std::vector<Bridged_border> bridged_borders(const Triangulated_surface& surface, const Cut_graph& cut_graph)
{
  const auto is_hole_filling = [&](Index h) { return surface.is_hole_filling(Triangulated_surface::face(h)); };
  const auto is_on_border = [&](Index h) { return is_hole_filling(h) && !is_hole_filling(surface.twin(h)); };
  std::vector<Bridged_border> result;
  const Index first = 3 * surface.first_hole_filling_face();
  std::vector<char> is_met(surface.number_of_halfedges() - first, 0);
  std::vector<Index> curve;
  for (Index start = first; start < surface.number_of_halfedges(); ++start) {
    curve.clear();
    for (Index h = start; is_on_border(h) && is_met[h - first] == 0;) {
      is_met[h - first] = 1;
      curve.push_back(h);
      // On along the hole-filling faces around the target.
      h = Triangulated_surface::next(h);
      while (!is_on_border(h)) {
        h = Triangulated_surface::next(surface.twin(h));
      }
    }
    if (!curve.empty()) {
      result.push_back(measure_border(surface, cut_graph, curve));
    }
  }
  return result;
}

/// Leads branches to the ends of limbs, and to the middle of the borders where limbs end. Branches on sheets go on
/// later, once they are centered.
class Limb_ends
{
public:
  /// All are referred to.
  Limb_ends(const Cut_solid& cut, const Piece_vertices& pieces, const Cut_graph_nodes& nodes, Skeleton_builder& graph)
      : m_cut(cut), m_pieces(pieces), m_nodes(nodes), m_graph(graph), m_openings(cut.number_of_pieces())
  {
    for (const Bridged_border& border : bridged_borders(cut.solid.triangulation(), cut.cut_graph)) {
      const Index piece = piece_behind(border);
      if (piece != no_index && is_opening(border, piece)) {
        m_openings[piece].push_back(border);
      }
    }
  }

  void operator()()
  {
    for (Index piece = 0; piece < m_cut.number_of_pieces(); ++piece) {
      open(piece, m_nodes.node_of_piece(piece));
      add_tips(piece);
    }
  }

private:
  /// The length of a border at the end of a limb, relative to the last separator, is at least this: across a shorter
  /// one, the limb is closed.
  static constexpr double min_opening_length = 0.6;
  /// The cosine of the angle between the normals of the two is at least this: the border is not a window in the side.
  static constexpr double min_opening_cosine = 0.3;
  /// The depth of a component without separators behind an opening, relative to the radius of the border. A shallower
  /// component is a sheet. In a deeper one, as in a ball with a hole of less than half its radius, the border is that
  /// of a hole in the wall.
  static constexpr double min_depth = 1.5;
  static constexpr double max_depth = 4;
  /// The other nodes of a limb are at least this far behind the plane of the border, relative to its radius.
  static constexpr double min_depth_of_node = 0.5;
  /// The node of an opening is this far inside of the border, relative to its radius.
  static constexpr double opening_depth = 0.01;

  /// A component of a smaller radius, relative to the root of the area of the surface, is flat: inside tests are
  /// unreliable there.
  static constexpr double min_thickness = 1e-7;
  /// The far end of a lobe is at least this far away, relative to where a ray across the last separator meets the end
  /// of the limb or, if that is more, to the radius of the separator: a second ball as large as the first is 3 away.
  /// ...
  static constexpr double min_way_to_lobe = 2.5;
  /// ... and the lobe has at least this radius, likewise: from 0.55, no bowl of a glass is one.
  static constexpr double min_radius_of_lobe = 0.75;
  /// A limb is straightened beyond its neck, a node whose distance from the surface is at most this, relative to the
  /// radius of the lobe, the largest such distance behind it, ...
  static constexpr double max_radius_of_neck = 0.67;
  /// ... and where the cosine of the angle between the branch and the normal of the separator is at least this.
  static constexpr double min_neck_cosine = 0.97;
  /// The neck is at most this far from the last separator, relative to the radius of the lobe, ...
  static constexpr double max_bent_length = 3;
  /// ... the straight way is shorter than the bent one by at most this, likewise, ...
  static constexpr double max_loss = 0.5;
  /// ... and is farther from the surface by at least this factor on average. All chosen for dumbbells, so that few
  /// other limbs change.
  static constexpr double min_gain = 1.02;
  /// Tips stay this far below the surface, relative to the radius.
  static constexpr double tip_depth = 0.65;
  /// An edge to a tip has at least this length, likewise.
  static constexpr double min_tip_length = 0.3;

  /// The piece that is open at `border`: where separators cross that, the piece at the end of a limb. Where there are
  /// several of these, the border goes along the body, as that of a sheet does, and the result is `no_index`.
  Index piece_behind(const Bridged_border& border) const
  {
    if (border.pieces.size() == 1) {
      return border.pieces.front();
    }
    const auto is_end = [this](Index piece) { return m_cut.around(piece).size() == 1; };
    const auto end = std::find_if(border.pieces.begin(), border.pieces.end(), is_end);
    return std::count_if(border.pieces.begin(), border.pieces.end(), is_end) == 1 ? *end : Index(no_index);
  }

  bool is_opening(const Bridged_border& border, Index piece) const
  {
    const std::vector<Index>& around = m_cut.around(piece);
    if (around.empty()) {
      const double depth = m_pieces.extent(piece, border.centroid, -border.normal);
      return depth >= min_depth * border.radius && depth <= max_depth * border.radius;
    }
    if (around.size() > 1) {
      return false;
    }
    const Separator& separator = m_cut.separator(last_separator(border, piece));
    const double side = separator.normal.dot(border.centroid - separator.center) < 0 ? -1 : 1;
    return border.length >= min_opening_length * separator.length &&
           side * separator.normal.dot(border.normal) >= min_opening_cosine;
  }

  /// The last separator of the limb that ends in `piece` before separators that cross `border`, as many do where the
  /// limb is cut obliquely.
  Index last_separator(const Bridged_border& border, Index piece) const
  {
    Index separator = m_cut.around(piece).front();
    for (;;) {
      piece = m_cut.cut_graph.sides(separator).other(piece);
      const std::vector<Index>& around = m_cut.around(piece);
      if (around.size() != 2 || !std::binary_search(border.pieces.begin(), border.pieces.end(), piece)) {
        return separator;
      }
      separator = around[0] == separator ? around[1] : around[0];
    }
  }

  /// Leads the curve from `node`, of `piece`, to the middle of each of its openings.
  void open(Index piece, Index node)
  {
    const bool is_end = m_cut.around(piece).size() == 1 && m_openings[piece].size() == 1;
    for (const Bridged_border& border : m_openings[piece]) {
      const Index last = is_end ? shorten_limb(piece, node, border) : node;
      const Vector3 position = border.centroid - opening_depth * border.radius * border.normal;
      const Index opening = m_graph.add_node(position, border.radius);
      m_graph[opening].is_opening = true;
      m_graph[opening].component = m_graph[last].component;
      m_graph.add_edge(last, opening);
    }
  }

  /// Removes the nodes at the end of a limb whose separators cross its border, and nodes near the plane of the border
  /// or beyond it. \return the last node that is left
  Index shorten_limb(Index piece, Index end, const Bridged_border& border)
  {
    const Index last = m_graph.last_heir(last_separator(border, piece));
    bool is_crossing = end != last;
    while (m_graph.degree(end) == 1 && m_graph.is_regular(m_graph[end].neighbors[0])) {
      const double depth = (border.centroid - m_graph[end].position).dot(border.normal);
      if (!is_crossing && depth >= min_depth_of_node * border.radius) {
        break;
      }
      const Index next = m_graph[end].neighbors[0];
      m_graph.contract(end, next);
      end = next;
      is_crossing = is_crossing && end != last;
    }
    return end;
  }

  void add_tips(Index piece)
  {
    const std::vector<Bridged_border>& openings = m_openings[piece];
    const std::size_t number_of_ways = m_cut.around(piece).size() + openings.size();
    const Index base = m_nodes.node_of_piece(piece);
    const Vector3 start = m_graph[base].position;
    // From outside, tips would lead somewhere into the wall of a hollow body; from a component without thickness, into
    // another component.
    if (number_of_ways > 1 || !(m_graph[base].radius > min_thickness) || !body(base).is_inside(start)) {
      return;
    }
    if (!openings.empty()) {
      add_tip(piece, base, -openings.front().normal);
    } else if (number_of_ways == 1) {
      if (!m_graph[base].is_on_sheet && !straighten(piece, base) && !enter_lobe(piece, base)) {
        add_tip(piece, base, outward_normal(piece, start));
      }
    } else {
      const Vector3 direction = (m_pieces.farthest(piece, start) - start).normalized();
      add_tip(piece, base, direction);
      add_tip(piece, base, -direction);
    }
  }

  /// The normal of the only separator of `piece`, at `start`, into the piece.
  Vector3 outward_normal(Index piece, const Vector3& start) const
  {
    const Index end = m_cut.around(piece).front();
    const double side = m_cut.cut_graph.sides(end).left == piece ? 1 : -1;
    const Vector3 normal = side * m_cut.separator(end).normal;
    return normal.dot(m_pieces.centroid(piece).value_or(start + normal) - start) < 0 ? Vector3(-normal) : normal;
  }

  /// Where the limb of `piece` has a neck, replaces a bent way from there to `end` by a straight one that leads as far
  /// and is farther from the surface: across a ball, circles in any direction are separators. `end` becomes the tip.
  /// \return whether the way was replaced
  bool straighten(Index piece, Index end)
  {
    const Vector3 outward = outward_normal(piece, m_graph[end].position);
    std::vector<double> lengths{distance_to_end(piece, end, outward)}; // of the ways from the nodes to the surface
    double radius = clearance(end, m_graph[end].position + lengths[0] / 2 * outward);
    const std::vector<Index> limb = nodes_to_neck(end, radius);
    if (limb.empty()) {
      return false;
    }
    for (std::size_t i = 1; i < limb.size(); ++i) {
      lengths.push_back(lengths.back() + m_graph.edge_length(limb[i - 1], limb[i]));
    }
    const Index neck = limb.back();
    const Vector3& start = m_graph[neck].position;
    const Vector3& normal = m_cut.separator(neck).normal;
    const Vector3 ray = normal.dot(m_graph[limb[limb.size() - 2]].position - start) < 0 ? Vector3(-normal) : normal;
    const double reach = distance_to_end(piece, neck, ray);
    double clearances = 0;
    double straight_clearances = 0;
    for (std::size_t i = 0; i + 1 < limb.size(); ++i) {
      clearances += clearance(neck, m_graph[limb[i]].position);
      straight_clearances += clearance(neck, start + (1 - lengths[i] / lengths.back()) * reach * ray);
    }
    if (reach < lengths.back() - max_loss * radius || straight_clearances < min_gain * clearances) {
      return false;
    }
    for (std::size_t i = 1; i + 1 < limb.size(); ++i) {
      m_graph.contract(limb[i], end); // whose vertices may be nearest to the tip
    }
    m_graph[end].radius = std::min(radius, m_graph[end].radius);
    m_graph[end].position = start + std::max(reach - tip_depth * m_graph[end].radius, reach / 2) * ray;
    return true;
  }

  /// The nodes from `end` to the neck of its limb; none without a neck. Enlarges `radius` to that of the lobe behind
  /// it.
  std::vector<Index> nodes_to_neck(Index end, double& radius) const
  {
    std::vector<Index> limb;
    double length = 0;
    for (Index node = end; m_graph.degree(node) == (limb.empty() ? 1 : 2) && length <= max_bent_length * radius;) {
      const double node_clearance = clearance(node, m_graph[node].position);
      radius = std::max(radius, node_clearance);
      const Index next = limb.empty() ? m_graph[node].neighbors[0] : m_graph.other_neighbor(node, limb.back());
      limb.push_back(node);
      const Vector3 way = m_graph[node].position - m_graph[next].position;
      if (limb.size() > 1 && node < m_cut.packed.size() && m_graph.is_regular(next) &&
          std::abs(m_cut.separator(node).normal.dot(way)) >= min_neck_cosine * way.norm() &&
          node_clearance <= max_radius_of_neck * radius) {
        return limb;
      }
      length += way.norm();
      node = next;
    }
    return {};
  }

  /// The distance of `point` from the surface of the component of `node`; 0 outside.
  double clearance(Index node, const Vector3& point) const
  {
    return body(node).is_inside(point) ? (body(node).closest_point(point).point - point).norm() : 0;
  }

  /// Leads the branch from `base` through the last lobe of the body where the farthest point of `piece` lies in one: a
  /// part behind a neck that is so thin or so short that no separator was found there. \return whether there is one
  bool enter_lobe(Index piece, Index base)
  {
    const Vector3 start = m_graph[base].position;
    const double reach = std::max(distance_to_end(piece, base, outward_normal(piece, start)), m_graph[base].radius);
    const Vector3 farthest = m_pieces.farthest(piece, start);
    if ((farthest - start).norm() < min_way_to_lobe * reach) {
      return false;
    }
    const std::optional<Vector3> middle = body(base).middle_behind(farthest);
    const double radius = middle ? (farthest - *middle).norm() : 0;
    if (radius < min_radius_of_lobe * reach) {
      return false;
    }
    const Index lobe = m_graph.extend(base, *middle, radius);
    m_graph[lobe].pieces = {piece};
    add_tip(piece, lobe, (farthest - *middle) / radius);
    return true;
  }

  /// Adds a tip in `direction` from `base`; if that is as near to the end, it becomes the tip.
  void add_tip(Index piece, Index base, const Vector3& direction)
  {
    const double radius = m_graph[base].radius;
    const Vector3 start = m_graph[base].position;
    const double reach = distance_to_end(piece, base, direction);
    const double depth = tip_depth * radius;
    const double length = reach - (reach > depth ? depth : depth / 2);
    if (length >= min_tip_length * radius) {
      const Index tip = m_graph.extend(base, start + length * direction, radius);
      m_graph[tip].pieces = {piece};
    } else if (length > 0 && m_graph.degree(base) == 1) {
      m_graph[base].position = start + length * direction;
    }
  }

  /// The component that `node` is in.
  const Solid_queries& body(Index node) const { return m_cut.solid.queries(m_graph[node].component); }

  double distance_to_end(Index piece, Index base, const Vector3& direction) const
  {
    const Vector3& start = m_graph[base].position;
    if (m_graph[base].is_on_sheet) {
      return m_pieces.extent(piece, start, direction); // the sheet may bend away from a ray
    }
    const std::optional<Surface_hit> hit = body(base).first_hit(start, direction);
    return hit ? hit->distance : 0;
  }

  const Cut_solid& m_cut;
  const Piece_vertices& m_pieces;
  const Cut_graph_nodes& m_nodes;
  Skeleton_builder& m_graph;
  std::vector<std::vector<Bridged_border>> m_openings; ///< of each piece
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_LIMB_ENDS_H
