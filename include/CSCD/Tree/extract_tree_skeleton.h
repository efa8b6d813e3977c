// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton of a scan of trees in one call.

#ifndef CSCD_TREE_EXTRACT_TREE_SKELETON_H
#define CSCD_TREE_EXTRACT_TREE_SKELETON_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Points/Point_cloud.h>
#include <CSCD/Points/recognize_tree_scan.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Traits/Input_points.h>
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// A node of the skeleton of a tree.
struct Tree_node
{
  Vector_3 position;
  double radius;
  Index parent; ///< stands before it; `no_index` for a root
};

/// The skeletons of the objects in a cloud, in the normalized coordinates of its points.
struct Tree_skeleton
{
  std::vector<Tree_node> nodes;
  std::vector<Index> node_of_point; ///< of every point of the cloud
  Tree_report report;               ///< in the unit of the input; without time
};

/// Thins a scan of trees that is denser than its noise allows: between points that are nearer to each other than they
/// are to the bark, there are branches everywhere. Points that are left out are those nearest to them. O(n log n).
Point_cloud thin_to_noise(Point_cloud&& cloud);

/// Skeletonizes a scan of trees; O(n log n).
/// \param root where one of the objects begins; all others begin at their lowest points
Tree_skeleton skeletonize_trees(const Point_cloud& cloud, const std::optional<Vector_3>& root);

/// Makes the graph of a skeleton; `points` are those of the input, of type `Point`.
template <class Skeleton, class Point, class PointRange>
Skeleton make_tree_graph(const PointRange& points, const Point_cloud& cloud, const Tree_skeleton& skeleton)
{
  Skeleton result;
  std::vector<decltype(add_vertex(result))> vertex;
  for (const Tree_node& node : skeleton.nodes) {
    vertex.push_back(add_vertex(result));
    auto& bundle = result[vertex.back()];
    bundle.point = to_input_point<Point>(cloud.normalization, node.position);
    if constexpr (has_radius_v<Skeleton>) {
      bundle.radius = cloud.normalization.unit * node.radius;
    }
    if (node.parent != no_index) {
      add_edge(vertex[node.parent], vertex.back(), result);
    }
  }
  for_each_descriptor(points, [&](std::size_t number, const Point_descriptor<PointRange>& descriptor) {
    result[vertex[skeleton.node_of_point[cloud.input_point[number]]]].vertices.push_back(descriptor);
  });
  compute_significance(result);
  return result;
}

} // namespace internal

/// returns whether dense points are a scan of trees, or of other branching thin things, by the form of their
/// neighborhoods: in more than 8 % of them the points lie along curves, not on a surface. Fewer than 20,000 points show
/// too little of their form: the answer is no. Linear, and fast: a sample of 50,000 points is examined. Does not depend
/// on the order of the points.
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \param points at least one point
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if `points` is empty
/// \pre all coordinates are finite
template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
bool is_scan_of_trees(const PointRange& points, const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t>();
  constexpr std::size_t min_number_of_points = 20000;
  const auto point_map = internal::point_map(points, np);
  std::vector<Vector_3> coordinates;
  for (const auto& element : points) {
    coordinates.push_back(internal::to_vector_3(get(point_map, element)));
  }
  const Point_cloud cloud = make_point_cloud(internal::sample_of(coordinates), {});
  return cloud.points.size() >= min_number_of_points && internal::is_scan_of_trees(internal::forms_of(cloud.points));
}

/// extracts the skeletons of trees, or of other branching thin things, from a scan of them.
///
/// Scans of trees are not surfaces: twigs are hit by few points, limbs are seen from one side, and parts behind others
/// are missing. So no surface is made. Points near each other for the spacing around are joined to a graph; its pieces
/// are joined across gaps; the shortest paths from the root cut it into slices, and these form limbs; circles are
/// fitted across the limbs. Every object becomes a tree of the skeleton, with radii that do not increase from base to
/// tip. A part that stands apart on the ground is an object of its own: the third coordinate is the height.
///
/// Nodes stand in the order of the branches that the report names, parents before children; the first of each object is
/// its root. Every point of the input belongs to exactly one node. The skeleton is the same, to the last bit, from call
/// to call and for any order of the points. O(n log n).
///
/// \tparam PointRange a range over points or over elements that `point_map` maps to points, or a `CGAL::Point_set_3`
/// \tparam Skeleton a model of `CurveSkeletonGraph`; its nodes hold the indices of the points in a `CGAL::Point_set_3`,
///         for other ranges the numbers of the points in the order of iteration, as `std::size_t`
/// \param points at least one point
/// \param skeleton is cleared first; if the function throws, it is left as it was
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of `points` as key}
///     \cgalParamDefault{`points.point_map()` for a `CGAL::Point_set_3`, else `CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{root}
///     \cgalParamDescription{where the trunk of the object next to it begins}
///     \cgalParamType{a point with coordinates `x()`, `y()`, `z()`}
///     \cgalParamDefault{the lowest points of the object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return branches with parent, order, length and radii; the gaps that were bridged; counts and warnings
/// \throw Input_error if there are too many points or none, or a coordinate of a point or of the root is not finite;
///        the message names the point and the remedy
template <class PointRange, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Tree_report extract_tree_skeleton(const PointRange& points, Skeleton& skeleton,
                                  const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::point_t, internal_np::root_t>();
  static_assert(is_point_range_v<PointRange>, "CSCD: extract_tree_skeleton requires a range of points");
  check_curve_skeleton_graph<Skeleton>();
  const auto start = std::chrono::steady_clock::now();
  const auto point_map = internal::point_map(points, np);
  const Point_cloud cloud =
      internal::thin_to_noise(internal::collect_any_points(points, point_map, internal::No_normals()));
  std::optional<Vector_3> root;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::root_t>::value) {
    root = cloud.normalization.from_input(internal::to_vector_3(parameters::get_parameter(np, internal_np::root)));
    if (!root->allFinite()) {
      throw Input_error("the root has a coordinate that is not finite: correct it or leave it out");
    }
  }
  internal::Tree_skeleton trees = internal::skeletonize_trees(cloud, root);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  skeleton = internal::make_tree_graph<Skeleton, Point>(points, cloud, trees);
  trees.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(trees.report);
}

} // namespace CSCD

#endif // CSCD_TREE_EXTRACT_TREE_SKELETON_H
