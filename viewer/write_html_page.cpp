// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Puts the data of a skeleton and its surface into the text of the page.

#include "write_html_page.h"

#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton/Branch_hierarchy.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Box_tree.h>

#include <CGAL/assertions.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The text of the page, with marks in the places of title and data. The build makes its definition.
std::string html_page_template();

namespace {

using Json = nlohmann::json;

/// Maps the shape to the cube from -1 to 1. Graphics cards compute in single precision, which suffices there for shapes
/// of any place and size.
class Frame
{
public:
  explicit Frame(const Html_page_content& content)
  {
    Bounding_box box;
    for (const std::vector<Vector3>* points : {&content.surface.points, &content.skeleton.points}) {
      for (const Vector3& point : *points) {
        CGAL_precondition(point.allFinite());
        box.extend(point);
      }
    }
    if (!box.is_empty()) {
      // Halved before they are added, so that coordinates near the greatest double do not overflow.
      m_center = box.min() / 2 + box.max() / 2;
      const double longest = (box.max() / 2 - box.min() / 2).maxCoeff();
      m_half_extent = longest > 0 ? longest : 1;
    }
  }

  /// Center and half extent.
  std::vector<double> numbers() const { return {m_center[0], m_center[1], m_center[2], m_half_extent}; }

  std::vector<float> positions(const std::vector<Vector3>& points) const
  {
    std::vector<float> result;
    result.reserve(3 * points.size());
    for (const Vector3& point : points) {
      for (int i = 0; i < 3; ++i) {
        result.push_back(float((point[i] - m_center[i]) / m_half_extent));
      }
    }
    return result;
  }

private:
  Vector3 m_center = Vector3::Zero();
  double m_half_extent = 1;
};

/// `bytes` in base 64, padded with `=` to a multiple of four characters.
std::string encode_base64(std::string bytes)
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

/// The letter of a typed array of the browser, and its bytes, least significant first.
template <class Number>
Json encode(const std::vector<Number>& numbers)
{
  constexpr const char* type = std::is_same_v<Number, float> ? "f" : std::is_same_v<Number, double> ? "d" : "u";
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    boost::endian::endian_store<Number, sizeof(Number), boost::endian::order::little>(
        reinterpret_cast<unsigned char*>(&bytes[i * sizeof(Number)]), numbers[i]);
  }
  return Json::array({type, encode_base64(std::move(bytes))});
}

/// For each branch the threshold of `measure`; greater thresholds let pruning cut it. Infinite for other branches.
std::vector<double> limits(const Skeleton& skeleton, const std::vector<Index>& branch_of_edge,
                           std::size_t number_of_branches, Branch_measure measure)
{
  const Branch_hierarchy fall(skeleton, measure);
  std::vector<double> result(number_of_branches, std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < branch_of_edge.size(); ++e) {
    if (!fall.is_last(Index(e))) {
      result[branch_of_edge[e]] = fall.levels()[e];
    }
  }
  return result;
}

/// Adds the edges in the order of the branches, and the measures of these, which have the numbers of all outputs.
void add_branches(Skeleton skeleton, Json& arrays)
{
  const std::vector<Skeleton_branch> branches = measure_branches(skeleton, {}).branches;
  std::vector<Index> branch_of_node(skeleton.number_of_nodes(), no_index); // of nodes that belong to one alone
  std::vector<Index> branch_of_edge;
  std::vector<Index> edges;
  std::vector<double> lengths;
  std::vector<double> radii;
  std::vector<double> significances;
  skeleton.edges.clear();
  for (const Skeleton_branch& branch : branches) {
    const Index b = Index(lengths.size());
    for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
      const Index node = branch.nodes[i];
      const bool is_end = i == 0 || i + 1 == branch.nodes.size();
      const Branch_end end = branch.ends[i == 0 ? 0 : 1];
      if (!is_end || end != Branch_end::junction) {
        branch_of_node[node] = b;
      }
      if (i > 0) {
        skeleton.edges.push_back({branch.nodes[i - 1], node});
        edges.insert(edges.end(), {branch.nodes[i - 1], node});
        branch_of_edge.push_back(b);
      }
    }
    lengths.push_back(branch.length);
    radii.push_back(branch.mean_radius);
    significances.push_back(branch.significance);
  }
  arrays["edges"] = encode(edges);
  arrays["branch_of_edge"] = encode(branch_of_edge);
  arrays["branch_of_node"] = encode(branch_of_node);
  arrays["branch_lengths"] = encode(lengths);
  if (skeleton.has_radii()) {
    arrays["branch_radii"] = encode(radii);
    arrays["branch_significances"] = encode(significances);
    arrays["significance_limits"] =
        encode(limits(skeleton, branch_of_edge, branches.size(), Branch_measure::significance));
    arrays["length_limits"] =
        encode(limits(skeleton, branch_of_edge, branches.size(), Branch_measure::length_over_radius));
  }
}

/// Adds the closed curves, one after the other, and the index of the first point of each.
void add_separators(const std::vector<std::vector<Vector3>>& separators, const Frame& frame, Json& arrays)
{
  std::vector<Vector3> points;
  std::vector<Index> offsets{0};
  for (const std::vector<Vector3>& separator : separators) {
    points.insert(points.end(), separator.begin(), separator.end());
    offsets.push_back(Index(points.size()));
  }
  arrays["separator_points"] = encode(frame.positions(points));
  arrays["separator_offsets"] = encode(offsets);
}

Json data_of(const Html_page_content& content)
{
  const Frame frame(content);
  std::vector<Index> triangles;
  for (const auto& triangle : content.surface.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  Json arrays{{"frame", encode(frame.numbers())},
              {"positions", encode(frame.positions(content.surface.points))},
              {"triangles", encode(triangles)},
              {"node_of_vertex", encode(content.surface.node_of_vertex)},
              {"node_positions", encode(frame.positions(content.skeleton.points))},
              {"cut_handles", encode(frame.positions(content.cloud.cut_handles))},
              {"joined_gaps", encode(frame.positions(content.cloud.joined_gaps))}};
  if (content.skeleton.has_radii()) {
    arrays["node_radii"] = encode(content.skeleton.radii);
  }
  add_branches(content.skeleton, arrays);
  add_separators(content.skeleton.separators, frame, arrays);
  return {{"number_of_points", content.cloud.number_of_points}, {"arrays", std::move(arrays)}};
}

} // namespace

void write_html_page(std::ostream& out, const Html_page_content& content, const std::string& title)
{
  const std::string page = html_page_template();
  const std::string title_mark = "@TITLE@";
  const std::string data_mark = "@DATA@";
  const std::size_t title_begin = page.find(title_mark);
  const std::size_t title_end = title_begin + title_mark.size();
  const std::size_t data_begin = page.find(data_mark);
  const std::string title_text =
      boost::algorithm::replace_all_copy(boost::algorithm::replace_all_copy(title, "&", "&amp;"), "<", "&lt;");
  out << page.substr(0, title_begin) << title_text << page.substr(title_end, data_begin - title_end) << data_of(content)
      << page.substr(data_begin + data_mark.size());
  if (!out.flush()) {
    throw File_error(
        "the page could not be written to the stream: check that it is open and that the disk is not full");
  }
}

} // namespace CSCD::internal
