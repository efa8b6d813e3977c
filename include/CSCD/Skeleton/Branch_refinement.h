// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides the edges of branches, centers the new nodes and smooths the branches.

#ifndef CSCD_SKELETON_BRANCH_REFINEMENT_H
#define CSCD_SKELETON_BRANCH_REFINEMENT_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Skeleton/Sheet_placement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/parallel.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Sections of the body perpendicular to a branch. Reuse one object.
class Branch_section
{
public:
  explicit Branch_section(const Triangulated_solid& solid) : m_solid(solid), m_section(solid.query_surface()) {}

  /// The section through `point` perpendicular to `axis`, if it surrounds the point and has about the expected radius.
  std::optional<Section_disc> operator()(const Vector_3& point, const Vector_3& axis, double expected_radius)
  {
    const auto hit = m_solid.first_hit(point, axis.unitOrthogonal());
    if (!hit ||
        !m_section.cut_at_face(hit->face, axis, point,
                               max_outline * 2 * boost::math::double_constants::pi * expected_radius) ||
        !is_in_outline(m_section.points(), point, axis)) {
      return std::nullopt;
    }
    const Section_disc disc = section_disc(m_section.points());
    const bool is_expected =
        disc.radius() >= min_radius * expected_radius && disc.radius() <= max_radius * expected_radius;
    return is_expected ? std::optional<Section_disc>(disc) : std::nullopt;
  }

  /// The length of the outline of the last section.
  double length() const { return m_section.length(); }

private:
  /// Bounds for the radius of an accepted section, relative to the expected radius.
  static constexpr double min_radius = 0.6;
  static constexpr double max_radius = 1.5;
  /// The length of a section is bounded by this, relative to the circle of the expected radius.
  static constexpr double max_outline = 4;

  const Triangulated_solid& m_solid;
  Plane_section m_section;
};

/// The two edges of a node that is moved may become this much longer than the straight line between its neighbors.
constexpr double max_detour = 1.4;

/// Whether a branch from `before` over `node` to `after` makes no longer detour than that.
inline bool is_direct(const Vector_3& before, const Vector_3& node, const Vector_3& after)
{
  return (node - before).norm() + (after - node).norm() < max_detour * (after - before).norm();
}

/// Divides long edges of branches and moves the new nodes to the middle of the section of the body that is
/// perpendicular to the branch there. A node without a reliable section is removed again.
class Branch_refinement
{
public:
  Branch_refinement(const Triangulated_solid& solid, Skeleton_builder& builder)
      : m_builder(builder), m_section(solid), m_sheet_section(solid)
  {
  }

  void operator()()
  {
    divide_edges();
    for (int sweep = 0; sweep < number_of_sweeps; ++sweep) {
      for (Index node : m_inserted) {
        if (m_builder.is_regular(node) && !center(node)) {
          m_builder.bypass(node);
        }
      }
    }
  }

private:
  /// Edges are divided into parts of about this length, relative to the mean radius at their ends.
  static constexpr double part_length = 0.5;
  static constexpr int max_parts = 30; // of an edge: bounds the work on long, thin ones
  static constexpr int number_of_sweeps = 2;
  /// A node moves at most this far, relative to the expected radius.
  static constexpr double max_shift = 1;

  void divide_edges()
  {
    std::vector<std::pair<Index, Index>> edges;
    m_builder.for_each_edge([&](Index a, Index b) {
      if (a != b && !m_builder.is_junction(a) && !m_builder.is_junction(b)) {
        edges.emplace_back(a, b);
      }
    });
    for (const auto& [a, b] : edges) {
      divide(a, b);
    }
  }

  void divide(Index a, Index b)
  {
    const Skeleton_builder::Node from = m_builder[a];
    const Skeleton_builder::Node to = m_builder[b];
    const double mean_radius = (from.radius + to.radius) / 2;
    if (!(mean_radius > 0)) {
      return;
    }
    const double length = (to.position - from.position).norm();
    const int parts = int(std::min(length / (part_length * mean_radius), double(max_parts))) + 1;
    Index last = a;
    for (int i = 1; i < parts; ++i) {
      const double along = double(i) / parts;
      last = m_builder.split_edge(last, b, (1 - along) * from.position + along * to.position,
                                  (1 - along) * from.radius + along * to.radius);
      m_inserted.push_back(last);
    }
  }

  /// Moves `node` to the center of its section. \return false if there is no section to trust
  bool center(Index node)
  {
    Skeleton_builder::Node& center_node = m_builder[node];
    const Vector_3& before = m_builder[center_node.neighbors[0]].position;
    const Vector_3& after = m_builder[center_node.neighbors[1]].position;
    const std::optional<Vector_3> middle = middle_of_section(center_node, (after - before).normalized());
    if (!middle || (*middle - center_node.position).norm() > max_shift * center_node.radius ||
        !is_direct(before, *middle, after)) {
      return false;
    }
    center_node.position = *middle;
    return true;
  }

  std::optional<Vector_3> middle_of_section(const Skeleton_builder::Node& node, const Vector_3& axis)
  {
    if (node.is_on_sheet) {
      return m_sheet_section(node.position, axis, node.radius);
    }
    const std::optional<Section_disc> disc = m_section(node.position, axis, node.radius);
    return disc ? std::optional<Vector_3>(disc->center) : std::nullopt;
  }

  Skeleton_builder& m_builder;
  Branch_section m_section;
  Sheet_section m_sheet_section;
  std::vector<Index> m_inserted;
};

/// Moves every node of degree 2 halfway to the middle of its neighbors, all at once, but for those on sheets. More such
/// steps decenter bends.
inline void smooth_branches(Skeleton_builder& builder)
{
  std::vector<Vector_3> smoothed(builder.size());
  for (Index node = 0; node < builder.size(); ++node) {
    smoothed[node] = builder[node].position;
    if (builder.is_regular(node) && !builder[node].is_on_sheet) {
      const std::vector<Index>& neighbors = builder[node].neighbors;
      smoothed[node] = smoothed[node] / 2 + (builder[neighbors[0]].position + builder[neighbors[1]].position) / 4;
    }
  }
  for (Index node = 0; node < builder.size(); ++node) {
    builder[node].position = smoothed[node];
  }
}

/// Moves the nodes of branches towards the middle of the section of the body, or of a sheet, that is perpendicular to
/// the branch, all at once. Its direction is taken over a part of the branch, not between the neighbors: these are
/// often nearer than the errors of their positions are small.
class Branch_centering
{
public:
  /// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
  Branch_centering(const Triangulated_solid& solid, Skeleton_builder& builder, unsigned number_of_threads = 1)
      : m_solid(solid), m_builder(builder), m_number_of_threads(number_of_threads)
  {
  }

  /// Centers the branches of bodies, and smooths them.
  void operator()()
  {
    std::vector<Index> centered;
    std::vector<Vector_3> positions;
    collect_sections(false, m_builder.size(), centering_share, centered, positions);
    move(centered, positions);
    for (std::size_t i = 0; i < centered.size(); ++i) {
      const Skeleton_builder::Node& node = m_builder[centered[i]];
      const Vector_3& before = m_builder[node.neighbors[0]].position;
      const Vector_3& after = m_builder[node.neighbors[1]].position;
      const double longer = std::max((before - node.position).norm(), (after - node.position).norm());
      if (longer <= max_smoothed_edge * node.radius) {
        positions[i] = (1 - smoothing_share) * node.position + smoothing_share / 2 * (before + after);
      }
    }
    move(centered, positions);
  }
  /// Moves the nodes on sheets among the first `number_of_nodes` to the middle of sections. Separators that are oblique
  /// to the borders have theirs aside.
  void center_on_sheets(Index number_of_nodes)
  {
    std::vector<Index> centered;
    std::vector<Vector_3> positions;
    for (int round = 0; round < number_of_sheet_rounds && m_solid.number_of_sheets() > 0; ++round) {
      collect_sections(true, number_of_nodes, 1, centered, positions);
      move(centered, positions);
    }
  }

private:
  /// The direction of a branch is taken over this distance to both sides, relative to the radius.
  static constexpr double window = 0.7;
  /// The part of the way to the center of the section, and then to the middle of the neighbors, that a node moves.
  /// Further rounds center bodies better and shorten bends more.
  static constexpr double centering_share = 0.7;
  static constexpr double smoothing_share = 0.3;
  /// Nodes with a longer edge, relative to the radius, are not smoothed: that would cut bends off.
  static constexpr double max_smoothed_edge = 2;
  /// A node moves at most this far, relative to its radius.
  static constexpr double max_shift = 0.5;
  /// The squared length of a section, relative to that of the circle of the same area: the centroid of a less compact
  /// one is no middle of the body.
  static constexpr double max_squared_length = 2;
  /// The first round turns branches of sheets, too: the second one has better directions.
  static constexpr int number_of_sheet_rounds = 2;

  /// The sections that one thread takes.
  struct Sections
  {
    explicit Sections(const Triangulated_solid& solid) : body(solid), sheet(solid) {}

    Branch_section body;
    Sheet_section sheet;
  };

  /// Writes the nodes of branches, on sheets or not, that have a section to be trusted, and where they are with `share`
  /// of the way to its center.
  void collect_sections(bool is_on_sheet, Index number_of_nodes, double share, std::vector<Index>& nodes,
                        std::vector<Vector_3>& positions)
  {
    std::vector<std::optional<Vector_3>> center(number_of_nodes);
    constexpr Index chunk_size = 16; // sections take some ten microseconds each
    for_each_part(number_of_nodes / chunk_size + 1, m_number_of_threads, [&](Index chunk) {
      Sections sections(m_solid);
      for (Index node = chunk * chunk_size; node < std::min(number_of_nodes, (chunk + 1) * chunk_size); ++node) {
        if (m_builder.is_regular(node) && m_builder[node].is_on_sheet == is_on_sheet) {
          center[node] = section_center(node, sections);
        }
      }
    });
    nodes.clear();
    positions.clear();
    for (Index node = 0; node < number_of_nodes; ++node) {
      if (center[node]) {
        nodes.push_back(node);
        positions.push_back(m_builder[node].position + share * (*center[node] - m_builder[node].position));
      }
    }
  }

  void move(const std::vector<Index>& nodes, const std::vector<Vector_3>& positions)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      m_builder[nodes[i]].position = positions[i];
    }
  }

  /// The first node beyond the window on the way from `node` over its neighbor `next`, or the end of the branch.
  Index end_of_window(Index node, Index next) const
  {
    const Vector_3& center = m_builder[node].position;
    const double distance = window * m_builder[node].radius;
    Index before = node;
    while (m_builder.is_regular(next) && next != node && (m_builder[next].position - center).norm() < distance) {
      before = std::exchange(next, m_builder.other_neighbor(next, before));
    }
    return next;
  }

  /// Whether `node` is in the disc of the junction `end`, where a section leads into other branches.
  bool is_in_junction(Index node, Index end) const
  {
    return m_builder.is_junction(end) && m_builder.edge_length(node, end) < m_builder[end].radius;
  }

  /// The center of the section through `node`, if it is to be trusted.
  std::optional<Vector_3> section_center(Index index, Sections& sections) const
  {
    const Skeleton_builder::Node& node = m_builder[index];
    const Index before = end_of_window(index, node.neighbors[0]);
    const Index after = end_of_window(index, node.neighbors[1]);
    const Vector_3 direction = m_builder[after].position - m_builder[before].position;
    if (!(direction.norm() > 0) ||
        (node.is_on_sheet && (is_in_junction(index, before) || is_in_junction(index, after)))) {
      return std::nullopt;
    }
    const std::optional<Vector_3> center = node.is_on_sheet
                                               ? sections.sheet(node.position, direction.normalized(), node.radius)
                                               : center_of_body(node, direction.normalized(), sections.body);
    if (!center || (*center - node.position).norm() > max_shift * node.radius ||
        !is_direct(m_builder[node.neighbors[0]].position, *center, m_builder[node.neighbors[1]].position)) {
      return std::nullopt;
    }
    return center;
  }

  static std::optional<Vector_3> center_of_body(const Skeleton_builder::Node& node, const Vector_3& direction,
                                                Branch_section& section)
  {
    const std::optional<Section_disc> disc = section(node.position, direction, node.radius);
    const double circle = 4 * boost::math::double_constants::pi * (disc ? disc->area : 0);
    const bool is_compact = disc && section.length() * section.length() <= max_squared_length * circle;
    return is_compact ? std::optional<Vector_3>(disc->center) : std::nullopt;
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
  unsigned m_number_of_threads;
};

/// Removes and moves nodes of branches where the straight way stays inside the body. Neither topology nor the
/// simplicity of the graph change.
class Branch_straightening
{
public:
  Branch_straightening(const Triangulated_solid& solid, Skeleton_builder& builder) : m_solid(solid), m_builder(builder)
  {
  }

  /// Removes nodes at which the branch turns by more than a right angle nearer than the surface is: it folds back where
  /// separators beside each other face different ways. The neighbors of removed nodes stay: where a branch leads into a
  /// wall and back, as in a cup, not all of it is to go.
  void drop_folds()
  {
    std::vector<char> is_kept(m_builder.size(), 0);
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (is_kept[node] == 0 && is_removable(node) && turns_back(node, m_builder[node].position) &&
          shorter_edge(node) <= depth(node) && is_free(end(node, 0), end(node, 1))) {
        is_kept[m_builder[node].neighbors[0]] = 1;
        is_kept[m_builder[node].neighbors[1]] = 1;
        m_builder.bypass(node);
      }
    }
  }

  /// Removes nodes that own so little of the surface that their radii scatter, where that leaves no long edge.
  /// \param number_of_vertices for each node, that of the vertices which belong to it
  void drop_scarce_nodes(std::vector<Index> number_of_vertices)
  {
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (number_of_vertices[node] < min_vertices && is_removable(node) &&
          merged_length(node) < max_merged_edge * m_builder[node].radius && is_free(end(node, 0), end(node, 1))) {
        number_of_vertices[m_builder[node].neighbors[0]] += number_of_vertices[node] / 2;
        number_of_vertices[m_builder[node].neighbors[1]] += (number_of_vertices[node] + 1) / 2;
        m_builder.bypass(node);
      }
    }
  }

  /// Moves nodes at which a branch turns by more than a right angle towards the middle of their neighbors, as far as
  /// needed.
  void blunt_turns()
  {
    for (int round = 0; round < number_of_rounds; ++round) {
      for (Index node = 0; node < m_builder.size(); ++node) {
        if (m_builder.is_regular(node) && turns_back(node, m_builder[node].position)) {
          blunt(node);
        }
      }
    }
  }

private:
  /// The radius at a node is the mean distance of its vertices: of this many, it scatters by a third of what they do.
  static constexpr Index min_vertices = 8;
  /// Nodes are not removed where that leaves an edge longer than this, relative to the radius: bends stay.
  static constexpr double max_merged_edge = 1;
  /// A node that is moved may give its neighbors a sharper turn.
  static constexpr int number_of_rounds = 3;

  /// The position of one of the two neighbors of `node`.
  const Vector_3& end(Index node, std::size_t i) const { return m_builder[m_builder[node].neighbors[i]].position; }

  /// Whether the graph stays simple if `node` goes.
  bool is_removable(Index node) const
  {
    if (!m_builder.is_regular(node)) {
      return false;
    }
    const Index a = m_builder[node].neighbors[0];
    const Index b = m_builder[node].neighbors[1];
    const std::vector<Index>& around = m_builder[a].neighbors;
    return a != b && std::find(around.begin(), around.end(), b) == around.end();
  }

  /// Whether an edge from `from` to `to` has a length and stays inside.
  bool is_free(const Vector_3& from, const Vector_3& to)
  {
    m_solid.crossings(from, to, m_crossings);
    return from != to && m_crossings.empty();
  }

  /// Whether the branch turns by more than a right angle at `node`, if that is at `position`.
  bool turns_back(Index node, const Vector_3& position) const
  {
    return (position - end(node, 0)).dot(end(node, 1) - position) < 0;
  }

  double merged_length(Index node) const { return (end(node, 1) - end(node, 0)).norm(); }
  double shorter_edge(Index node) const
  {
    const Vector_3& position = m_builder[node].position;
    return std::min((position - end(node, 0)).norm(), (position - end(node, 1)).norm());
  }
  double depth(Index node) const
  {
    const Vector_3& position = m_builder[node].position;
    return (m_solid.closest_point(position).point - position).norm();
  }

  void blunt(Index node)
  {
    const Vector_3 start = m_builder[node].position;
    const Vector_3 middle = (end(node, 0) + end(node, 1)) / 2;
    // Half way if that will do; less where the surface is in between.
    for (const double share : {0.5, 0.75, 1., 0.4, 0.3, 0.2, 0.1}) {
      const Vector_3 position = (1 - share) * start + share * middle;
      if (!turns_back(node, position) && is_free(start, position) && is_free(end(node, 0), position) &&
          is_free(position, end(node, 1))) {
        m_builder[node].position = position;
        return;
      }
    }
  }

  const Triangulated_solid& m_solid;
  Skeleton_builder& m_builder;
  std::vector<double> m_crossings;
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_BRANCH_REFINEMENT_H
