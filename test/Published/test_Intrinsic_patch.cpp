// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A patch behaves as the whole triangulation does, and holds no more than what was touched.

#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Edge_trace.h>
#include <CSCD/Published/Intrinsic_patch.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::Edge_trace;
using Intrinsic_patch = CSCD::internal::Intrinsic_patch<Triangulated_surface>;
using Intrinsic_triangulation = CSCD::internal::Intrinsic_triangulation<Triangulated_surface>;

/// What an edge crosses, from both ends, and its length.
template <class Triangulation>
std::vector<double> describe(Triangulation& triangulation, Index halfedge)
{
  Edge_trace trace;
  triangulation.trace(halfedge, trace);
  std::vector<double> result{triangulation.length(halfedge), double(triangulation.input_halfedge(halfedge))};
  for (const Edge_crossing& crossing : trace.crossings()) {
    result.push_back(double(crossing.halfedge));
    result.push_back(crossing.position);
  }
  return result;
}

/// Walks and flips at random in a patch of `source` and in `whole`, which is the same triangulation, and compares.
template <class Source>
void expect_alike(const Source& source, const Intrinsic_triangulation& triangulation)
{
  CSCD::internal::Intrinsic_patch<Source> patch(source, 0);
  std::mt19937_64 random(1);
  for (int round = 0; round < 5; ++round) {
    patch.clear();
    EXPECT_EQ(patch.number_of_faces(), 0u);
    Intrinsic_triangulation whole = triangulation;
    Index at_whole = Index(random() % source.number_of_halfedges());
    Index at_patch = patch.halfedge_along(at_whole);
    EXPECT_EQ(patch.number_of_faces(), 1u);
    for (int step = 0; step < 2000; ++step) {
      const std::size_t choice = random() % 4;
      if (choice == 0) {
        at_whole = Intrinsic_triangulation::next(at_whole);
        at_patch = Intrinsic_patch::next(at_patch);
      } else if (choice < 3) {
        at_whole = whole.twin(at_whole);
        at_patch = patch.twin(at_patch);
      } else {
        const bool is_flippable = whole.is_flippable(at_whole);
        ASSERT_EQ(patch.flip_if_convex(at_patch), is_flippable);
        if (is_flippable) {
          whole.flip(at_whole);
        }
      }
      ASSERT_EQ(patch.origin(at_patch), whole.origin(at_whole));
      ASSERT_EQ(patch.length(at_patch), whole.length(at_whole));
      ASSERT_EQ(patch.angle(at_patch), whole.angle(at_whole));
      ASSERT_EQ(patch.number_of_crossings(at_patch), whole.number_of_crossings(at_whole));
      if (step % 50 == 0) {
        ASSERT_EQ(describe(patch, at_patch), describe(whole, at_whole));
      }
    }
    EXPECT_LE(patch.number_of_faces(), source.number_of_faces());
  }
}

TEST(Intrinsic_patch, does_what_the_whole_triangulation_does)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::torus(3, 1, 16), 0.3, 1));
  Intrinsic_triangulation triangulation(surface);
  expect_alike(surface, triangulation);
  ASSERT_GT(triangulation.make_delaunay(), 0u);
  expect_alike(triangulation, triangulation);
}

TEST(Intrinsic_patch, adds_faces_one_by_one)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(3));
  Intrinsic_patch patch(surface, 0);
  const Index h = patch.halfedge_along(0);
  EXPECT_EQ(patch.number_of_faces(), 1u);
  EXPECT_EQ(patch.halfedge_along(0), h);
  EXPECT_EQ(patch.halfedge_along(2), Intrinsic_patch::previous(h));
  EXPECT_EQ(patch.number_of_faces(), 1u);
  const Index t = patch.twin(h);
  EXPECT_EQ(patch.number_of_faces(), 2u);
  EXPECT_TRUE(patch.are_twins(h, t));
  EXPECT_EQ(patch.twin(t), h);
  EXPECT_EQ(patch.halfedge_along(surface.twin(0)), t);
  // Once around a vertex: its whole fan, and back to the start.
  Index incident_edge = h;
  for (Index i = 0; i < surface.degree(surface.origin(0)); ++i) {
    incident_edge = patch.next_around_origin(incident_edge);
  }
  EXPECT_EQ(incident_edge, h);
  EXPECT_EQ(patch.number_of_faces(), surface.degree(surface.origin(0)));
}

} // namespace
