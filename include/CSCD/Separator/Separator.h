// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A closed curve on the surface that cuts a limb.

#ifndef CSCD_SEPARATOR_SEPARATOR_H
#define CSCD_SEPARATOR_SEPARATOR_H

#include <CSCD/Traits/Edge_crossing.h>
#include <CSCD/internal/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <vector>

namespace CSCD {

/// A local separator: a simple closed curve on the surface, given by the edges that it crosses, with its measures in
/// the normalized frame of the traits object.
struct Separator
{
  /// The crossings in order along the curve. On a mesh, consecutive ones lie in one face, the last and the first too;
  /// on a point cloud they have an end in common, or ends that are neighbors.
  std::vector<internal::Edge_crossing> crossings;
  /// On a point cloud, the points of the curve, which passes the crossed edges at a distance. Empty on a mesh, where
  /// the curve is the polygon of its crossings.
  std::vector<internal::Vector_3> points;
  /// Length of the curve.
  double length = 0;
  /// Mean of its points by length.
  internal::Vector_3 center = internal::Vector_3::Zero();
  /// Unit normal of the vector area of the curve; the left side of the curve lies on its positive side.
  internal::Vector_3 normal = internal::Vector_3::UnitZ();
  /// Norm of the vector area: the area that a planar curve encloses.
  double area = 0;
  /// Root mean square distance of the curve from its mean plane, relative to its length.
  double planarity = 0;
  /// The vertex of the finest surface from which it was found.
  internal::Index source = internal::no_index;
  /// The level of detail on which it was found.
  internal::Index level = 0;

  /// Radius of the circle of the same length.
  double radius() const { return length / (2 * boost::math::double_constants::pi); }
};

} // namespace CSCD

#endif // CSCD_SEPARATOR_SEPARATOR_H
