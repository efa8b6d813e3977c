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
#include <boost/unordered_set.hpp>

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

/// The vertex where `halfedge` begins.
Index origin(const Assigned_surface& surface, Index halfedge)
{
  return surface.triangles[halfedge / 3][halfedge % 3];
}

/// The anchor of a node is the nearer junction at an end of its branch, of a junction itself: the apex of cones.
std::vector<Index> anchors_of_nodes(const Skeleton_branches& branches)
{
  std::vector<Index> anchors(branches.branch_of_node.size(), no_index);
  for (const Skeleton_branch& branch : branches.branches) {
    const bool has_first = branch.ends[0] == Branch_end::junction;
    const bool has_last = branch.ends[1] == Branch_end::junction;
    for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
      const bool is_first_nearer = 2 * i < branch.nodes.size();
      anchors[branch.nodes[i]] = has_first && (is_first_nearer || !has_last) ? branch.nodes.front()
                                 : has_last                                  ? branch.nodes.back()
                                                                             : branch.nodes[i];
    }
  }
  return anchors;
}

/// For each vertex on a border, the middle of that.
std::vector<Vector3> middles_of_borders(const Assigned_surface& surface, const Halfedge_pairing& pairing)
{
  const std::size_t number_of_vertices = surface.points.size();
  Disjoint_sets borders(number_of_vertices);
  std::vector<Index> on_border;
  for (Index h = 0; h < pairing.number_of_halfedges(); ++h) {
    if (pairing.twin(h) == no_index) {
      on_border.push_back(origin(surface, h));
      borders.join(on_border.back(), origin(surface, Halfedge_pairing::next(h)));
    }
  }
  std::vector<Vector3> sums(number_of_vertices);
  std::vector<double> numbers(number_of_vertices, 0);
  for (const Index vertex : on_border) {
    sums[borders.find(vertex)] += surface.points[vertex];
    ++numbers[borders.find(vertex)];
  }
  std::vector<Vector3> middles(number_of_vertices);
  for (const Index vertex : on_border) {
    middles[vertex] = sums[borders.find(vertex)] / numbers[borders.find(vertex)];
  }
  return middles;
}

/// Along the skeleton, unit length; zero at junctions and isolated nodes.
Vector3 direction_at(const Skeleton& skeleton, Index node, const std::vector<Index>& neighbors)
{
  if (neighbors.empty() || neighbors.size() > 2) {
    return Vector3::Zero();
  }
  const Vector3& from = skeleton.points[neighbors.size() == 2 ? neighbors[1] : node];
  return (skeleton.points[neighbors[0]] - from).normalized();
}

double squared_distance(const Vector3& point, const Assigned_surface& surface, Index face)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto corner = [&](std::size_t i) {
    return make_point<Kernel::Point_3>(surface.points[surface.triangles[face][i]]);
  };
  return CGAL::squared_distance(make_point<Kernel::Point_3>(point),
                                Kernel::Triangle_3(corner(0), corner(1), corner(2)));
}

/// The area within the closed curve that the plane through `center` perpendicular to `normal`, of unit length, cuts out
/// of the faces `near` and that winds around the center, the least of several; not a number if there is none.
double section_area(const Assigned_surface& surface, const Halfedge_pairing& pairing, const std::vector<Index>& near,
                    const Vector3& center, const Vector3& normal)
{
  const auto height = [&](Index halfedge) { return (surface.points[origin(surface, halfedge)] - center).dot(normal); };
  const auto next = [](Index halfedge) { return Halfedge_pairing::next(halfedge); };
  const auto goes = [&](Index halfedge, bool is_up) {
    return (height(next(halfedge)) > 0) == is_up && (height(halfedge) > 0) != is_up;
  };
  const auto place = [&](Index halfedge) -> Vector3 { // relative to the center
    const double t = height(halfedge) / (height(halfedge) - height(next(halfedge)));
    return (1 - t) * surface.points[origin(surface, halfedge)] + t * surface.points[origin(surface, next(halfedge))] -
           center;
  };
  std::vector<Index> entries;        // of curves into faces
  boost::unordered_set<Index> ahead; // those of these faces that no curve has passed yet
  for (const Index face : near) {
    for (Index halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge) {
      if (goes(halfedge, true)) {
        entries.push_back(halfedge);
        ahead.insert(face);
      }
    }
  }
  double least = Skeleton_branch::unknown;
  for (const Index first : entries) {
    double area = 0;
    double angle = 0;
    Index entry = first;
    while (entry != no_index && ahead.erase(entry / 3) != 0) {
      const Index exit = goes(next(entry), false) ? next(entry) : next(next(entry));
      const Vector3 p = place(entry);
      const Vector3 q = place(exit);
      const double twice_area = p.cross(q).dot(normal);
      area += twice_area / 2;
      angle += std::atan2(twice_area, p.dot(q));
      entry = pairing.twin(exit);
    }
    constexpr double half_turn = boost::math::double_constants::pi; // that of a closed curve is a multiple of a turn
    if (entry == first && std::abs(angle) > half_turn && !(std::abs(area) >= least)) {
      least = std::abs(area);
    }
  }
  return least;
}

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
  const Halfedge_pairing pairing(surface.triangles, surface.points.size());
  const std::vector<Index> nodes = nodes_of_faces(surface);
  const std::vector<Index> anchors = anchors_of_nodes(branches);
  const std::vector<Vector3> middles = middles_of_borders(surface, pairing);
  Vector3 center; // near the surface, so that volumes do not cancel
  for (const Vector3& point : surface.points) {
    center += point / double(surface.points.size());
  }
  const auto tetrahedron = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    return (a - center).cross(b - center).dot(c - center) / 6;
  };
  const auto branch_of_face = [&](Index face) { return branches.branch_of_node[nodes[face]]; };
  // The apex of the cone that closes the part of a face at one of its sides; nothing if the part goes on there.
  const auto apex_behind = [&](Index halfedge) -> std::optional<Vector3> {
    const auto anchor = [&](Index face) -> const Vector3& { return skeleton.points[anchors[nodes[face]]]; };
    const Index face = halfedge / 3;
    const Index other = pairing.twin(halfedge) / 3;
    if (pairing.twin(halfedge) == no_index) {
      return middles[origin(surface, halfedge)];
    }
    if (nodes[other] == no_index) {
      return anchor(face);
    }
    return branch_of_face(face) == branch_of_face(other) ? std::nullopt
                                                         : std::optional((anchor(face) + anchor(other)) / 2);
  };
  for (Skeleton_branch& branch : branches.branches) {
    branch.surface_area = branch.volume = 0;
  }
  double total = 0;
  for (Index face = 0; face < nodes.size(); ++face) {
    if (nodes[face] == no_index) {
      continue;
    }
    const auto& [a, b, c] = surface.triangles[face];
    const std::array<Vector3, 3> corners{surface.points[a], surface.points[b], surface.points[c]};
    double volume = tetrahedron(corners[0], corners[1], corners[2]);
    for (Index side = 0; side < 3; ++side) {
      if (const std::optional<Vector3> apex = apex_behind(3 * face + side)) {
        volume += tetrahedron(corners[(side + 1) % 3], corners[side], *apex);
      }
    }
    Skeleton_branch& branch = branches.branches[branch_of_face(face)];
    branch.surface_area += triangle_area(corners[0], corners[1], corners[2]);
    branch.volume += volume;
    total += volume;
  }
  if (total < 0) { // the surface faces inwards
    for (Skeleton_branch& branch : branches.branches) {
      branch.volume = -branch.volume;
    }
  }
}

std::vector<Node_measures> measure_nodes(const Skeleton& skeleton, const Assigned_surface& surface)
{
  CGAL_precondition(skeleton.has_radii());
  constexpr double max_distance = 3; // in radii: what reaches farther is not a section of the limb alone
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  const Halfedge_pairing pairing(surface.triangles, surface.points.size());
  std::vector<Bounding_box> boxes(surface.triangles.size());
  for (Index face = 0; face < boxes.size(); ++face) {
    for (const Index corner : surface.triangles[face]) {
      boxes[face].extend(surface.points[corner]);
    }
  }
  const Box_tree faces(boxes);
  std::vector<Node_measures> result(skeleton.number_of_nodes());
  for (Index node = 0; node < result.size(); ++node) {
    const Vector3& center = skeleton.points[node];
    const double reach = max_distance * skeleton.radii[node];
    double least = std::numeric_limits<double>::infinity(); // squared distance
    std::vector<Index> near;
    faces.visit([&](const Bounding_box& box) { return box.squared_distance(center) <= reach * reach; },
                [&](Index face) {
                  least = std::min(least, squared_distance(center, surface, face));
                  near.push_back(face);
                });
    if (least <= reach * reach) {
      result[node].inscribed_radius = std::sqrt(least);
    }
    if (const Vector3 direction = direction_at(skeleton, node, neighbors[node]); direction != Vector3::Zero()) {
      result[node].section_area = section_area(surface, pairing, near, center, direction);
    }
  }
  return result;
}

} // namespace CSCD::internal
