// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A page that shows a skeleton inside its surface.

#ifndef CSCD_IO_WRITE_HTML_PAGE_H
#define CSCD_IO_WRITE_HTML_PAGE_H

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector_3.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

/// The points of a point set, and where the surface was repaired.
template <class Point>
struct Html_page_cloud
{
  /// The first vertices of the mesh are the points; 0 for a mesh that is no such surface.
  std::size_t number_of_points = 0;
  std::vector<Point> cut_handles; ///< where handles were cut
  std::vector<Point> joined_gaps; ///< where fragments were joined
};

namespace internal {

/// What the page shows, in the coordinates of the input.
struct Html_page_content : Assigned_surface
{
  Indexed_skeleton skeleton;
  bool has_radius = false;
  std::vector<std::vector<Vector_3>> separators;
  Html_page_cloud<Vector_3> cloud;
};

/// The arguments of `CSCD::write_html_page()`, as far as their types vary, in flat arrays.
template <class TriangleMesh, class Skeleton, class Point>
Html_page_content html_page_content(const TriangleMesh& mesh, const Skeleton& skeleton,
                                    const std::vector<std::vector<Point>>& separators,
                                    const Html_page_cloud<Point>& cloud)
{
  const auto to_vectors = [](const std::vector<Point>& points) {
    std::vector<Vector_3> result;
    result.reserve(points.size());
    for (const Point& p : points) {
      result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    return result;
  };
  Html_page_content result;
  static_cast<Assigned_surface&>(result) = assigned_surface(mesh, skeleton);
  result.skeleton = index_skeleton(skeleton);
  result.has_radius = has_radius_v<Skeleton>;
  for (const std::vector<Point>& separator : separators) {
    result.separators.push_back(to_vectors(separator));
  }
  result.cloud = {cloud.number_of_points, to_vectors(cloud.cut_handles), to_vectors(cloud.joined_gaps)};
  return result;
}

void write_html_page(std::ostream& out, const Html_page_content& content, const std::string& three_js_source,
                     const std::string& title);

} // namespace internal

/// writes a page for browsers that shows `skeleton` inside the translucent surface of `mesh`, with switches for what
/// is seen: one HTML file that needs no other file and no network.
/// Positions are stored in single precision relative to the middle of the shape. The page's address can carry what it
/// shows first: `page.html#separators=1&color=1&opacity=60&significance=1&up=z&panel=0`. Sliders hide branches
/// by the rule by which `simplify_skeleton()` prunes. Linear, but for sorting edges.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam Skeleton a `Skeleton_graph`, or CGAL's `Mean_curvature_flow_skeletonization<TriangleMesh>::Skeleton`; if its
///         nodes carry no radius, the page cannot show their balls
/// \param separators closed curves on the surface, the first point not repeated; may be empty
/// \param three_js_source the text of three.js as a classic script that defines `THREE`, followed by that of
///        `THREE.OrbitControls`; the page is written for release 111
/// \param title heads the page; any text
/// \param cloud the points of which the mesh was made, and where it was repaired; nothing for other meshes
/// \pre all faces of `mesh` are triangles; all coordinates are finite
/// \throw File_error if `out` fails
template <class TriangleMesh, class Skeleton, class Point>
void write_html_page(std::ostream& out, const TriangleMesh& mesh, const Skeleton& skeleton,
                     const std::vector<std::vector<Point>>& separators, const std::string& three_js_source,
                     const std::string& title, const Html_page_cloud<Point>& cloud = {})
{
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  internal::write_html_page(out, internal::html_page_content(mesh, skeleton, separators, cloud), three_js_source,
                            title);
}

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/IO/write_html_page_impl.h>
#endif

#endif // CSCD_IO_WRITE_HTML_PAGE_H
