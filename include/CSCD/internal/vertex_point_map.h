// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a mesh, as the caller of a function says.

#ifndef CSCD_INTERNAL_VERTEX_POINT_MAP_H
#define CSCD_INTERNAL_VERTEX_POINT_MAP_H

#include <CSCD/Named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

namespace CSCD::internal {

/// The point map that `np` gives, else that of the mesh; a mesh whose map is given need not have one of its own.
template <class TriangleMesh, class NamedParameters>
auto vertex_point_map(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value) {
    return get(CGAL::vertex_point, mesh);
  } else {
    return parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  }
}

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_VERTEX_POINT_MAP_H
