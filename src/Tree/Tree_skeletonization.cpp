// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a scan of trees to slices, sections, nodes and branches; cylinders of limbs, and the foresters' measures of
// them.

#include "Tree/Limb_finder.h"
#include "Tree/Neighbor_graph.h"
#include "Tree/Section_fitting.h"
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Points/Cloud_sampling.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Tree/extract_tree_skeleton.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// The foot of a trunk: the points of an object that are lowest and connected with the lowest. If that is too wide for
/// a foot, the outermost of them, an end of an object that lies. \param is_taken is set for the points that were looked
/// at
std::vector<Index> find_foot(const std::vector<Vector3>& points, const Neighbor_graph& graph,
                             const std::vector<Index>& members, std::vector<char>& is_taken)
{
  constexpr double foot_height = 3; // above the lowest point, relative to the spacing there
  // From the lowest point, relative to the extent of the object: a wider part is not a foot.
  constexpr double foot_width = 0.15;
  Index lowest = members.front();
  Vector3 centroid = Vector3::Zero();
  for (const Index point : members) {
    lowest = points[point].z() < points[lowest].z() ? point : lowest;
    centroid += points[point] / double(members.size());
  }
  double extent = 0;
  for (const Index point : members) {
    extent = std::max(extent, 2 * (points[point] - centroid).norm());
  }
  const double top = points[lowest].z() + foot_height * graph.spacing(lowest);
  const auto distance = [&](Index point) { return (points[point] - points[lowest]).norm(); };
  std::vector<Index> foot;
  const auto take = [&](Index point) {
    if (is_taken[point] == 0 && points[point].z() <= top) {
      is_taken[point] = 1;
      foot.push_back(point);
    }
  };
  take(lowest);
  for (std::size_t i = 0; i < foot.size(); ++i) {
    const Index point = foot[i]; // the vector grows
    for (const Index neighbor : graph.neighbors(point)) {
      take(neighbor);
    }
  }
  std::sort(foot.begin(), foot.end());
  if (std::any_of(foot.begin(), foot.end(), [&](Index point) { return distance(point) > foot_width * extent; })) {
    return {*std::max_element(foot.begin(), foot.end(), [&](Index a, Index b) {
      return (points[a] - centroid).squaredNorm() < (points[b] - centroid).squaredNorm();
    })};
  }
  return foot;
}

/// For each object the points that distances start from. Shortest paths from a single point would go round a thick
/// trunk; from all around its foot, they go up.
/// \param root where one of the objects, the nearest, begins; all others begin at their lowest points
std::vector<std::vector<Index>> roots_of_objects(const std::vector<Vector3>& points, const Neighbor_graph& graph,
                                                 const Gap_bridging& bridging, const std::optional<Vector3>& root)
{
  std::vector<std::vector<Index>> members(bridging.number_of_objects());
  Index nearest = no_index;
  for (Index point = 0; point < points.size(); ++point) {
    if (bridging.object(point) == no_index) {
      continue;
    }
    members[bridging.object(point)].push_back(point);
    if (root &&
        (nearest == no_index || (points[point] - *root).squaredNorm() < (points[nearest] - *root).squaredNorm())) {
      nearest = point;
    }
  }
  std::vector<char> is_taken(points.size(), 0);
  std::vector<std::vector<Index>> result;
  result.reserve(members.size());
  for (const std::vector<Index>& of_object : members) {
    result.push_back(find_foot(points, graph, of_object, is_taken));
  }
  if (root) {
    result[bridging.object(nearest)] = {nearest};
  }
  return result;
}

/// Makes a node of each section of a limb, one where a trunk begins, and one at the tip of each limb.
class Tree_nodes
{
public:
  Tree_nodes(const std::vector<Vector3>& points, const std::vector<Slice>& slices, const std::vector<Section>& sections,
             const std::vector<Tree_limb>& limbs)
      : node_of_slice(slices.size(), no_index), m_points(points), m_slices(slices), m_sections(sections)
  {
    for (const Tree_limb& limb : limbs) {
      add(limb);
    }
    find_strahler_orders();
  }

  std::vector<Vector3> centers;      ///< of the nodes, parents first, and each branch in one piece
  std::vector<double> radii;         ///< of the nodes
  std::vector<Tree_branch> branches; ///< one for each limb; lengths are in the unit of the points
  std::vector<Index> node_of_slice;  ///< of the slices of limbs
  std::array<std::size_t, number_of_circle_outcomes> number_of_outcomes{}; ///< of the sections

private:
  /// The least distance of an end from the next center, relative to the spacing of the points.
  static constexpr double min_end = 0.1;
  /// How far along its parent a joint is moved, relative to the radius of the parent.
  static constexpr double farthest_move = 3;
  /// The number of nodes that give the line of a branch.
  static constexpr std::size_t line_nodes = 4;

  void add(const Tree_limb& limb)
  {
    Tree_branch branch;
    if (limb.joint != no_index) {
      branch.parent = limb.parent;
      branch.object = branches[limb.parent].object;
      branch.order = branches[limb.parent].order + 1;
      branch.nodes.push_back(node_of_slice[limb.joint]);
    } else { // trunks stand in the order of the objects
      branch.object = m_number_of_trunks++;
      add_end(limb.slices.front(), -1, branch);
    }
    for (Index slice : limb.slices) {
      const Section& section = m_sections[slice];
      add_node(section.center, section.radius, branch);
      node_of_slice[slice] = Index(branch.nodes.back());
      branch.number_of_circles += section.is_circle() ? 1 : 0;
      ++number_of_outcomes[std::size_t(section.outcome)];
    }
    branch.number_of_sections = limb.slices.size();
    add_end(limb.slices.back(), 1, branch);
    if (limb.joint != no_index) {
      move_joint(branch);
    }
    branch.radius_at_base = m_sections[limb.slices.front()].radius;
    branch.radius_at_tip = radii[branch.nodes.back()];
    for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
      branch.length += (centers[branch.nodes[i]] - centers[branch.nodes[i - 1]]).norm();
    }
    branches.push_back(std::move(branch));
  }

  void add_node(const Vector3& center, double radius, Tree_branch& branch)
  {
    branch.nodes.push_back(centers.size());
    centers.push_back(center);
    radii.push_back(radius);
  }

  /// Adds a node where the axis leaves the points of a slice, backward or forward.
  void add_end(Index slice, int sense, Tree_branch& branch)
  {
    const Section& section = m_sections[slice];
    double farthest = 0;
    for (Index point : m_slices[slice].points) {
      farthest = std::max(farthest, sense * (m_points[point] - section.center).dot(section.direction));
    }
    if (farthest > min_end * m_slices[slice].spacing) {
      add_node(section.center + sense * farthest * section.direction, section.radius, branch);
    }
  }

  /// Moves the joint of a branch along its parent to where the line of its first nodes points: slices of limbs fall
  /// apart in the crotch, beyond the place where their axes meet.
  void move_joint(Tree_branch& branch)
  {
    const Vector3& base = centers[branch.nodes[1]];
    const Vector3& far = centers[branch.nodes[std::min(branch.nodes.size() - 1, line_nodes)]];
    if (far == base) {
      return;
    }
    const Vector3 direction = (far - base).normalized();
    const Tree_branch& parent = branches[branch.parent];
    const std::size_t old_joint = branch.nodes.front();
    double least = std::numeric_limits<double>::max();
    // The first node of a branch belongs to another one.
    for (std::size_t i = parent.parent == no_branch ? 0 : 1; i < parent.nodes.size(); ++i) {
      const Vector3& place = centers[parent.nodes[i]];
      if ((place - centers[old_joint]).norm() > farthest_move * radii[old_joint]) {
        continue;
      }
      const Vector3 d = place - base;
      const double distance = d.cross(direction).norm() + std::max(0., d.dot(direction));
      if (distance < least) {
        least = distance;
        branch.nodes.front() = parent.nodes[i];
      }
    }
  }

  /// Horton's orders as of Strahler, from tips to bases.
  void find_strahler_orders()
  {
    std::vector<std::size_t> order_at_node(centers.size(), 0); // the highest of the branches that begin there
    for (std::size_t b = branches.size(); b-- > 0;) {
      Tree_branch& branch = branches[b];
      branch.strahler_order = 1;
      for (std::size_t i = branch.nodes.size(); i-- > (branch.parent == no_branch ? 0u : 1u);) {
        const std::size_t joining = order_at_node[branch.nodes[i]];
        branch.strahler_order =
            joining == branch.strahler_order ? joining + 1 : std::max(joining, branch.strahler_order);
      }
      if (branch.parent != no_branch) {
        // Two of an order that begin at one node are one of the next.
        std::size_t& order = order_at_node[branch.nodes.front()];
        order = order == branch.strahler_order ? order + 1 : std::max(order, branch.strahler_order);
      }
    }
  }

  std::size_t m_number_of_trunks = 0;
  const std::vector<Vector3>& m_points;
  const std::vector<Slice>& m_slices;
  const std::vector<Section>& m_sections;
};

/// Measures twice: the first time, to find the bridge where each piece is entered. \param gaps is set to these bridges
Root_distances measure_distances(const std::vector<Vector3>& points, const Gap_bridging& bridging,
                                 const std::vector<std::vector<Index>>& roots, Neighbor_graph& graph,
                                 std::vector<Point_gap>& gaps)
{
  graph.set_bridges(bridging.bridges());
  Root_distances distances(points, graph, roots);
  if (!bridging.bridges().empty()) {
    gaps = bridging.entries(distances);
    graph.set_bridges(gaps);
    distances = Root_distances(points, graph, roots);
  }
  return distances;
}

/// Fits the sections of all slices of limbs; slices at the base of a limb may go to another one.
/// \param host of every slice, the one that has its points
std::vector<Section> fit_sections(const std::vector<Vector3>& points, std::vector<Slice>& slices,
                                  std::vector<Tree_limb>& limbs, std::vector<Index>& host)
{
  Section_fitting fitting(points, slices);
  const auto fit = [&] {
    for (const Tree_limb& limb : limbs) {
      fitting.fit(limb);
    }
  };
  fit();
  fitting.estimate_noise();
  const std::vector<Index> absorbing = absorb_limb_bases(slices, fitting.sections(), limbs);
  for (Index& slice : host) {
    slice = absorbing[slice];
  }
  fit();
  fitting.limit_by_pipe_model(limbs);
  return fitting.sections();
}

/// The warnings about a scan and its skeleton, one sentence each.
std::vector<std::string> tree_warnings(const Tree_report& report)
{
  std::vector<std::string> result;
  const auto add = [&result](std::size_t count, const char* one, const char* many) {
    if (count > 0) {
      result.push_back(counted(count, one, many));
    }
  };
  add(report.number_of_duplicates, "point at the place of another: it belongs to the same node",
      "points at the place of others: they belong to the same nodes");
  add(report.number_of_thinned_points,
      "point nearer to others than twice the noise: it belongs to the node of the nearest",
      "points nearer to others than twice the noise: they belong to the nodes of the nearest");
  add(report.number_of_debris, "point of no object: it belongs to the node of the nearest",
      "points of no object: they belong to the nodes of the nearest");
  add(report.gaps.size(), "gap between pieces of the scan: bridged", "gaps between pieces of the scan: bridged");
  const std::size_t number_of_sections =
      std::accumulate(report.number_of_sections.begin(), report.number_of_sections.end(), std::size_t(0));
  const std::size_t number_without_circle =
      number_of_sections - report.number_of_sections[std::size_t(Circle_outcome::fitted)];
  if (number_without_circle > 0) {
    result.push_back(std::to_string(number_without_circle) + " of " + counted(number_of_sections, "section") +
                     " of branches without a circle: their radii are rough");
  }
  return result;
}

/// Reports on `trees`, in the coordinates of the input, without the time. \param gaps that were bridged
Tree_report make_report(const Point_cloud& cloud, const Neighbor_graph& graph, const Gap_bridging& bridging,
                        const std::vector<Point_gap>& gaps, const Tree_nodes& trees)
{
  const Normalization& normalization = cloud.normalization;
  Tree_report report;
  report.number_of_points = cloud.input_point.size();
  report.number_of_duplicates = cloud.number_of_duplicates();
  report.number_of_thinned_points = cloud.number_of_thinned_points;
  for (Index point : cloud.input_point) {
    report.number_of_debris += bridging.object(point) == no_index ? 1 : 0;
  }
  std::vector<double> spacings;
  for (Index point = 0; point < cloud.points.size(); ++point) {
    spacings.push_back(graph.spacing(point));
  }
  report.number_of_objects = bridging.number_of_objects();
  report.spacing = normalization.unit * quantile(std::move(spacings), 0.5);
  report.number_of_sections = trees.number_of_outcomes;
  report.number_of_nodes = trees.centers.size();
  report.number_of_edges = report.number_of_nodes - report.number_of_objects;
  report.branches = trees.branches;
  for (Tree_branch& branch : report.branches) {
    branch.length *= normalization.unit;
    branch.radius_at_base *= normalization.unit;
    branch.radius_at_tip *= normalization.unit;
  }
  for (const Point_gap& gap : gaps) {
    report.gaps.push_back({normalization.to_input(cloud.points[gap.a]), normalization.to_input(cloud.points[gap.b]),
                           normalization.unit * gap.length});
  }
  report.warnings = tree_warnings(report);
  return report;
}

/// The trees in the coordinates of the input. \param node_of_point for every point of `cloud`
Skeleton to_skeleton(const Point_cloud& cloud, const Tree_nodes& trees, const std::vector<Index>& node_of_point)
{
  Skeleton skeleton;
  for (std::size_t node = 0; node < trees.centers.size(); ++node) {
    skeleton.points.push_back(cloud.normalization.to_input(trees.centers[node]));
    skeleton.radii.push_back(cloud.normalization.unit * trees.radii[node]);
  }
  for (const Tree_branch& branch : trees.branches) {
    for (std::size_t i = 1; i < branch.nodes.size(); ++i) {
      skeleton.edges.push_back({Index(branch.nodes[i - 1]), Index(branch.nodes[i])});
    }
  }
  skeleton.is_joined.assign(skeleton.edges.size(), 0);
  skeleton.is_opening.assign(skeleton.points.size(), 0);
  skeleton.significance = significance_levels(skeleton);
  skeleton.vertices.resize(skeleton.points.size());
  for (Index number = 0; number < cloud.input_point.size(); ++number) {
    skeleton.vertices[node_of_point[cloud.input_point[number]]].push_back(number);
  }
  return skeleton;
}

/// Makes the skeletons of the objects in a cloud, step by step. O(n log n).
/// \param root where one of the objects begins; all others begin at their lowest points
/// \return the report without the time
Tree_report skeletonize_cloud(const Point_cloud& cloud, const std::optional<Vector3>& root, Skeleton& skeleton)
{
  const std::vector<Vector3>& points = cloud.points;
  Neighbor_graph graph(points);
  const Gap_bridging bridging(points, graph);
  const std::vector<std::vector<Index>> roots = roots_of_objects(points, graph, bridging, root);
  std::vector<Point_gap> gaps;
  const Root_distances distances = measure_distances(points, bridging, roots, graph, gaps);
  std::vector<Slice> slices;
  Slice_growth growth(points, graph, distances);
  for (const std::vector<Index>& of_object : roots) {
    growth.grow(of_object, slices);
  }
  Limb_finder finder(slices);
  std::vector<Tree_limb> limbs = finder.limbs();
  std::vector<Index> host = finder.hosts();
  const std::vector<Section> sections = fit_sections(points, slices, limbs, host);
  const Tree_nodes trees(points, slices, sections, limbs);
  std::vector<Index> node_of_point(points.size(), no_index);
  for (Index slice = 0; slice < slices.size(); ++slice) {
    for (Index point : slices[slice].points) {
      node_of_point[point] = trees.node_of_slice[host[slice]];
    }
  }
  assign_to_nearest(points, node_of_point);
  skeleton = to_skeleton(cloud, trees, node_of_point);
  return make_report(cloud, graph, bridging, gaps, trees);
}

/// How far `points` deviate from the bark: from quadrics through some of them and their neighbors, at the quarter of
/// the places where it is least. From those at twigs, they deviate without noise.
double noise_of_bark(const std::vector<Vector3>& points)
{
  constexpr std::size_t number_of_places = 2000;
  constexpr double noise_quantile = 0.25;
  const Point_tree tree(points);
  std::vector<double> deviations;
  std::vector<Index> neighbors;
  for (std::size_t place = 0; place < points.size(); place += points.size() / number_of_places + 1) {
    const auto point = Index(place);
    double squared_reach = 0;
    neighbors.clear();
    tree.for_each_nearest(points[point], quadric_neighbors + 1, [&](Index neighbor, double square) {
      if (neighbor != point) {
        neighbors.push_back(neighbor);
        squared_reach = square;
      }
    });
    deviations.push_back(
        fit_quadric(points, point, {neighbors.data(), neighbors.data() + neighbors.size()}, std::sqrt(squared_reach))
            .deviation);
  }
  return quantile(std::move(deviations), noise_quantile);
}

/// Thins a scan of trees that is denser than its noise allows: between points that are nearer to each other than they
/// are to the bark, there are branches everywhere. Points that are left out are those nearest to them. O(n log n).
Point_cloud thin_to_noise(Point_cloud&& cloud)
{
  // In the unit of the noise: of four synthetic trees seen from two sides, with 1.5 there are twice as many superfluous
  // branches, with 2.5 fewer limbs.
  constexpr double min_distance = 2;
  // If a greater part of a scan would remain, the scan is not dense, and would lose twigs: 0.79 of scans from two sides
  // remain, and 0.83 or more of trees with as much noise for the spacing, but even density.
  constexpr double largest_part = 0.8;
  constexpr double rounding = 1e-9; // in the cube [-1, 1]^3 of the points, far above the residual of fits
  const double distance = min_distance * noise_of_bark(cloud.points);
  if (!(distance > rounding)) {
    return std::move(cloud);
  }
  const std::vector<Index> kept = thin(cloud.points, distance);
  if (double(kept.size()) > largest_part * double(cloud.points.size())) {
    return std::move(cloud);
  }
  std::vector<Index> representative(cloud.points.size(), no_index);
  for (Index i = 0; i < kept.size(); ++i) {
    representative[kept[i]] = i;
  }
  assign_to_nearest(cloud.points, representative);
  for (Index& point : cloud.input_point) {
    point = representative[point];
  }
  cloud.number_of_thinned_points += cloud.points.size() - kept.size();
  cloud.points = reordered(cloud.points, kept);
  return std::move(cloud);
}

} // namespace

Tree_report skeletonize_trees(const std::vector<Vector3>& points, const std::optional<Vector3>& root,
                              Skeleton& skeleton)
{
  const auto start = std::chrono::steady_clock::now();
  const Point_cloud cloud = thin_to_noise(make_point_cloud(std::vector<Vector3>(points), {}));
  std::optional<Vector3> place;
  if (root) {
    place = cloud.normalization.from_input(*root);
    if (!place->allFinite()) {
      throw Input_error("the root has a coordinate that is not finite: correct it or leave it out");
    }
  }
  Tree_report report = skeletonize_cloud(cloud, place, skeleton);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

namespace {

/// The volume of a cylinder.
double volume(const Tree_cylinder& cylinder)
{
  return boost::math::double_constants::pi * cylinder.radius * cylinder.radius * cylinder.length;
}

/// The radius of a trunk where it first reaches a height, linear between nodes; not a number if it does not.
double radius_at_height(const Skeleton& skeleton, const std::vector<std::size_t>& trunk, double height)
{
  for (std::size_t i = 1; i < trunk.size(); ++i) {
    const double from = skeleton.points[trunk[i - 1]].z();
    const double to = skeleton.points[trunk[i]].z();
    if (from <= height && height < to) {
      const double part = (height - from) / (to - from);
      return (1 - part) * skeleton.radii[trunk[i - 1]] + part * skeleton.radii[trunk[i]];
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<Tree_cylinder> make_tree_cylinders(const Skeleton& skeleton, const Tree_report& report)
{
  std::vector<Tree_cylinder> result;
  std::vector<std::optional<std::size_t>> cylinder_to(skeleton.number_of_nodes()); // that ends in a node
  for (std::size_t limb = 0; limb < report.branches.size(); ++limb) {
    const std::vector<std::size_t>& nodes = report.branches[limb].nodes;
    const bool is_trunk = report.branches[limb].parent == no_branch;
    std::size_t position = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const bool is_base = i == 1 && !is_trunk;
      const double radius = skeleton.radii[nodes[i]];
      const double radius_before = skeleton.radii[nodes[i - 1]];
      const Vector3 edge = skeleton.points[nodes[i]] - skeleton.points[nodes[i - 1]];
      const double inside = is_base ? radius_before : 0; // a limb begins at the bark of its parent
      cylinder_to[nodes[i]] = cylinder_to[nodes[i - 1]];
      if (!(edge.norm() > inside)) {
        continue;
      }
      Tree_cylinder cylinder;
      cylinder.axis = edge.normalized();
      cylinder.start = skeleton.points[nodes[i - 1]] + inside * cylinder.axis;
      cylinder.length = edge.norm() - inside;
      cylinder.radius = is_base ? radius : (radius_before + radius) / 2;
      cylinder.parent = cylinder_to[nodes[i - 1]];
      cylinder.limb = limb;
      cylinder.position = position++;
      if (cylinder.position > 0) {
        result.back().extension = result.size();
      }
      cylinder_to[nodes[i]] = result.size();
      result.push_back(cylinder);
    }
  }
  return result;
}

std::vector<Tree_measures> measure_trees(const Skeleton& skeleton, const Tree_report& report, double breast_height)
{
  std::vector<Tree_measures> result(report.number_of_objects);
  std::vector<double> foot(report.number_of_objects, 0);
  for (const Tree_branch& limb : report.branches) { // parents before children
    Tree_measures& tree = result[limb.object];
    if (limb.parent == no_branch) {
      foot[limb.object] = skeleton.points[limb.nodes.front()].z();
      tree.diameter_at_breast_height = 2 * radius_at_height(skeleton, limb.nodes, foot[limb.object] + breast_height);
    }
    tree.length += limb.length;
    for (const std::size_t node : limb.nodes) {
      tree.height = std::max(tree.height, skeleton.points[node].z() - foot[limb.object]);
    }
  }
  for (const Tree_cylinder& cylinder : make_tree_cylinders(skeleton, report)) {
    const Tree_branch& limb = report.branches[cylinder.limb];
    result[limb.object].volume += volume(cylinder);
    result[limb.object].trunk_volume += limb.parent == no_branch ? volume(cylinder) : 0;
  }
  return result;
}

} // namespace CSCD::internal

namespace CSCD {

void assign_limbs(const Tree_report& report, Skeleton_branches& branches)
{
  std::vector<std::size_t> limb_of_node(branches.branch_of_node.size(), 0);
  for (std::size_t limb = report.branches.size(); limb-- > 0;) {
    const Tree_branch& branch = report.branches[limb];
    for (std::size_t i = branch.parent == no_branch ? 0 : 1; i < branch.nodes.size(); ++i) {
      limb_of_node[branch.nodes[i]] = limb;
    }
  }
  for (Skeleton_branch& branch : branches.branches) {
    branch.limb = limb_of_node[branch.nodes.back()];
  }
}

} // namespace CSCD
