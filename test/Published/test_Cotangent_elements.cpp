// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Masses, components and matrices of linear finite elements.

#include "Published/Length_triangulation.h"
#include "Surface/to_bridged_surface.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::Cotangent_elements;
using CSCD::test::Length_triangulation;

double total_mass(const Cotangent_elements& elements)
{
  double sum = 0;
  for (Index v = 0; v < elements.number_of_vertices(); ++v) {
    sum += elements.mass(v) * elements.unit(elements.component(v)) * elements.unit(elements.component(v));
  }
  return sum;
}

TEST(Cotangent_elements, integrates_linear_functions_exactly)
{
  // On a flat disc, the Dirichlet energy of a linear function is its squared slope times the area; on all of its
  // vertices inside, its Laplacian is 0.
  const Triangulated_surface surface = CSCD::test::to_bridged_surface(CSCD::test::flat_disc(6, 24));
  const Cotangent_elements elements(CSCD::test::lengths_of(surface));
  const Eigen::SparseMatrix<double> lower = elements.matrix(0, false);
  Eigen::VectorXd values(elements.number_of_vertices());
  for (Index v = 0; v < elements.number_of_vertices(); ++v) {
    values[v] = 3 * surface.point(v).x() - 4 * surface.point(v).y();
  }
  const Eigen::VectorXd laplacian = lower.selfadjointView<Eigen::Lower>() * values;
  EXPECT_NEAR(values.dot(laplacian), 25 * total_mass(elements), 1e-10);
  for (Index v = 0; v < elements.number_of_vertices(); ++v) {
    if (surface.point(v).norm() < 0.99) {
      EXPECT_NEAR(laplacian[v], 0, 1e-12);
    }
  }
}

TEST(Cotangent_elements, leaves_out_faces_that_bridge_borders)
{
  const Triangulated_surface surface = CSCD::test::to_bridged_surface(CSCD::test::flat_disc(6, 24));
  ASSERT_LT(surface.first_hole_filling_face(), surface.number_of_faces());
  const Cotangent_elements bridged(surface);
  const Cotangent_elements open(CSCD::test::lengths_of(surface));
  EXPECT_EQ(bridged.faces().size(), surface.first_hole_filling_face());
  for (Index v = 0; v < bridged.number_of_vertices(); ++v) {
    EXPECT_EQ(bridged.mass(v), open.mass(v));
  }
}

TEST(Cotangent_elements, measures_each_component_in_its_own_unit)
{
  const CSCD::test::Shape ball = CSCD::test::sphere(2);
  const Triangulated_surface surface = CSCD::test::to_surface(
      CSCD::test::merged("two", {ball, CSCD::test::translated(CSCD::test::scaled(ball, 1024), {4000, 0, 0})}));
  const Cotangent_elements elements(surface);
  ASSERT_EQ(elements.number_of_components(), 2u);
  EXPECT_EQ(elements.component(0), 0u);
  EXPECT_EQ(elements.component(elements.number_of_vertices() - 1), 1u);
  EXPECT_NEAR(elements.unit(0), CSCD::test::mean_edge_length(ball), 1e-12);
  EXPECT_NEAR(elements.unit(1), 1024 * elements.unit(0), 1e-9);
  for (Index v = 0; v < ball.points.size(); ++v) {
    EXPECT_NEAR(elements.mass(v), elements.mass(Index(v + ball.points.size())), 1e-10);
  }
}

TEST(Cotangent_elements, knows_several_edges_between_vertices_and_edges_from_a_vertex_to_itself)
{
  // A flat torus of side 1 with a single vertex: all three edges of both faces lead from it to itself.
  const Length_triangulation torus{1, {{0, 0, 0}, {0, 0, 0}}, {{1, 1, std::sqrt(2.)}, {1, 1, std::sqrt(2.)}}};
  const Cotangent_elements elements(torus);
  EXPECT_NEAR(total_mass(elements), 1, 1e-12);
  EXPECT_EQ(elements.matrix(0, false).coeff(0, 0), 1) << "there is no stiffness";
  // A pillow: two equilateral faces with the same three vertices.
  const Length_triangulation pillow{3, {{0, 1, 2}, {0, 2, 1}}, {{1, 1, 1}, {1, 1, 1}}};
  const Eigen::SparseMatrix<double> lower = Cotangent_elements(pillow).matrix(0, false);
  EXPECT_NEAR(lower.coeff(1, 0), -1 / std::sqrt(3.), 1e-12);
  EXPECT_NEAR(lower.coeff(1, 1), 2 / std::sqrt(3.), 1e-12);
}

TEST(Cotangent_elements, pins_one_vertex_of_each_component)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::hollow_sphere(1));
  const Cotangent_elements elements(surface);
  const Eigen::SparseMatrix<double> difference = elements.matrix(0, true) - elements.matrix(0, false);
  EXPECT_EQ(elements.number_of_components(), 2u);
  EXPECT_EQ((Eigen::MatrixXd(difference).array() > 0).count(), 2);
}

} // namespace
