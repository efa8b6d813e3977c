// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data of the page, in the forms that a page can hold.

#ifndef CSCD_IO_INTERNAL_HTML_PAGE_DATA_H
#define CSCD_IO_INTERNAL_HTML_PAGE_DATA_H

#include <CSCD/IO/internal/skeleton_access.h>
#include <CSCD/Skeleton/split_into_branches.h>
#include <CSCD/Skeleton_graph.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CSCD {

/// The points of a point set, and where the surface was mended.
template <class Point>
struct Html_page_cloud
{
  std::size_t number_of_points =
      0; ///< the first vertices of the mesh are the points; 0 for a mesh that is no such surface
  std::vector<Point> cut_handles; ///< where handles were cut
  std::vector<Point> joined_gaps; ///< where fragments were joined
};

} // namespace CSCD

namespace CSCD::internal {

/// The bytes of `numbers`, least significant first: what the typed arrays of a browser hold.
template <class Number>
std::string little_endian_bytes(const std::vector<Number>& numbers)
{
  using Bits = std::conditional_t<sizeof(Number) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  static_assert(sizeof(Number) == sizeof(Bits), "only numbers of four or eight bytes");
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Bits bits;
    std::memcpy(&bits, &numbers[i], sizeof bits);
    boost::endian::native_to_little_inplace(bits);
    std::memcpy(&bytes[i * sizeof bits], &bits, sizeof bits);
  }
  return bytes;
}

/// `bytes` in base 64, padded with `=` to a multiple of four characters.
inline std::string encode_base64(std::string bytes)
{
  namespace iterators = boost::archive::iterators;
  constexpr int bits_of_character = 6;
  constexpr int bits_of_byte = 8;
  using Encoded =
      iterators::base64_from_binary<iterators::transform_width<const char*, bits_of_character, bits_of_byte>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0'); // the iterators read groups of three bytes to their end
  std::string text(Encoded(bytes.data()), Encoded(bytes.data() + bytes.size()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

/// `text` such that a page shows it literally.
inline std::string escape_html(std::string text)
{
  boost::algorithm::replace_all(text, "&", "&amp;");
  boost::algorithm::replace_all(text, "<", "&lt;");
  boost::algorithm::replace_all(text, ">", "&gt;");
  boost::algorithm::replace_all(text, "\"", "&quot;");
  boost::algorithm::replace_all(text, "'", "&#39;");
  return text;
}

/// `source` such that it can stand in a script element: it neither ends the element nor begins a comment in it.
/// In the strings, regular expressions and comments of JavaScript, where alone these can occur, the meaning stays.
inline std::string escape_script(std::string source)
{
  boost::algorithm::ireplace_all(source, "</script", "<\\/script");
  boost::algorithm::replace_all(source, "<!--", "<\\!--");
  return source;
}

/// Stands for "none" where the page expects the number of a node or of a branch.
inline constexpr std::uint32_t html_page_none = std::numeric_limits<std::uint32_t>::max();

/// The cube around the shape. The page draws it as the cube from -1 to 1: single precision, which is what graphics
/// cards compute in, then suffices wherever the shape is and whatever its size.
class Html_page_frame
{
public:
  void include(const std::array<double, 3>& point)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      CGAL_precondition(std::isfinite(point[i]));
      m_min[i] = std::min(m_min[i], point[i]);
      m_max[i] = std::max(m_max[i], point[i]);
    }
  }

  std::array<double, 3> centre() const
  {
    // Halved before they are added, so that coordinates near the greatest double do not overflow.
    return is_empty() ? std::array<double, 3>{0, 0, 0}
                      : std::array<double, 3>{m_min[0] / 2 + m_max[0] / 2, m_min[1] / 2 + m_max[1] / 2,
                                              m_min[2] / 2 + m_max[2] / 2};
  }

  /// Half the longest extent; 1 if there is none.
  double half_extent() const
  {
    double longest = 0;
    for (std::size_t i = 0; i < 3 && !is_empty(); ++i) {
      longest = std::max(longest, m_max[i] / 2 - m_min[i] / 2);
    }
    return longest > 0 ? longest : 1;
  }

private:
  bool is_empty() const { return m_min[0] > m_max[0]; }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> m_min{infinity, infinity, infinity};
  std::array<double, 3> m_max{-infinity, -infinity, -infinity};
};

/// The arrays and figures of the page. Points are three consecutive numbers in the frame.
struct Html_page_data
{
  std::array<double, 3> centre{};
  double half_extent = 1;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> node_of_vertex;
  std::vector<float> node_positions;
  std::vector<float> node_radii; // empty if the nodes have none
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> branch_of_node; // none for the ends that several branches share
  std::vector<std::uint32_t> branch_of_edge;
  std::vector<float> separator_points;
  std::vector<std::uint32_t> separator_offsets; // of the first point of each, and of the end
  std::size_t number_of_cloud_points = 0;       // the first of the positions
  std::vector<float> cut_handles;
  std::vector<float> joined_gaps;
  std::size_t number_of_branches = 0;
  std::size_t number_of_tips = 0;
  std::size_t number_of_junctions = 0;
  std::size_t number_of_cycles = 0;
};

/// Gathers the data of the page.
template <class TriangleMesh, class Skeleton, class Point>
class Html_page_data_builder
{
public:
  Html_page_data_builder(const TriangleMesh& mesh, const Skeleton& skeleton,
                         const std::vector<std::vector<Point>>& separators, const Html_page_cloud<Point>& cloud = {})
      : m_mesh(mesh), m_skeleton(skeleton), m_vertex_points(get(CGAL::vertex_point, mesh))
  {
    set_frame();
    add_mesh();
    add_nodes();
    add_edges();
    add_branches();
    add_separators(separators);
    add_cloud(cloud);
  }

  const Html_page_data& data() const { return m_data; }

private:
  using Mesh_vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Node = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  using Vertex_points = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;

  template <class AnyPoint>
  static std::array<double, 3> to_doubles(const AnyPoint& point)
  {
    return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
  }

  auto nodes() const { return boost::make_iterator_range(vertices(m_skeleton)); }
  auto skeleton_edges() const { return boost::make_iterator_range(edges(m_skeleton)); }

  void set_frame()
  {
    Html_page_frame frame;
    for (Mesh_vertex v : boost::make_iterator_range(vertices(m_mesh))) {
      frame.include(to_doubles(get(m_vertex_points, v)));
    }
    for (Node node : nodes()) {
      frame.include(coordinates(m_skeleton, node));
    }
    m_data.centre = frame.centre();
    m_data.half_extent = frame.half_extent();
  }

  void append(std::vector<float>& target, const std::array<double, 3>& point) const
  {
    for (std::size_t i = 0; i < 3; ++i) {
      target.push_back(static_cast<float>((point[i] - m_data.centre[i]) / m_data.half_extent));
    }
  }

  void add_mesh()
  {
    // A property of the mesh would be faster to ask, but adding one writes to the mesh: others may be reading it.
    std::unordered_map<Mesh_vertex, std::uint32_t> number;
    number.reserve(num_vertices(m_mesh));
    for (Mesh_vertex v : boost::make_iterator_range(vertices(m_mesh))) {
      number.emplace(v, static_cast<std::uint32_t>(number.size()));
      append(m_data.positions, to_doubles(get(m_vertex_points, v)));
    }
    for (auto f : boost::make_iterator_range(faces(m_mesh))) {
      for (Mesh_vertex v : CGAL::vertices_around_face(halfedge(f, m_mesh), m_mesh)) {
        m_data.triangles.push_back(number.at(v));
      }
    }
    m_data.node_of_vertex.assign(number.size(), html_page_none);
    for (Node node : nodes()) {
      for (Mesh_vertex v : m_skeleton[node].vertices) {
        m_data.node_of_vertex[number.at(v)] = static_cast<std::uint32_t>(node);
      }
    }
  }

  void add_nodes()
  {
    for (Node node : nodes()) {
      append(m_data.node_positions, coordinates(m_skeleton, node));
      if constexpr (has_radius_v<Skeleton>) {
        m_data.node_radii.push_back(static_cast<float>(radius(m_skeleton, node) / m_data.half_extent));
      }
      m_data.number_of_tips += out_degree(node, m_skeleton) == 1 ? 1 : 0;
      m_data.number_of_junctions += out_degree(node, m_skeleton) > 2 ? 1 : 0;
    }
  }

  void add_edges()
  {
    for (auto edge : skeleton_edges()) {
      m_data.edges.push_back(static_cast<std::uint32_t>(source(edge, m_skeleton)));
      m_data.edges.push_back(static_cast<std::uint32_t>(target(edge, m_skeleton)));
    }
    std::vector<std::size_t> component(num_vertices(m_skeleton));
    const std::size_t number_of_components =
        static_cast<std::size_t>(boost::connected_components(m_skeleton, component.data()));
    m_data.number_of_cycles = num_edges(m_skeleton) + number_of_components - num_vertices(m_skeleton);
  }

  void add_branches()
  {
    const auto branches = split_into_branches(m_skeleton);
    m_data.number_of_branches = branches.size();
    m_data.branch_of_node.assign(num_vertices(m_skeleton), html_page_none);
    std::map<std::pair<Node, Node>, std::uint32_t> branch_between;
    for (std::size_t b = 0; b < branches.size(); ++b) {
      const auto branch = static_cast<std::uint32_t>(b);
      for (std::size_t i = 0; i < branches[b].size(); ++i) {
        if (out_degree(branches[b][i], m_skeleton) <= 2) {
          m_data.branch_of_node[branches[b][i]] = branch;
        }
        if (i > 0) {
          branch_between[std::minmax(branches[b][i - 1], branches[b][i])] = branch;
        }
      }
    }
    for (auto edge : skeleton_edges()) {
      const std::pair<Node, Node> ends = std::minmax({source(edge, m_skeleton), target(edge, m_skeleton)});
      m_data.branch_of_edge.push_back(branch_between.at(ends));
    }
  }

  void add_separators(const std::vector<std::vector<Point>>& separators)
  {
    m_data.separator_offsets.push_back(0);
    for (const std::vector<Point>& separator : separators) {
      for (const Point& point : separator) {
        append(m_data.separator_points, to_doubles(point));
      }
      m_data.separator_offsets.push_back(static_cast<std::uint32_t>(m_data.separator_points.size() / 3));
    }
  }

  void add_cloud(const Html_page_cloud<Point>& cloud)
  {
    m_data.number_of_cloud_points = cloud.number_of_points;
    for (const Point& point : cloud.cut_handles) {
      append(m_data.cut_handles, to_doubles(point));
    }
    for (const Point& point : cloud.joined_gaps) {
      append(m_data.joined_gaps, to_doubles(point));
    }
  }

  const TriangleMesh& m_mesh;
  const Skeleton& m_skeleton;
  Vertex_points m_vertex_points;
  Html_page_data m_data;
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_HTML_PAGE_DATA_H
