// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What corresponds in two skeletons of one body in different poses, and labels that are carried over so.

#ifndef CSCD_APPLICATION_MATCH_SKELETONS_H
#define CSCD_APPLICATION_MATCH_SKELETONS_H

#include <CSCD/Application/Skeletonized_surface.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/input_concepts.h>

#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD {

/// What corresponds in two skeletons. Nodes are numbered from 0 in the order of their graphs.
struct Skeleton_match
{
  /// The ends of corresponding limbs, in the first and in the second skeleton.
  std::vector<std::array<Index, 2>> ends;
  /// For each node of the second skeleton, the one of the first to which it corresponds.
  std::vector<Index> nodes;
};

namespace internal {

/// See `CSCD::match_skeletons()`.
Skeleton_match match_skeletons(const Indexed_skeleton& first, const Indexed_skeleton& second);

/// For each face of `second`, one of the labels of the faces of `first`; see `CSCD::carry_labels()`.
std::vector<std::size_t> carry_labels(const Skeletonized_surface& first, const std::vector<std::size_t>& labels,
                                      const Skeletonized_surface& second);

} // namespace internal

/// finds what corresponds in the skeletons of one body in two poses, or of two bodies of one kind.
///
/// The limbs of each skeleton are found first: two ends that are furthest apart along it, then always the end that is
/// furthest from the paths to those before, while it is by a tenth of the distance of the first two; at most nine. A
/// skeleton without tips takes other nodes instead. Of all assignments of the limbs of the one to those of the other,
/// that of the least cost is taken: the mean difference of the distances of the ends along the skeleton, plus twice
/// that of the straight distances of the places where limbs begin, plus that of the radii along each limb. A node
/// corresponds to the one that is at the most similar distances from the ends. Lengths are relative to the length of
/// the paths between the ends, so that scale does not matter.
///
/// Where a body is symmetric, sides may be exchanged. That limbs begin as far apart as before tells that the left arm
/// is on the side of the left leg. In parts that are not connected, and further ends, nothing is certain.
///
/// O(k n log n + n^2 k) for n nodes and k ends, plus O(k!) in the worst case.
///
/// \tparam Skeleton1,Skeleton2 models of `CurveSkeletonGraph` with at least one node; radii count if both have them
template <class Skeleton1, class Skeleton2>
Skeleton_match match_skeletons(const Skeleton1& first, const Skeleton2& second)
{
  return internal::match_skeletons(internal::index_skeleton(first), internal::index_skeleton(second));
}

/// carries labels of the faces of a mesh to a mesh of the same body in another pose, which needs to have neither the
/// same faces nor the same number of them.
///
/// Every vertex has its distances from the ends that correspond: along the skeleton, averaged over the surface around,
/// and, with half the weight, along edges. A vertex of the second mesh gets the label of the vertex of the first whose
/// distances are the most similar; labels are then smoothed along the surface, and a face gets that of most of its
/// vertices. Of the eight best assignments of limbs, one is taken that keeps the orientation of the surface: so sides
/// are exchanged less often than by match_skeletons().
///
/// O(n log n + n m k + n l) for n vertices, m nodes, k ends and l labels, beside match_skeletons().
///
/// \tparam TriangleMesh1,TriangleMesh2 models of `FaceListGraph` of which all faces are triangles
/// \tparam Skeleton1,Skeleton2 models of `CurveSkeletonGraph` whose nodes list vertex descriptors of the meshes
/// \tparam FaceLabelMap1 a model of `ReadablePropertyMap` with face descriptors as keys and `std::size_t` as value
/// \tparam FaceLabelMap2 a model of `WritablePropertyMap` with face descriptors as keys and `std::size_t` as value
/// \param first,first_skeleton,first_labels a mesh, its skeleton, and labels of its faces
/// \param second,second_skeleton the other mesh and its skeleton
/// \param second_labels gets the labels
/// \param np1,np2 optional sequences of named parameters of the meshes
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices of the mesh}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Input_error if a mesh is no oriented manifold of triangles, or a skeleton is not that of its mesh
/// \see match_skeletons()
template <class TriangleMesh1, class Skeleton1, class FaceLabelMap1, class TriangleMesh2, class Skeleton2,
          class FaceLabelMap2, class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters>
void carry_labels(const TriangleMesh1& first, const Skeleton1& first_skeleton, const FaceLabelMap1& first_labels,
                  const TriangleMesh2& second, const Skeleton2& second_skeleton, FaceLabelMap2 second_labels,
                  const NamedParameters1& np1 = parameters::default_values(),
                  const NamedParameters2& np2 = parameters::default_values())
{
  internal::check_named_parameters<NamedParameters1, CGAL::internal_np::vertex_point_t>();
  internal::check_named_parameters<NamedParameters2, CGAL::internal_np::vertex_point_t>();
  check_triangle_mesh<TriangleMesh1>();
  check_triangle_mesh<TriangleMesh2>();
  const internal::Skeletonized_surface from =
      internal::collect_skeletonized_surface(first, first_skeleton, internal::vertex_point_map(first, np1)).first;
  const internal::Skeletonized_surface to =
      internal::collect_skeletonized_surface(second, second_skeleton, internal::vertex_point_map(second, np2)).first;
  std::vector<std::size_t> labels;
  labels.reserve(from.triangles.faces.size());
  for (const auto face : boost::make_iterator_range(faces(first))) {
    labels.push_back(std::size_t(get(first_labels, face)));
  }
  const std::vector<std::size_t> carried = internal::carry_labels(from, labels, to);
  std::size_t number = 0;
  for (const auto face : boost::make_iterator_range(faces(second))) {
    put(second_labels, face, carried[number++]);
  }
}

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Application/match_skeletons_impl.h>
#endif

#endif // CSCD_APPLICATION_MATCH_SKELETONS_H
