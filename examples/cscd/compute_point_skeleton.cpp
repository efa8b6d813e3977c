// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation for points; a file of its own, as the code for it takes long to compile.

#include "compute_point_skeleton.h"

#include "compute_tree_skeleton.h"
#include "convert_skeleton.h"
#include "run_skeletonization.h"
#include "types.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/Point_set_traits.h>
#include <CSCD/exceptions.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace cscd {

namespace {

using Numbers = std::vector<std::size_t>;
using Point_map = CGAL::Pointer_property_map<Point>::const_type;
using Traits = CSCD::Point_set_traits<Numbers, Point_map>;

/// The surface of `traits`; its first vertices are `points`, the others were inserted.
Mesh make_mesh(const std::vector<Point>& points, const Traits& traits)
{
  Mesh mesh;
  for (const Point& point : points) {
    mesh.add_vertex(point);
  }
  std::vector<Mesh::Vertex_index> vertex_of_site;
  for (Traits::Index site = 0; site < traits.number_of_sites(); ++site) {
    const auto numbers = traits.descriptors(site);
    vertex_of_site.push_back(numbers.begin() == numbers.end()
                                 ? mesh.add_vertex(traits.to_input_point(traits.point(site)))
                                 : Mesh::Vertex_index(static_cast<Mesh::size_type>(*numbers.begin())));
  }
  for (Traits::Index triangle = 0; triangle < traits.number_of_triangles(); ++triangle) {
    const std::array<Traits::Index, 3> sites = traits.triangle(triangle);
    mesh.add_face(vertex_of_site[sites[0]], vertex_of_site[sites[1]], vertex_of_site[sites[2]]);
  }
  return mesh;
}

/// The surface that is made of the points of `input`.
Traits make_traits(const Input& input, const Numbers& numbers)
{
  const Point_map point_map = CGAL::make_property_map(std::as_const(input.points));
  return input.normals.empty() ? Traits(numbers, point_map)
                               : Traits(numbers, point_map, CGAL::make_property_map(std::as_const(input.normals)));
}

Skeletonization_result compute_surface_skeleton(Input& input, const Traits& traits, const Skeletonize_options& options,
                                                Progress_visitor& visitor)
{
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  Skeletonization_result result = run_skeletonization(traits, options, visitor, skeleton);
  result.skeleton = convert_skeleton(skeleton);
  input.mesh = make_mesh(input.points, traits);
  return result;
}

/// The same for points that may be no surface, with the reason in front of the warnings.
Skeletonization_result compute_recognized_tree_skeleton(Input& input, const Skeletonize_options& options,
                                                        const std::string& reason)
{
  Skeletonization_result result = compute_tree_skeleton(input, options);
  std::vector<std::string>& warnings = result.tree->warnings;
  warnings.insert(warnings.begin(), reason + ": taken for a scan of trees; --shape surface or tree decides");
  return result;
}

} // namespace

Skeletonization_result compute_point_skeleton(Input& input, const Skeletonize_options& options,
                                              Progress_visitor& visitor)
{
  if (options.shape == tree_shape) {
    return compute_tree_skeleton(input, options);
  }
  Numbers numbers(input.points.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  try {
    const Traits traits = make_traits(input, numbers);
    if (options.shape == surface_shape || !traits.is_surface_doubtful()) {
      return compute_surface_skeleton(input, traits, options, visitor);
    }
  } catch (const CSCD::Surface_error&) {
    // Of a handful of points nothing can be told.
    constexpr std::size_t least_scan = 100;
    if (options.shape == surface_shape || input.points.size() < least_scan) {
      throw;
    }
    return compute_recognized_tree_skeleton(input, options, "the points do not sample a surface");
  }
  return compute_recognized_tree_skeleton(input, options, "the points hardly sample the surface of a body");
}

} // namespace cscd
