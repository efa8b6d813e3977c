// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The types that the parts of the program share.

#ifndef CSCD_PROGRAM_TYPES_H
#define CSCD_PROGRAM_TYPES_H

#include <CSCD/Skeleton_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

namespace cscd {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Skeleton = CSCD::Skeleton_graph<Point, boost::graph_traits<Mesh>::vertex_descriptor>;

} // namespace cscd

#endif // CSCD_PROGRAM_TYPES_H
