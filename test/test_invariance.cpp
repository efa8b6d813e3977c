// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeleton does not depend on the pose and the unit of the input, the order and the type of its storage, and the
// type of the output.

#include "support/Similarity.h"
#include "support/Skeleton_comparison.h"
#include "support/invariants.h"
#include "support/shapes.h"
#include "support/skip_or_fail.h"
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;
using CSCD::test::Plain_skeleton, CSCD::test::Shape, CSCD::test::Shape_maker, CSCD::test::Similarity,
    CSCD::test::Violations;

/// Distances that may be due to rounding, relative to the diagonal of the bounding box.
constexpr double relative_tolerance = 1e-6;

template <class AnyMesh>
using Skeleton_of = CSCD::Skeleton_graph<
    typename boost::property_traits<typename boost::property_map<AnyMesh, CGAL::vertex_point_t>::type>::value_type,
    typename boost::graph_traits<AnyMesh>::vertex_descriptor>;

template <class AnyMesh = Mesh>
Plain_skeleton skeletonize(const Shape& shape)
{
  const AnyMesh mesh = CSCD::test::to_mesh<AnyMesh>(shape);
  Skeleton_of<AnyMesh> skeleton;
  CSCD::extract_curve_skeleton(mesh, skeleton);
  return CSCD::test::plain(mesh, skeleton);
}

class Invariance : public testing::TestWithParam<Shape_maker>
{
protected:
  void expect_equivariant(const Similarity& motion) const
  {
    const Shape other = CSCD::test::moved(m_shape, motion, motion.scale);
    const double tolerance = relative_tolerance * diagonal(other);
    EXPECT_EQ(difference(moved(skeletonize(m_shape), motion), skeletonize(other), tolerance), "");
  }

  Shape m_shape = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(Asymmetric, Invariance, testing::ValuesIn(CSCD::test::asymmetric_shapes()),
                         testing::PrintToStringParamName());

TEST_P(Invariance, under_rotations)
{
  for (const double angle : {1e-3, CSCD::test::pi / 2, 2.0}) {
    SCOPED_TRACE(angle);
    expect_equivariant(Similarity{1, CSCD::test::unit({1, 2, 3}), angle, {0, 0, 0}});
    expect_equivariant(Similarity{1, {0, 1, 0}, angle, {1, 2, 3}});
  }
}

TEST_P(Invariance, under_scalings_by_powers_of_two_to_the_last_bit)
{
  const Similarity doubling{2, {0, 0, 1}, 0, {0, 0, 0}};
  EXPECT_EQ(moved(skeletonize(m_shape), doubling), skeletonize(CSCD::test::scaled(m_shape, 2)));
}

TEST_P(Invariance, under_the_type_of_the_mesh)
{
  const Plain_skeleton expected = skeletonize(m_shape);
  EXPECT_EQ(expected, skeletonize<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(m_shape));
  EXPECT_EQ(expected, skeletonize<Polyhedron>(m_shape));
  const double tolerance = relative_tolerance * diagonal(m_shape);
  // A cell complex iterates its faces, hence the sums over them, in another order.
  EXPECT_EQ(difference(expected, skeletonize<Linear_cell_complex>(m_shape), tolerance), "");
}

/// Symmetry does not excuse differences if the pose stays.
class Renumbering : public testing::TestWithParam<Shape_maker>
{
};

TEST_P(Renumbering, changes_names_only)
{
  const Shape shape = GetParam().make();
  const double tolerance = relative_tolerance * diagonal(shape);
  const CSCD::test::Renumbered_shape other = CSCD::test::renumbered(shape, 1);
  const Plain_skeleton expected = renamed(skeletonize(shape), other.new_number);
  EXPECT_EQ(difference(expected, skeletonize(other.shape), tolerance), "");
}

INSTANTIATE_TEST_SUITE_P(Asymmetric, Renumbering, testing::ValuesIn(CSCD::test::asymmetric_shapes()),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Known, Renumbering, testing::ValuesIn(CSCD::test::shapes_with_known_skeleton()),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Hard, Renumbering, testing::ValuesIn(CSCD::test::hard_closed_shapes()),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(Open, Renumbering, testing::ValuesIn(CSCD::test::open_shapes()),
                         testing::PrintToStringParamName());

/// Real meshes have equal edges, planes through vertices, and loops of equal length: rounding must not choose between
/// them. Their triangulations are not symmetric: a symmetric one has several equal starts.
class Real_mesh_invariance : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    const std::string path = std::string(CSCD_CGAL_DATA_DIR) + "/" + GetParam() + ".off";
    std::ifstream file(path);
    if (!file) {
      CSCD_TEST_SKIP_OR_FAIL(path << " is missing: it comes with the Debian package libcgal-demo");
    }
    Mesh mesh;
    ASSERT_TRUE(CGAL::IO::read_OFF(file, mesh));
    m_shape = CSCD::test::to_shape(mesh);
  }

  Shape m_shape;
};

TEST_P(Real_mesh_invariance, under_moves_turns_scalings_and_renumbering)
{
  const double size = diagonal(m_shape);
  const Plain_skeleton skeleton = skeletonize(m_shape);
  const CSCD::test::Renumbered_shape other = CSCD::test::renumbered(m_shape, 1);
  EXPECT_EQ(difference(renamed(skeleton, other.new_number), skeletonize(other.shape), relative_tolerance * size), "");
  const Similarity move{1, {0, 0, 1}, 0, {0.7 * size, -0.2 * size, 0.4 * size}};
  const Similarity turn{3.7, CSCD::test::unit({1, 2, 3}), 2, {size, 0, 0}};
  for (const Similarity& motion : {move, turn}) {
    SCOPED_TRACE(motion.angle);
    const Shape moved_shape = CSCD::test::moved(m_shape, motion, motion.scale);
    const double tolerance = relative_tolerance * motion.scale * size;
    EXPECT_EQ(difference(moved(skeleton, motion), skeletonize(moved_shape), tolerance), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Cgal, Real_mesh_invariance,
                         testing::Values("anchor", "bear", "bull", "cheese", "cow", "elephant", "fandisk", "femur",
                                         "hand", "homer", "joint", "pig", "spool"),
                         [](const auto& mesh) { return std::string(mesh.param); });

} // namespace
