// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named parameters chain in any order, are read as CGAL's are, and are understood by CGAL's own functions.

#include <CSCD/Named_parameters.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace {

using CSCD::parameters::get_parameter, CSCD::parameters::get_parameter_reference;
namespace own = CSCD::internal_np;
namespace cgal = CGAL::internal_np;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

template <class NamedParameters>
void expect_seed_threads_sources(const NamedParameters& np)
{
  EXPECT_EQ(get_parameter(np, cgal::random_seed), 7u);
  EXPECT_EQ(get_parameter(np, own::number_of_threads), 2);
  EXPECT_EQ(get_parameter(np, own::maximum_number_of_sources), 100L);
  const bool has_visitor = !CSCD::parameters::is_default_parameter<NamedParameters, cgal::visitor_t>::value;
  const bool has_threads = !CSCD::parameters::is_default_parameter<NamedParameters, own::number_of_threads_t>::value;
  EXPECT_FALSE(has_visitor);
  EXPECT_TRUE(has_threads);
}

TEST(Named_parameters, Chain_in_any_order)
{
  namespace p = CSCD::parameters;
  expect_seed_threads_sources(p::random_seed(7u).number_of_threads(2).maximum_number_of_sources(100L));
  expect_seed_threads_sources(p::random_seed(7u).maximum_number_of_sources(100L).number_of_threads(2));
  expect_seed_threads_sources(p::number_of_threads(2).random_seed(7u).maximum_number_of_sources(100L));
  expect_seed_threads_sources(p::number_of_threads(2).maximum_number_of_sources(100L).random_seed(7u));
  expect_seed_threads_sources(p::maximum_number_of_sources(100L).random_seed(7u).number_of_threads(2));
  expect_seed_threads_sources(p::maximum_number_of_sources(100L).number_of_threads(2).random_seed(7u));
}

// As CGAL's functions take them: the three parameters of the chain are deduced, from the front of the chain.
template <class T, class Tag, class Base>
int number_of_threads_by_deduction(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return get_parameter(np, own::number_of_threads);
}

struct Counter
{
  int number_of_calls = 0;
};

struct Not_copyable : Counter
{
  Not_copyable() = default;
  Not_copyable(const Not_copyable&) = delete;
  Not_copyable& operator=(const Not_copyable&) = delete;
};

TEST(Named_parameters, What_cannot_be_copied_is_referred_to)
{
  const Not_copyable visitor;
  const auto np = CSCD::parameters::visitor(visitor).number_of_threads(2);
  const Not_copyable& seen = get_parameter(np, cgal::visitor);
  EXPECT_EQ(&seen, &visitor);
  const Not_copyable& seen_in_combined = get_parameter(CSCD::parameters::combine(np), cgal::visitor);
  EXPECT_EQ(&seen_in_combined, &visitor);
}

TEST(Named_parameters, Combine_joins_chains_of_cgal_with_own)
{
  namespace p = CSCD::parameters;
  expect_seed_threads_sources(
      p::combine(CGAL::parameters::random_seed(7u), p::number_of_threads(2).maximum_number_of_sources(100L)));
  expect_seed_threads_sources(
      p::combine(p::number_of_threads(2), CGAL::parameters::random_seed(7u), p::maximum_number_of_sources(100L)));
  expect_seed_threads_sources(p::combine(CGAL::parameters::random_seed(7u).verbose(true), p::number_of_threads(2))
                                  .maximum_number_of_sources(100L));
  expect_seed_threads_sources(
      p::combine(CGAL::parameters::default_values(),
                 p::combine(p::default_values(), CGAL::parameters::verbose(true).random_seed(7u)).number_of_threads(2),
                 p::maximum_number_of_sources(100L)));
}

Mesh unit_triangle()
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)), mesh.add_vertex(Point(0, 1, 0)));
  return mesh;
}

TEST(Named_parameters, Functions_of_cgal_take_own_chains)
{
  Mesh mesh = unit_triangle();
  const auto doubled = mesh.add_property_map<Mesh::Vertex_index, Point>("v:doubled").first;
  for (const auto v : vertices(mesh)) {
    doubled[v] = Point(2 * mesh.point(v).x(), 2 * mesh.point(v).y(), 2 * mesh.point(v).z());
  }
  namespace PMP = CGAL::Polygon_mesh_processing;
  EXPECT_DOUBLE_EQ(PMP::area(mesh), 0.5);
  EXPECT_DOUBLE_EQ(PMP::area(mesh, CSCD::parameters::vertex_point_map(doubled)), 2);
  EXPECT_DOUBLE_EQ(PMP::area(mesh, CSCD::parameters::vertex_point_map(doubled).number_of_threads(2)), 2);
  EXPECT_DOUBLE_EQ(PMP::area(mesh, CSCD::parameters::number_of_threads(2).vertex_point_map(doubled).verbose(true)), 2);
  EXPECT_DOUBLE_EQ(PMP::area(mesh, CSCD::parameters::combine(CGAL::parameters::vertex_point_map(doubled),
                                                             CSCD::parameters::number_of_threads(2))),
                   2);
}

TEST(Named_parameters, Overloaded_functions_of_cgal_take_own_chains)
{
  Mesh mesh = unit_triangle();
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto np = CSCD::parameters::number_of_threads(2).verbose(false);
  EXPECT_DOUBLE_EQ(PMP::face_area(*faces(mesh).begin(), mesh, np), 0.5);
  EXPECT_DOUBLE_EQ(PMP::area(faces(mesh), mesh, np), 0.5);
  EXPECT_EQ(PMP::stitch_borders(mesh, np), 0u);
  EXPECT_TRUE(PMP::triangulate_faces(mesh, np));
  PMP::reverse_face_orientations(mesh);
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(mesh, normals, np);
  EXPECT_DOUBLE_EQ(normals[*vertices(mesh).begin()].z(), -1);
}

template <class NamedParameters>
void use_seed_and_threads(const NamedParameters& /* np */)
{
  CSCD::internal::check_named_parameters<NamedParameters, cgal::random_seed_t, own::number_of_threads_t>();
}

TEST(Named_parameters, Used_ones_are_accepted_from_any_chain)
{
  use_seed_and_threads(CSCD::parameters::default_values());
  use_seed_and_threads(CGAL::parameters::default_values());
  use_seed_and_threads(CGAL::parameters::random_seed(7u));
  use_seed_and_threads(CSCD::parameters::number_of_threads(2));
  use_seed_and_threads(CSCD::parameters::number_of_threads(2).random_seed(7u));
  use_seed_and_threads(
      CSCD::parameters::combine(CGAL::parameters::random_seed(7u), CSCD::parameters::number_of_threads(2)));
}

} // namespace
