// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances by the heat method compared with CGAL's: time to prepare a mesh, time for each source, alone and
// eight at a time, and the errors against exact shortest paths. CPU time of one thread.

#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/estimate_geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Distances = Mesh::Property_map<Vertex, double>;
using Estimator = CSCD::Geodesic_distance_estimator<Mesh>;
using Cgal_estimator =
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;

constexpr std::size_t number_of_sources = 8;
/// The number of these sources with exact distances, which take seconds each.
constexpr std::size_t number_of_exact_sources = 2;

/// A mesh and its known properties.
struct Prepared
{
  explicit Prepared(const std::string& name)
  {
    CSCD::read_triangle_mesh(std::string(CSCD_CGAL_DATA_DIR) + '/' + name + ".off", mesh);
    for (std::size_t i = 0; i < number_of_sources; ++i) {
      // Spread over the numbers of vertices.
      sources.push_back(Vertex(Mesh::size_type((2 * i + 1) * mesh.number_of_vertices() / (2 * number_of_sources))));
      maps.push_back(mesh.add_property_map<Vertex, double>().first);
    }
    double sum = 0;
    for (const auto edge : mesh.edges()) {
      sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(edge, 0)), mesh.point(mesh.vertex(edge, 1))));
    }
    edge_length = sum / mesh.number_of_edges();
    for (std::size_t i = 0; i < number_of_exact_sources; ++i) {
      exact.push_back(exact_distances(sources[i]));
    }
  }

  std::vector<double> exact_distances(Vertex source) const
  {
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> shortest_path(mesh);
    shortest_path.add_source_point(source);
    std::vector<double> result;
    for (const Vertex vertex : mesh.vertices()) {
      result.push_back(shortest_path.shortest_distance_to_source_points(vertex).first);
    }
    return result;
  }

  Mesh mesh;
  double edge_length = 0;
  std::vector<Vertex> sources;
  std::vector<Distances> maps;
  std::vector<std::vector<double>> exact; ///< of the first sources
};

/// The result of the last call is kept.
Prepared& prepared(const std::string& name)
{
  static std::string last_name;
  static std::unique_ptr<Prepared> last;
  if (name != last_name) {
    last.reset();
    last = std::make_unique<Prepared>(name);
    last_name = name;
  }
  return *last;
}

/// Compares the maps of the first sources with the exact distances. Errors of vertices closer than three edges are not
/// taken relative to their distance.
void count_errors(benchmark::State& state, const Prepared& input)
{
  double sum = 0;
  double relative_sum = 0;
  double number = 0;
  double relative_number = 0;
  double largest = 0;
  double max_distance = 0;
  for (std::size_t i = 0; i < input.exact.size(); ++i) {
    for (const Vertex vertex : input.mesh.vertices()) {
      const double exact = input.exact[i][vertex];
      const double error = std::fabs(input.maps[i][vertex] - exact);
      max_distance = std::max(max_distance, exact);
      largest = std::max(largest, error);
      sum += error;
      number += 1;
      if (exact > 3 * input.edge_length) {
        relative_sum += error / exact;
        relative_number += 1;
      }
    }
  }
  state.counters["vertices"] = double(input.mesh.number_of_vertices());
  state.counters["diameter"] = max_distance / input.edge_length;
  state.counters["mean_error"] = sum / number / input.edge_length;
  state.counters["max_error"] = largest / input.edge_length;
  state.counters["percent_error"] = 100 * relative_sum / relative_number;
}

template <class AnyEstimator>
void prepare(benchmark::State& state, const std::string& name)
{
  const Prepared& input = prepared(name);
  for (auto _ : state) {
    const AnyEstimator estimator(input.mesh);
    benchmark::DoNotOptimize(&estimator);
  }
}

void one_by_one(benchmark::State& state, const std::string& name)
{
  const Prepared& input = prepared(name);
  const Estimator estimator(input.mesh);
  for (auto _ : state) {
    for (std::size_t i = 0; i < number_of_sources; ++i) {
      estimator.estimate(std::array<Vertex, 1>{input.sources[i]}, input.maps[i]);
    }
  }
}

void together(benchmark::State& state, const std::string& name)
{
  const Prepared& input = prepared(name);
  const Estimator estimator(input.mesh);
  std::vector<std::array<Vertex, 1>> source_sets;
  for (const Vertex source : input.sources) {
    source_sets.push_back({source});
  }
  for (auto _ : state) {
    estimator.estimate_each(source_sets, input.maps);
  }
  count_errors(state, input);
}

void cgal_one_by_one(benchmark::State& state, const std::string& name)
{
  const Prepared& input = prepared(name);
  Cgal_estimator estimator(input.mesh);
  for (auto _ : state) {
    for (std::size_t i = 0; i < number_of_sources; ++i) {
      estimator.clear_sources();
      estimator.add_source(input.sources[i]);
      estimator.estimate_geodesic_distances(input.maps[i]);
    }
  }
  count_errors(state, input);
}

void add(const std::string& name, void (*run)(benchmark::State&, const std::string&), const std::string& mesh)
{
  benchmark::RegisterBenchmark((name + '/' + mesh).c_str(), run, mesh)->Unit(benchmark::kMillisecond);
}

/// Registers the benchmarks before main() runs them.
[[maybe_unused]] const bool is_registered = [] {
  for (const char* mesh : {"elephant", "homer", "camel", "armadillo"}) {
    add("prepare", prepare<Estimator>, mesh);
    add("one_by_one", one_by_one, mesh);
    add("together", together, mesh);
    add("prepare_cgal", prepare<Cgal_estimator>, mesh);
    add("cgal_one_by_one", cgal_one_by_one, mesh);
  }
  return true;
}();

} // namespace
