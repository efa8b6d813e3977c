// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole skeletonization of real meshes, compared with CGAL's mean curvature flow (MCF), with the quality of the
// skeletons; and its cost from a few thousand to some million vertices. CPU time is that of the whole process, all
// threads.
// Meshes are some of CGAL's data, and the OFF files in the folder that the environment variable CSCD_MODELS names, if
// there is one.

#include "Inside_count.h"
#include "Surface_facts.h"
#include "invariants.h"
#include "support/Peak_memory.h"
#include "support/mesh_paths.h"
#include "support/run_benchmarks.h"
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeleton = CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>;
using Mcf_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;

/// MCF takes seconds beyond this number of vertices.
constexpr std::size_t max_for_mcf = 50000;

/// A file and how often its mesh is subdivided after Loop.
struct Source
{
  std::string path;
  int subdivisions;

  friend bool operator==(const Source& a, const Source& b)
  {
    return a.path == b.path && a.subdivisions == b.subdivisions;
  }
};

/// The mesh of the last call is kept.
const Mesh& mesh_of(const Source& source)
{
  static Source last;
  static Mesh mesh;
  if (!(source == last)) {
    mesh = Mesh();
    CSCD::read_triangle_mesh(source.path, mesh);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh,
                                                 CGAL::parameters::number_of_iterations(unsigned(source.subdivisions)));
    mesh.collect_garbage();
    mesh.shrink_to_fit();
    last = source;
  }
  return mesh;
}

/// Runs `extract(mesh, skeleton)`, and counts properties of the skeleton.
template <class AnySkeleton, class Extract>
void run(benchmark::State& state, const Source& source, const Extract& extract)
{
  const Mesh& mesh = mesh_of(source);
  const CSCD::benchmark::Peak_memory peak_memory;
  AnySkeleton skeleton;
  for (auto _ : state) {
    skeleton = AnySkeleton();
    extract(mesh, skeleton);
  }
  state.counters["megabytes"] = peak_memory.megabytes();
  state.counters["vertices"] = double(num_vertices(mesh));
  state.SetComplexityN(std::int64_t(num_vertices(mesh)));
  const CSCD::test::Skeleton_facts facts = CSCD::test::skeleton_facts(skeleton);
  state.counters["nodes"] = double(facts.number_of_nodes);
  state.counters["tips"] = double(facts.number_of_tips);
  state.counters["betti_number"] = double(facts.betti_number);
  if (num_vertices(mesh) <= max_for_mcf) {
    state.counters["genus"] = double(CSCD::test::surface_facts(mesh).genus);
    state.counters["percent_inside"] = 100 * CSCD::test::count_inside(mesh, skeleton).fraction_of_length_inside();
  }
}

void sequential(benchmark::State& state, const Source& source)
{
  run<Skeleton>(state, source,
                [](const Mesh& mesh, Skeleton& skeleton) { CSCD::extract_curve_skeleton(mesh, skeleton); });
}

void on_two_threads(benchmark::State& state, const Source& source)
{
  run<Skeleton>(state, source, [](const Mesh& mesh, Skeleton& skeleton) {
    CSCD::extract_curve_skeleton<CGAL::Parallel_if_available_tag>(mesh, skeleton,
                                                                  CSCD::parameters::number_of_threads(2));
  });
}

void mean_curvature_flow(benchmark::State& state, const Source& source)
{
  run<Mcf_skeleton>(state, source, [](const Mesh& mesh, Mcf_skeleton& skeleton) {
    CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  });
}

template <class Function>
benchmark::internal::Benchmark* add(const std::string& name, Function function, const Source& source)
{
  return benchmark::RegisterBenchmark(name.c_str(), function, source)
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime();
}

void add_real_meshes()
{
  for (const std::string& path :
       CSCD::benchmark::mesh_paths({"elephant", "knot1", "homer", "camel", "armadillo", "refined_elephant"})) {
    const std::string mesh = std::filesystem::path(path).stem().string();
    const Source source{path, 0};
    add("mesh/" + mesh + "/CSCD", sequential, source);
    add("mesh/" + mesh + "/CSCD_2_threads", on_two_threads, source)->UseRealTime();
    if (num_vertices(mesh_of(source)) <= max_for_mcf) {
      add("mesh/" + mesh + "/MCF", mean_curvature_flow, source);
    }
  }
}

/// One shape from 2775 vertices to 2.8 million.
void add_growing_mesh()
{
  constexpr int max_subdivisions = 5;
  for (int subdivisions = 0; subdivisions <= max_subdivisions; ++subdivisions) {
    const Source source{CSCD::benchmark::cgal_mesh("elephant"), subdivisions};
    const std::string name = "growing/elephant_" + std::to_string(subdivisions);
    add(name + "/CSCD", sequential, source);
    add(name + "/CSCD_2_threads", on_two_threads, source)->UseRealTime();
  }
}

} // namespace

int main(int argc, char** argv)
{
  return CSCD::benchmark::run_benchmarks(argc, argv, [] {
    add_real_meshes();
    add_growing_mesh();
  });
}
