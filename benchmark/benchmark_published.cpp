// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method beside the local one: quality and time of both, and of the published one with other targets and
// shortenings, numbers of sources, with noise, and with fewer vertices. One thread.
// Meshes are the closed ones among the OFF files in the folder that the environment variable CSCD_BENCHMARK_MESHES
// names, by default some of CGAL's data.

#include "convert_shape.h"
#include "shape_operations.h"
#include "support/mesh_paths.h"
#include "support/run_benchmarks.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Separator/Shortening_rule.h>
#include <CSCD/Separator/Target_rule.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/helpers.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using CSCD::Shortening_rule;
using CSCD::Target_rule;

/// What is done to a mesh, and how its skeleton is computed.
struct Variant
{
  bool is_published = true;
  std::optional<std::size_t> number_of_sources{};
  Target_rule target_rule = Target_rule::nearest_in_space;
  Shortening_rule shortening_rule = Shortening_rule::edge_flips;
  double noise = 0;         ///< standard deviation of each coordinate, relative to the mean edge length
  double edges_to_keep = 1; ///< of all edges, when the mesh is simplified
};

Mesh prepare(const std::string& path, const Variant& variant)
{
  Mesh mesh;
  CSCD::read_triangle_mesh(path, mesh);
  if (variant.noise > 0) {
    const CSCD::test::Shape shape = CSCD::test::to_shape(mesh);
    mesh = CSCD::test::to_mesh<Mesh>(CSCD::test::noisy(shape, variant.noise * CSCD::test::mean_edge_length(shape), 1));
  }
  if (variant.edges_to_keep < 1) {
    CGAL::Surface_mesh_simplification::Count_ratio_stop_predicate<Mesh> stop(variant.edges_to_keep);
    CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
    mesh.collect_garbage();
  }
  return mesh;
}

template <class Policies>
void measure(benchmark::State& state, const Mesh& mesh, const Mesh& original, const Policies& policies,
             const Variant& variant)
{
  CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
  CSCD::Skeletonization_report report;
  for (auto _ : state) {
    const Traits traits(mesh);
    CSCD::Curve_skeletonization<Traits, Policies> skeletonization(traits, policies);
    if (variant.number_of_sources) {
      skeletonization.set_maximum_number_of_sources(*variant.number_of_sources);
    }
    report = skeletonization(skeleton);
  }
  // Of the reconstructed surfaces nothing is used: they may be coarse.
  const CSCD::Skeleton_measures measures =
      CSCD::evaluate_skeleton(original, skeleton, CSCD::parameters::resolution(20));
  state.counters["vertices"] = double(num_vertices(mesh));
  state.counters["sources"] = double(report.number_of_sources);
  state.counters["packed"] = double(report.number_of_packed_separators);
  state.counters["genus"] = double(measures.position.genus);
  state.counters["betti_number"] = double(measures.counts.betti_number);
  state.counters["surface_components"] = double(measures.position.number_of_surface_components);
  state.counters["components"] = double(measures.counts.number_of_components);
  state.counters["tips"] = double(measures.counts.number_of_tips);
  state.counters["percent_inside"] = 100 * measures.position.fraction_of_length_inside;
  state.counters["error"] = measures.mean_distance_from_round_cones;
}

/// The error is measured against the mesh without noise and with all its vertices.
void skeletonize(benchmark::State& state, const std::string& path, const Variant& variant)
{
  const Mesh original = prepare(path, {});
  const Mesh mesh = prepare(path, variant);
  if (variant.is_published) {
    const CSCD::Published_policies<Traits> policies(variant.target_rule, variant.shortening_rule);
    measure(state, mesh, original, policies, variant);
  } else {
    measure(state, mesh, original, CSCD::Local_policies<Traits>(), variant);
  }
}

void add(const std::string& name, const std::string& path, const Variant& variant)
{
  benchmark::RegisterBenchmark(name.c_str(), skeletonize, path, variant)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->MeasureProcessCPUTime();
}

void add_methods(const std::vector<std::string>& paths)
{
  // The variational flow takes several times as long as edge flips: fewer sources must do to compare the two.
  constexpr std::size_t few = 500;
  for (const std::string& path : paths) {
    const std::string prefix = "method/" + std::filesystem::path(path).stem().string() + '/';
    add(prefix + "local", path, {false});
    add(prefix + "published", path, {});
    add(prefix + "geodesic target", path, {true, {}, Target_rule::nearest_along_surface});
    add(prefix + "flips, 500 sources", path, {true, few});
    add(prefix + "variational, 500 sources", path,
        {true, few, Target_rule::nearest_in_space, Shortening_rule::variational});
  }
}

void add_numbers_of_sources(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths) {
    for (std::size_t number = 8; number <= 8192; number *= 4) {
      add("sources/" + std::filesystem::path(path).stem().string() + '/' + std::to_string(number), path,
          {true, number});
    }
  }
}

void add_noise_and_resolution(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths) {
    const std::string mesh = std::filesystem::path(path).stem().string() + '/';
    for (const bool is_published : {false, true}) {
      const std::string method = is_published ? "/published" : "/local";
      for (const int percent : {0, 10, 20, 30, 50}) {
        Variant variant{is_published};
        variant.noise = percent / 100.;
        add("noise/" + mesh + std::to_string(percent) + method, path, variant);
      }
      for (const int part : {1, 2, 4, 8}) {
        Variant variant{is_published};
        variant.edges_to_keep = 1. / part;
        add("resolution/" + mesh + std::to_string(part) + method, path, variant);
      }
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  return CSCD::benchmark::run_benchmarks(argc, argv, [] {
    add_methods(CSCD::benchmark::mesh_paths(
        {"armadillo", "camel", "cow", "dino", "elephant", "femur", "hand", "homer", "knot1", "triceratops"}));
    const std::vector<std::string> two = {CSCD::benchmark::cgal_mesh("camel"), CSCD::benchmark::cgal_mesh("elephant")};
    add_numbers_of_sources(two);
    add_noise_and_resolution(two);
  });
}
