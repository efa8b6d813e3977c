// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tufted covers: how copies are glued, and the elements on them beside those of meshes.

#include "Points/to_point_cloud.h"
#include "Points/to_point_complex.h"
#include "Surface/to_surface.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Point_complex;
using CSCD::Vector_3;
using CSCD::internal::Cotangent_elements;
using CSCD::internal::Tufted_cover;

void expect_manifold(const Tufted_cover& cover)
{
  ASSERT_EQ(2 * cover.complex().number_of_faces(), cover.number_of_faces());
  for (Index h = 0; h < cover.number_of_halfedges(); ++h) {
    const Index t = cover.twin(h);
    ASSERT_LT(t, cover.number_of_halfedges());
    EXPECT_NE(h, t);
    EXPECT_EQ(h, cover.twin(t));
    EXPECT_EQ(cover.origin(h), cover.target(t));
    EXPECT_EQ(cover.target(h), cover.origin(t));
    EXPECT_EQ(cover.length(h), cover.length(t));
    EXPECT_EQ(cover.target(h), cover.origin(Tufted_cover::next(h)));
    const Index other = Tufted_cover::other_copy(h);
    EXPECT_EQ(h, Tufted_cover::other_copy(other));
    EXPECT_EQ(Tufted_cover::face(h) ^ 1u, Tufted_cover::face(other));
    EXPECT_EQ(cover.origin(h), cover.target(other));
  }
}

Eigen::MatrixXd stiffness(const Cotangent_elements& elements)
{
  const Eigen::MatrixXd lower = elements.matrix(0, false);
  return Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>());
}

TEST(Tufted_cover, of_a_closed_surface_is_its_two_sides)
{
  const Point_complex complex = CSCD::test::to_point_complex(CSCD::test::torus(3, 1, 12));
  const Tufted_cover cover(complex);
  expect_manifold(cover);
  for (Index h = 0; h < cover.number_of_halfedges(); ++h) {
    EXPECT_EQ(Tufted_cover::face(h) % 2, Tufted_cover::face(cover.twin(h)) % 2);
    EXPECT_NE(Tufted_cover::face(h), Tufted_cover::face(cover.twin(h)));
  }
}

TEST(Tufted_cover, joins_front_and_back_at_borders)
{
  const Point_complex complex({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<Vector_3>(3, Vector_3::UnitZ()),
                              {{0, 1, 2}});
  const Tufted_cover cover(complex);
  expect_manifold(cover);
  for (Index h = 0; h < cover.number_of_halfedges(); ++h) {
    EXPECT_EQ(Tufted_cover::other_copy(h), cover.twin(h));
  }
}

TEST(Tufted_cover, glues_what_looks_at_each_other)
{
  // A book of four pages around the z-axis, not in order.
  std::vector<Vector_3> points{{0, 0, 0}, {0, 0, 1}};
  std::vector<double> angles{0.3, 3.9, 1.7, 5.5};
  for (const double angle : angles) {
    points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
  }
  const std::size_t number = points.size();
  const Point_complex complex(std::move(points), std::vector<Vector_3>(number, Vector_3(0.6, 0, 0.8)),
                              {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}});
  const Tufted_cover cover(complex);
  expect_manifold(cover);
  const std::vector<Index> next_page{2, 3, 1, 0};
  for (Index h = 0; h < cover.number_of_halfedges(); ++h) {
    if (cover.origin(h) == 0 && cover.target(h) == 1) {
      // Looks to where the angle grows.
      EXPECT_EQ(next_page[Tufted_cover::face(h) / 2], Tufted_cover::face(cover.twin(h)) / 2);
    }
  }
}

TEST(Tufted_cover, has_twice_the_elements_of_a_closed_mesh)
{
  const CSCD::test::Shape shape = CSCD::test::noisy(CSCD::test::torus(3, 1, 12), 0.2, 1);
  const Point_complex complex = CSCD::test::to_point_complex(shape);
  const Tufted_cover cover(complex);
  const Cotangent_elements of_cover(CSCD::internal::make_intrinsic_delaunay(cover));
  const auto surface = CSCD::test::to_surface(shape);
  const Cotangent_elements of_mesh(CSCD::internal::make_intrinsic_delaunay(surface));
  const Eigen::MatrixXd expected = 2 * stiffness(of_mesh);
  EXPECT_LT((stiffness(of_cover) - expected).cwiseAbs().maxCoeff(), 1e-6);
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    EXPECT_NEAR(2 * of_mesh.mass(v), of_cover.mass(v), 1e-6);
  }
}

TEST(Tufted_cover, has_a_laplacian_with_a_maximum_principle)
{
  // With holes and noise.
  const CSCD::test::Shape shape = CSCD::test::torus(3, 1, 24);
  constexpr std::size_t number = 600;
  const std::vector<CSCD::test::Triple> points = CSCD::test::without_ball(
      CSCD::test::shaken(CSCD::test::sampled(shape, number, 1), 0.5 * CSCD::test::mean_spacing(shape, number), 1),
      {4, 0, 0}, 1);
  const Point_complex complex = CSCD::internal::build_point_complex(CSCD::test::to_point_cloud(points));
  const Tufted_cover cover(complex);
  expect_manifold(cover);
  auto triangulation = CSCD::internal::make_intrinsic_delaunay(cover);
  for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    EXPECT_TRUE(triangulation.is_delaunay(h) || !triangulation.is_flippable(h));
  }
  const Eigen::MatrixXd matrix = stiffness(Cotangent_elements(triangulation));
  double max_coupling = 0;
  for (Index v = 0; v < complex.number_of_vertices(); ++v) {
    if (!complex.outgoing(v).empty()) {
      EXPECT_NEAR(0, matrix.row(v).sum(), 1e-9);
    }
    for (Index w = 0; w < v; ++w) {
      max_coupling = std::max(max_coupling, matrix(v, w));
    }
  }
  EXPECT_LT(max_coupling, 1e-6) << "no weight is negative";
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff(), -1e-9);
}

} // namespace
