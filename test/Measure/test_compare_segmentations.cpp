// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the comparison of two segmentations, on constructed cases with known answers.

#include "support/convert_shape.h"
#include "support/shape_operations.h"
#include "support/simple_shapes.h"
#include "support/swept_shapes.h"
#include <CSCD/Measure/compare_segmentations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>

namespace {

using Segmented_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using CSCD::Segmentation_comparison;

/// Compares segmentations that give each face of a mesh a label by its number.
class Compare_segmentations : public testing::Test
{
protected:
  using Labels = std::function<int(std::size_t)>;

  Segmentation_comparison compare(const Labels& first, const Labels& second)
  {
    return CSCD::compare_segmentations(m_mesh, label_map(first), label_map(second));
  }

  Segmented_mesh::Property_map<Segmented_mesh::Face_index, int> label_map(const Labels& labels)
  {
    const auto map = m_mesh.add_property_map<Segmented_mesh::Face_index, int>().first;
    for (const auto face : m_mesh.faces()) {
      map[face] = labels(std::size_t(face));
    }
    return map;
  }

  Segmented_mesh m_mesh = CSCD::test::to_mesh<Segmented_mesh>(CSCD::test::sphere(2));
  std::size_t m_size = m_mesh.number_of_faces();
};

TEST_F(Compare_segmentations, equal_ones_do_not_differ_whatever_their_labels)
{
  const Segmentation_comparison same =
      compare([](std::size_t f) { return f % 3; }, [](std::size_t f) { return 7 - 5 * int(f % 3); });
  EXPECT_EQ(same.rand_error, 0);
  EXPECT_EQ(same.adjusted_rand_index, 1);
  EXPECT_EQ(same.missing_rate, 0);
  EXPECT_EQ(same.false_alarm_rate, 0);
  EXPECT_EQ(same.hamming_distance, 0);
  EXPECT_EQ(same.global_consistency_error, 0);
  EXPECT_EQ(same.local_consistency_error, 0);
  EXPECT_EQ(same.cut_discrepancy, 0);
}

TEST_F(Compare_segmentations, one_part_against_two_halves)
{
  const std::size_t half = m_size / 2;
  const Segmentation_comparison halves =
      compare([](std::size_t) { return 1; }, [half](std::size_t f) { return f < half ? 0 : 1; });
  const double pairs = double(m_size) * double(m_size - 1) / 2;
  EXPECT_NEAR(halves.rand_error, double(half) * double(half) / pairs, 1e-12); // the pairs that the halves part
  EXPECT_NEAR(halves.adjusted_rand_index, 0, 1e-12);
  EXPECT_NEAR(halves.missing_rate, 0, 1e-12); // each half lies within the one part
  EXPECT_NEAR(halves.false_alarm_rate, 0.5, 1e-12);
  EXPECT_NEAR(halves.hamming_distance, 0.25, 1e-12);
  EXPECT_NEAR(halves.global_consistency_error, 0, 1e-12); // a refinement
  EXPECT_NEAR(halves.local_consistency_error, 0, 1e-12);
  EXPECT_TRUE(std::isnan(halves.cut_discrepancy)); // no boundary to be near to
}

TEST_F(Compare_segmentations, halves_that_cross)
{
  const std::size_t quarter = m_size / 4;
  const Segmentation_comparison crossing = compare([=](std::size_t f) { return f < 2 * quarter ? 0 : 1; },
                                                   [=](std::size_t f) { return f / quarter % 2 == 0 ? 0 : 1; });
  const double n = double(m_size);
  EXPECT_NEAR(crossing.rand_error, (n * n / 4) / (n * (n - 1) / 2), 1e-12);
  EXPECT_NEAR(crossing.hamming_distance, 0.5, 1e-12);
  EXPECT_NEAR(crossing.global_consistency_error, 0.5, 1e-12);
  EXPECT_NEAR(crossing.local_consistency_error, 0.5, 1e-12);
}

TEST_F(Compare_segmentations, refinement_in_different_places_is_consistent_locally_only)
{
  const std::size_t quarter = m_size / 4; // 0 0 1 2 against 0 1 2 2
  const Segmentation_comparison mixed = compare([=](std::size_t f) { return f < 2 * quarter ? 0 : int(f / quarter); },
                                                [=](std::size_t f) { return f < 2 * quarter ? int(f / quarter) : 2; });
  EXPECT_NEAR(mixed.local_consistency_error, 0, 1e-12);
  EXPECT_NEAR(mixed.global_consistency_error, 0.25, 1e-12);
}

/// The distance between two cuts of a tube is known.
TEST(Cut_discrepancy, is_how_far_boundaries_are_apart)
{
  Segmented_mesh mesh = CSCD::test::to_mesh<Segmented_mesh>(CSCD::test::tube(20, 1, 24, CSCD::test::Tube_end::flat));
  const auto cut_at = [&mesh](double x) {
    const auto map = mesh.add_property_map<Segmented_mesh::Face_index, int>().first;
    for (const auto face : mesh.faces()) {
      double center = 0;
      for (const auto vertex : vertices_around_face(mesh.halfedge(face), mesh)) {
        center += mesh.point(vertex).x() / 3;
      }
      map[face] = center < x ? 0 : 1;
    }
    return map;
  };
  const double discrepancy = CSCD::compare_segmentations(mesh, cut_at(8), cut_at(12)).cut_discrepancy;
  const double mean_radius = 5; // of a thin rod of length 20; somewhat more, since it is not that thin
  EXPECT_NEAR(discrepancy * mean_radius, 2 * 4, 0.8);
  EXPECT_GT(CSCD::compare_segmentations(mesh, cut_at(5), cut_at(15)).cut_discrepancy, 2 * discrepancy);
}

} // namespace
