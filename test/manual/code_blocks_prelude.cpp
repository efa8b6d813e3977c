// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Declarations that the code fragments in README.md, in the manual and in comments of headers assume. The fragments
// have their own includes.

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

extern Mesh mesh;
extern CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
extern Mesh::Property_map<Mesh::Vertex_index, Point> map;
extern CSCD::Default_skeletonization_visitor my_visitor;
std::vector<Point> my_points();

extern Mesh::Vertex_index source;
extern std::vector<Mesh::Vertex_index> sources;
extern std::vector<std::vector<Mesh::Vertex_index>> source_sets;
extern Mesh::Property_map<Mesh::Vertex_index, double> distance_map;
extern std::vector<Mesh::Property_map<Mesh::Vertex_index, double>> distance_maps;
