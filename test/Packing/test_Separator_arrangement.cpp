// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Separators that are disjoint are accepted, those that cross refused, and refused ones leave no trace.

#include "Separator/make_separator.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

using CSCD::Edge_crossing;
using CSCD::Index;
using CSCD::no_index;
using CSCD::Separator;
using CSCD::Triangulated_surface;
using CSCD::Vector_3;
using CSCD::internal::Separator_arrangement;
using CSCD::test::circle_separator;

class Separator_arrangement_test : public testing::Test
{
protected:
  Separator section(double x, const Vector_3& axis = {1, 0, 0}) const
  {
    return CSCD::test::tube_section(m_surface, x, axis);
  }

  Triangulated_surface m_surface = CSCD::test::to_surface(CSCD::test::tube(10, 1, 12, CSCD::test::Tube_end::flat));
  Separator_arrangement m_arrangement{m_surface};
};

TEST_F(Separator_arrangement_test, takes_parallels_however_close)
{
  // All between the same two rings: every face holds many chords.
  Index number = 0;
  for (double x = 5.01; x < 5.4; x += 0.001) {
    ASSERT_TRUE(m_arrangement.insert(number++, section(x).crossings)) << x;
  }
  EXPECT_EQ(m_arrangement.points().size(), m_arrangement.chords().size());
  for (Index face = 0; face < m_surface.number_of_faces(); ++face) {
    for (Index chord = m_arrangement.first_chord(face); chord != no_index; chord = m_arrangement.chords()[chord].next) {
      EXPECT_EQ(m_arrangement.chords()[chord].face, face);
    }
  }
}

TEST_F(Separator_arrangement_test, refuses_what_crosses)
{
  ASSERT_TRUE(m_arrangement.insert(0, section(5).crossings));
  EXPECT_FALSE(m_arrangement.insert(1, section(5.01, {1, 0.5, 0}).crossings));
  EXPECT_TRUE(m_arrangement.insert(2, section(6.5, {1, 0.5, 0}).crossings));
  EXPECT_FALSE(m_arrangement.insert(3, section(6.5, {1, -0.5, 0}).crossings));
  EXPECT_FALSE(m_arrangement.insert(4, section(5, {0, 1, 0.01}).crossings)) << "along the tube";
}

TEST_F(Separator_arrangement_test, refuses_what_crosses_itself)
{
  // Twice around, by two tilted sections joined where they cross: here, the same section twice, in a spiral.
  std::vector<Edge_crossing> twice = section(5.03).crossings;
  const std::vector<Edge_crossing> once = twice;
  for (std::size_t i = 0; i < once.size(); ++i) {
    twice.push_back({once[i].halfedge, once[i].position + 0.01});
  }
  EXPECT_FALSE(m_arrangement.insert(0, twice)) << "a spiral that comes back to its beginning crosses itself";
  EXPECT_TRUE(m_arrangement.insert(1, once));
}

TEST_F(Separator_arrangement_test, refused_ones_leave_no_trace)
{
  ASSERT_TRUE(m_arrangement.insert(0, section(5).crossings));
  ASSERT_TRUE(m_arrangement.insert(1, section(7).crossings));
  std::vector<Index> first_chords;
  for (Index face = 0; face < m_surface.number_of_faces(); ++face) {
    first_chords.push_back(m_arrangement.first_chord(face));
  }
  const std::size_t size = m_arrangement.points().size();
  ASSERT_FALSE(m_arrangement.insert(2, section(6, {1, 2, 0}).crossings));
  EXPECT_EQ(m_arrangement.points().size(), size);
  EXPECT_EQ(m_arrangement.chords().size(), size);
  for (Index face = 0; face < m_surface.number_of_faces(); ++face) {
    EXPECT_EQ(m_arrangement.first_chord(face), first_chords[face]);
  }
  EXPECT_TRUE(m_arrangement.insert(2, section(6).crossings)) << "what was refused is not in the way";
}

TEST_F(Separator_arrangement_test, is_empty_after_it_was_cleared)
{
  ASSERT_TRUE(m_arrangement.insert(0, section(5).crossings));
  m_arrangement.clear();
  EXPECT_TRUE(m_arrangement.points().empty());
  EXPECT_TRUE(m_arrangement.chords().empty());
  EXPECT_TRUE(m_arrangement.insert(1, section(5.01, {1, 0.5, 0}).crossings));
}

TEST_F(Separator_arrangement_test, takes_circles_around_all_vertices_unless_they_reach_into_each_other)
{
  for (const double position : {0.2, 0.49}) {
    m_arrangement.clear();
    for (Index vertex = 0; vertex < m_surface.number_of_vertices(); ++vertex) {
      ASSERT_TRUE(m_arrangement.insert(vertex, circle_separator(m_surface, vertex, position).crossings));
    }
  }
  m_arrangement.clear();
  EXPECT_TRUE(m_arrangement.insert(0, circle_separator(m_surface, 100, 0.6).crossings));
  EXPECT_FALSE(m_arrangement.insert(1, circle_separator(m_surface, 101, 0.6).crossings));
  EXPECT_TRUE(m_arrangement.insert(2, circle_separator(m_surface, 100, 0.3).crossings)) << "one in the other";
}

TEST_F(Separator_arrangement_test, orders_equal_positions_alike_from_both_faces)
{
  // Circles around neighbors meet exactly in the middles of the edges.
  ASSERT_TRUE(m_arrangement.insert(0, circle_separator(m_surface, 100, 0.5).crossings));
  m_arrangement.insert(1, circle_separator(m_surface, 101, 0.5).crossings);
  m_arrangement.insert(2, circle_separator(m_surface, 100, 0.5).crossings);
  for (Index a = 0; a < m_arrangement.points().size(); ++a) {
    for (Index b = 0; b < m_arrangement.points().size(); ++b) {
      const Index edge = m_arrangement.points()[a].edge;
      if (a == b || m_arrangement.points()[b].edge != edge) {
        continue;
      }
      const Index face = Triangulated_surface::face(edge);
      const Index other_face = Triangulated_surface::face(m_surface.twin(edge));
      EXPECT_NE(m_arrangement.is_before(a, b, face), m_arrangement.is_before(b, a, face));
      EXPECT_NE(m_arrangement.is_before(a, b, face), m_arrangement.is_before(a, b, other_face));
    }
  }
}

TEST_F(Separator_arrangement_test, does_not_depend_on_the_order_of_insertion_even_with_ties)
{
  // Positions on a coarse grid: nearly all crossings of an edge coincide.
  std::mt19937 random(1);
  std::vector<Separator> separators;
  for (int i = 0; i < 40; ++i) {
    const double x = 4.6 + 0.1 * double(random() % 8);
    const Vector_3 axis(1, 0.05 * double(random() % 3), 0.05 * double(random() % 3));
    separators.push_back(section(x, axis));
    for (Edge_crossing& crossing : separators.back().crossings) {
      crossing.position = crossing.position < 0.4 ? 0.25 : crossing.position < 0.6 ? 0.5 : 0.75;
    }
  }
  std::size_t accepted = 0;
  std::size_t refused = 0;
  for (Index a = 0; a < separators.size(); ++a) {
    for (Index b = 0; b < a; ++b) {
      m_arrangement.clear();
      const bool is_first_in = m_arrangement.insert(a, separators[a].crossings);
      const bool are_both_in = is_first_in && m_arrangement.insert(b, separators[b].crossings);
      m_arrangement.clear();
      const bool is_other_in = m_arrangement.insert(b, separators[b].crossings);
      EXPECT_EQ(are_both_in, is_other_in && m_arrangement.insert(a, separators[a].crossings)) << a << " " << b;
      ++(are_both_in ? accepted : refused);
    }
  }
  EXPECT_GT(accepted, 20u);
  EXPECT_GT(refused, 20u);
}

} // namespace
