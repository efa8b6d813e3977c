// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops around handles: as many as there are, independent, short; and the cutting of every handle along some of them.

#include "Packing/Cut_surface.h"
#include "Separator/is_closed_curve.h"
#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/Shape_solid.h"
#include "support/name_of_shape.h"
#include "support/shapes.h"
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::no_index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::Vertex_loop;
using CSCD::internal::Cut_graph;
using CSCD::internal::Handle_loops;
using CSCD::internal::Separator_arrangement;
using CSCD::internal::Separator_packing;
using CSCD::test::Cut_surface;
using CSCD::test::section_separator;
using CSCD::test::Shape;
using CSCD::test::Shape_maker;
using CSCD::test::Shape_solid;

/// Bodies with handles: thin and thick, few triangles and many, smooth and noisy, knotted, linked, apart.
std::vector<Shape_maker> shapes_with_handles()
{
  using namespace CSCD::test;
  return {{"torus", [] { return torus(3, 1, 24); }},
          {"coarse_torus", [] { return torus(3, 1, 5); }},
          {"noisy_torus", [] { return noisy(torus(3, 1, 24), 0.2, 2); }},
          {"plate_with_hole", [] { return midpoint_subdivided(plate_with_hole(), 3); }},
          {"double_torus", [] { return double_torus(0.15); }},
          {"genus_5", [] { return ladder(5, 0.15); }},
          {"trefoil_knot", [] { return trefoil_knot(0.4, 16); }},
          {"chain_of_rings", [] { return chain_of_rings(3, 16); }}};
}

std::size_t genus(const Cut_graph& cut_graph)
{
  return std::accumulate(
      cut_graph.pieces().begin(), cut_graph.pieces().end(), std::size_t(0),
      [](std::size_t sum, const Cut_graph::Piece& piece) { return sum + std::size_t(piece.genus()); });
}

/// Whether `loop` is a simple closed curve along edges.
testing::AssertionResult is_simple_loop(const Triangulated_surface& surface, const Vertex_loop& loop)
{
  if (loop.size() < 3) {
    return testing::AssertionFailure() << loop.size() << " vertices";
  }
  if (std::set(loop.begin(), loop.end()).size() != loop.size()) {
    return testing::AssertionFailure() << "a vertex stands twice";
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]) == no_index) {
      return testing::AssertionFailure() << "no edge after vertex " << loop[i];
    }
  }
  return testing::AssertionSuccess();
}

/// How often `a`, pushed to its left, crosses `b`.
std::size_t number_of_crossings(const Triangulated_surface& surface, const Vertex_loop& a, const Vertex_loop& b)
{
  std::set<Index> edges;
  for (std::size_t i = 0; i < b.size(); ++i) {
    edges.insert(surface.edge(surface.find_halfedge(b[i], b[(i + 1) % b.size()])));
  }
  std::vector<Edge_crossing> crossings;
  EXPECT_TRUE(CSCD::internal::push_off(surface, a, crossings));
  return std::size_t(std::count_if(crossings.begin(), crossings.end(), [&](const Edge_crossing& crossing) {
    return edges.count(surface.edge(crossing.halfedge)) > 0;
  }));
}

/// The rank over the integers modulo 2.
std::size_t rank(std::vector<std::vector<bool>> matrix)
{
  std::size_t result = 0;
  for (std::size_t column = 0; column < matrix.size(); ++column) {
    const auto first = matrix.begin() + std::ptrdiff_t(result);
    const auto pivot = std::find_if(first, matrix.end(), [&](const auto& row) { return row[column]; });
    if (pivot == matrix.end()) {
      continue;
    }
    std::iter_swap(first, pivot);
    for (auto row = first + 1; row != matrix.end(); ++row) {
      for (std::size_t k = matrix.size(); (*row)[column] && k-- > column;) {
        (*row)[k] = (*row)[k] != (*first)[k];
      }
    }
    ++result;
  }
  return result;
}

/// Expects `loops` to be a basis of the homology of a closed surface of genus loops.size() / 2. They are one if and
/// only if no combination of them crosses all others an even number of times.
void expect_is_basis(const Triangulated_surface& surface, const std::vector<Vertex_loop>& loops)
{
  std::vector<std::vector<bool>> crosses_oddly(loops.size(), std::vector<bool>(loops.size()));
  for (std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_TRUE(is_simple_loop(surface, loops[i]));
    for (std::size_t k = 0; k < loops.size(); ++k) {
      crosses_oddly[i][k] = number_of_crossings(surface, loops[i], loops[k]) % 2 == 1;
    }
  }
  EXPECT_EQ(rank(crosses_oddly), loops.size());
}

double length(const Triangulated_surface& surface, const Vertex_loop& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    result += surface.length(surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
  }
  return result;
}

/// A surface with its levels of detail, cut along disjoint separators.
struct Cut_levels
{
  Cut_levels(const Shape& shape, const std::vector<Separator>& separators)
      : levels(CSCD::test::to_levels(shape)), cut(levels.finest().surface, separators)
  {
  }

  std::vector<Vertex_loop> loops_of_piece_with(Index vertex) const
  {
    return Handle_loops(levels.finest(), cut.arrangement)(vertex);
  }

  CSCD::Surface_levels levels;
  CSCD::test::Cut_surface cut;
};

class Handle_loops_of : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Handle_loops_of, every_piece_are_a_basis_of_its_homology)
{
  const Shape shape = GetParam().make();
  const Cut_levels levels(shape, {});
  const Cut_surface& cut = levels.cut;
  std::size_t number_of_loops = 0;
  std::set<Index> seen;
  for (Index vertex = 0; vertex < cut.surface.number_of_vertices(); ++vertex) {
    const Index piece = cut.cut_graph.piece_of_vertex(vertex);
    if (!seen.insert(piece).second) {
      continue;
    }
    const std::vector<Vertex_loop> loops = levels.loops_of_piece_with(vertex);
    expect_is_basis(cut.surface, loops);
    for (const Vertex_loop& loop : loops) {
      EXPECT_TRUE(
          std::all_of(loop.begin(), loop.end(), [&](Index v) { return cut.cut_graph.piece_of_vertex(v) == piece; }));
    }
    number_of_loops += loops.size();
  }
  EXPECT_EQ(number_of_loops, 2 * shape.genus);
}

INSTANTIATE_TEST_SUITE_P(All, Handle_loops_of, testing::ValuesIn(shapes_with_handles()), CSCD::test::name_of_shape);

TEST(Handle_loops, are_the_shortest_through_their_root)
{
  const Cut_levels levels(CSCD::test::torus(3, 1, 24), {});
  const Triangulated_surface& surface = levels.cut.surface;
  const std::vector<Vertex_loop> loops = levels.loops_of_piece_with(CSCD::test::nearest_vertex(surface, {2, 0, 0}));
  ASSERT_EQ(loops.size(), 2u);
  const double around_the_tube = 48 * std::sin(CSCD::test::pi / 24);
  EXPECT_NEAR(length(surface, loops[0]), around_the_tube, 1e-6);
  EXPECT_NEAR(length(surface, loops[1]), 4 * CSCD::test::pi, 0.1) << "around the hole, where it is narrowest";
}

/// Expects that separators from `first_new` on are disjoint closed curves, all packed, and no handle is left.
void expect_cuts_all_handles(const Shape_solid& solid, const std::vector<Separator>& separators, std::size_t first_new,
                             const Separator_packing& packing, const Shape& shape)
{
  const Triangulated_surface& surface = solid.surface();
  EXPECT_EQ(genus(packing.cut_graph()), 0u);
  EXPECT_EQ(packing.packed().size() + shape.number_of_components - packing.cut_graph().pieces().size(), shape.genus)
      << "the first Betti number of the graph of pieces";
  Separator_arrangement arrangement(surface);
  for (Index i : packing.packed()) {
    EXPECT_TRUE(arrangement.insert(i, separators[i].crossings)) << "crosses another one";
  }
  for (std::size_t i = first_new; i < separators.size(); ++i) {
    EXPECT_TRUE(CSCD::test::is_closed_curve(surface, separators[i].crossings));
    EXPECT_EQ(std::count(packing.packed().begin(), packing.packed().end(), Index(i)), 1);
    EXPECT_GT(separators[i].length, 0);
    EXPECT_LT(separators[i].source, surface.number_of_vertices());
  }
}

class Cut_handles_of : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Cut_handles_of, an_uncut_shape_cuts_all_of_them)
{
  const Shape shape = GetParam().make();
  const Shape_solid solid(shape);
  std::vector<Separator> separators;
  Separator_packing packing(solid.surface(), separators, {});
  ASSERT_EQ(genus(packing.cut_graph()), shape.genus);
  const std::size_t count = CSCD::internal::cut_handles(*solid, separators, packing);
  EXPECT_EQ(count, separators.size());
  EXPECT_EQ(count, shape.genus) << "one cut for each handle";
  expect_cuts_all_handles(solid, separators, 0, packing, shape);
  EXPECT_EQ(CSCD::internal::cut_handles(*solid, separators, packing), 0u) << "nothing is left to do";
}

TEST_P(Cut_handles_of, a_shape_cut_in_part_cuts_the_others)
{
  const Shape shape = GetParam().make();
  const Shape_solid solid(shape);
  const Triangulated_surface& surface = solid.surface();
  std::vector<Separator> all;
  Separator_packing packing_of_all(surface, all, {});
  CSCD::internal::cut_handles(*solid, all, packing_of_all);
  for (std::size_t size = 1; size <= all.size(); ++size) {
    std::vector<Separator> separators(all.begin(), all.begin() + std::ptrdiff_t(size));
    Separator_packing packing(surface, separators, std::vector<double>(size));
    ASSERT_EQ(genus(packing.cut_graph()), shape.genus - size);
    EXPECT_EQ(CSCD::internal::cut_handles(*solid, separators, packing), shape.genus - size);
    expect_cuts_all_handles(solid, separators, size, packing, shape);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Cut_handles_of, testing::ValuesIn(shapes_with_handles()), CSCD::test::name_of_shape);

TEST(cut_handles, cuts_across_the_body_not_around_its_holes)
{
  const Shape shape = CSCD::test::ladder(4, 0.15);
  const Shape_solid solid(shape);
  std::vector<Separator> separators;
  Separator_packing packing(solid.surface(), separators, {});
  CSCD::internal::cut_handles(*solid, separators, packing);
  const double way_around_a_hole = 4 * (2 - 2 * 0.35);
  for (const Separator& separator : separators) {
    EXPECT_LT(separator.length * solid.unit(), way_around_a_hole);
  }
}

} // namespace
