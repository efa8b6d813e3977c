// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of scans of trees, compared with trees that are known exactly, with seeds that were used to choose
// constants and with other seeds; of the scans, XYZ files, in the folder that the environment variable
// CSCD_BENCHMARK_TREES names, if any; and the cost of up to 100,000 points. One thread.

#include "Synthetic_tree.h"
#include "Tree_match.h"
#include "found_branches.h"
#include "sampling.h"
#include "support/Peak_memory.h"
#include "support/run_benchmarks.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Tree/extract_tree_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
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

const std::vector<Scan>& scans()
{
  static const std::vector<Scan> result{
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
  return result;
}

std::vector<Point> to_points(const std::vector<Triple>& triples)
{
  std::vector<Point> result;
  for (const Triple& p : triples) {
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

using Skeleton = CSCD::Skeleton_graph<Point, std::size_t>;

CSCD::Tree_report skeletonize(benchmark::State& state, const std::vector<Point>& points, Skeleton& skeleton)
{
  const CSCD::benchmark::Peak_memory peak_memory;
  CSCD::Tree_report report;
  for (auto _ : state) {
    report = CSCD::extract_tree_skeleton(points, skeleton);
  }
  double length = 0;
  for (const CSCD::Tree_branch& branch : report.branches) {
    length += branch.length;
  }
  state.counters["megabytes"] = peak_memory.megabytes();
  state.counters["points"] = double(points.size());
  state.counters["objects"] = double(report.number_of_objects);
  state.counters["nodes"] = double(report.number_of_nodes);
  state.counters["branches"] = double(report.branches.size());
  state.counters["gaps"] = double(report.gaps.size());
  state.counters["length"] = length;
  state.counters["radius_at_base"] = report.branches.front().radius_at_base;
  return report;
}

void skeletonize_synthetic(benchmark::State& state, const Scan& scan, unsigned seed)
{
  CSCD::test::Tree_settings settings;
  settings.seed = seed;
  const Synthetic_tree tree(settings);
  Skeleton skeleton;
  const CSCD::Tree_report report = skeletonize(state, to_points(scan.make(tree, seed)), skeleton);
  const auto branches = CSCD::test::found_branches(skeleton, report);
  const CSCD::test::Tree_matching matching(tree.limbs(), branches, 0.3, 0.05, 0.02);
  const CSCD::test::Tree_match& match = matching.result();
  state.counters["limbs"] = double(match.number_of_limbs);
  state.counters["found"] = double(match.found);
  state.counters["superfluous"] = double(match.superfluous);
  state.counters["right_parents"] = double(match.right_parents);
  state.counters["right_orders"] = double(match.right_orders);
  state.counters["length_error"] = match.length_error;
  state.counters["radius_error"] = match.radius_error;
  state.counters["radius_bias"] = match.radius_bias;
  state.counters["distance"] = match.distance;
}

void skeletonize_file(benchmark::State& state, const std::string& path)
{
  std::vector<Point> points;
  std::vector<Kernel::Vector_3> normals;
  CSCD::read_points(path, points, normals);
  Skeleton skeleton;
  skeletonize(state, points, skeleton);
}

void skeletonize_growing(benchmark::State& state, std::size_t number)
{
  const std::vector<Point> points = to_points(Synthetic_tree(CSCD::test::Tree_settings{}).scanned(number, 0.5, 1));
  Skeleton skeleton;
  skeletonize(state, points, skeleton);
}

template <class Function, class... Arguments>
void add(const std::string& name, const Function& function, const Arguments&... arguments)
{
  benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->MeasureProcessCPUTime();
}

void add_files()
{
  const char* folder = std::getenv("CSCD_BENCHMARK_TREES");
  if (folder == nullptr) {
    return;
  }
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".xyz") {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths) {
    add("scan/" + std::filesystem::path(path).stem().string(), skeletonize_file, path);
  }
}

} // namespace

int main(int argc, char** argv)
{
  return CSCD::benchmark::run_benchmarks(argc, argv, [] {
    for (const Scan& scan : scans()) {
      for (const unsigned seed : {1u, 2u, 3u, 4u, 11u, 12u, 13u, 14u, 15u, 16u}) {
        const std::string kind = seed < 10 ? "tree/chosen/" : "tree/other/";
        add(kind + scan.name + '/' + std::to_string(seed), skeletonize_synthetic, scan, seed);
      }
    }
    add_files();
    for (const std::size_t number : {10000u, 100000u}) {
      add("growing_tree/" + std::to_string(number), skeletonize_growing, number);
    }
  });
}
