// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file that benchmark/reproduce/compile_time.py compiles. The macros choose the included headers and the mesh types
// that extract_curve_skeleton() is called with, so that the cost of each can be measured.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

#ifdef WITH_POLYHEDRON
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

using Polyhedron = CGAL::Polyhedron_3<Kernel>;
#endif

#if NUMBER_OF_MESH_TYPES > 0
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

template <class AnyMesh>
using Skeleton = CSCD::Skeleton_graph<Point, typename boost::graph_traits<AnyMesh>::vertex_descriptor>;

std::size_t skeletonize(const Mesh& mesh)
{
  Skeleton<Mesh> skeleton;
  return CSCD::extract_curve_skeleton(mesh, skeleton).number_of_nodes;
}
#endif

#if NUMBER_OF_MESH_TYPES > 1
std::size_t skeletonize(const Polyhedron& mesh)
{
  Skeleton<Polyhedron> skeleton;
  return CSCD::extract_curve_skeleton(mesh, skeleton).number_of_nodes;
}
#endif

#if NUMBER_OF_MESH_TYPES > 2
/// The points of a mesh, moved.
struct Moved_point_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;

  friend Point get(const Moved_point_map& map, Mesh::Vertex_index vertex)
  {
    return map.mesh->point(vertex) + Kernel::Vector_3(1, 0, 0);
  }

  const Mesh* mesh;
};

std::size_t skeletonize_moved(const Mesh& mesh)
{
  Skeleton<Mesh> skeleton;
  const Moved_point_map map{&mesh};
  return CSCD::extract_curve_skeleton(mesh, skeleton, CSCD::parameters::vertex_point_map(map)).number_of_nodes;
}
#endif
