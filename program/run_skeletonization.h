// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The computation of skeletons by `Curve_skeletonization`, for any traits and policies.

#ifndef CSCD_PROGRAM_RUN_SKELETONIZATION_H
#define CSCD_PROGRAM_RUN_SKELETONIZATION_H

#include "types.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Options.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Vector3.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace cscd {

using Numbers = std::vector<std::size_t>;
using Point_map = CGAL::Pointer_property_map<Vector3>::const_type;

/// Passes progress on to a function, if given.
class Progress_visitor : public CSCD::Default_skeletonization_visitor
{
public:
  /// \param progress is referred to
  explicit Progress_visitor(const Stage_progress& progress) : m_progress(progress) {}

  void on_stage_begin(CSCD::Skeletonization_stage stage)
  {
    m_stage = stage;
    progress(0);
  }

  void progress(double fraction)
  {
    if (m_progress) {
      m_progress(m_stage, fraction);
    }
  }

private:
  const Stage_progress& m_progress;
  CSCD::Skeletonization_stage m_stage = CSCD::Skeletonization_stage::compile_surface;
};

/// The options of the engine that `options` choose.
CSCD::Options engine_options(const Skeletonize_options& options);

/// Makes surface traits of the numbered points of `input`, and of the normals if there are any.
template <class Traits>
Traits make_traits(const Input& input)
{
  Numbers numbers(input.number_of_points);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const Point_map point_map = CGAL::make_property_map(input.points);
  return input.normals.empty() ? Traits(numbers, point_map)
                               : Traits(numbers, point_map, Point_map(CGAL::make_property_map(input.normals)));
}

/// Takes over the surface of `traits`, which were made of the points of `input`: its vertices are the points, and
/// inserted ones behind them.
template <class Traits>
void take_surface(const Traits& traits, Input& input)
{
  const auto& triangulation = traits.surface().triangulation();
  std::vector<Index> place_of_vertex;
  for (Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
    const auto numbers = traits.descriptors(vertex);
    const Vector3 place = traits.normalization().to_input(triangulation.point(vertex));
    const auto nearest = std::min_element(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
      return (input.points[a] - place).squaredNorm() < (input.points[b] - place).squaredNorm();
    });
    place_of_vertex.push_back(Index(nearest == numbers.end() ? input.points.size() : *nearest));
    if (nearest == numbers.end()) {
      input.points.push_back(place);
    }
  }
  for (Index face = 0; face < triangulation.number_of_faces(); ++face) {
    const auto [a, b, c] = triangulation.face_halfedges(face);
    input.faces.push_back({place_of_vertex[triangulation.origin(a)], place_of_vertex[triangulation.origin(b)],
                           place_of_vertex[triangulation.origin(c)]});
  }
}

/// Skeletonizes the surface of `traits` by the algorithms of `policies`.
template <class Traits, class Policies>
Skeletonization_result run_skeletonization(const Traits& traits, const Policies& policies,
                                           const Skeletonize_options& options, Progress_visitor& visitor)
{
  Skeletonization_result result;
  result.report = CSCD::internal::run_stages(traits, policies, engine_options(options), visitor, result.skeleton);
  return result;
}

} // namespace cscd

#endif // CSCD_PROGRAM_RUN_SKELETONIZATION_H
