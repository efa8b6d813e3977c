// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concepts of the library, in words and in code: what each asks for, whether a type is a model, and functions that
// refuse at compile time what is none, with one sentence for each missing expression.

#ifndef CSCD_CONCEPTS_H
#define CSCD_CONCEPTS_H

#include <CSCD/Selection/Search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

struct Search_result;

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

template <class Void, class Object, template <class...> class Expression, class... T>
struct Refers_to : std::false_type
{
};

template <class Object, template <class...> class Expression, class... T>
struct Refers_to<std::void_t<Expression<T...>>, Object, Expression, T...>
    : std::bool_constant<std::is_lvalue_reference_v<Expression<T...>> &&
                         std::is_convertible_v<Expression<T...>, const Object&>>
{
};

/// Whether the type `Expression<T...>` is well formed and a reference to an `Object`, which may be held on to.
template <class Object, template <class...> class Expression, class... T>
inline constexpr bool refers_to_v = Refers_to<void, Object, Expression, T...>::value;

/// Whether the type `Expression<T, More...>` is well formed and is, or can be converted to, the type `Own<T>`.
template <template <class...> class Own, template <class...> class Expression, class T, class... More>
constexpr bool gives_own_type()
{
  if constexpr (is_valid_v<Own, T> && is_valid_v<Expression, T, More...>) {
    return std::is_same_v<Expression<T, More...>, Own<T>> || std::is_convertible_v<Expression<T, More...>, Own<T>>;
  } else {
    return false;
  }
}

/// The type of the elements of a range.
template <class Range>
using Element = decltype(*std::begin(std::declval<Range&>()));

/// The expressions of the concepts, as types: `t` is an object, `g` a graph, `i` an index, each of its parameter's
/// type.
namespace expressions {

template <class T>
using Point = typename T::Point;
template <class T>
using Input_descriptor = typename T::Input_descriptor;
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
template <class T>
using descriptor = Element<decltype(std::declval<const T&>().descriptors(Index()))>;
template <class T>
using to_input_point = decltype(std::declval<const T&>().to_input_point(Vector_3()));
template <class T>
using to_input_length = decltype(std::declval<const T&>().to_input_length(1.));
template <class T>
using number_of_input_vertices = decltype(std::declval<const T&>().number_of_input_vertices());
template <class T>
using number_of_isolated_vertices = decltype(std::declval<const T&>().number_of_isolated_vertices());
template <class T>
using number_of_components = decltype(std::declval<const T&>().number_of_components());
template <class T>
using number_of_bridged_borders = decltype(std::declval<const T&>().number_of_bridged_borders());
template <class T>
using number_of_inserted_vertices = decltype(std::declval<const T&>().number_of_inserted_vertices());
template <class T>
using number_of_degenerate_faces = decltype(std::declval<const T&>().number_of_degenerate_faces());
template <class T>
using warnings = decltype(std::declval<const T&>().warnings());
template <class T>
using genus = decltype(std::declval<const T&>().genus());
template <class T>
using seconds_to_compile = decltype(std::declval<const T&>().seconds_to_compile());

template <class T>
using levels = decltype(std::declval<const T&>().levels());

template <class T>
using surface = decltype(std::declval<const T&>().surface());
template <class T>
using address_of_surface = decltype(&std::declval<const T&>().surface());
template <class T>
using crossed_edge = decltype(std::declval<const surface<T>&>().edge(Index()));
template <class T>
using outgoing_halfedge = Element<decltype(std::declval<const surface<T>&>().outgoing(Index()))>;
template <class T>
using is_inside = decltype(std::declval<const T&>().is_inside(Vector_3()));
template <class T>
using middle_behind = decltype(std::declval<const T&>().middle_behind(Vector_3()));
template <class T>
using crossings =
    decltype(std::declval<const T&>().crossings(Vector_3(), Vector_3(), std::declval<std::vector<double>&>()));

template <class T>
using solid_surface = decltype(std::declval<const T&>().solid_surface());
template <class T>
using closest_point = decltype(std::declval<const T&>().closest_point(Vector_3()).point);
template <class T>
using first_hit = decltype(std::declval<const T&>().first_hit(Vector_3(), Vector_3()));
template <class T>
using is_hit = decltype(!std::declval<const first_hit<T>&>());
template <class T>
using hit_point = decltype(std::declval<const first_hit<T>&>()->point);
template <class T>
using hit_face = decltype(std::declval<const first_hit<T>&>()->face);

template <class W>
using cost_of_separator = decltype(std::declval<const W&>()(std::declval<const Separator&>()));

template <class F>
using search = decltype(std::declval<F&>()(Index(), Index(), std::declval<Search_result&>()));

template <class F, class T>
using make_finder = decltype(F(std::declval<const T&>()));

template <class P, class T>
using find_separators = decltype(std::declval<const P&>().template find_separators<CGAL::Sequential_tag>(
    std::declval<const T&>(), std::declval<const Search_settings&>(), std::declval<Skeletonization_report&>(),
    std::declval<void (&)(double)>()));
template <class P>
using Packing = typename P::Packing;
template <class P, class T>
using pack_separators = decltype(std::declval<const P&>().pack_separators(
    std::declval<const T&>(), std::declval<std::vector<Separator>&>(), std::declval<Skeletonization_report&>()));
template <class P>
using packed = decltype(std::declval<const typename P::Packing&>().packed());
template <class P, class T>
using build_skeleton = decltype(std::declval<const P&>().build_skeleton(
    std::declval<const T&>(), std::declval<const std::vector<Separator>&>(), std::declval<const typename P::Packing&>(),
    std::declval<Skeletonization_report&>()));

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
using vertices_of_node = Element<decltype(std::declval<G&>()[std::declval<add_vertex<G>>()].vertices)>;

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

#ifdef DOXYGEN_RUNNING
/// A surface as the skeletonization sees it: sites `0` to `n - 1`, triangles over them, and the way back to the input.
/// All functions take constant time, are const, and may be called by several threads at once. Positions and lengths are
/// normalized (unit area, centroid at the origin), so that the skeleton depends on the shape alone.
///
/// | expression | value |
/// |---|---|
/// | `T::Point`, `T::Input_descriptor` | the types of the points of the input, and of what identifies a site there |
/// | `t.number_of_sites()` | the number of sites, inserted ones included |
/// | `t.point(i)`, `t.normal(i)` | the position of site `i`, and the outward unit normal there |
/// | `t.weight(i)` | the area that site `i` stands for |
/// | `t.neighbors(i)` | a range of the sites next to site `i` |
/// | `t.number_of_triangles()`, `t.triangle(f)` | the triangles, each an array of three sites |
/// | `t.descriptors(i)` | a range of what identifies, in the input, the sites for which site `i` stands; may be empty |
/// | `t.to_input_point(p)`, `t.to_input_length(l)` | a point and a length in the coordinates of the input |
/// | `t.genus()` | the number of handles, over all components; an empty `std::optional` if it is not known |
/// | `t.number_of_components()` | the number of connected components of the surface |
/// | `t.number_of_input_vertices()` | the number of sites of the input |
/// | `t.number_of_isolated_vertices()` | the number of vertices of the input that are no sites |
/// | `t.number_of_bridged_borders()` | the number of borders that were closed |
/// | `t.number_of_inserted_vertices()` | the number of sites that are not of the input |
/// | `t.number_of_degenerate_faces()` | the number of triangles of the input with (nearly) no area |
/// | `t.warnings()` | a `std::vector<std::string>`: what is doubtful about the input or was mended |
/// | `t.seconds_to_compile()` | the time that it took to make `t` |
///
/// If there is `t.reconstruction_report()`, a `Reconstruction_report`, the report of the skeletonization holds it.
///
/// \cgalHasModels{`Triangle_mesh_traits`, `Reconstructed_surface_traits`}
/// \cgalArchetype{Skeletonization_traits_archetype.h}
/// \cgalConcept
class SkeletonizationTraits
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Skeletonization_traits_requirements
{
  static constexpr bool has_point_type = internal::is_valid_v<internal::expressions::Point, T>;
  static constexpr bool has_input_descriptor = internal::is_valid_v<internal::expressions::Input_descriptor, T>;
  static constexpr bool has_number_of_sites = internal::gives_v<std::size_t, internal::expressions::number_of_sites, T>;
  static constexpr bool has_point = internal::gives_v<Vector_3, internal::expressions::point, T>;
  static constexpr bool has_weight = internal::gives_v<double, internal::expressions::weight, T>;
  static constexpr bool has_normal = internal::gives_v<Vector_3, internal::expressions::normal, T>;
  static constexpr bool has_neighbors = internal::gives_v<std::size_t, internal::expressions::neighbor, T>;
  static constexpr bool has_number_of_triangles =
      internal::gives_v<std::size_t, internal::expressions::number_of_triangles, T>;
  static constexpr bool has_triangle = internal::gives_v<std::size_t, internal::expressions::corner, T>;
  static constexpr bool has_descriptors =
      internal::gives_own_type<internal::expressions::Input_descriptor, internal::expressions::descriptor, T>();
  static constexpr bool has_to_input_point =
      internal::gives_own_type<internal::expressions::Point, internal::expressions::to_input_point, T>();
  static constexpr bool has_to_input_length = internal::gives_v<double, internal::expressions::to_input_length, T>;
  static constexpr bool has_genus = internal::gives_v<std::optional<std::size_t>, internal::expressions::genus, T>;
  static constexpr bool has_number_of_components =
      internal::gives_v<std::size_t, internal::expressions::number_of_components, T>;
  static constexpr bool has_counts_of_input =
      internal::gives_v<std::size_t, internal::expressions::number_of_input_vertices, T> &&
      internal::gives_v<std::size_t, internal::expressions::number_of_isolated_vertices, T> &&
      internal::gives_v<std::size_t, internal::expressions::number_of_bridged_borders, T> &&
      internal::gives_v<std::size_t, internal::expressions::number_of_inserted_vertices, T> &&
      internal::gives_v<std::size_t, internal::expressions::number_of_degenerate_faces, T> &&
      internal::gives_v<double, internal::expressions::seconds_to_compile, T>;
  static constexpr bool has_warnings = internal::gives_v<std::vector<std::string>, internal::expressions::warnings, T>;
  static constexpr bool value = has_point_type && has_input_descriptor && has_number_of_sites && has_point &&
                                has_weight && has_normal && has_neighbors && has_number_of_triangles && has_triangle &&
                                has_descriptors && has_warnings && has_to_input_point && has_to_input_length &&
                                has_genus && has_number_of_components && has_counts_of_input;
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
      Requirements::has_input_descriptor,
      "CSCD: SkeletonizationTraits requires the type T::Input_descriptor, which identifies a site of the input");
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
  static_assert(Requirements::has_descriptors,
                "CSCD: SkeletonizationTraits requires t.descriptors(i) const, a range of T::Input_descriptor");
  static_assert(Requirements::has_warnings,
                "CSCD: SkeletonizationTraits requires t.warnings() const, convertible to std::vector<std::string>");
  static_assert(
      Requirements::has_to_input_point,
      "CSCD: SkeletonizationTraits requires t.to_input_point(Eigen::Vector3d) const, convertible to T::Point");
  static_assert(Requirements::has_to_input_length,
                "CSCD: SkeletonizationTraits requires t.to_input_length(double) const, convertible to double");
  static_assert(Requirements::has_genus,
                "CSCD: SkeletonizationTraits requires t.genus() const, an integer or an optional one");
  static_assert(Requirements::has_number_of_components,
                "CSCD: SkeletonizationTraits requires t.number_of_components() const, an integer");
  static_assert(Requirements::has_counts_of_input,
                "CSCD: SkeletonizationTraits requires what the report tells of the input: the counts "
                "number_of_input_vertices, _isolated_vertices, _bridged_borders, _inserted_vertices, _degenerate_faces, "
                "and seconds_to_compile()");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// A surface in levels of detail, which is all that `Local_separator_finder` asks for. The reference that it gives to
/// them must hold as long as the object lives.
///
/// | expression | value |
/// |---|---|
/// | `t.levels()` | a `const Surface_levels&`; the sites are the vertices of the finest level |
///
/// \cgalHasModels{`Triangle_mesh_traits`, `Reconstructed_surface_traits`}
/// \cgalArchetype{Multiresolution_traits_archetype.h}
/// \cgalConcept
class MultiresolutionSkeletonizationTraits
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// Whether `T` is a model of `MultiresolutionSkeletonizationTraits`.
template <class T>
inline constexpr bool is_multiresolution_skeletonization_traits_v =
    internal::refers_to_v<Surface_levels, internal::expressions::levels, T>;

/// refuses at compile time a type that is no model of `MultiresolutionSkeletonizationTraits`.
template <class T>
constexpr void check_multiresolution_skeletonization_traits()
{
  static_assert(is_multiresolution_skeletonization_traits_v<T>,
                "CSCD: MultiresolutionSkeletonizationTraits requires t.levels() const, a reference to the levels of "
                "detail");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// A surface that bounds a body: what the steps ask for that separator_costs separators and keep nodes inside. All functions are
/// const, and may be called by several threads at once; references hold as long as the object lives.
///
/// | expression | value |
/// |---|---|
/// | `t.surface()` | what separators lie on: a `const Triangulated_surface&` or `Point_complex&` |
/// | `t.is_inside(p)` | whether the body holds the point `p` |
/// | `t.middle_behind(p)` | an optional point: the middle of the body behind where the surface is nearest to `p` |
/// | `t.crossings(p, q, v)` | fills the vector `v` with the ascending distances at which segment `p` `q` meets it |
///
/// \cgalHasModels{`Triangle_mesh_traits`, `Reconstructed_surface_traits`, `Point_set_traits`}
/// \cgalArchetype{Solid_traits_archetype.h}
/// \cgalConcept
class SolidSkeletonizationTraits
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Solid_skeletonization_traits_requirements
{
  static constexpr bool has_surface = internal::gives_v<std::size_t, internal::expressions::crossed_edge, T> &&
                                      internal::gives_v<std::size_t, internal::expressions::outgoing_halfedge, T> &&
                                      internal::is_valid_v<internal::expressions::address_of_surface, T>;
  static constexpr bool has_is_inside = internal::gives_v<bool, internal::expressions::is_inside, T>;
  static constexpr bool has_middle_behind =
      internal::gives_v<std::optional<Vector_3>, internal::expressions::middle_behind, T>;
  static constexpr bool has_crossings = internal::is_valid_v<internal::expressions::crossings, T>;
  static constexpr bool value = has_surface && has_is_inside && has_middle_behind && has_crossings;
};

/// Whether `T` is a model of `SolidSkeletonizationTraits`.
template <class T>
inline constexpr bool is_solid_skeletonization_traits_v = Solid_skeletonization_traits_requirements<T>::value;

/// refuses at compile time a type that is no model of `SolidSkeletonizationTraits`.
template <class T>
constexpr void check_solid_skeletonization_traits()
{
  using Requirements = Solid_skeletonization_traits_requirements<T>;
  static_assert(Requirements::has_surface,
                "CSCD: SolidSkeletonizationTraits requires t.surface() const, a reference to what separators lie on");
  static_assert(Requirements::has_is_inside,
                "CSCD: SolidSkeletonizationTraits requires t.is_inside(p) const, convertible to bool");
  static_assert(Requirements::has_middle_behind,
                "CSCD: SolidSkeletonizationTraits requires t.middle_behind(p) const, an optional Eigen::Vector3d");
  static_assert(Requirements::has_crossings,
                "CSCD: SolidSkeletonizationTraits requires t.crossings(p, q, v) const, which fills a "
                "std::vector<double>");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// A body bounded by triangles, in levels of detail: what the local method asks for. All functions are const, and may
/// be called by several threads at once; references hold as long as the object lives.
///
/// | expression | value |
/// |---|---|
/// | `t.solid_surface()` | a `const Triangulated_surface&`: the surface that the queries refer to |
/// | `t.closest_point(p)` | the `point` of the surface that is nearest to `p` |
/// | `t.first_hit(p, d)` | pointer-like: `point` and `face` where the ray from `p` along `d` first meets it, or null |
///
/// \cgalRefines{`MultiresolutionSkeletonizationTraits`, `SolidSkeletonizationTraits`}
/// \cgalHasModels{`Triangle_mesh_traits`, `Reconstructed_surface_traits`}
/// \cgalArchetype{Solid_traits_archetype.h}
/// \cgalConcept
class TriangulatedSolidSkeletonizationTraits
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// The requirements of the concept, one by one.
template <class T>
struct Triangulated_solid_skeletonization_traits_requirements
{
  static constexpr bool has_levels = is_multiresolution_skeletonization_traits_v<T>;
  static constexpr bool is_solid = is_solid_skeletonization_traits_v<T>;
  static constexpr bool has_solid_surface =
      internal::refers_to_v<Triangulated_surface, internal::expressions::solid_surface, T>;
  static constexpr bool has_closest_point =
      internal::gives_v<Vector_3, internal::expressions::closest_point, T>;
  static constexpr bool has_first_hit = internal::gives_v<bool, internal::expressions::is_hit, T> &&
                                        internal::gives_v<Vector_3, internal::expressions::hit_point, T> &&
                                        internal::gives_v<Index, internal::expressions::hit_face, T>;
  static constexpr bool value = has_levels && is_solid && has_solid_surface && has_closest_point && has_first_hit;
};

/// Whether `T` is a model of `TriangulatedSolidSkeletonizationTraits`.
template <class T>
inline constexpr bool is_triangulated_solid_skeletonization_traits_v =
    Triangulated_solid_skeletonization_traits_requirements<T>::value;

/// refuses at compile time a type that is no model of `TriangulatedSolidSkeletonizationTraits`.
template <class T>
constexpr void check_triangulated_solid_skeletonization_traits()
{
  using Requirements = Triangulated_solid_skeletonization_traits_requirements<T>;
  check_multiresolution_skeletonization_traits<T>();
  check_solid_skeletonization_traits<T>();
  static_assert(Requirements::has_solid_surface,
                "CSCD: TriangulatedSolidSkeletonizationTraits requires t.solid_surface() const, a reference to the "
                "surface of the body");
  static_assert(Requirements::has_closest_point,
                "CSCD: TriangulatedSolidSkeletonizationTraits requires t.closest_point(p) const, with member point");
  static_assert(Requirements::has_first_hit,
                "CSCD: TriangulatedSolidSkeletonizationTraits requires t.first_hit(p, d) const, a pointer to what has "
                "members point and face, or null");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// Weighs separators: of two that overlap, the one of lesser weight is packed. A function object `w` that can be
/// copied, with `w(separator)` const and convertible to double; equal weights are ordered by when the separators were
/// found.
///
/// \cgalHasModels{`Length_and_planarity_cost`}
/// \cgalArchetype{Separator_cost_archetype.h}
/// \cgalConcept
class SeparatorCost
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// Whether `T` is a model of `SeparatorCost`.
template <class T>
inline constexpr bool is_separator_cost_v =
    internal::gives_v<double, internal::expressions::cost_of_separator, T>&& std::is_copy_constructible_v<T>;

/// refuses at compile time a type that is no model of `SeparatorCost`.
template <class T>
constexpr void check_separator_cost()
{
  static_assert(internal::gives_v<double, internal::expressions::cost_of_separator, T>,
                "CSCD: SeparatorCost requires w(separator) const, convertible to double");
  static_assert(std::is_copy_constructible_v<T>, "CSCD: SeparatorCost requires a copy constructor");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// Finds the separator of one source after the other; one object serves one thread. `F(t)` makes one for the surface
/// `t`, an object of type `T`, in any thread. `f(source, level_hint, result)` seeks the separator of `source`, a vertex
/// of the finest level, preferably on the level `level_hint`, and writes all members of `result`, a `Search_result&`
/// that may hold an earlier answer. What it writes depends on its arguments alone, not on earlier calls: else the
/// answer would not be the same for every number of threads.
///
/// \cgalHasModels{`Local_separator_finder`}
/// \cgalArchetype{Policies_archetype.h}
/// \cgalConcept
class SeparatorFinder
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// Whether `F` is a model of `SeparatorFinder` for surfaces of type `T`.
template <class F, class T>
inline constexpr bool is_separator_finder_v = internal::is_valid_v<internal::expressions::search, F>&&
    internal::is_valid_v<internal::expressions::make_finder, F, T>;

/// refuses at compile time a type that is no model of `SeparatorFinder` for surfaces of type `T`.
template <class F, class T>
constexpr void check_separator_finder()
{
  static_assert(internal::is_valid_v<internal::expressions::search, F>,
                "CSCD: SeparatorFinder requires f(source, level_hint, result) of two indices and a Search_result&");
  static_assert(internal::is_valid_v<internal::expressions::make_finder, F, T>,
                "CSCD: SeparatorFinder requires F(t), which makes one for a surface");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// The algorithms of the pipeline's stages, for surfaces of type `T`. All functions are const.
///
/// | expression | value |
/// |---|---|
/// | `P::Packing` | which separators are packed, and what else follows from them; can be moved |
/// | `packing.packed()` | the packed ones, as positions in the list: a `const std::vector<unsigned>&` |
/// | `p.template find_separators<Tag>(t, settings, report, progress)` | a `std::vector<Separator>` |
/// | `p.pack_separators(t, separators, report)` | a `P::Packing` of `separators`, to which more may be appended |
/// | `p.build_skeleton(t, separators, packing, report)` | an `Embedded_skeleton` |
///
/// Separators lie on the finest level of `t`. They are sought by the `Search_settings`, with frequent calls of
/// `progress(fraction)`, which may throw.
/// `Tag` is one of CGAL's concurrency tags; the answer must not depend on it, nor on the number of threads. In the
/// `Skeletonization_report` each function fills in what it knows: the numbers of sources and of separators that were
/// not taken, of handle cuts, of nodes and edges outside. Policies can be moved.
///
/// \cgalHasModels{`Local_policies`, `Published_policies`}
/// \cgalArchetype{Policies_archetype.h}
/// \cgalConcept
class SkeletonizationPolicies
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
/// @{

/// The requirements of the concept, one by one.
template <class P, class T>
struct Skeletonization_policies_requirements
{
  static constexpr bool has_find_separators =
      internal::gives_v<std::vector<Separator>, internal::expressions::find_separators, P, T>;
  static constexpr bool has_pack_separators =
      internal::gives_own_type<internal::expressions::Packing, internal::expressions::pack_separators, P, T>();
  static constexpr bool has_packed =
      internal::refers_to_v<std::vector<Index>, internal::expressions::packed, P>;
  static constexpr bool has_build_skeleton =
      internal::gives_v<Embedded_skeleton, internal::expressions::build_skeleton, P, T>;
  static constexpr bool is_movable = std::is_move_constructible_v<P>;
  static constexpr bool value =
      has_find_separators && has_pack_separators && has_packed && has_build_skeleton && is_movable;
};

/// Whether `P` is a model of `SkeletonizationPolicies` for surfaces of type `T`.
template <class P, class T>
inline constexpr bool is_skeletonization_policies_v = Skeletonization_policies_requirements<P, T>::value;

/// refuses at compile time a type that is no model of `SkeletonizationPolicies` for surfaces of type `T`.
template <class P, class T>
constexpr void check_skeletonization_policies()
{
  using Requirements = Skeletonization_policies_requirements<P, T>;
  static_assert(Requirements::has_find_separators,
                "CSCD: SkeletonizationPolicies requires p.template find_separators<Tag>(t, settings, report, progress) "
                "const, a std::vector<Separator>");
  static_assert(Requirements::has_pack_separators,
                "CSCD: SkeletonizationPolicies requires p.pack_separators(t, separators, report) const, a P::Packing");
  static_assert(Requirements::has_packed,
                "CSCD: SkeletonizationPolicies requires packing.packed() const, a const std::vector<unsigned>&");
  static_assert(Requirements::has_build_skeleton,
                "CSCD: SkeletonizationPolicies requires p.build_skeleton(t, separators, packing, report) const, an "
                "Embedded_skeleton");
  static_assert(Requirements::is_movable, "CSCD: SkeletonizationPolicies requires a move constructor");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// CGAL's `FaceListGraph`, of which all faces are triangles. Of its functions these are used, found by
/// argument-dependent look-up: `vertices(g)`, `faces(g)`, `num_halfedges(g)`, `halfedge(f, g)`, `next(h, g)` and
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

#ifdef DOXYGEN_RUNNING
/// A Boost `VertexListGraph`, `EdgeListGraph` and `MutableGraph` that can be default constructed and moved; the bundles
/// of its vertices have a `point`, assignable from the points of the input, the container `vertices` of the sites of
/// the input, which are appended by `push_back()`, and perhaps a `radius`.
///
/// \cgalRefines{Boost's `VertexListGraph`, `EdgeListGraph`, `MutableGraph`}
/// \cgalHasModels{`Skeleton_graph`, `CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton`}
/// \cgalArchetype{Skeleton_archetype.h}
/// \cgalConcept
class CurveSkeletonGraph
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
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
  static constexpr bool has_vertices_of_node = internal::is_valid_v<internal::expressions::vertices_of_node, T>;
  static constexpr bool is_regular = std::is_default_constructible_v<T> && std::is_move_assignable_v<T>;
  static constexpr bool value = has_vertices && has_num_vertices && has_edges && has_add_vertex && has_add_edge &&
                                has_point && has_vertices_of_node && is_regular;
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
  static_assert(Requirements::has_vertices_of_node, "CSCD: CurveSkeletonGraph requires g[v].vertices, a range of sites");
  static_assert(Requirements::is_regular,
                "CSCD: CurveSkeletonGraph requires a default constructor and a move assignment");
}

/// @}

#ifdef DOXYGEN_RUNNING
/// Hears of the progress of a skeletonization and can stop it. All calls come from the thread that runs the pipeline.
///
/// | expression | when, and what it means |
/// |---|---|
/// | `v.on_stage_begin(stage)`, `v.on_stage_end(stage)` | a `Skeletonization_stage` begins, and is done |
/// | `v.progress(fraction)` | often: the part of the stage that is done, in [0, 1] |
/// | `v.go_further()` | after each call of `progress()`: false stops the work by a `Cancelled_error` |
///
/// What it throws is passed on.
///
/// \cgalHasModels{`Default_skeletonization_visitor`}
/// \cgalArchetype{Visitor_archetype.h}
/// \cgalConcept
class SkeletonizationVisitor
{
};
#endif

/// \addtogroup PkgCSCDConceptChecks
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
