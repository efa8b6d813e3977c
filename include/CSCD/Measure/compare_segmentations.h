// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How alike two segmentations of a mesh are.

#ifndef CSCD_MEASURE_COMPARE_SEGMENTATIONS_H
#define CSCD_MEASURE_COMPARE_SEGMENTATIONS_H

#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/input_concepts.h>

#include <boost/range/iterator_range_core.hpp>

#include <vector>

namespace CSCD {

/// How two segmentations of the same faces differ: the measures of the Princeton segmentation benchmark (X. Chen,
/// A. Golovinskiy, T. Funkhouser, "A benchmark for 3D mesh segmentation", 2009). Each face counts once, whatever its
/// area. All are 0 for equal segmentations, except the adjusted Rand index.
struct Segmentation_comparison
{
  double rand_error = 0;               ///< part of the pairs of faces that are together in one, apart in the other
  double adjusted_rand_index = 1;      ///< 1 for equal segmentations, about 0 for segmentations with nothing in common
  double missing_rate = 0;             ///< part of the faces outside of the part of the first that covers theirs best
  double false_alarm_rate = 0;         ///< the same with the segmentations exchanged
  double hamming_distance = 0;         ///< mean of both rates
  double global_consistency_error = 0; ///< 0 if one segmentation refines the other
  double local_consistency_error = 0;  ///< 0 if at each place one segmentation refines the other
  /// Mean distances along edges from the boundaries of each segmentation to those of the other, added and divided by
  /// the mean distance of the faces from their centroid; undefined if just one of the segmentations has boundaries, or
  /// some lie in components where the other has none.
  double cut_discrepancy = undefined_measure;
};

namespace internal {

/// The measures of two segmentations, by the labels of the faces.
Segmentation_comparison compare_segmentations(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                              const std::vector<Index>& first, const std::vector<Index>& second);

/// Replaces labels by the numbers from 0 of their order. O(n log n).
std::vector<Index> number_labels(const std::vector<long long>& labels);

/// The labels of the faces of `mesh` in their order, numbered anew from 0.
template <class TriangleMesh, class FaceLabelMap>
std::vector<Index> numbered_labels(const TriangleMesh& mesh, const FaceLabelMap& labels)
{
  std::vector<long long> values;
  values.reserve(num_faces(mesh));
  for (const auto face : boost::make_iterator_range(faces(mesh))) {
    values.push_back(static_cast<long long>(get(labels, face)));
  }
  return number_labels(values);
}

} // namespace internal

/// measures how alike two segmentations of a mesh are.
///
/// O(n log n) for n faces.
///
/// \tparam TriangleMesh a model of `FaceListGraph` whose faces are all triangles
/// \tparam FaceLabelMap1,FaceLabelMap2 models of `ReadablePropertyMap` with face descriptors as keys and integers as
///         values
/// \param mesh an oriented manifold with or without borders
/// \param first,second the labels of the faces; faces of one label are one part, connected or not
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
/// \throw Input_error if the mesh is not an oriented manifold of triangles
template <class TriangleMesh, class FaceLabelMap1, class FaceLabelMap2,
          class NamedParameters = parameters::Default_named_parameters>
Segmentation_comparison compare_segmentations(const TriangleMesh& mesh, const FaceLabelMap1& first,
                                              const FaceLabelMap2& second,
                                              const NamedParameters& np = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters, CGAL::internal_np::vertex_point_t>();
  check_triangle_mesh<TriangleMesh>();
  const auto collected = internal::collect_triangles(mesh, internal::vertex_point_map(mesh, np));
  return internal::compare_segmentations(collected.triangles, collected.pairing, internal::numbered_labels(mesh, first),
                                         internal::numbered_labels(mesh, second));
}

} // namespace CSCD

#endif // CSCD_MEASURE_COMPARE_SEGMENTATIONS_H
