// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons of point sets, compared with the meshes that the points are drawn from and with the skeletons of these
// meshes: clouds of two densities, with noise, and with missing data, by default and as published; and the cost of up
// to a million points. One thread.
// Meshes are some of CGAL's data, and the closed ones among the OFF files in the folder that the environment variable
// CSCD_MODELS names, if there is one.

#include "convert_shape.h"
#include "sampling.h"
#include "support/Peak_memory.h"
#include "support/mesh_paths.h"
#include "support/run_benchmarks.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Points = std::vector<Point>;
using Mesh = CGAL::Surface_mesh<Point>;
using CSCD::test::Shape;
using CSCD::test::Triple;

/// The sampling of points from a mesh.
struct Sampling
{
  const char* name;
  std::size_t number_of_points;
  double noise = 0;       ///< standard deviation of each coordinate, relative to the mean distance to the nearest point
  unsigned holes = 0;     ///< balls around points; the points inside them are missing
  double hole_radius = 0; ///< relative to the diagonal of the bounding box
};

/// A mesh and the quality of its own skeleton.
struct Body
{
  Shape shape;
  Mesh mesh;
  CSCD::Skeleton_measures measures;
};

CSCD::Skeleton_measures measure(const Mesh& mesh, const CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  // The reconstructed surfaces are not used: they may be coarse.
  return CSCD::evaluate_skeleton(mesh, skeleton, CSCD::parameters::resolution(20));
}

/// The mesh of the last call is kept.
const Body& body_of(const std::string& path)
{
  static std::string last;
  static std::unique_ptr<Body> body;
  if (path != last) {
    body = std::make_unique<Body>();
    CSCD::read_triangle_mesh(path, body->mesh);
    body->shape = CSCD::test::to_shape(body->mesh);
    CSCD::Skeleton_graph<Point, Mesh::Vertex_index> skeleton;
    CSCD::extract_curve_skeleton(body->mesh, skeleton);
    CSCD::Skeleton_graph<Point, std::size_t> plain;
    for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
      plain[add_vertex(plain)].point = skeleton[node].point;
    }
    for (const auto edge : boost::make_iterator_range(edges(skeleton))) {
      add_edge(source(edge, skeleton), target(edge, skeleton), plain);
    }
    body->measures = measure(body->mesh, plain);
    last = path;
  }
  return *body;
}

Points draw(const Shape& shape, const Sampling& sampling, unsigned seed)
{
  std::vector<Triple> triples = CSCD::test::sampled(shape, sampling.number_of_points, seed);
  const std::vector<Triple> centers(triples.begin(), triples.begin() + sampling.holes);
  for (const Triple& center : centers) {
    triples = CSCD::test::without_ball(std::move(triples), center, sampling.hole_radius * diagonal(shape));
  }
  const double deviation = sampling.noise * CSCD::test::mean_spacing(shape, sampling.number_of_points);
  triples = CSCD::test::shaken(std::move(triples), deviation, seed + 1);
  Points points;
  points.reserve(triples.size());
  for (const Triple& p : triples) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

using Skeletonize = void (*)(const Points& points, CSCD::Skeleton_graph<Point, std::size_t>& skeleton);

void skeletonize_by_default(const Points& points, CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  CSCD::extract_curve_skeleton(points, skeleton);
}

/// Fewer sources than in the published experiments: more make little difference.
void skeletonize_as_published(const Points& points, CSCD::Skeleton_graph<Point, std::size_t>& skeleton)
{
  constexpr std::size_t number_of_sources = 1000;
  CSCD::extract_curve_skeleton(
      points, skeleton,
      CSCD::parameters::policies(CSCD::Published_policies()).maximum_number_of_sources(number_of_sources));
}

/// Skeletonizes a cloud and compares the skeleton with that of the mesh.
void run(benchmark::State& state, Skeletonize skeletonize, const std::string& path, const Sampling& sampling,
         bool is_evaluated)
{
  const Body& body = body_of(path);
  const Points points = draw(body.shape, sampling, 1);
  const CSCD::benchmark::Peak_memory peak_memory;
  CSCD::Skeleton_graph<Point, std::size_t> skeleton;
  for (auto _ : state) {
    skeletonize(points, skeleton);
  }
  state.counters["megabytes"] = peak_memory.megabytes();
  state.counters["points"] = double(points.size());
  if (is_evaluated) {
    const CSCD::Skeleton_measures measures = measure(body.mesh, skeleton);
    state.counters["genus"] = double(measures.position.genus);
    state.counters["betti_number"] = double(measures.counts.betti_number);
    state.counters["surface_components"] = double(measures.position.number_of_surface_components);
    state.counters["components"] = double(measures.counts.number_of_components);
    state.counters["tips"] = double(measures.counts.number_of_tips);
    state.counters["tips_of_mesh"] = double(body.measures.counts.number_of_tips);
    state.counters["percent_inside"] = 100 * measures.position.fraction_of_length_inside;
    state.counters["percent_inside_of_mesh"] = 100 * body.measures.position.fraction_of_length_inside;
    state.counters["error"] = measures.mean_distance_from_round_cones;
    state.counters["error_of_mesh"] = body.measures.mean_distance_from_round_cones;
  }
}

/// The closed ones among the meshes to measure.
std::vector<std::string> mesh_paths()
{
  std::vector<std::string> paths =
      CSCD::benchmark::mesh_paths({"armadillo", "bear", "bull", "cactus", "camel", "cow", "dino", "elephant", "elk",
                                   "femur", "hand", "homer", "knot1", "knot2", "man", "triceratops"});
  const auto is_open = [](const std::string& path) {
    Mesh mesh;
    CSCD::read_triangle_mesh(path, mesh);
    return !CGAL::is_closed(mesh);
  };
  paths.erase(std::remove_if(paths.begin(), paths.end(), is_open), paths.end());
  return paths;
}

void add(const std::string& name, Skeletonize skeletonize, const std::string& path, const Sampling& sampling,
         bool is_evaluated)
{
  benchmark::RegisterBenchmark(name.c_str(), run, skeletonize, path, sampling, is_evaluated)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->MeasureProcessCPUTime();
}

void add_clouds()
{
  for (const std::string& path : mesh_paths()) {
    for (const Sampling& sampling :
         {Sampling{"uniform, 5,000", 5000}, Sampling{"uniform, 20,000", 20000}, Sampling{"noise, 20,000", 20000, 0.3},
          Sampling{"holes, 20,000", 20000, 0, 10, 0.02}}) {
      const std::string name = std::filesystem::path(path).stem().string() + '/' + sampling.name;
      add("cloud/" + name, skeletonize_by_default, path, sampling, true);
      add("published/" + name, skeletonize_as_published, path, sampling, true);
    }
  }
}

void add_growing_cloud()
{
  for (const std::size_t number : {5000u, 20000u, 100000u, 300000u, 1000000u}) {
    add("growing/armadillo/" + std::to_string(number), skeletonize_by_default, CSCD::benchmark::cgal_mesh("armadillo"),
        {"", number, 0.3}, false);
  }
}

} // namespace

int main(int argc, char** argv)
{
  return CSCD::benchmark::run_benchmarks(argc, argv, [] {
    add_clouds();
    add_growing_cloud();
  });
}
