// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A page that shows a skeleton inside its surface. It carries three.js, which is not installed with the library:
// so it belongs to the program.

#ifndef CSCD_VIEWER_WRITE_HTML_PAGE_H
#define CSCD_VIEWER_WRITE_HTML_PAGE_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

/// Whether three.js was found when this was built. Without it pages show a message in place of the picture.
bool has_three_js();

/// The points of a point set, and the repairs of its surface.
struct Html_page_cloud
{
  std::size_t number_of_points = 0;   ///< the first vertices of the mesh are the points; 0 for other meshes
  std::vector<Vector3> cut_handles{}; ///< where handles were cut
  std::vector<Vector3> joined_gaps{}; ///< where fragments were joined
};

namespace internal {

/// The content of a page, in the coordinates of the input.
struct Html_page_content
{
  Assigned_surface surface;
  Skeleton skeleton;
  Html_page_cloud cloud;
};

void write_html_page(std::ostream& out, const Html_page_content& content, const std::string& title);

} // namespace internal

/// writes a page for browsers that shows `skeleton` inside the translucent surface of `mesh`: one HTML file that needs
/// no other file and no network.
/// Positions are stored in single precision relative to the middle of the shape. The page's address can carry the first
/// view: `page.html#separators=1&color=1&opacity=60&significance=1&up=z&panel=0`. Sliders hide branches by the pruning
/// rule of `simplify_skeleton()`. O(n log n).
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam SkeletonGraph a `Skeleton_graph`, or CGAL's `Mean_curvature_flow_skeletonization<TriangleMesh>::Skeleton`,
///         whose nodes have no radius, so that the page has no balls and no sliders
/// \param separators closed curves on the surface, the first point not repeated; may be empty
/// \param title heads the page; any text
/// \pre all faces of `mesh` are triangles; all coordinates are finite
/// \throw File_error if `out` fails
template <class TriangleMesh, class SkeletonGraph, class Point>
void write_html_page(std::ostream& out, const TriangleMesh& mesh, const SkeletonGraph& skeleton,
                     const std::vector<std::vector<Point>>& separators, const std::string& title)
{
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  internal::Html_page_content content{
      internal::assigned_surface(mesh, skeleton), internal::index_skeleton(skeleton), {}};
  for (const std::vector<Point>& separator : separators) {
    std::transform(separator.begin(), separator.end(), std::back_inserter(content.skeleton.separators.emplace_back()),
                   internal::to_vector_3<Point>);
  }
  internal::write_html_page(out, content, title);
}

} // namespace CSCD

#endif // CSCD_VIEWER_WRITE_HTML_PAGE_H
