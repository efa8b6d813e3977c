// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a mesh or points, and named parameters, to what skeletons are measured against.

#ifndef CSCD_MEASURE_MEASURED_INPUT_H
#define CSCD_MEASURE_MEASURED_INPUT_H

#include <CSCD/Measure/Measured_body.h>
#include <CSCD/Measure/Skeleton_evaluation.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/concepts.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/double.h>
#include <CGAL/float.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Refuses at compile time named parameters that do not apply to a surface of this type, nor are among `MoreTags`.
template <class Surface, class NamedParameters, class... MoreTags>
constexpr void check_evaluation_parameters()
{
  if constexpr (is_triangle_mesh_v<Surface>) {
    check_triangle_mesh<Surface>();
    check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t, MoreTags...>();
  } else {
    check_named_parameters<NamedParameters, CGAL::internal_np::point_t, internal_np::resolution_t,
                           internal_np::use_skeleton_radii_t, MoreTags...>();
  }
}

template <class NamedParameters>
Evaluation_parameters evaluation_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Evaluation_parameters result;
  result.uses_skeleton_radii =
      choose_parameter(get_parameter(np, internal_np::use_skeleton_radii), result.uses_skeleton_radii);
  result.resolution = std::size_t(choose_parameter(get_parameter(np, internal_np::resolution), result.resolution));
  return result;
}

/// Prepares a mesh or a range of points for measuring.
template <class Surface, class NamedParameters>
auto measured_input(const Surface& surface, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr (is_triangle_mesh_v<Surface>) {
    if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value) {
      return std::make_unique<const Measured_body>(surface, get(CGAL::vertex_point, surface));
    } else {
      return std::make_unique<const Measured_body>(surface, get_parameter(np, CGAL::internal_np::vertex_point));
    }
  } else {
    const auto to_vector = [](const auto& point) {
      return Vector_3(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
    };
    std::vector<Vector_3> points;
    for (const auto& element : surface) {
      if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::point_t>::value) {
        points.push_back(to_vector(element));
      } else {
        points.push_back(to_vector(get(get_parameter(np, CGAL::internal_np::point_map), element)));
      }
    }
    return std::make_unique<const Measured_cloud>(std::move(points));
  }
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_MEASURED_INPUT_H
