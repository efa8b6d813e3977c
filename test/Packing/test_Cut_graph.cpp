// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pieces of a cut surface: areas, Euler numbers, sides, and the graph that they form.

#include "Packing/Cut_surface.h"
#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::no_index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Cut_graph;
using CSCD::internal::Separator_arrangement;
using CSCD::test::circle_separator;
using CSCD::test::Cut_surface;
using CSCD::test::section_separator;
using CSCD::test::tube_section;

/// What might have been cut besides must not matter.
void expect_is_that_of_the_arrangement_alone(const Cut_surface& cut)
{
  Cut_graph alone(cut.surface, cut.arrangement);
  alone.cut(cut.arrangement);
  ASSERT_EQ(alone.pieces().size(), cut.cut_graph.pieces().size());
  for (Index piece = 0; piece < alone.pieces().size(); ++piece) {
    EXPECT_NEAR(alone.pieces()[piece].area, cut.cut_graph.pieces()[piece].area, 1e-6);
    EXPECT_EQ(alone.pieces()[piece].euler, cut.cut_graph.pieces()[piece].euler);
    EXPECT_EQ(alone.pieces()[piece].separators, cut.cut_graph.pieces()[piece].separators);
  }
  for (Index vertex = 0; vertex < cut.surface.number_of_vertices(); ++vertex) {
    ASSERT_EQ(alone.piece_of_vertex(vertex), cut.cut_graph.piece_of_vertex(vertex));
  }
}

/// What holds for every cut.
void expect_is_sound(const Cut_surface& cut)
{
  expect_is_that_of_the_arrangement_alone(cut);
  const std::vector<Cut_graph::Piece>& pieces = cut.cut_graph.pieces();
  double area = 0;
  int euler = 0;
  std::vector<std::size_t> times_around(cut.separators.size(), 0);
  for (Index piece = 0; piece < pieces.size(); ++piece) {
    EXPECT_GE(pieces[piece].area, -1e-9);
    EXPECT_GE(pieces[piece].genus(), 0);
    EXPECT_EQ((2 - pieces[piece].euler - int(pieces[piece].separators.size())) % 2, 0);
    area += pieces[piece].area;
    euler += pieces[piece].euler;
    for (Index i : pieces[piece].separators) {
      ++times_around[i];
      const Cut_graph::Sides& sides = cut.cut_graph.sides(i);
      EXPECT_TRUE(sides.first == piece || sides.second == piece);
      EXPECT_EQ(sides.other(sides.first), sides.second);
      EXPECT_EQ(sides.other(sides.second), sides.first);
    }
  }
  EXPECT_NEAR(area, cut.surface.total_area(), 1e-5 * cut.surface.total_area());
  EXPECT_EQ(euler, cut.euler_number()) << "circles have Euler number 0";
  EXPECT_EQ(times_around, std::vector<std::size_t>(cut.separators.size(), 2));
  // A halfedge that crosses one separator once goes from the one side to the other.
  for (Index i = 0; i < cut.separators.size(); ++i) {
    const Cut_graph::Sides& sides = cut.cut_graph.sides(i);
    for (const Edge_crossing& crossing : cut.separators[i].crossings) {
      const Index edge = cut.surface.edge(crossing.halfedge);
      const auto& points = cut.arrangement.points();
      if (std::count_if(points.begin(), points.end(), [&](const auto& point) { return point.edge == edge; }) == 1) {
        const Index from = cut.cut_graph.piece_of_vertex(cut.surface.origin(edge));
        const Index to = cut.cut_graph.piece_of_vertex(cut.surface.target(edge));
        EXPECT_TRUE((from == sides.first && to == sides.second) || (from == sides.second && to == sides.first));
      }
    }
  }
}

/// The connected components of the vertices along edges that no separator crosses, found by flooding: where separators
/// are some vertices apart, these are the pieces. Compares them, with the Euler numbers of what they span.
void expect_is_as_flooded(const Cut_surface& cut)
{
  const Triangulated_surface& surface = cut.surface;
  std::set<Index> crossed;
  for (const Separator& separator : cut.separators) {
    for (const Edge_crossing& crossing : separator.crossings) {
      crossed.insert(surface.edge(crossing.halfedge));
    }
  }
  std::vector<Index> flooded(surface.number_of_vertices(), no_index);
  Index number = 0;
  std::vector<int> euler;
  for (Index start = 0; start < flooded.size(); ++start) {
    if (flooded[start] != no_index) {
      continue;
    }
    std::vector<Index> stack{start};
    flooded[start] = number;
    euler.push_back(0);
    while (!stack.empty()) {
      const Index vertex = stack.back();
      stack.pop_back();
      ++euler.back();
      for (Index h : surface.outgoing(vertex)) {
        if (crossed.count(surface.edge(h)) == 0 && flooded[surface.target(h)] == no_index) {
          flooded[surface.target(h)] = number;
          stack.push_back(surface.target(h));
        }
      }
    }
    ++number;
  }
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    euler[flooded[surface.origin(h)]] -= surface.edge(h) == h && crossed.count(h) == 0 ? 1 : 0;
    const bool is_face_whole = crossed.count(surface.edge(h)) + crossed.count(surface.edge(surface.next(h))) +
                                   crossed.count(surface.edge(surface.previous(h))) ==
                               0;
    euler[flooded[surface.origin(h)]] += h % 3 == 0 && is_face_whole ? 1 : 0;
  }
  ASSERT_EQ(cut.cut_graph.pieces().size(), number);
  for (Index vertex = 0; vertex < flooded.size(); ++vertex) {
    ASSERT_EQ(cut.cut_graph.piece_of_vertex(vertex), flooded[vertex]) << "pieces are numbered by their least vertex";
  }
  for (Index piece = 0; piece < number; ++piece) {
    EXPECT_EQ(cut.cut_graph.pieces()[piece].euler, euler[piece]);
  }
}

TEST(Cut_graph, of_an_uncut_surface_is_one_piece)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::torus(3, 1, 12));
  const Cut_surface cut(surface, {});
  expect_is_sound(cut);
  expect_is_as_flooded(cut);
  EXPECT_EQ(cut.cut_graph.pieces().front().genus(), 1);
}

TEST(Cut_graph, of_a_tube_is_a_path)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 24, CSCD::test::Tube_end::flat));
  std::vector<Separator> separators;
  const std::vector<double> places{2.03, 5.04, 7.55};
  for (double x : places) {
    separators.push_back(tube_section(surface, x));
  }
  const Cut_surface cut(surface, separators);
  expect_is_sound(cut);
  expect_is_as_flooded(cut);
  EXPECT_EQ(cut.cut_graph.pieces().size(), 4u);
  EXPECT_EQ(cut.betti_number(1), 0u);
  const double circumference = 48 * std::sin(CSCD::test::pi / 24);
  const Index middle = cut.cut_graph.piece_of_vertex(CSCD::test::nearest_vertex(surface, {3.5, 0, 1}));
  EXPECT_NEAR(cut.cut_graph.pieces()[middle].area, circumference * (places[1] - places[0]), 1e-3);
  EXPECT_EQ(cut.cut_graph.pieces()[middle].separators, (std::vector<Index>{0, 1}));
  EXPECT_EQ(cut.cut_graph.pieces()[middle].euler, 0);
  const Index end = cut.cut_graph.piece_of_vertex(CSCD::test::nearest_vertex(surface, {10, 0, 0}));
  EXPECT_EQ(cut.cut_graph.pieces()[end].euler, 1);
}

TEST(Cut_graph, knows_slices_without_vertices)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 6, CSCD::test::Tube_end::flat));
  std::vector<Separator> separators;
  const double first = 5.05;
  const double step = 0.01;
  for (int i = 0; i < 20; ++i) {
    const double x = first + step * i;
    separators.push_back(tube_section(surface, x));
  }
  // The order of insertion does not follow the tube.
  std::swap(separators[3], separators[15]);
  std::swap(separators[0], separators[8]);
  const Cut_surface cut(surface, separators);
  expect_is_sound(cut);
  ASSERT_EQ(cut.cut_graph.pieces().size(), 21u);
  EXPECT_EQ(cut.betti_number(1), 0u);
  std::size_t slices = 0;
  for (const Cut_graph::Piece& piece : cut.cut_graph.pieces()) {
    if (piece.separators.size() == 2) {
      EXPECT_NEAR(piece.area, 6 * step, 1e-5) << "the hexagon has side 1";
      EXPECT_EQ(piece.euler, 0);
      ++slices;
    }
  }
  EXPECT_EQ(slices, 19u);
}

TEST(Cut_graph, measures_circles_around_vertices)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::noisy(CSCD::test::sphere(2), 0.2, 1));
  std::vector<Separator> separators;
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    for (double position : {0.3, 0.45}) {
      separators.push_back(circle_separator(surface, vertex, position));
    }
  }
  const Cut_surface cut(surface, separators);
  expect_is_sound(cut);
  EXPECT_EQ(cut.cut_graph.pieces().size(), 2 * surface.number_of_vertices() + 1);
  for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
    double star = 0;
    for (Index h : surface.outgoing(vertex)) {
      star += surface.face_area(Triangulated_surface::face(h));
    }
    const Index disc = cut.cut_graph.piece_of_vertex(vertex);
    const Cut_graph::Piece& piece = cut.cut_graph.pieces()[disc];
    EXPECT_EQ(piece.separators, std::vector<Index>{2 * vertex});
    EXPECT_EQ(piece.euler, 1);
    EXPECT_NEAR(piece.area, 0.09 * star, 1e-6);
    const Index ring = cut.cut_graph.sides(2 * vertex).other(disc);
    EXPECT_NEAR(cut.cut_graph.pieces()[ring].area, (0.45 * 0.45 - 0.09) * star, 1e-6);
    EXPECT_EQ(cut.cut_graph.pieces()[ring].euler, 0);
  }
}

TEST(Cut_graph, of_a_torus_is_a_cycle)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::torus(3, 1, 24));
  std::vector<Separator> separators;
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.1 + 2 * CSCD::test::pi * i / 5;
    const Vector_3 axis(-std::sin(angle), std::cos(angle), 0);
    separators.push_back(section_separator(surface, {0, 0, 0}, axis, {3 * std::cos(angle), 3 * std::sin(angle), 1}));
    const Cut_surface cut(surface, separators);
    expect_is_sound(cut);
    expect_is_as_flooded(cut);
    EXPECT_EQ(cut.cut_graph.pieces().size(), separators.size());
    EXPECT_EQ(cut.betti_number(1), 1u);
    for (const Cut_graph::Piece& piece : cut.cut_graph.pieces()) {
      EXPECT_EQ(piece.genus(), 0);
      EXPECT_EQ(piece.separators.size(), 2u);
    }
  }
}

TEST(Cut_graph, keeps_handles_that_nothing_cuts)
{
  const CSCD::test::Shape shape = CSCD::test::double_torus(0.15);
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  // Across the bars of the ladder, which lie along the axes.
  const Separator left = section_separator(surface, {0, 1.03, 0}, {0, 1, 0}, {0, 1.03, 0});
  const Separator middle = section_separator(surface, {2, 1.03, 0}, {0, 1, 0}, {2, 1.03, 0});
  const Separator right = section_separator(surface, {4, 1.03, 0}, {0, 1, 0}, {4, 1.03, 0});
  const Separator top = section_separator(surface, {1.03, 2, 0}, {1, 0, 0}, {1.03, 2, 0});
  const std::vector<std::pair<std::vector<Separator>, std::pair<int, std::size_t>>> cases{
      {{}, {2, 0}},
      {{left}, {1, 1}},
      {{left, middle}, {0, 2}},
      {{left, right}, {0, 2}},
      {{left, top}, {1, 1}},
      {{left, middle, right}, {0, 2}},
      {{left, top, middle, right}, {0, 2}}};
  for (const auto& [separators, expected] : cases) {
    SCOPED_TRACE(separators.size());
    const Cut_surface cut(surface, separators);
    expect_is_sound(cut);
    expect_is_as_flooded(cut);
    int genus = 0;
    for (const Cut_graph::Piece& piece : cut.cut_graph.pieces()) {
      genus += piece.genus();
    }
    EXPECT_EQ(genus, expected.first);
    EXPECT_EQ(cut.betti_number(1), expected.second) << "together they are the genus of the surface";
  }
}

TEST(Cut_graph, keeps_components_apart)
{
  const CSCD::test::Shape shape = CSCD::test::merged(
      "", {CSCD::test::capsule(6, 1, 16), CSCD::test::translated(CSCD::test::torus(3, 1, 16), {0, 10, 0})});
  const Triangulated_surface surface = CSCD::test::to_surface(shape);
  const Cut_surface cut(
      surface, {tube_section(surface, 3.01), section_separator(surface, {0.01, 10, 0}, {1, 0, 0}, {0, 13, 1})});
  expect_is_sound(cut);
  expect_is_as_flooded(cut);
  EXPECT_EQ(cut.cut_graph.pieces().size(), 3u);
  EXPECT_EQ(cut.betti_number(2), 1u);
}

TEST(Cut_graph, cuts_along_a_part_of_the_separators_that_it_was_prepared_for)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::capsule(6, 1, 24));
  std::vector<Separator> separators;
  for (double x : {1.01, 2.02, 2.03, 4.04}) {
    separators.push_back(tube_section(surface, x));
  }
  Separator_arrangement arrangement(surface);
  Cut_graph used(surface, separators);
  for (Index i : {Index(0), Index(1), Index(2), Index(3)}) {
    ASSERT_TRUE(arrangement.insert(i, separators[i].crossings));
  }
  used.cut(arrangement);
  EXPECT_EQ(used.pieces().size(), 5u);
  arrangement.clear();
  for (Index i : {Index(3), Index(1)}) {
    ASSERT_TRUE(arrangement.insert(i, separators[i].crossings));
  }
  used.cut(arrangement);
  const Cut_surface fresh(surface, {separators[3], separators[1]});
  ASSERT_EQ(used.pieces().size(), fresh.cut_graph.pieces().size());
  for (Index piece = 0; piece < used.pieces().size(); ++piece) {
    EXPECT_NEAR(used.pieces()[piece].area, fresh.cut_graph.pieces()[piece].area, 1e-6);
    EXPECT_EQ(used.pieces()[piece].euler, fresh.cut_graph.pieces()[piece].euler);
    EXPECT_EQ(used.pieces()[piece].separators, fresh.cut_graph.pieces()[piece].separators);
  }
}

} // namespace
