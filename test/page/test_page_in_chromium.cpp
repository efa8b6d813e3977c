// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loads the viewer page in headless Chromium with a script behind it, self_test.js, that works all switches, compares
// the pixels before and after, and writes its findings into an element. Skipped without Chromium, and where three.js
// was not found when this was built.

#include "support/Temporary_folder.h"
#include "support/fork_in_box.h"
#include "support/skip_or_fail.h"
#include "write_html_page.h"
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Measure/split_into_branches.h>
#include <CSCD/Named_parameters.h>
#include <CSCD/Skeleton_graph.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/algorithm/string/replace.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CSCD::test::Box_mesh;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using Separators = std::vector<std::vector<Point>>;
using CSCD::test::box_mesh, CSCD::test::fork_in_box;

class Page_in_chromium : public testing::Test
{
protected:
  void SetUp() override
  {
    std::istringstream(output_of("command -v chromium || command -v chromium-browser || command -v google-chrome")) >>
        m_chromium;
    if (m_chromium.empty()) {
      CSCD_TEST_SKIP_OR_FAIL("Chromium is not installed (package chromium)");
    }
    if (!CSCD::has_three_js()) {
      CSCD_TEST_SKIP_OR_FAIL("three.js was not found when this test was built (package libjs-three)");
    }
  }

  template <class AnySkeleton>
  static std::string page_of(const Mesh& mesh, const AnySkeleton& skeleton, const Separators& separators = {})
  {
    std::ostringstream out;
    CSCD::write_html_page(out, mesh, skeleton, separators, "A page <to> be \"tested\" & seen");
    return out.str();
  }

  /// The standard output of a shell command.
  std::string output_of(const std::string& command) const
  {
    const std::string file = m_folder.file("output");
    std::ignore = std::system(("(" + command + ") > '" + file + "'").c_str());
    return test_support::read_file(file);
  }

  /// The findings of the script that is put behind the scripts of `page`, or of its function `only` if that is given.
  /// Graphics are computed in software, so that the test runs on machines without display and graphics card; network
  /// services of the browser are off. The time limit is many times what it takes.
  std::string self_test(std::string page, const std::string& only = "") const
  {
    const std::string script = test_support::read_file(CSCD_SELF_TEST);
    boost::algorithm::replace_last(page, "</body>", "<script type=\"module\">\n" + script + "</script>\n</body>");
    const std::string file = m_folder.write("page.html", page);
    const std::string command =
        "timeout 120 " + m_chromium +
        " --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist"
        " --no-first-run --disable-background-networking --disable-component-update --disable-sync --disable-quic"
        " --disable-dev-shm-usage --window-size=640,420 --virtual-time-budget=5000 --user-data-dir='" +
        m_folder.file("profile") + "' --dump-dom 'file://" + file + "?" + only + "' 2>/dev/null";
    const std::string dom = output_of(command);
    const std::string begin = "<pre id=\"selftest\">";
    const std::size_t first = dom.find(begin);
    return first == std::string::npos
               ? "no self test in the page; the browser gave " + std::to_string(dom.size()) + " characters"
               : dom.substr(first + begin.size(), dom.find("</pre>", first) - first - begin.size());
  }

  test_support::Temporary_folder m_folder;
  std::string m_chromium;
};

Separators girdles_of(const Skeleton& skeleton)
{
  Separators separators;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const Point p = skeleton[i].point;
    separators.push_back({p + Kernel::Vector_3(0, 0.5, 0.5), p + Kernel::Vector_3(0, -0.5, 0.5),
                          p + Kernel::Vector_3(0, -0.5, -0.5), p + Kernel::Vector_3(0, 0.5, -0.5)});
  }
  return separators;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST_F(Page_in_chromium, draws_and_all_switches_work)
{
  const Mesh mesh = box_mesh();
  const auto skeleton = fork_in_box<Skeleton>(mesh);
  const std::string result = self_test(page_of(mesh, skeleton, girdles_of(skeleton)));
  EXPECT_TRUE(contains(result, "selftest passed")) << result;
  EXPECT_FALSE(contains(result, "failed")) << result;
  for (const char* name : {"surface", "skeleton", "nodes", "balls", "separators", "color"}) {
    EXPECT_TRUE(contains(result, std::string("ok switch ") + name + ":")) << name << '\n' << result;
  }
  for (const char* line : {"coloring significance:", "clip z:", "row: node 0, degree", "png of", "svg:", "address:"}) {
    EXPECT_TRUE(contains(result, std::string("ok ") + line)) << line << '\n' << result;
  }
}

/// The text of the page at a threshold: the counts of the skeleton that the library prunes by it.
template <class Report>
std::string line_of(const std::string& slider, int threshold, const Report& report, std::size_t number_of_branches)
{
  return slider + ' ' + std::to_string(threshold) + ": " + std::to_string(report.number_of_nodes) + " nodes, " +
         std::to_string(report.number_of_edges) + " edges, " + std::to_string(number_of_branches) + " branches, " +
         std::to_string(report.number_of_tips) + " tips, " + std::to_string(report.number_of_junctions) +
         " junctions, " + std::to_string(report.betti_number) + " cycles";
}

TEST_F(Page_in_chromium, sliders_prune_as_the_library_does)
{
  // A spine with limbs of all lengths and radii, twigs on limbs, a cycle, and an isolated node.
  const Mesh mesh = box_mesh();
  Skeleton skeleton;
  std::mt19937 random(3);
  const auto number = [&](double greatest) { return std::uniform_real_distribution<double>(0.1, greatest)(random); };
  for (std::size_t i = 0; i < 120; ++i) {
    const std::size_t node = add_vertex(skeleton);
    const std::size_t parent = i == 0 ? 0 : i % 3 == 0 ? random() % i : i - 1;
    const Point& from = skeleton[parent].point;
    skeleton[node].point =
        i == 0 ? Point(-1.5, 0, 0) : from + 0.3 * Kernel::Vector_3(number(1), number(1) - 0.5, number(1));
    skeleton[node].radius = number(0.3);
    if (i > 0 && i < 119) {
      add_edge(parent, node, skeleton);
    }
  }
  add_edge(2, 50, skeleton);
  const std::string result = self_test(page_of(mesh, skeleton), "check_detail");
  EXPECT_TRUE(contains(result, "selftest passed")) << result;
  EXPECT_TRUE(contains(result, "ok slider significance:")) << result;
  std::set<std::size_t> sizes;
  for (const int threshold : {1, 2, 4, 8}) {
    Skeleton significant = skeleton;
    const auto report = CSCD::simplify_skeleton(significant, CSCD::parameters::minimum_significance(threshold));
    const std::string line = line_of("significance", threshold, report, CSCD::split_into_branches(significant).size());
    EXPECT_TRUE(contains(result, line)) << line << '\n' << result;
    sizes.insert(report.number_of_nodes);
    Skeleton slender = skeleton;
    const auto other = CSCD::simplify_skeleton(slender, CSCD::parameters::minimum_length_over_radius(threshold));
    const std::string other_line = line_of("length", threshold, other, CSCD::split_into_branches(slender).size());
    EXPECT_TRUE(contains(result, other_line)) << other_line << '\n' << result;
  }
  EXPECT_GE(sizes.size(), 3u);
}

TEST_F(Page_in_chromium, does_without_radii_and_separators)
{
  using Cgal_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
  const Mesh mesh = box_mesh();
  const std::string result = self_test(page_of(mesh, fork_in_box<Cgal_skeleton>(mesh)));
  EXPECT_TRUE(contains(result, "selftest passed")) << result;
  EXPECT_TRUE(contains(result, "absent balls")) << result;
  EXPECT_TRUE(contains(result, "absent detail")) << result;
  EXPECT_TRUE(contains(result, "absent separators")) << result;
}

TEST_F(Page_in_chromium, tells_what_went_wrong)
{
  const Mesh mesh = box_mesh();
  const std::string page = page_of(mesh, fork_in_box<Skeleton>(mesh));
  const auto with_script = [&](const std::string& script) {
    return boost::algorithm::replace_first_copy(page, "<body>", "<body>\n<script>\n" + script + "\n</script>");
  };
  const std::string without_three =
      self_test(with_script("Object.defineProperty(window, 'THREE', {value: Object.freeze({})});"));
  EXPECT_TRUE(contains(without_three, "written without three.js")) << without_three;
  EXPECT_FALSE(contains(without_three, "selftest passed")) << without_three;

  const std::string with_errors =
      self_test(with_script("console.error('a complaint');\nnew Image().src = 'file:///picture.png';"), "check_resize");
  EXPECT_TRUE(contains(with_errors, "failed error: a complaint")) << with_errors;
  EXPECT_TRUE(contains(with_errors, "content security policy")) << with_errors;
  EXPECT_FALSE(contains(with_errors, "selftest passed")) << with_errors;
}

} // namespace
