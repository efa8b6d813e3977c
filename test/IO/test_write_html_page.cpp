// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data of the viewer page; its scripts are tested in test/page.

#include "mesh_files.h"
#include "support/Shape.h"
#include "support/fork_in_box.h"
#include "write_html_page.h"
#include "write_in_foreign_locale.h"
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CSCD::test::Box_mesh;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using Separators = std::vector<std::vector<Point>>;
using CSCD::test::box_mesh, CSCD::test::fork_in_box;

constexpr std::uint32_t none = CSCD::no_index;

template <class AnyMesh, class AnySkeleton>
std::string page_of(const AnyMesh& mesh, const AnySkeleton& skeleton, const Separators& separators = {},
                    const std::string& title = "title")
{
  std::ostringstream out;
  CSCD::write_html_page(out, mesh, skeleton, separators, title);
  return out.str();
}

nlohmann::json data_of(const std::string& page)
{
  const std::string begin = "id=\"cscd-data\">";
  const std::size_t first = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

template <class Number>
std::vector<Number> array_of(const nlohmann::json& data, const std::string& name)
{
  const std::string bytes = test_support::from_base64(data["arrays"][name][1]);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

std::size_t occurrences(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// The page without its first `<script>` behind the data, which is three.js.
std::string without_three_js(const std::string& page)
{
  const std::string begin = "<script>";
  const std::size_t first = page.find(begin, page.find("id=\"cscd-data\""));
  return page.substr(0, first) + page.substr(page.find("</script>", first));
}

TEST(Write_html_page, keeps_positions_far_from_the_origin)
{
  const CSCD::test::Triple middle{1e9, -2e9, 3e9};
  const Mesh mesh = box_mesh(middle);
  const nlohmann::json data = data_of(page_of(mesh, fork_in_box<Skeleton>(mesh, middle)));
  const auto frame = array_of<double>(data, "frame");
  const auto positions = array_of<float>(data, "positions");
  ASSERT_EQ(frame.size(), 4u);
  ASSERT_EQ(positions.size(), 3 * num_vertices(mesh));
  constexpr double rounding = 1e-6; // of coordinates between -1 and 1 to single precision, and of those near 1e9
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float coordinate = positions[3 * v.idx() + i];
      EXPECT_LE(std::abs(coordinate), 1);
      EXPECT_NEAR(frame[i] + frame[3] * static_cast<double>(coordinate), mesh.point(v)[static_cast<int>(i)], rounding);
    }
  }
  EXPECT_EQ(array_of<double>(data, "node_radii"), std::vector<double>(5, CSCD::test::fork_radius));
}

TEST(Write_html_page, survives_extreme_and_missing_extents)
{
  for (const double size : {1e-310, 1e-200, 1e200, 1.5e308}) {
    Mesh mesh;
    CGAL::make_triangle(Point(-size, 0, 0), Point(size, 0, 0), Point(0, size, 0), mesh);
    const auto positions = array_of<float>(data_of(page_of(mesh, Skeleton())), "positions");
    EXPECT_EQ(positions, (std::vector<float>{-1, -0.5, 0, 1, -0.5, 0, 0, 0.5, 0})) << size;
  }
  Skeleton one_node(1);
  one_node[0].point = Point(7, 7, 7);
  EXPECT_EQ(array_of<float>(data_of(page_of(Mesh(), one_node)), "node_positions"), (std::vector<float>{0, 0, 0}));
  EXPECT_TRUE(array_of<float>(data_of(page_of(Mesh(), Skeleton())), "node_positions").empty());
}

TEST(Write_html_page, says_what_belongs_to_which_branch)
{
  const Mesh mesh = box_mesh();
  const nlohmann::json data = data_of(page_of(mesh, fork_in_box<Skeleton>(mesh)));
  const auto of_node = array_of<std::uint32_t>(data, "branch_of_node");
  const auto of_edge = array_of<std::uint32_t>(data, "branch_of_edge");
  ASSERT_EQ(of_node.size(), 5u);
  ASSERT_EQ(of_edge.size(), 4u);
  EXPECT_EQ(of_node[2], none);
  EXPECT_EQ(of_node[0], of_node[1]);
  EXPECT_EQ(of_edge[0], of_node[0]);
  EXPECT_EQ(of_edge[1], of_node[0]);
  EXPECT_EQ(of_edge[2], of_node[3]);
  EXPECT_EQ(of_edge[3], of_node[4]);
  EXPECT_NE(of_node[3], of_node[4]);
  const auto of_vertex = array_of<std::uint32_t>(data, "node_of_vertex");
  for (std::uint32_t v = 0; v < of_vertex.size(); ++v) {
    EXPECT_EQ(of_vertex[v], v % 5);
  }
}

TEST(Write_html_page, knows_cycles_and_lone_nodes)
{
  const auto skeleton =
      CSCD::test::to_graph<Skeleton>({{0, 0, 0}, {1, 1, 0}, {2, 4, 0}, {3, 9, 0}}, {{0, 1}, {1, 2}, {2, 0}});
  const nlohmann::json data = data_of(page_of(Mesh(), skeleton));
  EXPECT_EQ(array_of<double>(data, "branch_lengths").size(), 2u);
  const auto of_node = array_of<std::uint32_t>(data, "branch_of_node");
  ASSERT_EQ(of_node.size(), 4u);
  EXPECT_EQ(of_node[1], of_node[0]);
  EXPECT_EQ(of_node[2], of_node[0]);
  EXPECT_NE(of_node[3], of_node[0]);
  EXPECT_EQ(array_of<std::uint32_t>(data, "branch_of_edge"), std::vector<std::uint32_t>(3, of_node[0]));
}

TEST(Write_html_page, measures_branches_as_tables_do)
{
  const Mesh mesh = box_mesh();
  const auto skeleton = fork_in_box<Skeleton>(mesh);
  const nlohmann::json data = data_of(page_of(mesh, skeleton));
  const CSCD::Skeleton_branches table = CSCD::measure_branches(skeleton);
  ASSERT_EQ(array_of<double>(data, "branch_lengths").size(), 3u);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(array_of<double>(data, "branch_lengths")[b], table.branches[b].length);
    EXPECT_EQ(array_of<double>(data, "branch_radii")[b], table.branches[b].mean_radius);
    EXPECT_EQ(array_of<double>(data, "branch_significances")[b], table.branches[b].significance);
  }
}

TEST(Write_html_page, limits_branches_where_pruning_cuts_them)
{
  const Mesh mesh = box_mesh();
  const auto skeleton = fork_in_box<Skeleton>(mesh);
  const nlohmann::json data = data_of(page_of(mesh, skeleton));
  const auto limits = array_of<double>(data, "significance_limits");
  ASSERT_EQ(limits.size(), 3u);
  // The handle, of two edges, is the shortest limb. The prongs are the path that is left.
  EXPECT_EQ(std::count(limits.begin(), limits.end(), std::numeric_limits<double>::infinity()), 2);
  const double least = *std::min_element(limits.begin(), limits.end());
  const auto edges_left = [&](double threshold) {
    Skeleton pruned = skeleton;
    return CSCD::simplify_skeleton(pruned, CSCD::parameters::minimum_significance(threshold)).number_of_edges;
  };
  EXPECT_EQ(edges_left(least), 4u);
  EXPECT_EQ(edges_left(std::nextafter(least, 2 * least)), 2u);
}

TEST(Write_html_page, lists_separators)
{
  const Mesh mesh = box_mesh();
  const Separators separators{{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {}, {Point(2, 1, 1), Point(1, 0, 0)}};
  const nlohmann::json data = data_of(page_of(mesh, fork_in_box<Skeleton>(mesh), separators));
  EXPECT_EQ(array_of<std::uint32_t>(data, "separator_offsets"), (std::vector<std::uint32_t>{0, 3, 3, 5}));
  EXPECT_EQ(array_of<float>(data, "separator_points").size(), 15u);
}

TEST(Write_html_page, reads_other_meshes_and_cgals_skeleton)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Polyhedron mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  CGAL::Mean_curvature_flow_skeletonization<Polyhedron>::Skeleton skeleton(1);
  skeleton[0].point = Point(0.1, 0.1, 0.1);
  skeleton[0].vertices.assign(vertices(mesh).begin(), vertices(mesh).end());
  const nlohmann::json data = data_of(page_of(mesh, skeleton));
  EXPECT_FALSE(data["arrays"].contains("node_radii"));
  EXPECT_EQ(array_of<std::uint32_t>(data, "node_of_vertex"), (std::vector<std::uint32_t>(4, 0)));
}

TEST(Write_html_page, numbers_vertices_without_the_removed_ones)
{
  Mesh mesh;
  mesh.remove_vertex(mesh.add_vertex(Point(9, 9, 9)));
  const auto kept = mesh.add_vertex(Point(5, 5, 5));
  const auto removed = mesh.add_vertex(Point(9, 9, 9));
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), mesh);
  mesh.remove_vertex(removed);
  mesh.remove_vertex(kept);
  const nlohmann::json data = data_of(page_of(mesh, Skeleton()));
  EXPECT_EQ(array_of<float>(data, "positions").size(), 9u);
  for (const std::uint32_t v : array_of<std::uint32_t>(data, "triangles")) {
    EXPECT_LT(v, 3u);
  }
}

TEST(Write_html_page, escapes_the_title)
{
  const std::string page = page_of(Mesh(), Skeleton(), {}, "<b>\"&'</title>@DATA@");
  EXPECT_NE(page.find("<title>&lt;b>\"&amp;'&lt;/title>@DATA@</title>"), std::string::npos);
  EXPECT_EQ(occurrences(page, "<b>\""), 0u);
}

TEST(Write_html_page, has_scripts_that_end_where_they_should)
{
  const std::string page = page_of(Mesh(), Skeleton());
  EXPECT_EQ(occurrences(page, "<script"), 4u); // errors, data, three.js, modules
  EXPECT_EQ(occurrences(page, "</script"), 4u);
  EXPECT_EQ(occurrences(page, "<!--"), 1u); // the license
  EXPECT_EQ(occurrences(page, "\nimport "), 0u);
  EXPECT_EQ(occurrences(page, "\nexport "), 0u);
}

TEST(Write_html_page, needs_no_other_file)
{
  const std::string page = without_three_js(page_of(Mesh(), Skeleton()));
  for (const char* reference : {"http:", "https:", " src=", "href=", "url(", "import ", "fetch(", "XMLHttpRequest"}) {
    EXPECT_EQ(occurrences(page, reference), 0u) << reference;
  }
  EXPECT_EQ(occurrences(page, "default-src 'none'"), 1u);
}

TEST(Write_html_page, does_not_depend_on_the_locale)
{
  const Mesh mesh = box_mesh();
  std::ostringstream out;
  out.imbue(std::locale(std::locale::classic(), new test_support::Foreign_punctuation));
  CSCD::write_html_page(out, mesh, fork_in_box<Skeleton>(mesh), Separators(), "title");
  EXPECT_EQ(out.str(), page_of(mesh, fork_in_box<Skeleton>(mesh)));
}

TEST(Write_html_page, reports_a_stream_that_fails)
{
  std::ostream closed(nullptr);
  EXPECT_THROW(CSCD::write_html_page(closed, Mesh(), Skeleton(), Separators(), ""), CSCD::File_error);
}

TEST(Write_html_page, wants_triangles)
{
  Mesh mesh;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), mesh);
  EXPECT_THROW(page_of(mesh, Skeleton()), CGAL::Precondition_exception);
}

} // namespace
