// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The algorithms of the pipeline as published.

#ifndef CSCD_PUBLISHED_POLICIES_H
#define CSCD_PUBLISHED_POLICIES_H

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Options.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/Point_solid.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Quotient_skeleton.h>
#include <CSCD/Published/Region_packing.h>
#include <CSCD/Published/Sampled_search.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeleton/embed_skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/concepts.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD {

/// The method as published: distances by the heat method on the intrinsic Delaunay triangulation, the cut locus from
/// the whole distance field, shortening by edge flips or, among points, the variational flow, random sources; of
/// a mesh the cut graph, else the quotient graph of regions. A model of `SkeletonizationPolicies` for every model of
/// `SkeletonizationSurface`: with `Triangulated_solid` this is CSCD-M, with `Point_solid` CSCD-PC. Slower than
/// `Local_policies` by an order of magnitude; its time grows with the number of sources times that of vertices.
class Published_policies
{
public:
  /// The packed separators, and the regions of the surface around them.
  using Packing = internal::Region_packing;

  /// The number of sources of the published experiments.
  static constexpr std::size_t default_number_of_sources = 3000;

  /// \param settings how sources are drawn, targets chosen, loops shortened and separators packed
  /// \pre a multiscale search for `Triangulated_solid` only
  explicit Published_policies(const Field_search_settings& settings = Field_search_settings()) : m_settings(settings) {}

  /// Draws `settings.maximum_number_of_sources` sources. Where that has no bound, `default_number_of_sources`; fewer,
  /// but as many as the mesh has vertices, where most vertices were inserted into large faces and there are thousands.
  /// \throw Input_error for `Point_solid` with overlap by crossings
  template <class Surface>
  std::vector<Separator> find_separators(const Surface& surface, const Options& settings,
                                         Skeletonization_report& report, const Progress& progress) const;

  /// Drops separators by score, inside test and overlap. With `Placement_rule::sections`, appends separators around
  /// handles that no other one cuts; else gives each vertex to the nearest that remains.
  template <class Surface>
  Packing pack_separators(const Surface& surface, std::vector<Separator>& separators,
                          Skeletonization_report& report) const;

  /// Builds the skeleton of a mesh cut along the packed separators, as `Local_policies`. With
  /// `Placement_rule::centroids`, and of any other surface, it is the quotient graph: a node for each region, an edge
  /// where two regions touch.
  template <class Surface>
  Embedded_skeleton build_skeleton(const Surface& surface, const std::vector<Separator>& separators,
                                   const Packing& packing, Skeletonization_report& report) const;

private:
  /// The number of sources where the user sets no bound.
  template <class Surface>
  static std::size_t number_of_sources(const Surface& surface)
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      // Sources times vertices: as on a cube, and a few seconds. Needles are given ten times as many vertices.
      constexpr std::size_t max_work = 7'500'000;
      constexpr std::size_t usual_growth = 3; // inserted for each vertex of the input, see `refine_large_faces()`
      const std::size_t number_of_vertices = surface.triangulation().number_of_vertices();
      const std::size_t number_of_given_vertices = number_of_vertices - surface.report().number_of_inserted_vertices;
      if (surface.report().number_of_inserted_vertices > usual_growth * number_of_given_vertices) {
        return std::min(default_number_of_sources, std::max(number_of_given_vertices, max_work / number_of_vertices));
      }
    }
    return default_number_of_sources;
  }

  Field_search_settings m_settings;
};

template <class Surface>
std::vector<Separator> Published_policies::find_separators(const Surface& surface, const Options& settings,
                                                           Skeletonization_report& report,
                                                           const Progress& progress) const
{
  check_skeletonization_surface<Surface>();
  if (std::is_same_v<std::decay_t<decltype(surface.triangulation())>, Point_complex> &&
      m_settings.overlap_rule == Overlap_rule::crossing) {
    throw Input_error("separators among points cannot be tested for crossings: choose Overlap_rule::nearest_vertex");
  }
  internal::Sampled_search<Surface> search(surface, settings, m_settings);
  const bool is_bounded = settings.maximum_number_of_sources != Options().maximum_number_of_sources;
  std::vector<Separator> separators =
      search(is_bounded ? settings.maximum_number_of_sources : number_of_sources(surface), report, progress);
  for (Separator& separator : separators) {
    internal::mark_open(surface, separator);
  }
  return separators;
}

template <class Surface>
Published_policies::Packing Published_policies::pack_separators(const Surface& surface,
                                                                std::vector<Separator>& separators,
                                                                Skeletonization_report& report) const
{
  std::vector<Index> packed = Packing::pack(surface, separators, m_settings, report);
  if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
    if (m_settings.placement_rule == Placement_rule::sections) {
      internal::Separator_packing packing(surface.triangulation(), separators, packed);
      internal::cut_handles(surface, separators, packing, report);
      return Packing(packing);
    }
  }
  return Packing(surface, separators, std::move(packed), m_settings.overlap_rule);
}

template <class Surface>
Embedded_skeleton Published_policies::build_skeleton(const Surface& surface, const std::vector<Separator>& separators,
                                                     const Packing& packing, Skeletonization_report& report) const
{
  if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
    if (packing.cut_graph()) {
      return internal::embed_skeleton(surface, separators, packing.packed(), *packing.cut_graph(),
                                      Options().node_spacing, report);
    }
  }
  return internal::Quotient_skeleton_builder<Surface>(surface, packing.regions())(report);
}

#ifdef CSCD_COMPILED
#define CSCD_PUBLISHED_POLICIES_INSTANCE(prefix, Surface)                                                              \
  prefix template std::vector<Separator> Published_policies::find_separators<Surface>(                                 \
      const Surface&, const Options&, Skeletonization_report&, const Progress&) const;                                 \
  prefix template Published_policies::Packing Published_policies::pack_separators<Surface>(                            \
      const Surface&, std::vector<Separator>&, Skeletonization_report&) const;                                         \
  prefix template Embedded_skeleton Published_policies::build_skeleton<Surface>(                                       \
      const Surface&, const std::vector<Separator>&, const Packing&, Skeletonization_report&) const;
CSCD_PUBLISHED_POLICIES_INSTANCE(extern, Triangulated_solid)
CSCD_PUBLISHED_POLICIES_INSTANCE(extern, Point_solid)
#endif

} // namespace CSCD

#endif // CSCD_PUBLISHED_POLICIES_H
