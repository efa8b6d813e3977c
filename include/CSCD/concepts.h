// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concepts of the library, in code: whether a type is a model, and functions that refuse at compile time what is
// none, with one sentence for each missing expression.

#ifndef CSCD_CONCEPTS_H
#define CSCD_CONCEPTS_H

#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CSCD {

namespace internal {

template <class Void, template <class...> class Expression, class... T>
struct Is_valid : std::false_type
{
};

template <template <class...> class Expression, class... T>
struct Is_valid<std::void_t<Expression<T...>>, Expression, T...> : std::true_type
{
};

/// Whether the type `Expression<T...>` is well formed.
template <template <class...> class Expression, class... T>
inline constexpr bool is_valid_v = Is_valid<void, Expression, T...>::value;

template <class Void, class Result, template <class...> class Expression, class... T>
struct Gives : std::false_type
{
};

template <class Result, template <class...> class Expression, class... T>
struct Gives<std::void_t<Expression<T...>>, Result, Expression, T...> : std::is_convertible<Expression<T...>, Result>
{
};

/// Whether the type `Expression<T...>` is well formed and can be converted to `Result`.
template <class Result, template <class...> class Expression, class... T>
inline constexpr bool gives_v = Gives<void, Result, Expression, T...>::value;

/// The type of the elements of a range.
template <class Range>
using Element = decltype(*std::begin(std::declval<Range&>()));

/// The expressions of the concepts, as types: `t` is an object, `g` a graph, `i` an index, each of its parameter's
/// type.
namespace expressions {

template <class T>
using Point = typename T::Point;
template <class T>
using Site_descriptor = typename T::Site_descriptor;
template <class T>
using number_of_sites = decltype(std::declval<const T&>().number_of_sites());
template <class T>
using point = decltype(std::declval<const T&>().point(Index()));
template <class T>
using weight = decltype(std::declval<const T&>().weight(Index()));
template <class T>
using normal = decltype(std::declval<const T&>().normal(Index()));
template <class T>
using neighbor = Element<decltype(std::declval<const T&>().neighbors(Index()))>;
template <class T>
using number_of_triangles = decltype(std::declval<const T&>().number_of_triangles());
template <class T>
using corner = decltype(std::declval<const T&>().triangle(Index())[2]);

// Found by argument-dependent look-up only. boost::graph_traits is not asked: it fails hard on what is no graph.
template <class G>
using faces = Element<decltype(faces(std::declval<const G&>()))>;
template <class T>
using begin = decltype(std::begin(std::declval<T&>()));
template <class T>
using end = decltype(std::end(std::declval<T&>()));
template <class T>
using reconstruction_report = decltype(std::declval<const T&>().reconstruction_report());

template <class G>
using vertices = decltype(vertices(std::declval<const G&>()));
template <class G>
using num_vertices = decltype(num_vertices(std::declval<const G&>()));
template <class G>
using num_halfedges = decltype(num_halfedges(std::declval<const G&>()));
template <class G>
using halfedge = decltype(halfedge(std::declval<faces<G>>(), std::declval<const G&>()));
template <class G>
using next = decltype(next(std::declval<halfedge<G>>(), std::declval<const G&>()));
template <class G>
using target = decltype(target(std::declval<halfedge<G>>(), std::declval<const G&>()));

template <class G>
using add_vertex = decltype(add_vertex(std::declval<G&>()));
template <class G>
using add_edge = decltype(add_edge(std::declval<add_vertex<G>>(), std::declval<add_vertex<G>>(), std::declval<G&>()));
template <class G>
using edges = decltype(edges(std::declval<const G&>()));
template <class G>
using point_of_node = decltype(std::declval<G&>()[std::declval<add_vertex<G>>()].point);
template <class G>
using sites_of_node = Element<decltype(std::declval<G&>()[std::declval<add_vertex<G>>()].vertices)>;

template <class T>
using on_stage_begin = decltype(std::declval<T&>().on_stage_begin(Skeletonization_stage()));
template <class T>
using on_stage_end = decltype(std::declval<T&>().on_stage_end(Skeletonization_stage()));
template <class T>
using progress = decltype(std::declval<T&>().progress(0.5));
template <class T>
using go_further = decltype(std::declval<T&>().go_further());

} // namespace expressions
} // namespace internal

/// \name SkeletonizationTraits
/// A surface as the skeletonization sees it: sites `0` to `number_of_sites() - 1` with positions, weights (the areas
/// that they stand for), normals, neighbours, and triangles over them. All functions take constant time, are const, and
/// may be called by several threads at once. Models: `Triangle_mesh_traits`.
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Skeletonization_traits_requirements
{
  static constexpr bool has_point_type = internal::is_valid_v<internal::expressions::Point, T>;
  static constexpr bool has_site_descriptor = internal::is_valid_v<internal::expressions::Site_descriptor, T>;
  static constexpr bool has_number_of_sites = internal::gives_v<std::size_t, internal::expressions::number_of_sites, T>;
  static constexpr bool has_point = internal::gives_v<internal::Vector_3, internal::expressions::point, T>;
  static constexpr bool has_weight = internal::gives_v<double, internal::expressions::weight, T>;
  static constexpr bool has_normal = internal::gives_v<internal::Vector_3, internal::expressions::normal, T>;
  static constexpr bool has_neighbors = internal::gives_v<std::size_t, internal::expressions::neighbor, T>;
  static constexpr bool has_number_of_triangles =
      internal::gives_v<std::size_t, internal::expressions::number_of_triangles, T>;
  static constexpr bool has_triangle = internal::gives_v<std::size_t, internal::expressions::corner, T>;
  static constexpr bool value = has_point_type && has_site_descriptor && has_number_of_sites && has_point &&
                                has_weight && has_normal && has_neighbors && has_number_of_triangles && has_triangle;
};

/// Whether `T` is a model of `SkeletonizationTraits`.
template <class T>
inline constexpr bool is_skeletonization_traits_v = Skeletonization_traits_requirements<T>::value;

/// refuses at compile time a type that is no model of `SkeletonizationTraits`.
template <class T>
constexpr void check_skeletonization_traits()
{
  using Requirements = Skeletonization_traits_requirements<T>;
  static_assert(Requirements::has_point_type,
                "CSCD: SkeletonizationTraits requires the type T::Point, the points of the input");
  static_assert(
      Requirements::has_site_descriptor,
      "CSCD: SkeletonizationTraits requires the type T::Site_descriptor, which identifies a site of the input");
  static_assert(Requirements::has_number_of_sites,
                "CSCD: SkeletonizationTraits requires t.number_of_sites() const, an integer");
  static_assert(Requirements::has_point,
                "CSCD: SkeletonizationTraits requires t.point(i) const, convertible to an Eigen::Vector3d");
  static_assert(Requirements::has_weight,
                "CSCD: SkeletonizationTraits requires t.weight(i) const, convertible to double");
  static_assert(Requirements::has_normal,
                "CSCD: SkeletonizationTraits requires t.normal(i) const, convertible to an Eigen::Vector3d");
  static_assert(Requirements::has_neighbors,
                "CSCD: SkeletonizationTraits requires t.neighbors(i) const, a range of indices");
  static_assert(Requirements::has_number_of_triangles,
                "CSCD: SkeletonizationTraits requires t.number_of_triangles() const, an integer");
  static_assert(Requirements::has_triangle,
                "CSCD: SkeletonizationTraits requires t.triangle(f) const, an array of three indices");
}

/// @}

/// \name TriangleMesh
/// CGAL's `FaceListGraph`, of which all faces are triangles.
/// @{

/// Whether `T` looks like a `FaceListGraph`; may be asked of any type.
template <class T>
inline constexpr bool is_triangle_mesh_v = internal::is_valid_v<internal::expressions::faces, T>&&
    internal::gives_v<std::size_t, internal::expressions::num_halfedges, T>;

/// Whether `T` is a range of points, or of elements with points, and no mesh; may be asked of any type.
template <class T>
inline constexpr bool is_point_range_v = internal::is_valid_v<internal::expressions::begin, const T>&&
                                             internal::is_valid_v<internal::expressions::end, const T> &&
                                         !internal::is_valid_v<internal::expressions::faces, T>;

/// refuses at compile time a type that is no `FaceListGraph`.
template <class T>
constexpr void check_triangle_mesh()
{
  static_assert(internal::is_valid_v<internal::expressions::vertices, T>,
                "CSCD: TriangleMesh requires vertices(g), as CGAL's FaceListGraph");
  static_assert(internal::is_valid_v<internal::expressions::faces, T>,
                "CSCD: TriangleMesh requires faces(g), as CGAL's FaceListGraph");
  static_assert(internal::gives_v<std::size_t, internal::expressions::num_halfedges, T>,
                "CSCD: TriangleMesh requires num_halfedges(g), as CGAL's FaceListGraph");
  static_assert(internal::is_valid_v<internal::expressions::halfedge, T>,
                "CSCD: TriangleMesh requires halfedge(f, g), as CGAL's FaceListGraph");
  static_assert(internal::is_valid_v<internal::expressions::next, T>,
                "CSCD: TriangleMesh requires next(h, g), as CGAL's FaceListGraph");
  static_assert(internal::is_valid_v<internal::expressions::target, T>,
                "CSCD: TriangleMesh requires target(h, g), as CGAL's FaceListGraph");
}

/// @}

/// \name CurveSkeletonGraph
/// A Boost `VertexListGraph`, `EdgeListGraph` and `MutableGraph` that can be default constructed and moved; the bundles
/// of its vertices have a `point` and the range `vertices` of the sites of the input, and perhaps a `radius`.
/// Models: `Skeleton_graph`, `CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton`.
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Curve_skeleton_graph_requirements
{
  static constexpr bool has_vertices = internal::is_valid_v<internal::expressions::vertices, T>;
  static constexpr bool has_num_vertices = internal::gives_v<std::size_t, internal::expressions::num_vertices, T>;
  static constexpr bool has_edges = internal::is_valid_v<internal::expressions::edges, T>;
  static constexpr bool has_add_vertex = internal::is_valid_v<internal::expressions::add_vertex, T>;
  static constexpr bool has_add_edge = internal::is_valid_v<internal::expressions::add_edge, T>;
  static constexpr bool has_point = internal::is_valid_v<internal::expressions::point_of_node, T>;
  static constexpr bool has_sites = internal::is_valid_v<internal::expressions::sites_of_node, T>;
  static constexpr bool is_regular = std::is_default_constructible_v<T> && std::is_move_assignable_v<T>;
  static constexpr bool value = has_vertices && has_num_vertices && has_edges && has_add_vertex && has_add_edge &&
                                has_point && has_sites && is_regular;
};

/// Whether `T` is a model of `CurveSkeletonGraph`.
template <class T>
inline constexpr bool is_curve_skeleton_graph_v = Curve_skeleton_graph_requirements<T>::value;

/// refuses at compile time a type that is no model of `CurveSkeletonGraph`.
template <class T>
constexpr void check_curve_skeleton_graph()
{
  using Requirements = Curve_skeleton_graph_requirements<T>;
  static_assert(Requirements::has_vertices, "CSCD: CurveSkeletonGraph requires vertices(g)");
  static_assert(Requirements::has_num_vertices, "CSCD: CurveSkeletonGraph requires num_vertices(g)");
  static_assert(Requirements::has_edges, "CSCD: CurveSkeletonGraph requires edges(g)");
  static_assert(Requirements::has_add_vertex, "CSCD: CurveSkeletonGraph requires add_vertex(g)");
  static_assert(Requirements::has_add_edge, "CSCD: CurveSkeletonGraph requires add_edge(v, w, g)");
  static_assert(Requirements::has_point, "CSCD: CurveSkeletonGraph requires g[v].point");
  static_assert(Requirements::has_sites, "CSCD: CurveSkeletonGraph requires g[v].vertices, a range of sites");
  static_assert(Requirements::is_regular,
                "CSCD: CurveSkeletonGraph requires a default constructor and a move assignment");
}

/// @}

/// \name SkeletonizationVisitor
/// Hears of the progress of a skeletonization and can stop it: see `Default_skeletonization_visitor`.
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Skeletonization_visitor_requirements
{
  static constexpr bool has_on_stage_begin = internal::is_valid_v<internal::expressions::on_stage_begin, T>;
  static constexpr bool has_on_stage_end = internal::is_valid_v<internal::expressions::on_stage_end, T>;
  static constexpr bool has_progress = internal::is_valid_v<internal::expressions::progress, T>;
  static constexpr bool has_go_further = internal::gives_v<bool, internal::expressions::go_further, T>;
  static constexpr bool value = has_on_stage_begin && has_on_stage_end && has_progress && has_go_further;
};

/// Whether `T` is a model of `SkeletonizationVisitor`.
template <class T>
inline constexpr bool is_skeletonization_visitor_v = Skeletonization_visitor_requirements<T>::value;

/// refuses at compile time a type that is no model of `SkeletonizationVisitor`.
template <class T>
constexpr void check_skeletonization_visitor()
{
  using Requirements = Skeletonization_visitor_requirements<T>;
  static_assert(Requirements::has_on_stage_begin,
                "CSCD: SkeletonizationVisitor requires v.on_stage_begin(Skeletonization_stage)");
  static_assert(Requirements::has_on_stage_end,
                "CSCD: SkeletonizationVisitor requires v.on_stage_end(Skeletonization_stage)");
  static_assert(Requirements::has_progress, "CSCD: SkeletonizationVisitor requires v.progress(double)");
  static_assert(Requirements::has_go_further,
                "CSCD: SkeletonizationVisitor requires v.go_further(), convertible to bool");
}

/// @}

} // namespace CSCD

#endif // CSCD_CONCEPTS_H
