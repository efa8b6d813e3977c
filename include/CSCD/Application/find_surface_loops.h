// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed geodesics around the handles, the tunnels and the constrictions of a body.

#ifndef CSCD_APPLICATION_FIND_SURFACE_LOOPS_H
#define CSCD_APPLICATION_FIND_SURFACE_LOOPS_H

#include <CSCD/Named_parameters.h>
#include <CSCD/Traits/read_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// The feature of a body that a closed geodesic marks.
enum class Loop_kind
{
  handle,      ///< it bounds a surface inside the body, and cutting along it opens a handle
  tunnel,      ///< it bounds a surface outside the body, across the hole that a handle makes
  constriction ///< it separates the surface where the body is thinner than on both sides
};

/// The name of a value of `Loop_kind`, as files have it.
constexpr const char* name(Loop_kind kind)
{
  return kind == Loop_kind::handle ? "handle" : kind == Loop_kind::tunnel ? "tunnel" : "constriction";
}

/// A closed geodesic on a surface.
template <class Point>
struct Surface_loop
{
  /// The feature that it surrounds.
  Loop_kind kind = Loop_kind::handle;
  /// Its length, in the unit of the mesh.
  double length = 0;
  /// Of a constriction, by how much longer it must become if it is to move away, relative to its own length. The loops
  /// parallel to it are followed on either side, up to three of its diameters away, `length / pi`, and until they have
  /// no connected piece any more that is as long as it; the depth is the excess of the longest piece, on the side where
  /// that is less. It is 0 if no such loop reaches half a diameter away, and for other loops.
  double depth = 0;
  /// Its points on edges and vertices, in order; the last and the first are neighbors.
  std::vector<Point> points;
};

/// Constrictions less deep than this are left out by default: loops parallel to them are longer by so much, relative to
/// them. On FAUST bodies, necks, wrists, ankles and most waists are deeper, folds and toes less deep.
inline constexpr double default_min_constriction_depth = 0.3;

namespace internal {

/// See `CSCD::find_surface_loops()`.
std::vector<Surface_loop<Vector3>> find_surface_loops(std::vector<Vector3> points,
                                                      std::vector<std::array<Index, 3>> faces, unsigned random_seed,
                                                      double min_depth);

} // namespace internal

/// finds short closed geodesics around the handles, tunnels and constrictions of a body (supplement of the method's
/// paper, appendix I.3).
///
/// Candidates are local separators and the shortest loops of greedy bases of homology from several roots (Erickson and
/// Whittlesey, "Greedy optimal homotopy and homology generators", 2005). They are shortened freely, by edge flips.
///
/// A loop is a handle loop if its linking number with every other curve of the surface, pushed outwards, is even, and a
/// tunnel loop if it is with curves pushed inwards. For each kind, the shortest candidates that are independent in the
/// homology of the surface over Z2 are returned: g for a surface of genus g if the candidates contain them. They need
/// not be the shortest of all loops.
///
/// A constriction separates the surface. Of several that are at one place or cross, the shortest is returned.
///
/// Near linear in the number of vertices, times 2 g for a surface of genus g, and at most quadratic in the number of
/// edges of a basis of its loops.
/// \tparam TriangleMesh a model of `FaceListGraph` whose faces are all triangles
/// \param mesh an oriented manifold; the surface counts as closed at its borders
/// \param np an optional sequence of named parameters
/// \param min_depth constrictions that are less deep are left out
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed for the order of the sources of separators}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return handle loops, tunnel loops, constrictions, each kind by increasing length
/// \throw Input_error if the mesh is not an oriented manifold of triangles, or has no extent or no area
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto find_surface_loops(const TriangleMesh& mesh, const NamedParameters& np = parameters::default_values(),
                        double min_depth = default_min_constriction_depth)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                   CGAL::internal_np::random_seed_t>();
  check_triangle_mesh<TriangleMesh>();
  const auto point_map = internal::vertex_point_map(mesh, np);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  auto arrays = internal::read_mesh(mesh, point_map);
  const std::vector<Surface_loop<Vector3>> loops = internal::find_surface_loops(
      std::move(arrays.points), std::move(arrays.faces),
      unsigned(choose_parameter(get_parameter(np, CGAL::internal_np::random_seed), 0U)), min_depth);
  std::vector<Surface_loop<Point>> result;
  result.reserve(loops.size());
  for (const Surface_loop<Vector3>& loop : loops) {
    result.push_back({loop.kind, loop.length, loop.depth, {}});
    result.back().points.reserve(loop.points.size());
    for (const Vector3& point : loop.points) {
      result.back().points.push_back(internal::make_point<Point>(point));
    }
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_APPLICATION_FIND_SURFACE_LOOPS_H
