// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the cut graph to nodes in space.

#ifndef CSCD_SKELETON_NODE_PLACEMENT_H
#define CSCD_SKELETON_NODE_PLACEMENT_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Surface_regions.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Bridged_borders.h>
#include <CSCD/Skeleton/Limb_end.h>
#include <CSCD/Skeleton/Sheet_placement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The vertices of each piece, on the level of the regions, and what follows from them.
class Surface_pieces
{
public:
  Surface_pieces(const Cut_graph& cut_graph, const Surface_regions& regions) : m_regions(regions)
  {
    const Triangulated_surface& surface = regions.level().surface;
    const Index n = surface.number_of_vertices();
    m_vertices = Compressed_rows<Index>(cut_graph.pieces().size(), [&](const auto& add) {
      for (Index vertex = 0; vertex < n; ++vertex) {
        add(cut_graph.piece_of_vertex(regions.level().to_finest(vertex)), vertex);
      }
    });
  }

  /// The vertices of `piece`; none in a piece that is smaller than the triangles of the level.
  CGAL::Iterator_range<const Index*> vertices(Index piece) const { return m_vertices[piece]; }

  /// A sum of points by area.
  struct Weighted_sum
  {
    Vector_3 sum = Vector_3::Zero();
    double weight = 0;

    void add(const Vector_3& point, double point_weight)
    {
      sum += point_weight * point;
      weight += point_weight;
    }
  };

  /// The area-weighted sum of the vertices of `piece`.
  Weighted_sum area_sum(Index piece) const
  {
    const Triangulated_surface& surface = m_regions.level().surface;
    Weighted_sum result;
    for (Index vertex : vertices(piece)) {
      result.add(surface.point(vertex), double(surface.vertex_area(vertex)));
    }
    return result;
  }

  /// `piece` as the end of a limb.
  Limb_end limb_end(Index piece) const
  {
    const Triangulated_surface& surface = m_regions.level().surface;
    Limb_end result;
    for (Index vertex : vertices(piece)) {
      result.add(surface.point(vertex), double(surface.vertex_area(vertex)), m_regions.distance(vertex));
    }
    return result;
  }

  /// The largest extent of `piece` from `origin` in `direction`; 0 where it does not reach beyond `origin`.
  double extent(Index piece, const Vector_3& origin, const Vector_3& direction) const
  {
    double result = 0;
    for (Index vertex : vertices(piece)) {
      result = std::max(result, direction.dot(m_regions.level().surface.point(vertex) - origin));
    }
    return result;
  }

private:
  const Surface_regions& m_regions;
  Compressed_rows<Index> m_vertices;
};

/// Builds the builder of a skeleton from a cut graph: a node for each separator, one for each piece with three or more
/// separators (a junction), one for the tip of each long piece with one separator, and one for each piece without any.
/// Where a limb ends at a border of the input, its last node is in the middle of the border. Nodes of sheets are
/// between their sides, those of open separators in the middle of these.
class Node_placement
{
public:
  Node_placement(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                 const std::vector<Index>& packed, const Cut_graph& cut_graph)
      : m_solid(solid), m_separators(separators), m_packed(packed), m_cut_graph(cut_graph),
        m_regions(solid.levels(), separators, packed, Surface_regions::precise_size), m_pieces(cut_graph, m_regions),
        m_number_of_openings(cut_graph.pieces().size(), 0)
  {
    find_openings();
  }

  /// The placed builder. Parallel edges and loops may occur where a piece joins two separators, or one to itself.
  Skeleton_builder operator()()
  {
    Skeleton_builder builder;
    place_separators(builder);
    for (Index piece = 0; piece < m_cut_graph.pieces().size(); ++piece) {
      connect_piece(builder, piece);
    }
    for (const Opening& opening : m_openings) {
      place_opening(builder, opening);
    }
    Sheet_placement(m_solid, builder).finish();
    return builder;
  }

private:
  /// Weight of the center of a separator against the area of its region, relative to the squared length: matters only
  /// where a region holds few vertices.
  static constexpr double separator_weight = 0.02;
  /// The same for the separators around a junction.
  static constexpr double junction_separator_weight = 0.05;
  /// Share of the centroid of the region in a node's position; the rest is the centroid of the section. On a bend, the
  /// first lies outwards of the middle of the body, the second on it; half and half reconstructs best.
  static constexpr double region_share = 0.5;
  /// A piece at the end of a sheet, which is mostly straight, gets a tip if it is higher than this, relative to the
  /// radius.
  static constexpr double min_tip_height_on_sheet = 1.5;
  /// Of a component that no separator cuts, and that is thinner than this, in the unit of the area of the surface, rays
  /// tell nothing.
  static constexpr double min_thickness = 1e-7;
  /// A border at the end of a limb is an opening if it is this long, relative to the last separator of the limb. Across
  /// a shorter one, the limb is closed ...
  static constexpr double min_opening_length = 0.6;
  /// ... and if the cosine of the angle between their normals is at least this: it is no window in the side.
  static constexpr double min_opening_cosine = 0.3;
  /// Of a component that no separator cuts, a border is an opening if the component is this deep behind it, relative to
  /// its radius: it is no sheet.
  static constexpr double min_depth = 1.5;
  /// Elsewhere, a border ends a stump, too short for a separator, if it is this far from the node of the piece,
  /// relative to the radius there, ...
  static constexpr double min_stump_length = 1.6;
  /// ... has this radius, likewise, ...
  static constexpr double min_stump_radius = 0.3;
  /// ... and if the cosine of the angle between its normal and the stump is at least this.
  static constexpr double min_stump_cosine = 0.5;
  /// The other nodes of a limb are at least this far behind the plane of the border, relative to its radius ...
  static constexpr double min_depth_of_node = 0.5;
  /// ... and the node of an opening is this far inside of the border, relative to its radius.
  static constexpr double opening_depth = 0.01;

  /// A border at which a limb ends.
  struct Opening
  {
    Bridged_border border;
    Index piece; ///< at the end of the limb
  };

  void place_separators(Skeleton_builder& builder)
  {
    const Triangulated_surface& surface = m_regions.level().surface;
    std::vector<Surface_pieces::Weighted_sum> region(m_packed.size());
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      if (m_regions.separator(vertex) != no_index) {
        region[m_regions.separator(vertex)].add(surface.point(vertex), double(surface.vertex_area(vertex)));
      }
    }
    std::vector<Vector_3> outline;
    for (Index i = 0; i < m_packed.size(); ++i) {
      const Separator& separator = m_separators[m_packed[i]];
      region[i].add(separator.center, separator_weight * separator.length * separator.length);
      crossing_points(m_solid.levels().finest().surface, separator.crossings, outline);
      const Section_disc disc = section_disc(outline);
      const Vector_3 centroid = region[i].sum / region[i].weight;
      const Index node = builder.add_node(region_share * centroid + (1 - region_share) * disc.center, disc.radius());
      builder[node].separators = {i};
      Sheet_placement(m_solid, builder).place(node, separator);
    }
  }

  void connect_piece(Skeleton_builder& builder, Index piece)
  {
    const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
    if (around.empty()) {
      place_blob(builder, piece);
    } else if (around.size() == 1) {
      place_tip(builder, piece, around.front());
    } else if (around.size() == 2) {
      builder.add_edge(around[0], around[1]);
    } else {
      place_junction(builder, piece);
    }
  }

  void place_junction(Skeleton_builder& builder, Index piece)
  {
    Surface_pieces::Weighted_sum sum = m_pieces.area_sum(piece);
    double radius = 0;
    const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
    for (Index i : around) {
      const Separator& separator = m_separators[m_packed[i]];
      sum.add(separator.center, junction_separator_weight * separator.length * separator.length);
      radius = std::max(radius, separator.radius());
    }
    const Index node = builder.add_node(sum.sum / sum.weight, radius);
    builder[node].pieces = {piece};
    for (Index i : around) {
      builder.add_edge(node, i);
    }
  }

  void place_tip(Skeleton_builder& builder, Index piece, Index base)
  {
    if (m_number_of_openings[piece] > 0) {
      return;
    }
    const double min_height = builder[base].is_on_sheet ? min_tip_height_on_sheet : Limb_end::min_tip_height;
    const double radius = builder[base].radius;
    join_tip(builder, base, m_pieces.limb_end(piece).tip(builder[base].position, radius, min_height), piece, radius);
  }

  /// Joins a tip to `node`, in `direction`, if `piece` extends far enough.
  void extend(Skeleton_builder& builder, Index node, Index piece, const Vector_3& direction, double radius)
  {
    const Limb_end end = m_pieces.limb_end(piece);
    join_tip(builder, node, end.tip_towards(builder[node].position, direction, radius), piece, radius);
  }

  static void join_tip(Skeleton_builder& builder, Index node, const std::optional<Vector_3>& position, Index piece,
                       double radius)
  {
    if (position) {
      const Index tip = builder.add_node(*position, radius);
      builder[tip].pieces = {piece};
      builder.add_edge(node, tip);
    }
  }

  /// A component that no separator cuts: a node in its middle, and two tips if it is longer than thick.
  void place_blob(Skeleton_builder& builder, Index piece)
  {
    const Surface_pieces::Weighted_sum sum = m_pieces.area_sum(piece);
    const Vector_3 center = sum.weight > 0 ? Vector_3(sum.sum / sum.weight)
                                           : m_regions.level().surface.point(*m_pieces.vertices(piece).begin());
    const double radius = (m_solid.closest_point(center).point - center).norm();
    const Index node = builder.add_node(center, radius);
    builder[node].pieces = {piece};
    const Index vertex_of_piece = m_regions.level().to_finest(*m_pieces.vertices(piece).begin());
    builder[node].is_on_sheet = m_solid.side_of_sheet(vertex_of_piece) != 0;
    Vector_3 farthest = center;
    for (Index vertex : m_pieces.vertices(piece)) {
      const Vector_3& point = m_regions.level().surface.point(vertex);
      if ((point - center).squaredNorm() > (farthest - center).squaredNorm()) {
        farthest = point;
      }
    }
    const Vector_3 direction = (farthest - center).normalized();
    // From outside, tips would lead somewhere into the wall of what is hollow.
    if (m_number_of_openings[piece] == 0 && radius > min_thickness && m_solid.is_inside(center)) {
      extend(builder, node, piece, direction, radius);
      extend(builder, node, piece, -direction, radius);
    }
  }

  /// Finds the borders at which limbs end.
  void find_openings()
  {
    for (Bridged_border& border : bridged_borders(m_solid.triangulation(), m_cut_graph)) {
      const Index piece = piece_behind(border);
      if (piece != no_index && is_opening(border, piece)) {
        ++m_number_of_openings[piece];
        m_openings.push_back({std::move(border), piece});
      }
    }
  }

  /// The piece that is open at `border`. Where separators cross a border, it is the piece at the end of a limb; with
  /// several of these, the border goes along the body, as that of a sheet does, and the result is `no_index`.
  Index piece_behind(const Bridged_border& border) const
  {
    if (border.pieces.size() == 1) {
      return border.pieces.front();
    }
    const auto is_end = [this](Index piece) { return m_cut_graph.pieces()[piece].separators.size() == 1; };
    const auto end = std::find_if(border.pieces.begin(), border.pieces.end(), is_end);
    return std::count_if(border.pieces.begin(), border.pieces.end(), is_end) == 1 ? *end : Index(no_index);
  }

  bool is_opening(const Bridged_border& border, Index piece) const
  {
    const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
    if (around.empty()) {
      return m_pieces.extent(piece, border.centroid, -border.normal) >= min_depth * border.radius;
    }
    if (around.size() > 1) {
      return border.pieces.size() == 1 && ends_stump(border, piece);
    }
    const Separator& separator = m_separators[m_packed[last_separator(border, piece)]];
    const double side = separator.normal.dot(border.centroid - separator.center) < 0 ? -1 : 1;
    return border.length >= min_opening_length * separator.length &&
           side * separator.normal.dot(border.normal) >= min_opening_cosine;
  }

  /// The last separator of the limb that ends in `piece` before those that cross `border`, as many do where the limb is
  /// cut obliquely.
  Index last_separator(const Bridged_border& border, Index piece) const
  {
    Index separator = m_cut_graph.pieces()[piece].separators.front();
    for (;;) {
      piece = m_cut_graph.sides(separator).other(piece);
      const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
      if (around.size() != 2 || !std::binary_search(border.pieces.begin(), border.pieces.end(), piece)) {
        return separator;
      }
      separator = around[0] == separator ? around[1] : around[0];
    }
  }

  bool ends_stump(const Bridged_border& border, Index piece) const
  {
    double radius = 0;
    for (Index i : m_cut_graph.pieces()[piece].separators) {
      radius = std::max(radius, m_separators[m_packed[i]].radius());
    }
    const Surface_pieces::Weighted_sum sum = m_pieces.area_sum(piece);
    const Vector_3 stump = sum.weight > 0 ? Vector_3(border.centroid - sum.sum / sum.weight) : Vector_3::Zero();
    return stump.norm() >= min_stump_length * radius && border.radius >= min_stump_radius * radius &&
           border.normal.dot(stump) >= min_stump_cosine * stump.norm();
  }

  /// Leads the curve to the middle of the border.
  void place_opening(Skeleton_builder& builder, const Opening& opening)
  {
    const Bridged_border& border = opening.border;
    Index end = node_of_piece(builder, opening.piece);
    if (m_cut_graph.pieces()[opening.piece].separators.size() == 1 && m_number_of_openings[opening.piece] == 1) {
      end = shorten_limb(builder, opening);
    }
    const Index node = builder.add_node(border.centroid - opening_depth * border.radius * border.normal, border.radius);
    builder[node].is_opening = true;
    builder.add_edge(end, node);
    if (m_cut_graph.pieces()[opening.piece].separators.empty() && m_number_of_openings[opening.piece] == 1) {
      extend(builder, end, opening.piece, -border.normal, builder[end].radius);
    }
  }

  /// The node in the middle of `piece` or, where there is none, that of its first separator.
  Index node_of_piece(const Skeleton_builder& builder, Index piece) const
  {
    for (Index node = 0; node < builder.size(); ++node) {
      const std::vector<Index>& pieces = builder[node].pieces;
      if (std::find(pieces.begin(), pieces.end(), piece) != pieces.end()) {
        return node;
      }
    }
    return m_cut_graph.pieces()[piece].separators.front();
  }

  /// Removes the nodes at the end of a limb of which the separators cross its border, and those near the plane of the
  /// border or beyond it. \return the last node that is left
  Index shorten_limb(Skeleton_builder& builder, const Opening& opening) const
  {
    const Bridged_border& border = opening.border;
    const Index last = last_separator(border, opening.piece);
    Index end = m_cut_graph.pieces()[opening.piece].separators.front();
    bool is_crossing = end != last;
    while (builder.degree(end) == 1) {
      const Index next = builder[end].neighbors.front();
      const double depth = (border.centroid - builder[end].position).dot(border.normal);
      if (!builder.is_regular(next) || (!is_crossing && depth >= min_depth_of_node * border.radius)) {
        break;
      }
      builder.contract(end, next);
      end = next;
      is_crossing = is_crossing && end != last;
    }
    return end;
  }

  const Triangulated_solid& m_solid;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  const Cut_graph& m_cut_graph;
  Surface_regions m_regions;
  Surface_pieces m_pieces;
  std::vector<Opening> m_openings;
  std::vector<Index> m_number_of_openings; ///< of each piece
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_NODE_PLACEMENT_H
