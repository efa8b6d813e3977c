// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which shapes are alike, by their thickness and by their skeletons.

#ifndef CSCD_APPLICATION_CLASSIFY_SHAPES_H
#define CSCD_APPLICATION_CLASSIFY_SHAPES_H

#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Indexed_triangles.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/input_concepts.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CSCD {

/// What a shape is compared by. Neither position nor scale nor, but for what the skeleton changes, pose matter.
enum class Shape_descriptor
{
  diameter, ///< the distribution of shape diameters over the surface
  skeleton  ///< besides, the lengths of the longest branches, and the distances between tips along the skeleton
};

/// The numbers by which a shape is compared; see `describe_shape()`.
using Shape_description = std::vector<double>;

/// The class of each shape, as found, and how often it is right.
struct Shape_classification
{
  /// For each shape, the one nearest to it of the others that have a class; the number of shapes if there is none.
  std::vector<std::size_t> nearest;
  /// The distance to it, or infinity.
  std::vector<double> distance;
  /// Its class, or an empty string.
  std::vector<std::string> found;
  /// Of the shapes that have a class, the part of which it is found.
  double accuracy = std::numeric_limits<double>::quiet_NaN();
  /// The mean over the classes of the harmonic mean of precision and recall.
  double macro_f1 = std::numeric_limits<double>::quiet_NaN();
};

namespace internal {

Shape_description describe_shape(const Skeletonized_surface& surface, Shape_descriptor descriptor);

/// By shape diameters of any origin, one for each face.
Shape_description describe_diameters(const Indexed_triangles& triangles, const std::vector<double>& diameters);

} // namespace internal

/// describes a shape by numbers that are alike for shapes of one kind.
///
/// Of shape diameters: the logarithms of 0.01 plus the diameters of the faces, relative to the square root of the area,
/// of which 64 quantiles by area are taken. The mean difference of two such lists is the Wasserstein distance of the
/// two distributions (earth mover's distance in one dimension); see the supplement of the method's paper, appendix I.1.
/// Of the skeleton, besides: the lengths of the twelve longest branches and 16 quantiles of the distances between tips,
/// by the same unit. Near linear.
///
/// \tparam TriangleMesh a model of `FaceListGraph` of which all faces are triangles
/// \tparam Skeleton a model of `CurveSkeletonGraph` whose nodes list vertex descriptors of the mesh
/// \param mesh an oriented manifold with or without borders
/// \param skeleton of `mesh`: each vertex with a face is in the list of a node
/// \param descriptor what to describe
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of `mesh`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if the mesh is no oriented manifold of triangles, or `skeleton` is not its skeleton
template <class TriangleMesh, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Shape_description describe_shape(const TriangleMesh& mesh, const Skeleton& skeleton,
                                 Shape_descriptor descriptor = Shape_descriptor::skeleton,
                                 const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t>();
  check_triangle_mesh<TriangleMesh>();
  return internal::describe_shape(
      internal::collect_skeletonized_surface(mesh, skeleton, internal::vertex_point_map(mesh, np)).first, descriptor);
}

/// How different two shapes are: the sum of the differences of their numbers. Linear.
/// \pre both are described alike
double shape_distance(const Shape_description& first, const Shape_description& second);

/// finds the class of each shape: that of the nearest of all others that have a class, by `shape_distance()`. Shapes of
/// known class are found like the others, so that accuracy and F1 score are those of leaving one out.
/// O(n^2) distances. \param descriptions of the shapes, all alike
/// \param classes of the shapes, empty where a class is not known
/// \pre there are as many classes as descriptions
Shape_classification classify_shapes(const std::vector<Shape_description>& descriptions,
                                     const std::vector<std::string>& classes);

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Application/classify_shapes_impl.h>
#endif

#endif // CSCD_APPLICATION_CLASSIFY_SHAPES_H
