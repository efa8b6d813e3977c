// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls that the compiler must refuse, each with the sentence that its comment names, and with no other of ours.

#undef CGAL_LINKED_WITH_TBB

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/concepts.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>
#include <CSCD/input_concepts.h>
#include <CSCD/shorten_curve.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;

void parameters(const Mesh& mesh, Skeleton& skeleton, const std::vector<Point>& points,
                CSCD::Skeleton_graph<Point, std::size_t>& skeleton_of_points)
{
  // expected error: CSCD: the same named parameter is given by two of the combined chains
  CSCD::parameters::combine(CGAL::parameters::random_seed(7), CSCD::parameters::number_of_threads(2).random_seed(8));
  // A parameter of CGAL, in the midst of the parameters that the function uses.
  // expected error: CSCD: this named parameter is not used by this function
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::number_of_threads(2).verbose(true).random_seed(7u));
  // A parameter of the library, last in the chain.
  // expected error: CSCD: this named parameter is not used by this function
  std::vector<Point> curve;
  CSCD::shorten_curve(mesh, std::vector<Mesh::Vertex_index>(), false, std::back_inserter(curve),
                      CSCD::parameters::random_seed(7));
  // A parameter of meshes alone.
  // expected error: CSCD: this named parameter is not used by this function
  CSCD::extract_curve_skeleton(points, skeleton_of_points, CSCD::parameters::random_seed(7u).vertex_point_map(0));
  // expected error: CSCD: detail belongs to the default policies and cannot be given with policies
  CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::policies(CSCD::Local_policies()).detail(0.5));
  // expected error: CSCD: CGAL::Parallel_tag needs oneTBB: link CSCD::parallel
  CSCD::extract_curve_skeleton<CGAL::Parallel_tag>(mesh, skeleton);
}

// A range of points is not a mesh: the refusals name the missing functions; they are not errors inside Boost.
// expected error: CSCD: TriangleMesh requires vertices(g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires faces(g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires num_vertices(g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires num_faces(g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires halfedge(f, g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires next(h, g), as CGAL's FaceListGraph
// expected error: CSCD: TriangleMesh requires target(h, g), as CGAL's FaceListGraph
void points_as_mesh()
{
  CSCD::check_triangle_mesh<std::vector<Point>>();
}

struct Surface_without_crossings
{
  const CSCD::Triangulated_surface& triangulation() const;
  bool is_inside(const CSCD::Vector3& p) const;
  std::optional<CSCD::Vector3> middle_behind(const CSCD::Vector3& p) const;
};

// expected error: CSCD: SkeletonizationSurface requires s.crossings(p, q, v) const, which fills a std::vector<double>
void surface_without_crossings()
{
  CSCD::check_skeletonization_surface<Surface_without_crossings>();
}

struct Node_without_vertices
{
  std::array<double, 3> point;
};
using Skeleton_without_vertices =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Node_without_vertices>;

// expected error: CSCD: CurveSkeletonGraph requires g[v].vertices, a range of input descriptors
void skeleton_without_vertices()
{
  CSCD::check_curve_skeleton_graph<Skeleton_without_vertices>();
}

struct Traits_without_descriptors
{
  using Point = std::array<double, 3>;
  using Input_descriptor = int;
  struct Surface
  {
  };
  const Surface& surface() const;
  CSCD::Normalization normalization() const;
  void describe_input(CSCD::Skeletonization_report& report) const;
};

// expected error: CSCD: SkeletonizationTraits requires t.descriptors(v) const, a range of T::Input_descriptor
void traits_without_descriptors()
{
  CSCD::check_skeletonization_traits<Traits_without_descriptors>();
}

struct Visitor_without_go_further
{
  void on_stage_begin(CSCD::Skeletonization_stage stage);
  void on_stage_end(CSCD::Skeletonization_stage stage);
  void progress(double fraction);
};

// expected error: CSCD: SkeletonizationVisitor requires v.go_further(), convertible to bool
void visitor_without_go_further()
{
  CSCD::check_skeletonization_visitor<Visitor_without_go_further>();
}
