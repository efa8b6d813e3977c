// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a surface and its reconstruction from a skeleton are apart.

#ifndef CSCD_MEASURE_MEASURE_RECONSTRUCTION_H
#define CSCD_MEASURE_MEASURE_RECONSTRUCTION_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/triangulate_field.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Measures from the reconstruction to the input, at the centres of faces, weighted by their areas. Of many faces some
/// are chosen: one of each stretch of the numbering, at a place that goes with the golden ratio, so that the pattern in
/// which a cell's faces follow each other has no say.
template <class Distance>
void measure_reverse(const Triangulated_surface& surface, const Distance& distance_to_input,
                     Reconstruction_error& error)
{
  constexpr std::size_t enough_faces = 25000; // for a mean that is right to one percent
  const std::size_t number_of_faces = surface.number_of_faces();
  const std::size_t number_of_samples = std::min(number_of_faces, enough_faces);
  const double stretch = double(number_of_faces) / double(number_of_samples);
  double total_area = 0;
  double sum = 0;
  error.reverse_maximum = 0;
  double place = 0;
  for (std::size_t i = 0; i < number_of_samples; ++i) {
    const auto f = Index(std::min<double>((double(i) + place) * stretch, double(number_of_faces - 1)));
    place += boost::math::double_constants::phi;
    place -= std::floor(place);
    const Vector_3 center = (surface.point(surface.origin(3 * f)) + surface.point(surface.target(3 * f)) +
                             surface.point(surface.opposite_vertex(3 * f))) /
                            3;
    const double area = surface.face_vector(f).norm() / 2;
    const double distance = distance_to_input(center);
    total_area += area;
    sum += area * distance;
    error.reverse_maximum = std::max(error.reverse_maximum, distance);
  }
  error.reverse_mean = sum / total_area;
}

/// Measures the distances between `points`, those of the input, and the faces of `reconstruction`, both ways.
/// O((p + f) log f) for p points and f faces.
/// \param distance_to_input gives the distance of a point from the input
template <class Distance>
Reconstruction_error measure_reconstruction(Field_surface&& reconstruction, const std::vector<Vector_3>& points,
                                            const Distance& distance_to_input)
{
  Reconstruction_error error;
  error.unresolved_fraction = reconstruction.unresolved_fraction;
  error.cell_size = reconstruction.cell_size;
  error.number_of_faces = reconstruction.triangles.faces.size();
  if (error.number_of_faces == 0) {
    return error;
  }
  const Triangulated_surface surface(std::move(reconstruction.triangles));
  CGAL_assertion(!surface.defect());
  const Solid_queries queries(surface);
  double sum = 0;
  double sum_of_squares = 0;
  error.maximum = 0;
  Index near = no_index;
  for (const Vector_3& point : points) {
    const Surface_point nearest = queries.closest_point(point, near);
    near = nearest.face;
    const double square = (nearest.point - point).squaredNorm();
    sum += std::sqrt(square);
    sum_of_squares += square;
    error.maximum = std::max(error.maximum, std::sqrt(square));
  }
  error.mean = sum / double(points.size());
  error.mean_square = sum_of_squares / double(points.size());
  measure_reverse(surface, distance_to_input, error);
  return error;
}

} // namespace CSCD::internal

#endif // CSCD_MEASURE_MEASURE_RECONSTRUCTION_H
