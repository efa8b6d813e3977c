// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures branches, the parts of a surface that belong to them, and the surroundings of nodes.

#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/squared_distance_3.h>

#include <boost/math/constants/constants.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

using Node_pair = std::pair<Index, Index>; ///< the lesser number first

Branch_end kind_of_end(const Skeleton& skeleton, const std::vector<std::vector<Index>>& neighbors, Index node)
{
  const bool is_opening = !skeleton.is_opening.empty() && skeleton.is_opening[node] != 0;
  const std::size_t degree = neighbors[node].size();
  return degree > 2    ? Branch_end::junction
         : degree == 2 ? Branch_end::closed
         : degree == 0 ? Branch_end::isolated
         : is_opening  ? Branch_end::opening
                       : Branch_end::tip;
}

/// Measures what depends on radii alone; the length is known.
void measure_radii(const Skeleton& skeleton, Skeleton_branch& branch)
{
  using boost::math::double_constants::pi;
  branch.end_radii = {skeleton.radii[branch.nodes.front()], skeleton.radii[branch.nodes.back()]};
  branch.min_radius = branch.max_radius = branch.end_radii[0];
  branch.cone_area = branch.cone_volume = 0;
  double integral = 0; // of the radius over the length
  for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
    const double r = skeleton.radii[branch.nodes[i - 1]];
    const double s = skeleton.radii[branch.nodes[i]];
    const double length = skeleton.length({branch.nodes[i - 1], branch.nodes[i]});
    branch.min_radius = std::min(branch.min_radius, s);
    branch.max_radius = std::max(branch.max_radius, s);
    integral += length * (r + s) / 2;
    branch.cone_area += pi * (r + s) * std::hypot(length, r - s);
    branch.cone_volume += pi * length * (r * r + r * s + s * s) / 3;
  }
  branch.mean_radius = branch.length > 0 ? integral / branch.length : branch.end_radii[0];
}

/// Gives branches their parents and orders.
void assign_orders(const Rooted_forest& forest, std::vector<Skeleton_branch>& branches)
{
  boost::unordered_map<Node_pair, Index> branch_of_edge;
  for (Index b = 0; b < branches.size(); ++b) {
    for (std::size_t i = 1; i < branches[b].nodes.size(); ++i) {
      branch_of_edge.emplace(std::minmax(branches[b].nodes[i - 1], branches[b].nodes[i]), b);
    }
  }
  std::vector<Index> branch_before(forest.order().size(), no_index); // of the edge to the parent; of roots none
  // A branch that is entered at both ends, as a cycle is cut in it, keeps the lesser order.
  const auto enter = [&](Index b, Index node) {
    const Index before = branch_before[node];
    if (before == b) {
      return;
    }
    Skeleton_branch& branch = branches[b];
    const std::size_t order = before == no_index ? 0 : *branches[before].order + 1;
    if (!branch.order || order < *branch.order) {
      branch.order = order;
      branch.parent = before == no_index ? std::nullopt : std::optional<std::size_t>(before);
    }
  };
  for (const Index node : forest.order()) {
    if (!forest.is_root(node)) {
      const Index parent = forest.parent(node);
      branch_before[node] = branch_of_edge.at(std::minmax(parent, node));
      enter(branch_before[node], parent);
    }
  }
  // The parts that the forest does not enter: isolated nodes, and edges between two junctions where a cycle is cut.
  for (Index b = 0; b < branches.size(); ++b) {
    if (!branches[b].order) {
      enter(b, branches[b].nodes.front());
      enter(b, branches[b].nodes.back());
    }
  }
}

/// The node of two corners of each triangle, or the least of three different ones; `no_index` if no corner has any.
inline std::vector<Index> nodes_of_faces(const Assigned_surface& surface)
{
  std::vector<Index> result;
  result.reserve(surface.triangles.size());
  for (const std::array<Index, 3>& triangle : surface.triangles) {
    std::array<Index, 3> nodes{surface.node_of_vertex[triangle[0]], surface.node_of_vertex[triangle[1]],
                               surface.node_of_vertex[triangle[2]]};
    std::sort(nodes.begin(), nodes.end()); // those without a node come last
    result.push_back(nodes[1] == nodes[2] && nodes[1] != no_index ? nodes[1] : nodes[0]);
  }
  return result;
}

/// Adds up area and volume of the faces of each branch, and of the cones that close them.
class Surface_part_measurement
{
public:
  Surface_part_measurement(const Skeleton& skeleton, const Assigned_surface& surface, Skeleton_branches& branches)
      : m_skeleton(skeleton), m_surface(surface), m_branches(branches.branches),
        m_branch_of_node(branches.branch_of_node), m_pairing(surface.triangles, surface.points.size()),
        m_node_of_face(nodes_of_faces(surface)), m_anchor(skeleton.number_of_nodes(), no_index),
        m_borders(surface.points.size()), m_middle(surface.points.size())
  {
    for (const Vector3& point : surface.points) {
      m_origin += point / double(surface.points.size());
    }
    find_anchors();
    find_middles_of_borders();
  }

  void measure()
  {
    for (Skeleton_branch& branch : m_branches) {
      branch.surface_area = branch.volume = 0;
    }
    double total = 0;
    for (std::size_t f = 0; f < m_node_of_face.size(); ++f) {
      if (m_node_of_face[f] != no_index) {
        total += add_face(f);
      }
    }
    if (total < 0) { // the surface faces inwards
      for (Skeleton_branch& branch : m_branches) {
        branch.volume = -branch.volume;
      }
    }
  }

private:
  /// The anchor of a node is the nearer junction at an end of its branch, of a junction itself: the apex of cones.
  void find_anchors()
  {
    for (const Skeleton_branch& branch : m_branches) {
      const bool has_first = branch.ends[0] == Branch_end::junction;
      const bool has_last = branch.ends[1] == Branch_end::junction;
      for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
        const bool is_first_nearer = 2 * i < branch.nodes.size();
        m_anchor[branch.nodes[i]] = has_first && (is_first_nearer || !has_last) ? branch.nodes.front()
                                    : has_last                                  ? branch.nodes.back()
                                                                                : branch.nodes[i];
      }
    }
  }

  void find_middles_of_borders()
  {
    std::vector<Index> border;
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      if (m_pairing.twin(h) == no_index) {
        m_borders.join(origin(h), origin(Halfedge_pairing::next(h)));
        border.push_back(origin(h));
      }
    }
    std::vector<double> number(m_surface.points.size(), 0);
    for (const Index vertex : border) {
      m_middle[m_borders.find(vertex)] += m_surface.points[vertex];
      ++number[m_borders.find(vertex)];
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
      m_middle[v] /= std::max(number[v], 1.);
    }
  }

  Index origin(Index halfedge) const { return m_surface.triangles[halfedge / 3][halfedge % 3]; }

  double tetrahedron(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    return (a - m_origin).cross(b - m_origin).dot(c - m_origin) / 6;
  }

  /// \return the volume that is added
  double add_face(std::size_t face)
  {
    const auto& [a, b, c] = m_surface.triangles[face];
    const std::array<Vector3, 3> corners{m_surface.points[a], m_surface.points[b], m_surface.points[c]};
    Skeleton_branch& branch = m_branches[m_branch_of_node[m_node_of_face[face]]];
    branch.surface_area += triangle_area(corners[0], corners[1], corners[2]);
    double volume = tetrahedron(corners[0], corners[1], corners[2]);
    for (Index side = 0; side < 3; ++side) {
      if (const std::optional<Vector3> apex = apex_behind(Index(3 * face + side))) {
        volume += tetrahedron(corners[(side + 1) % 3], corners[side], *apex);
      }
    }
    branch.volume += volume;
    return volume;
  }

  /// The apex of the cone that closes the part of a face at one of its sides; nothing if the part goes on there.
  std::optional<Vector3> apex_behind(Index halfedge)
  {
    const Index node = m_node_of_face[halfedge / 3];
    const Index twin = m_pairing.twin(halfedge);
    if (twin == no_index) {
      return m_middle[m_borders.find(origin(halfedge))];
    }
    const Index other = m_node_of_face[twin / 3];
    if (other == no_index) {
      return m_skeleton.points[m_anchor[node]];
    }
    if (m_branch_of_node[node] == m_branch_of_node[other]) {
      return std::nullopt;
    }
    return (m_skeleton.points[m_anchor[node]] + m_skeleton.points[m_anchor[other]]) / 2;
  }

  const Skeleton& m_skeleton;
  const Assigned_surface& m_surface;
  std::vector<Skeleton_branch>& m_branches;
  const std::vector<Index>& m_branch_of_node;
  Halfedge_pairing m_pairing;
  std::vector<Index> m_node_of_face;
  Vector3 m_origin = Vector3::Zero(); ///< near the surface, so that volumes do not cancel
  std::vector<Index> m_anchor;        ///< of each node
  Disjoint_sets m_borders;            ///< of vertices
  std::vector<Vector3> m_middle;
};

/// Measures the surface around one node after the other.
class Node_measurement
{
public:
  Node_measurement(const Skeleton& skeleton, const Assigned_surface& surface)
      : m_skeleton(skeleton), m_surface(surface), m_neighbors(node_neighbors(skeleton)),
        m_pairing(surface.triangles, surface.points.size()), m_is_near(surface.triangles.size()),
        m_is_passed(surface.triangles.size())
  {
    std::vector<Bounding_box> boxes(surface.triangles.size());
    for (Index face = 0; face < boxes.size(); ++face) {
      for (const Index corner : surface.triangles[face]) {
        boxes[face].extend(surface.points[corner]);
      }
    }
    m_faces = Box_tree(boxes);
  }

  Node_measures operator()(Index node)
  {
    constexpr double max_distance = 3; // in radii: what reaches farther is not a section of the limb alone
    const Vector3& center = m_skeleton.points[node];
    const double reach = max_distance * m_skeleton.radii[node];
    double least = std::numeric_limits<double>::infinity(); // squared distance
    m_near.clear();
    m_is_near.clear();
    m_faces.visit([&](const Bounding_box& box) { return box.squared_distance(center) <= reach * reach; },
                  [&](Index face) {
                    least = std::min(least, squared_distance(center, face));
                    m_near.push_back(face);
                    m_is_near.mark(face);
                  });
    Node_measures result;
    result.inscribed_radius = least <= reach * reach ? std::sqrt(least) : result.inscribed_radius;
    if (const Vector3 direction = direction_at(node); direction != Vector3::Zero()) {
      result.section_area = section_area(center, direction);
    }
    return result;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;

  /// Along the skeleton, unit length; zero at junctions and isolated nodes.
  Vector3 direction_at(Index node) const
  {
    const std::vector<Index>& neighbors = m_neighbors[node];
    if (neighbors.empty() || neighbors.size() > 2) {
      return Vector3::Zero();
    }
    const Vector3& from = neighbors.size() == 2 ? m_skeleton.points[neighbors[1]] : m_skeleton.points[node];
    return (m_skeleton.points[neighbors[0]] - from).normalized();
  }

  /// The area within the closed curve that the plane through `center` perpendicular to `normal`, of unit length, cuts
  /// out of the faces nearby and that winds around the center, the least of several; not a number if there is none.
  double section_area(const Vector3& center, const Vector3& normal)
  {
    const auto height = [&](Index vertex) { return (m_surface.points[vertex] - center).dot(normal); };
    const auto corner = [&](Index halfedge) { return m_surface.triangles[halfedge / 3][halfedge % 3]; };
    const auto next = [](Index halfedge) { return Halfedge_pairing::next(halfedge); };
    const auto goes = [&](Index halfedge, bool is_up) {
      return (height(corner(next(halfedge))) > 0) == is_up && (height(corner(halfedge)) > 0) != is_up;
    };
    const auto place = [&](Index halfedge) -> Vector3 { // relative to the center
      const Vector3& from = m_surface.points[corner(halfedge)];
      const Vector3& to = m_surface.points[corner(next(halfedge))];
      const double t = height(corner(halfedge)) / (height(corner(halfedge)) - height(corner(next(halfedge))));
      return (1 - t) * from + t * to - center;
    };
    double least = Skeleton_branch::unknown;
    m_is_passed.clear();
    for (const Index face : m_near) {
      Index entry = 3 * face;
      while (entry < 3 * face + 3 && !goes(entry, true)) {
        ++entry;
      }
      if (entry == 3 * face + 3) {
        continue;
      }
      double area = 0;
      double angle = 0;
      while (entry != no_index && m_is_near.is_marked(entry / 3) && m_is_passed.mark(entry / 3)) {
        const Index exit = goes(next(entry), false) ? next(entry) : next(next(entry));
        const Vector3 p = place(entry);
        const Vector3 q = place(exit);
        const double twice_area = p.cross(q).dot(normal);
        area += twice_area / 2;
        angle += std::atan2(twice_area, p.dot(q));
        entry = m_pairing.twin(exit);
      }
      constexpr double half_turn = boost::math::double_constants::pi; // that of a closed curve is a multiple of a turn
      const bool is_closed = entry != no_index && entry / 3 == face;
      if (is_closed && std::abs(angle) > half_turn && !(std::abs(area) >= least)) {
        least = std::abs(area);
      }
    }
    return least;
  }

  double squared_distance(const Vector3& point, Index face) const
  {
    const auto to_point = [](const Vector3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
    const auto& [a, b, c] = m_surface.triangles[face];
    const Kernel::Triangle_3 triangle(to_point(m_surface.points[a]), to_point(m_surface.points[b]),
                                      to_point(m_surface.points[c]));
    return CGAL::squared_distance(to_point(point), triangle);
  }

  const Skeleton& m_skeleton;
  const Assigned_surface& m_surface;
  std::vector<std::vector<Index>> m_neighbors;
  Halfedge_pairing m_pairing;
  Box_tree m_faces;
  std::vector<Index> m_near; ///< faces within reach of the node
  Epoch_marks m_is_near;     ///< of faces: whether among these
  Epoch_marks m_is_passed;   ///< of faces: whether their curve was followed
};

} // namespace

std::vector<double> edge_significances(const Skeleton& skeleton)
{
  return skeleton.has_radii() ? significance_levels(skeleton) : std::vector<double>();
}

Skeleton_branches measure_branches(const Skeleton& skeleton, const std::vector<Index>& roots)
{
  Skeleton_branches result;
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  const std::vector<double> significances = edge_significances(skeleton);
  boost::unordered_map<Node_pair, double> significance;
  for (std::size_t e = 0; e < significances.size(); ++e) { // parallel edges are all infinitely significant
    significance.emplace(std::minmax(skeleton.edges[e][0], skeleton.edges[e][1]), significances[e]);
  }
  for (std::vector<Index>& nodes : split_into_branches(neighbors)) {
    Skeleton_branch& branch = result.branches.emplace_back();
    branch.nodes = std::move(nodes);
    branch.ends = {kind_of_end(skeleton, neighbors, branch.nodes.front()),
                   kind_of_end(skeleton, neighbors, branch.nodes.back())};
    branch.chord = skeleton.length({branch.nodes.front(), branch.nodes.back()});
    for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
      branch.length += skeleton.length({branch.nodes[i - 1], branch.nodes[i]});
    }
    if (skeleton.has_radii()) {
      measure_radii(skeleton, branch);
      if (branch.nodes.size() > 1) {
        branch.significance = significance.at(std::minmax(branch.nodes[0], branch.nodes[1]));
      }
    }
  }
  result.branch_of_node.assign(skeleton.number_of_nodes(), no_index);
  for (Index b = 0; b < result.branches.size(); ++b) {
    for (const Index node : result.branches[b].nodes) {
      Index& its_branch = result.branch_of_node[node];
      const bool is_first = its_branch == no_index;
      its_branch =
          is_first || result.branches[b].mean_radius > result.branches[its_branch].mean_radius ? b : its_branch;
    }
  }
  if (!roots.empty()) {
    assign_orders(Rooted_forest(skeleton, roots), result.branches);
  }
  return result;
}

void measure_surface_parts(const Skeleton& skeleton, const Assigned_surface& surface, Skeleton_branches& branches)
{
  Surface_part_measurement(skeleton, surface, branches).measure();
}

std::vector<Node_measures> measure_nodes(const Skeleton& skeleton, const Assigned_surface& surface)
{
  CGAL_precondition(skeleton.has_radii());
  Node_measurement measure(skeleton, surface);
  std::vector<Node_measures> result;
  result.reserve(skeleton.number_of_nodes());
  for (Index node = 0; node < skeleton.number_of_nodes(); ++node) {
    result.push_back(measure(node));
  }
  return result;
}

} // namespace CSCD::internal
