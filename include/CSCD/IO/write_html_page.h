// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A page that shows a skeleton inside its surface.

#ifndef CSCD_IO_WRITE_HTML_PAGE_H
#define CSCD_IO_WRITE_HTML_PAGE_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/Html_page_data.h>
#include <CSCD/IO/internal/html_page_template.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

namespace internal {

inline void write_html_page_counts(std::ostream& out, const Html_page_data& data)
{
  out << "\"counts\": {\"vertices\": " << data.positions.size() / 3 << ", \"triangles\": " << data.triangles.size() / 3
      << ", \"nodes\": " << data.node_positions.size() / 3 << ", \"edges\": " << data.edges.size() / 2
      << ", \"branches\": " << data.number_of_branches << ", \"tips\": " << data.number_of_tips
      << ", \"junctions\": " << data.number_of_junctions << ", \"cycles\": " << data.number_of_cycles
      << ", \"separators\": " << data.separator_offsets.size() - 1 << ", \"points\": " << data.number_of_cloud_points
      << '}';
}

/// The letter by which the page's script chooses the type of a typed array.
constexpr char html_page_array_type(float)
{
  return 'f';
}
constexpr char html_page_array_type(double)
{
  return 'd';
}
constexpr char html_page_array_type(std::uint32_t)
{
  return 'u';
}

template <class Number>
void write_html_page_array(std::ostream& out, const char* name, const std::vector<Number>& numbers)
{
  out << ",\n\"" << name << "\": [\"" << html_page_array_type(Number{}) << "\", \""
      << encode_base64(little_endian_bytes(numbers)) << "\"]";
}

inline void write_html_page_data(std::ostream& out, const Html_page_data& data)
{
  const std::vector<double> frame{data.centre[0], data.centre[1], data.centre[2], data.half_extent};
  out << '{';
  write_html_page_counts(out, data);
  out << ",\n\"arrays\": {\"frame\": [\"d\", \"" << encode_base64(little_endian_bytes(frame)) << "\"]";
  write_html_page_array(out, "positions", data.positions);
  write_html_page_array(out, "triangles", data.triangles);
  write_html_page_array(out, "node_of_vertex", data.node_of_vertex);
  write_html_page_array(out, "node_positions", data.node_positions);
  if (!data.node_radii.empty()) {
    write_html_page_array(out, "node_radii", data.node_radii);
  }
  write_html_page_array(out, "edges", data.edges);
  write_html_page_array(out, "branch_of_node", data.branch_of_node);
  write_html_page_array(out, "branch_of_edge", data.branch_of_edge);
  write_html_page_array(out, "separator_points", data.separator_points);
  write_html_page_array(out, "separator_offsets", data.separator_offsets);
  if (data.number_of_cloud_points > 0) {
    write_html_page_array(out, "cut_handles", data.cut_handles);
    write_html_page_array(out, "joined_gaps", data.joined_gaps);
  }
  out << "}}";
}

} // namespace internal

/// writes a page for browsers that shows `skeleton` inside the translucent surface of `mesh`, with switches for what
/// is seen: one HTML file that needs no other file and no network.
/// Positions are stored in single precision relative to the middle of the shape. The page's address can carry what it
/// shows first: `page.html#separators=1&colour=1&opacity=60&up=z&panel=0`. Linear, but for sorting edges.
/// \tparam TriangleMesh a model of `FaceListGraph` with an internal property map for `CGAL::vertex_point_t`
/// \tparam Skeleton a `Skeleton_graph`, or CGAL's `Mean_curvature_flow_skeletonization<TriangleMesh>::Skeleton`; if its
///         nodes carry no radius, the page cannot show their balls
/// \param separators closed curves on the surface, the first point not repeated; may be empty
/// \param three_js_source the text of three.js as a classic script that defines `THREE`, followed by that of
///        `THREE.OrbitControls`; the page is written for release 111
/// \param title heads the page; any text
/// \param cloud the points of which the mesh was made, and where it was mended; nothing for other meshes
/// \pre all faces of `mesh` are triangles; all coordinates are finite
/// \throw File_error if `out` fails
template <class TriangleMesh, class Skeleton, class Point>
void write_html_page(std::ostream& out, const TriangleMesh& mesh, const Skeleton& skeleton,
                     const std::vector<std::vector<Point>>& separators, const std::string& three_js_source,
                     const std::string& title, const Html_page_cloud<Point>& cloud = {})
{
  CGAL_precondition(CGAL::is_triangle_mesh(mesh));
  const internal::Html_page_data_builder<TriangleMesh, Skeleton, Point> builder(mesh, skeleton, separators, cloud);
  internal::Exact_format format(out);
  out << internal::html_page_head << internal::escape_html(title) << internal::html_page_style
      << internal::html_page_body << "<script type=\"application/json\" id=\"cscd-data\">\n";
  internal::write_html_page_data(out, builder.data());
  out << "\n</script>\n<script>\n"
      << internal::escape_script(three_js_source) << "\n</script>\n<script>" << internal::html_page_model_script
      << internal::html_page_scene_script << internal::html_page_view_script << internal::html_page_panel_script
      << "</script>\n</body>\n</html>\n";
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_HTML_PAGE_H
