// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concepts of the library: their requirements, and functions that refuse at compile time a type that is not a
// model, with one sentence for each missing expression.

#ifndef CSCD_CONCEPTS_H
#define CSCD_CONCEPTS_H

#include <CSCD/Options.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>

#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

class Point_complex;

#ifdef DOXYGEN_RUNNING
/// Adapts an input to a surface, and leads back: an object that models this concept is all that a new kind of input
/// needs. All functions are const and may be called by several threads at once.
///
/// | expression | value |
/// |---|---|
/// | `T::Point`, `T::Input_descriptor` | the points of the input, of three coordinates, and what names a vertex there |
/// | `T::Surface` | the type of the surface, a model of `SkeletonizationSurface`, or `Spatial_graph` |
/// | `t.surface()` | the surface: a `const T::Surface&` |
/// | `t.descriptors(v)` | the input elements represented by vertex `v`; may be empty |
/// | `t.normalization()` | from the coordinates of the input to those of the surface: a `Normalization` |
/// | `t.describe_input(report)` | writes counts, genus and warnings to a `Skeletonization_report&` |
///
/// \cgalHasModels{`Triangle_mesh_traits`, `Reconstructed_surface_traits`, `Voxel_surface_traits`, `Point_set_traits`,
/// `Spatial_graph_traits`}
/// \cgalArchetype{Skeletonization_traits_archetype.h}
/// \cgalConcept
class SkeletonizationTraits
{
};
#endif

/// refuses at compile time a type that is not a model of `SkeletonizationTraits`.
/// \ingroup PkgCSCDConceptChecks
template <class T>
constexpr void check_skeletonization_traits()
{
  static_assert(CSCD_IS_VALID(const T&, std::declval<typename std::decay_t<decltype(t)>::Point>()),
                "CSCD: SkeletonizationTraits requires the type T::Point, that of the points of the input");
  static_assert(
      CSCD_IS_VALID(const T&, std::declval<typename std::decay_t<decltype(t)>::Input_descriptor>()),
      "CSCD: SkeletonizationTraits requires the type T::Input_descriptor, which identifies a vertex or point of "
      "the input");
  static_assert(CSCD_GIVES(const typename T::Surface&, const T&, t.surface()),
                "CSCD: SkeletonizationTraits requires t.surface() const, a const T::Surface&");
  static_assert(CSCD_GIVES(typename T::Input_descriptor, const T&, *std::begin(t.descriptors(Index()))),
                "CSCD: SkeletonizationTraits requires t.descriptors(v) const, a range of T::Input_descriptor");
  static_assert(CSCD_GIVES(Normalization, const T&, t.normalization()),
                "CSCD: SkeletonizationTraits requires t.normalization() const, a Normalization");
  static_assert(CSCD_IS_VALID(const T&, t.describe_input(std::declval<Skeletonization_report&>())),
                "CSCD: SkeletonizationTraits requires t.describe_input(report) const, of a Skeletonization_report&");
}

#ifdef DOXYGEN_RUNNING
/// A closed, oriented 2-manifold of triangles: vertices `0` to `n - 1`, and halfedges `h`, each the side `h % 3` of
/// face `h / 3`, counterclockwise seen from outside. No edge joins a vertex to itself, no two edges have the same ends.
/// All functions are const, take constant time, and may be called by several threads at once.
///
/// | expression | value |
/// |---|---|
/// | `t.number_of_vertices()`, `t.number_of_halfedges()`, `t.number_of_faces()` | the numbers of elements |
/// | `T::face(h)`, `T::next(h)`, `T::previous(h)` | as numbered above; inherited from `Triangle_halfedges` |
/// | `t.origin(h)`, `t.target(h)` | the ends of halfedge `h` |
/// | `t.twin(h)` | the halfedge from the target of `h` to its origin |
/// | `t.outgoing(v)` | a range of the halfedges from vertex `v`, in any order |
/// | `t.points()` | the positions of the vertices: a `const std::vector<Vector3>&` |
/// | `t.length(h)` | the length of halfedge `h` |
/// | `t.vertex_area(v)` | the area of the surface that belongs to vertex `v` |
///
/// There may be a function `t.is_hole_filling(f)`: faces where it is true are not part of the surface.
///
/// \cgalHasModels{`Triangulated_surface`}
/// \cgalArchetype{Surface_archetype.h}
/// \cgalConcept
class SurfaceTriangulation
{
};
#endif

/// refuses at compile time a type that is not a model of `SurfaceTriangulation`.
/// \ingroup PkgCSCDConceptChecks
template <class T>
constexpr void check_surface_triangulation()
{
  static_assert(CSCD_GIVES(Index, const T&, t.number_of_vertices()) &&
                    CSCD_GIVES(Index, const T&, t.number_of_halfedges()) &&
                    CSCD_GIVES(Index, const T&, t.number_of_faces()),
                "CSCD: SurfaceTriangulation requires t.number_of_vertices(), t.number_of_halfedges() and "
                "t.number_of_faces()");
  static_assert(CSCD_GIVES(Index, const T&, std::decay_t<decltype(t)>::face(Index())) &&
                    CSCD_GIVES(Index, const T&, std::decay_t<decltype(t)>::next(Index())) &&
                    CSCD_GIVES(Index, const T&, std::decay_t<decltype(t)>::previous(Index())),
                "CSCD: SurfaceTriangulation requires T::face(h), T::next(h) and T::previous(h), as Triangle_halfedges");
  static_assert(CSCD_GIVES(Index, const T&, t.origin(Index())) && CSCD_GIVES(Index, const T&, t.target(Index())) &&
                    CSCD_GIVES(Index, const T&, t.twin(Index())),
                "CSCD: SurfaceTriangulation requires t.origin(h), t.target(h) and t.twin(h)");
  static_assert(CSCD_GIVES(Index, const T&, *std::begin(t.outgoing(Index()))),
                "CSCD: SurfaceTriangulation requires t.outgoing(v), a range of halfedges");
  static_assert(CSCD_GIVES(const std::vector<Vector3>&, const T&, t.points()),
                "CSCD: SurfaceTriangulation requires t.points(), a const std::vector<Vector3>&");
  static_assert(CSCD_GIVES(double, const T&, t.length(Index())),
                "CSCD: SurfaceTriangulation requires t.length(h), convertible to double");
  static_assert(CSCD_GIVES(double, const T&, t.vertex_area(Index())),
                "CSCD: SurfaceTriangulation requires t.vertex_area(v), convertible to double");
}

#ifdef DOXYGEN_RUNNING
/// A surface that bounds a body. All functions are const and may be called by several threads at once.
///
/// | expression | value |
/// |---|---|
/// | `s.triangulation()` | the triangles: a reference to a model of `SurfaceTriangulation`, or to a `Point_complex` |
/// | `s.is_inside(p)` | whether the body contains the point `p` |
/// | `s.middle_behind(p)` | an optional point: the middle of the body behind where the surface is nearest to `p` |
/// | `s.crossings(p, q, v)` | fills `v`: the ascending distances from `p` at which `p` `q` enters or leaves the body |
///
/// \cgalHasModels{`Triangulated_solid`, `Point_solid`}
/// \cgalArchetype{Surface_archetype.h}
/// \cgalConcept
class SkeletonizationSurface
{
};
#endif

/// refuses at compile time a type that is not a model of `SkeletonizationSurface`.
/// \ingroup PkgCSCDConceptChecks
template <class T>
constexpr void check_skeletonization_surface()
{
  constexpr bool has_triangulation = CSCD_IS_VALID(const T&, &t.triangulation());
  static_assert(has_triangulation, "CSCD: SkeletonizationSurface requires s.triangulation() const, a reference");
  if constexpr (has_triangulation) {
    using Triangulation = std::decay_t<decltype(std::declval<const T&>().triangulation())>;
    if constexpr (!std::is_same_v<Triangulation, Point_complex>) {
      check_surface_triangulation<Triangulation>();
    }
  }
  static_assert(CSCD_GIVES(bool, const T&, t.is_inside(Vector3())),
                "CSCD: SkeletonizationSurface requires s.is_inside(p) const, convertible to bool");
  static_assert(CSCD_GIVES(std::optional<Vector3>, const T&, t.middle_behind(Vector3())),
                "CSCD: SkeletonizationSurface requires s.middle_behind(p) const, an optional Vector3");
  static_assert(CSCD_IS_VALID(const T&, t.crossings(Vector3(), Vector3(), std::declval<std::vector<double>&>())),
                "CSCD: SkeletonizationSurface requires s.crossings(p, q, v) const, which fills a std::vector<double>");
}

#ifdef DOXYGEN_RUNNING
/// The algorithms of the pipeline's stages, for surfaces of type `S`. All functions are const.
///
/// | expression | value |
/// |---|---|
/// | `P::Packing` | the packed separators and results derived from them; can be moved |
/// | `packing.packed()` | the packed ones, as positions in the list: a `const std::vector<Index>&` |
/// | `p.find_separators(s, settings, report, progress)` | a `std::vector<Separator>` |
/// | `p.pack_separators(s, separators, report)` | a `P::Packing` of `separators`; more may be appended to these |
/// | `p.build_skeleton(s, separators, packing, report)` | an `Embedded_skeleton` |
///
/// Separators are sought by the `Options`, with frequent calls of `progress(fraction)`, a `Progress`, which may throw.
/// The answer must not depend on the number of threads. Each function fills in its part of the
/// `Skeletonization_report`: the numbers of sources and of separators that were not taken, of handle cuts, of nodes and
/// edges outside. Policies can be copied.
///
/// \cgalHasModels{`Local_policies`, `Published_policies`, `Graph_policies`}
/// \cgalArchetype{Policies_archetype.h}
/// \cgalConcept
class SkeletonizationPolicies
{
};
#endif

/// Whether `P` can find separators on a surface of type `S`.
/// \ingroup PkgCSCDConceptChecks
template <class P, class S>
inline constexpr bool is_skeletonization_policies_v =
    CSCD_GIVES(std::vector<Separator>, const P&,
               t.find_separators(std::declval<const S&>(), std::declval<const Options&>(),
                                 std::declval<Skeletonization_report&>(), std::declval<const Progress&>()));

/// refuses at compile time a type that is not a model of `SkeletonizationPolicies` for surfaces of type `S`.
/// \ingroup PkgCSCDConceptChecks
template <class P, class S>
constexpr void check_skeletonization_policies()
{
  static_assert(is_skeletonization_policies_v<P, S>,
                "CSCD: SkeletonizationPolicies requires p.find_separators(s, settings, report, progress) const, a "
                "std::vector<Separator>");
  static_assert(CSCD_GIVES(typename P::Packing, const P&,
                           t.pack_separators(std::declval<const S&>(), std::declval<std::vector<Separator>&>(),
                                             std::declval<Skeletonization_report&>())),
                "CSCD: SkeletonizationPolicies requires p.pack_separators(s, separators, report) const, a P::Packing");
  static_assert(CSCD_GIVES(const std::vector<Index>&, const typename P::Packing&, t.packed()),
                "CSCD: SkeletonizationPolicies requires packing.packed() const, a const std::vector<Index>&");
  static_assert(
      CSCD_GIVES(Embedded_skeleton, const P&,
                 t.build_skeleton(std::declval<const S&>(), std::declval<const std::vector<Separator>&>(),
                                  std::declval<const typename P::Packing&>(), std::declval<Skeletonization_report&>())),
      "CSCD: SkeletonizationPolicies requires p.build_skeleton(s, separators, packing, report) const, an "
      "Embedded_skeleton");
  static_assert(std::is_copy_constructible_v<P>, "CSCD: SkeletonizationPolicies requires a copy constructor");
}

} // namespace CSCD

#endif // CSCD_CONCEPTS_H
