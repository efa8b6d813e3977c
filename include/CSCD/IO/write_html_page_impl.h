// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_html_page.h.

#ifndef CSCD_IO_WRITE_HTML_PAGE_IMPL_H
#define CSCD_IO_WRITE_HTML_PAGE_IMPL_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/internal/html_page_template.h>
#include <CSCD/IO/write_html_page.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/config.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The cube around the shape. The page draws it as the cube from -1 to 1: single precision, which is what graphics
/// cards compute in, then suffices wherever the shape is and whatever its size.
class Html_page_frame
{
public:
  void include(const Vector_3& point)
  {
    CGAL_precondition(point.allFinite());
    m_box.extend(point);
  }

  Vector_3 center() const
  {
    // Halved before they are added, so that coordinates near the greatest double do not overflow.
    return m_box.is_empty() ? Vector_3(Vector_3::Zero()) : Vector_3(m_box.min() / 2 + m_box.max() / 2);
  }

  /// Half the longest extent; 1 if there is none.
  double half_extent() const
  {
    const double longest = m_box.is_empty() ? 0 : (m_box.max() / 2 - m_box.min() / 2).maxCoeff();
    return longest > 0 ? longest : 1;
  }

private:
  Bounding_box m_box;
};

/// The arrays and figures of the page. Points are three consecutive numbers in the frame.
struct Html_page_data
{
  Vector_3 center = Vector_3::Zero();
  double half_extent = 1;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> node_of_vertex;
  std::vector<float> node_positions;
  std::vector<float> node_radii; // empty if the nodes have none
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> branch_of_node; // `no_index` for the ends that several branches share
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
class Html_page_data_builder
{
public:
  explicit Html_page_data_builder(const Html_page_content& content) : m_content(content), m_skeleton(content.skeleton)
  {
    set_frame();
    add_mesh();
    add_nodes();
    add_edges();
    add_branches();
    add_separators();
    add_cloud();
  }

  const Html_page_data& data() const { return m_data; }

private:
  void set_frame()
  {
    Html_page_frame frame;
    for (const std::vector<Vector_3>* points : {&m_content.points, &m_skeleton.points}) {
      for (const Vector_3& point : *points) {
        frame.include(point);
      }
    }
    m_data.center = frame.center();
    m_data.half_extent = frame.half_extent();
  }

  void append(std::vector<float>& target, const std::vector<Vector_3>& points) const
  {
    for (const Vector_3& point : points) {
      for (int i = 0; i < 3; ++i) {
        target.push_back(static_cast<float>((point[i] - m_data.center[i]) / m_data.half_extent));
      }
    }
  }

  void add_mesh()
  {
    append(m_data.positions, m_content.points);
    for (const std::array<Index, 3>& triangle : m_content.triangles) {
      m_data.triangles.insert(m_data.triangles.end(), triangle.begin(), triangle.end());
    }
    m_data.node_of_vertex = m_content.node_of_vertex;
  }

  void add_nodes()
  {
    m_neighbors = node_neighbors(m_skeleton);
    append(m_data.node_positions, m_skeleton.points);
    for (Index node = 0; node < m_neighbors.size(); ++node) {
      if (m_content.has_radius) {
        m_data.node_radii.push_back(static_cast<float>(m_skeleton.radii[node] / m_data.half_extent));
      }
      m_data.number_of_tips += m_neighbors[node].size() == 1 ? 1 : 0;
      m_data.number_of_junctions += m_neighbors[node].size() > 2 ? 1 : 0;
    }
  }

  void add_edges()
  {
    Disjoint_sets components(m_skeleton.number_of_nodes());
    for (const auto& [source, target] : m_skeleton.edges) {
      m_data.edges.push_back(source);
      m_data.edges.push_back(target);
      m_data.number_of_cycles += components.join(source, target) ? 0 : 1;
    }
  }

  void add_branches()
  {
    const std::vector<std::vector<Index>> branches = split_into_branches(m_neighbors);
    m_data.number_of_branches = branches.size();
    m_data.branch_of_node.assign(m_neighbors.size(), no_index);
    std::map<std::pair<Index, Index>, Index> branch_between;
    for (Index b = 0; b < branches.size(); ++b) {
      const std::vector<Index>& branch = branches[b];
      for (std::size_t i = 0; i < branch.size(); ++i) {
        if (m_neighbors[branch[i]].size() <= 2) {
          m_data.branch_of_node[branch[i]] = b;
        }
        if (i > 0) {
          branch_between[std::minmax(branch[i - 1], branch[i])] = b;
        }
      }
    }
    for (const auto& [source, target] : m_skeleton.edges) {
      const std::pair<Index, Index> ends = std::minmax({source, target});
      m_data.branch_of_edge.push_back(branch_between.at(ends));
    }
  }

  void add_separators()
  {
    m_data.separator_offsets.push_back(0);
    for (const std::vector<Vector_3>& separator : m_content.separators) {
      append(m_data.separator_points, separator);
      m_data.separator_offsets.push_back(static_cast<std::uint32_t>(m_data.separator_points.size() / 3));
    }
  }

  void add_cloud()
  {
    m_data.number_of_cloud_points = m_content.cloud.number_of_points;
    append(m_data.cut_handles, m_content.cloud.cut_handles);
    append(m_data.joined_gaps, m_content.cloud.joined_gaps);
  }

  const Html_page_content& m_content;
  const Indexed_skeleton& m_skeleton;
  std::vector<std::vector<Index>> m_neighbors; // of every node
  Html_page_data m_data;
};

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
  const std::vector<double> frame{data.center[0], data.center[1], data.center[2], data.half_extent};
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

CSCD_INLINE void write_html_page(std::ostream& out, const Html_page_content& content,
                                 const std::string& three_js_source, const std::string& title)
{
  const Html_page_data_builder builder(content);
  Exact_format format(out);
  out << html_page_head << escape_html(title) << html_page_style << html_page_body
      << "<script type=\"application/json\" id=\"cscd-data\">\n";
  write_html_page_data(out, builder.data());
  out << "\n</script>\n<script>\n"
      << escape_script(three_js_source) << "\n</script>\n<script>" << html_page_model_script << html_page_scene_script
      << html_page_view_script << html_page_panel_script << "</script>\n</body>\n</html>\n";
  format.finish();
}

} // namespace CSCD::internal

#endif // CSCD_IO_WRITE_HTML_PAGE_IMPL_H
