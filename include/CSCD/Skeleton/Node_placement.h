// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the cut graph to nodes in space.

#ifndef CSCD_SKELETON_NODE_PLACEMENT_H
#define CSCD_SKELETON_NODE_PLACEMENT_H

#include <CSCD/Selection/Cut_graph.h>
#include <CSCD/Selection/Surface_regions.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  bool is_empty(Index piece) const { return m_vertices.size(piece) == 0; }

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

  /// The area-weighted sum of those vertices of `piece` that are at least `min_distance` from its separators.
  Weighted_sum area_sum(Index piece, float min_distance = 0) const
  {
    const Triangulated_surface& surface = m_regions.level().surface;
    Weighted_sum result;
    for (Index vertex : vertices(piece)) {
      if (m_regions.distance(vertex) >= min_distance) {
        result.add(surface.point(vertex), double(surface.vertex_area(vertex)));
      }
    }
    return result;
  }

  /// The largest distance of a vertex of `piece` from its separators; 0 in an empty piece.
  float height(Index piece) const
  {
    float result = 0;
    for (Index vertex : vertices(piece)) {
      result = std::max(result, m_regions.distance(vertex));
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
class Node_placement
{
public:
  Node_placement(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                 const std::vector<Index>& packed, const Cut_graph& cut_graph)
      : m_solid(solid), m_separators(separators), m_packed(packed), m_cut_graph(cut_graph),
        m_regions(solid.levels(), separators, packed, Surface_regions::precise_size), m_pieces(cut_graph, m_regions)
  {
  }

  /// The placed builder. Parallel edges and loops may occur where a piece joins two separators, or one to itself.
  Skeleton_builder operator()()
  {
    Skeleton_builder builder;
    place_separators(builder);
    for (Index piece = 0; piece < m_cut_graph.pieces().size(); ++piece) {
      connect_piece(builder, piece);
    }
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
  /// A piece at the end of a limb gets a tip if it is higher than this, relative to the radius of the limb ...
  static constexpr double min_tip_height = 0.7;
  /// ... and the tip stays this far below the surface ...
  static constexpr double tip_depth = 0.75;
  /// ... and this far from the node that it is joined to, likewise.
  static constexpr double min_tip_length = 0.3;
  /// The direction of a tip is that to the vertices beyond this part of the height of the piece.
  static constexpr double far_part = 0.6;

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
    const double radius = builder[base].radius;
    const float height = m_pieces.height(piece);
    const Surface_pieces::Weighted_sum far = m_pieces.area_sum(piece, float(far_part * height));
    if (!(height > min_tip_height * radius) || !(far.weight > 0)) {
      return;
    }
    extend(builder, base, piece, (far.sum / far.weight - builder[base].position).normalized(), radius);
  }

  /// Joins a tip to `node`, in `direction`, if `piece` extends far enough.
  void extend(Skeleton_builder& builder, Index node, Index piece, const Vector_3& direction, double radius)
  {
    const double length = m_pieces.extent(piece, builder[node].position, direction) - tip_depth * radius;
    if (length > min_tip_length * radius) {
      const Index tip = builder.add_node(builder[node].position + length * direction, radius);
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
    Vector_3 farthest = center;
    for (Index vertex : m_pieces.vertices(piece)) {
      const Vector_3& point = m_regions.level().surface.point(vertex);
      if ((point - center).squaredNorm() > (farthest - center).squaredNorm()) {
        farthest = point;
      }
    }
    const Vector_3 direction = (farthest - center).normalized();
    extend(builder, node, piece, direction, radius);
    extend(builder, node, piece, -direction, radius);
  }

  const Triangulated_solid& m_solid;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  const Cut_graph& m_cut_graph;
  Surface_regions m_regions;
  Surface_pieces m_pieces;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_NODE_PLACEMENT_H
