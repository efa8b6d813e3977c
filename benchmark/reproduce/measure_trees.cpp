// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of scans of trees, one JSON object a line: of trees that are known exactly, of two sizes of one scan, and
// of XYZ files. One thread.
//
// Usage: measure_trees SEEDS [FILE...]; SEEDS are numbers with commas between them

#include "Synthetic_tree.h"
#include "Tree_match.h"
#include "sampling.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/extract_tree_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;
using Json = nlohmann::ordered_json;
using CSCD::test::Synthetic_tree;
using CSCD::test::Triple;

/// A way to scan a tree of ten meters.
struct Scan
{
  const char* name;
  std::vector<Triple> (*make)(const Synthetic_tree& tree, unsigned seed);
};

constexpr std::size_t number_of_points = 15000;

std::vector<Triple> seen(const std::vector<Triple>& points, const Triple& scanner)
{
  return CSCD::test::seen_from(points, scanner, 0.0015, 0.1);
}

/// The gaps are 0.5 m wide, in the trunk and in all its limbs.
std::vector<Triple> without_pieces(const Synthetic_tree& tree, std::vector<Triple> points)
{
  for (const CSCD::test::Tree_limb& limb : tree.limbs()) {
    if (limb.order < 2) {
      points = CSCD::test::without_ball(std::move(points), limb.axis[12], 0.25);
    }
  }
  return points;
}

const Scan scans[] = {
    {"all round", [](const Synthetic_tree& tree, unsigned seed) { return tree.scanned(number_of_points, 1, seed); }},
    {"noise of 8 mm",
     [](const Synthetic_tree& tree, unsigned seed) {
       return CSCD::test::shaken(tree.scanned(number_of_points, 1, seed), 0.008, seed + 1);
     }},
    {"fewer points upwards",
     [](const Synthetic_tree& tree, unsigned seed) { return tree.scanned(number_of_points, 0.15, seed); }},
    {"from one side",
     [](const Synthetic_tree& tree, unsigned seed) {
       return CSCD::test::shaken(seen(tree.scanned(2 * number_of_points, 0.5, seed), {12, 0, 1.5}), 0.004, seed);
     }},
    {"from two sides",
     [](const Synthetic_tree& tree, unsigned seed) {
       const std::vector<Triple> all = tree.scanned(2 * number_of_points, 0.5, seed);
       std::vector<Triple> both = seen(all, {12, 0, 1.5});
       const std::vector<Triple> other = seen(all, {-6, 10, 1.5});
       both.insert(both.end(), other.begin(), other.end());
       return CSCD::test::shaken(both, 0.004, seed);
     }},
    {"gaps of 0.5 m", [](const Synthetic_tree& tree, unsigned seed) {
       return without_pieces(tree, tree.scanned(number_of_points, 0.5, seed));
     }}};

std::vector<Point> to_points(const std::vector<Triple>& triples)
{
  std::vector<Point> result;
  for (const Triple& p : triples) {
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

/// Skeletonizes points. \param result gets the counts that need no knowledge of the tree
CSCD::Tree_report skeletonize(const std::vector<Point>& points, Skeleton& skeleton, Json& result)
{
  const std::clock_t begin = std::clock();
  const CSCD::Tree_report report = CSCD::extract_tree_skeleton(points, skeleton);
  result["seconds"] = double(std::clock() - begin) / CLOCKS_PER_SEC;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["megabytes"] = 1.024e-3 * double(usage.ru_maxrss); // of all runs until now
  double length = 0;
  for (const CSCD::Tree_branch& branch : report.branches) {
    length += branch.length;
  }
  result.update({{"points", points.size()},
                 {"objects", report.number_of_objects},
                 {"nodes", report.number_of_nodes},
                 {"branches", report.branches.size()},
                 {"gaps", report.gaps.size()},
                 {"length", length},
                 {"radius_at_base", report.branches.front().radius_at_base}});
  return report;
}

void measure_known(const Scan& scan, unsigned seed)
{
  CSCD::test::Tree_settings settings;
  settings.seed = seed;
  const Synthetic_tree tree(settings);
  Skeleton skeleton;
  Json result{{"kind", "tree"}, {"name", scan.name}, {"seed", seed}};
  const CSCD::Tree_report report = skeletonize(to_points(scan.make(tree, seed)), skeleton, result);
  const auto branches = CSCD::test::found_branches(skeleton, report);
  const CSCD::test::Tree_matching matching(tree.limbs(), branches, 0.3, 0.05, 0.02);
  const CSCD::test::Tree_match& match = matching.result();
  result.update({{"limbs", match.number_of_limbs},
                 {"found", match.found},
                 {"superfluous", match.superfluous},
                 {"right_parents", match.right_parents},
                 {"right_orders", match.right_orders},
                 {"length_error", match.length_error},
                 {"radius_error", match.radius_error},
                 {"distance", match.distance}});
  std::cout << result << std::endl;
}

void measure_points(const char* kind, const std::string& name, const std::vector<Point>& points)
{
  Skeleton skeleton;
  Json result{{"kind", kind}, {"name", name}};
  skeletonize(points, skeleton, result);
  std::cout << result << std::endl;
}

} // namespace

int main(int argc, char** argv)
try {
  for (const std::size_t number : {10000u, 100000u}) {
    const Synthetic_tree tree(CSCD::test::Tree_settings{});
    measure_points("growing", std::to_string(number), to_points(tree.scanned(number, 0.5, 1)));
  }
  std::istringstream seeds(argc > 1 ? argv[1] : "");
  for (std::string seed; std::getline(seeds, seed, ',');) {
    for (const Scan& scan : scans) {
      measure_known(scan, unsigned(std::stoul(seed)));
    }
  }
  for (int i = 2; i < argc; ++i) {
    std::vector<Point> points;
    std::vector<Kernel::Vector_3> normals;
    CSCD::read_points(argv[i], points, normals);
    measure_points("scan", std::filesystem::path(argv[i]).stem().string(), points);
  }
} catch (const std::exception& error) {
  std::cerr << "measure_trees: " << error.what() << '\n';
  return 1;
}
