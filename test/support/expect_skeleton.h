// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletonizes and expects properties of every answer and of every failure.

#ifndef CSCD_TEST_SUPPORT_EXPECT_SKELETON_H
#define CSCD_TEST_SUPPORT_EXPECT_SKELETON_H

#include "invariants.h"
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/extract_curve_skeleton.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace CSCD::test {

/// Expects that `mesh`, which has `number_of_cavities` cavities, has a skeleton with all invariants, and writes it to
/// `skeleton`.
template <class Mesh, class Skeleton, class NamedParameters = parameters::Default_named_parameters>
Skeletonization_report expect_skeleton(const Mesh& mesh, Skeleton& skeleton,
                                       const NamedParameters& np = parameters::default_values(),
                                       std::size_t number_of_cavities = 0)
{
  Skeletonization_report report;
  EXPECT_NO_THROW(report = extract_curve_skeleton(mesh, skeleton, np));
  EXPECT_EQ(violated_invariants(mesh, skeleton, report, number_of_cavities), Violations{});
  return report;
}

/// A skeleton that no mesh has, to check that a function that fails keeps its output.
template <class Skeleton>
Skeleton marked_skeleton()
{
  Skeleton skeleton(2);
  skeleton[0].point = {1, 2, 3};
  skeleton[1].point = {4, 5, 6}; // points of some kernels have no coordinates before
  skeleton[1].radius = 42;
  add_edge(0, 1, skeleton);
  return skeleton;
}

/// Expects that `skeleton` is still the `marked_skeleton()`.
template <class Skeleton>
void expect_is_marked(const Skeleton& skeleton)
{
  const Skeleton marked = marked_skeleton<Skeleton>();
  ASSERT_EQ(num_vertices(skeleton), num_vertices(marked));
  EXPECT_EQ(num_edges(skeleton), num_edges(marked));
  for (const std::size_t node : {0U, 1U}) {
    EXPECT_EQ(skeleton[node].point, marked[node].point);
    EXPECT_EQ(skeleton[node].radius, marked[node].radius);
    EXPECT_EQ(skeleton[node].vertices, marked[node].vertices);
  }
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_EXPECT_SKELETON_H
