// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concepts of the input: meshes and ranges of points.

#ifndef CSCD_INPUT_CONCEPTS_H
#define CSCD_INPUT_CONCEPTS_H

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace CSCD::internal {

template <class... T, class Function>
constexpr bool is_valid(const Function& /* expression */)
{
  return std::is_invocable_v<const Function&, T...>;
}

template <class Result, class... T, class Function>
constexpr bool gives(const Function& /* expression */)
{
  return std::is_invocable_r_v<Result, const Function&, T...>;
}

} // namespace CSCD::internal

/// Whether an expression in `t`, an object of type `T`, is valid. The expression is not evaluated.
#define CSCD_IS_VALID(T, ...)                                                                                          \
  ::CSCD::internal::is_valid<T>([]([[maybe_unused]] auto&& t) -> decltype(__VA_ARGS__) { return __VA_ARGS__; })
/// Whether it is valid and convertible to `Result`.
#define CSCD_GIVES(Result, T, ...)                                                                                     \
  ::CSCD::internal::gives<Result, T>([]([[maybe_unused]] auto&& t) -> decltype(__VA_ARGS__) { return __VA_ARGS__; })

namespace CSCD {

#ifdef DOXYGEN_RUNNING
/// CGAL's `FaceListGraph` whose faces are all triangles. The library uses these of its functions, by argument-dependent
/// lookup: `vertices(g)`, `faces(g)`, `num_vertices(g)`, `num_faces(g)`, `halfedge(f, g)`, `next(h, g)` and
/// `target(h, g)`.
///
/// \cgalRefines{CGAL's `FaceListGraph`}
/// \cgalHasModels{`CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, and all others of CGAL's}
/// \cgalArchetype{Triangle_mesh_archetype.h}
/// \cgalConcept
class TriangleMesh
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// Whether `T` is a `FaceListGraph`, judged by its faces; for any type.
// Without boost::graph_traits, which is a hard error for a type that is not a graph.
template <class T>
inline constexpr bool is_triangle_mesh_v = CSCD_IS_VALID(const T&, *std::begin(faces(t)));

/// Whether `T` is a range of points, or of elements with points, and no mesh; for any type.
template <class T>
inline constexpr bool is_point_range_v = CSCD_IS_VALID(const T&, std::begin(t)) &&
                                         CSCD_IS_VALID(const T&, std::end(t)) && !is_triangle_mesh_v<T>;

/// Whether `T` is a graph without faces: it has vertices and edges, as Boost's graphs; for any type.
template <class T>
inline constexpr bool is_spatial_graph_v = CSCD_IS_VALID(const T&, vertices(t)) && CSCD_IS_VALID(const T&, edges(t)) &&
                                           !is_triangle_mesh_v<T> && !is_point_range_v<T>;

/// refuses at compile time a type that is not a `FaceListGraph`.
template <class T>
constexpr void check_triangle_mesh()
{
  static_assert(CSCD_IS_VALID(const T&, vertices(t)),
                "CSCD: TriangleMesh requires vertices(g), as CGAL's FaceListGraph");
  static_assert(is_triangle_mesh_v<T>, "CSCD: TriangleMesh requires faces(g), as CGAL's FaceListGraph");
  static_assert(CSCD_GIVES(std::size_t, const T&, num_vertices(t)),
                "CSCD: TriangleMesh requires num_vertices(g), as CGAL's FaceListGraph");
  static_assert(CSCD_GIVES(std::size_t, const T&, num_faces(t)),
                "CSCD: TriangleMesh requires num_faces(g), as CGAL's FaceListGraph");
  static_assert(CSCD_IS_VALID(const T&, halfedge(*std::begin(faces(t)), t)),
                "CSCD: TriangleMesh requires halfedge(f, g), as CGAL's FaceListGraph");
  static_assert(CSCD_IS_VALID(const T&, next(halfedge(*std::begin(faces(t)), t), t)),
                "CSCD: TriangleMesh requires next(h, g), as CGAL's FaceListGraph");
  static_assert(CSCD_IS_VALID(const T&, target(halfedge(*std::begin(faces(t)), t), t)),
                "CSCD: TriangleMesh requires target(h, g), as CGAL's FaceListGraph");
}

/// @}

} // namespace CSCD

#endif // CSCD_INPUT_CONCEPTS_H
