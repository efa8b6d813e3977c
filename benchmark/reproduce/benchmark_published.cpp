// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method compared with the local one and CGAL's mean curvature flow (MCF): quality and time; the
// published one also with other targets, shortenings and numbers of sources; both with noise, fewer vertices, holes,
// and threads. One thread, except in the last.
// Meshes are generated ones, some of CGAL's data, and the OFF files in the folder that the environment variable
// CSCD_MODELS names, if there is one; all must be closed.

#include "convert_shape.h"
#include "sampling.h"
#include "shape_operations.h"
#include "support/generated_shapes.h"
#include "support/mesh_paths.h"
#include "support/run_benchmarks.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Measure/evaluate_skeleton.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published_policies.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using Skeleton = CSCD::Skeleton_graph<Point, Mesh::Vertex_index>;
using Mcf_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;
using CSCD::Shortening_rule;
using CSCD::Target_rule;
using CSCD::test::Shape;
using CSCD::test::Triple;
using CSCD::test::operator+; // of triples, which argument-dependent lookup does not find
using CSCD::test::operator*;

/// The number of cells along the diagonal of reconstructions that are not used.
constexpr std::size_t coarse_resolution = 20;

enum class Method
{
  local,
  published,
  mean_curvature_flow
};

/// The computation of a skeleton.
struct Variant
{
  Method method = Method::published;
  std::optional<std::size_t> number_of_sources{};
  Target_rule target_rule = Target_rule::nearest_in_space;
  Shortening_rule shortening_rule = Shortening_rule::edge_flips;
  unsigned number_of_threads = 1;
  bool is_reconstructed = false; ///< whether the error of the convolution surface is measured
};

/// The origin of a mesh, and its change before the skeletonization.
struct Input
{
  std::string name;
  std::function<Mesh()> make;             ///< the original, which skeletons are measured against
  std::function<Mesh(const Mesh&)> alter; ///< if given, its result is skeletonized instead
};

Input input_of(const std::string& path)
{
  return {std::filesystem::path(path).stem().string(),
          [path] {
            Mesh mesh;
            CSCD::read_triangle_mesh(path, mesh);
            return mesh;
          },
          {}};
}

Input input_of(const CSCD::benchmark::Sized_shape& shape)
{
  constexpr std::int64_t number_of_vertices = 12500;
  return {shape.name, [shape] { return CSCD::test::to_mesh<Mesh>(shape.make(number_of_vertices)); }, {}};
}

/// Each coordinate moved by a normally distributed number, its standard deviation relative to the mean edge length.
Mesh with_noise(const Mesh& mesh, double deviation)
{
  Shape shape = CSCD::test::to_shape(mesh);
  shape.points = CSCD::test::shaken(shape.points, deviation * CSCD::test::mean_edge_length(shape), 1);
  return CSCD::test::to_mesh<Mesh>(shape);
}

/// Simplified to this part of the edges.
Mesh simplified(Mesh mesh, double edges_to_keep)
{
  CGAL::Surface_mesh_simplification::Count_ratio_stop_predicate<Mesh> stop(edges_to_keep);
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  return mesh;
}

/// Without the triangles around so many vertices.
Mesh with_holes(const Mesh& mesh, std::size_t number)
{
  return CSCD::test::to_mesh<Mesh>(CSCD::test::with_small_holes(CSCD::test::to_shape(mesh), number, 1));
}

/// The torus whose skeleton the paper shows (supplement, H.3): with two holes back to back and, if `is_broken`, a break
/// all around the tube on the other side of the ring.
Mesh torus_with_holes(const Mesh& mesh, bool is_broken)
{
  constexpr double major_radius = 3;
  constexpr double hole_radius = 0.4;
  constexpr double half_width_of_break = 0.3;
  Shape shape = CSCD::test::to_shape(mesh);
  std::vector<bool> is_removed;
  for (const CSCD::test::Triangle& t : shape.triangles) {
    const Triple center = (1. / 3) * (shape.points[t[0]] + shape.points[t[1]] + shape.points[t[2]]);
    const bool is_in_hole = std::hypot(center[0] - major_radius, center[1]) < hole_radius; // above and below
    const bool is_in_break = is_broken && center[0] < 0 && std::fabs(center[1]) < half_width_of_break;
    is_removed.push_back(is_in_hole || is_in_break);
  }
  remove_triangles(shape, is_removed);
  return CSCD::test::to_mesh<Mesh>(shape);
}

template <class Policies>
void run(benchmark::State& state, const Mesh& mesh, const Policies& policies, const Variant& variant,
         Skeleton& skeleton)
{
  CSCD::Skeletonization_report report;
  for (auto _ : state) {
    const Traits traits(mesh);
    CSCD::Curve_skeletonization<Traits, Policies> skeletonization(traits, policies);
    if (variant.number_of_sources) {
      skeletonization.set_maximum_number_of_sources(*variant.number_of_sources);
    }
    if (variant.number_of_threads > 1) {
      skeletonization.set_number_of_threads(variant.number_of_threads);
      report = skeletonization.template run<CGAL::Parallel_if_available_tag>(skeleton);
    } else {
      report = skeletonization.run(skeleton);
    }
  }
  state.counters["sources"] = double(report.number_of_sources);
  state.counters["packed"] = double(report.number_of_packed_separators);
}

/// Errors are measured against the original mesh, topology and position against the one that was skeletonized.
template <class AnySkeleton>
void count_measures(benchmark::State& state, const Mesh& original, const Mesh* altered, const Variant& variant,
                    const AnySkeleton& skeleton)
{
  const auto coarsely = CSCD::parameters::resolution(coarse_resolution);
  const CSCD::Skeleton_measures measures = variant.is_reconstructed
                                               ? CSCD::evaluate_skeleton(original, skeleton)
                                               : CSCD::evaluate_skeleton(original, skeleton, coarsely);
  const CSCD::Position_measures position =
      altered == nullptr ? measures.position : CSCD::evaluate_skeleton(*altered, skeleton, coarsely).position;
  state.counters["genus"] = double(position.genus);
  state.counters["surface_components"] = double(position.number_of_surface_components);
  state.counters["percent_inside"] = 100 * position.fraction_of_length_inside;
  state.counters["betti_number"] = double(measures.counts.betti_number);
  state.counters["components"] = double(measures.counts.number_of_components);
  state.counters["tips"] = double(measures.counts.number_of_tips);
  state.counters["error"] = measures.mean_distance_from_round_cones;
  if (variant.is_reconstructed) {
    state.counters["convolution_error"] = measures.convolution.mean;
  }
}

void skeletonize(benchmark::State& state, const Input& input, const Variant& variant)
{
  const Mesh original = input.make();
  std::optional<Mesh> altered;
  if (input.alter) {
    altered = input.alter(original);
  }
  const Mesh& mesh = altered ? *altered : original;
  state.counters["vertices"] = double(num_vertices(mesh));
  state.counters["faces"] = double(num_faces(mesh));
  const auto count_measures_of = [&](const auto& skeleton) {
    count_measures(state, original, altered ? &*altered : nullptr, variant, skeleton);
  };
  if (variant.method == Method::mean_curvature_flow) {
    Mcf_skeleton skeleton;
    for (auto _ : state) {
      CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
    }
    count_measures_of(skeleton);
  } else {
    Skeleton skeleton;
    if (variant.method == Method::published) {
      const CSCD::Published_policies policies({variant.target_rule, variant.shortening_rule});
      run(state, mesh, policies, variant, skeleton);
    } else {
      run(state, mesh, CSCD::Local_policies(), variant, skeleton);
    }
    count_measures_of(skeleton);
  }
}

benchmark::internal::Benchmark* add(const std::string& name, const Input& input, const Variant& variant)
{
  const auto skeletonize_or_skip = [input, variant](benchmark::State& state) {
    try {
      skeletonize(state, input, variant);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), skeletonize_or_skip)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->MeasureProcessCPUTime();
}

void add_methods(const std::vector<Input>& inputs)
{
  // The variational flow takes several times as long as edge flips: the two are compared with fewer sources.
  constexpr std::size_t few = 500;
  for (const Input& input : inputs) {
    const std::string prefix = "method/" + input.name + '/';
    for (const auto& [name, method] : {std::pair{"local", Method::local}, std::pair{"published", Method::published},
                                       std::pair{"MCF", Method::mean_curvature_flow}}) {
      Variant variant{method};
      variant.is_reconstructed = true;
      add(prefix + name, input, variant);
    }
    add(prefix + "geodesic target", input, {Method::published, {}, Target_rule::nearest_along_surface});
    add(prefix + "flips, 500 sources", input, {Method::published, few});
    add(prefix + "variational, 500 sources", input,
        {Method::published, few, Target_rule::nearest_in_space, Shortening_rule::variational});
  }
}

void add_numbers_of_sources(const std::vector<Input>& inputs)
{
  for (const Input& input : inputs) {
    for (std::size_t number = 8; number <= 8192; number *= 2) {
      add("sources/" + input.name + '/' + std::to_string(number), input, {Method::published, number});
    }
  }
}

/// Adds both methods on the mesh that `alter` returns.
void add_altered(const std::string& name, Input input, const std::function<Mesh(const Mesh&)>& alter)
{
  input.alter = alter;
  add(name + "/local", input, {Method::local});
  add(name + "/published", input, {Method::published});
}

void add_noise_and_resolution_and_holes(const std::vector<Input>& inputs)
{
  for (const Input& input : inputs) {
    for (const int percent : {0, 10, 20, 30, 50}) {
      add_altered("noise/" + input.name + '/' + std::to_string(percent), input,
                  [percent](const Mesh& mesh) { return with_noise(mesh, percent / 100.); });
    }
    for (const int part : {1, 2, 4, 8}) {
      add_altered("resolution/" + input.name + '/' + std::to_string(part), input,
                  [part](const Mesh& mesh) { return simplified(mesh, 1. / part); });
    }
    for (const std::size_t number : {0u, 10u, 30u, 100u}) {
      add_altered("holes/" + input.name + '/' + std::to_string(number), input,
                  [number](const Mesh& mesh) { return with_holes(mesh, number); });
    }
  }
}

void add_ring(const Input& torus)
{
  add("ring/whole/local", torus, {Method::local});
  add("ring/whole/published", torus, {Method::published});
  add_altered("ring/two holes", torus, [](const Mesh& mesh) { return torus_with_holes(mesh, false); });
  add_altered("ring/two holes and a break", torus, [](const Mesh& mesh) { return torus_with_holes(mesh, true); });
}

/// One thread, two, four, and so on, up to all threads.
void add_threads(const Input& input)
{
  const unsigned all = std::max(1u, std::thread::hardware_concurrency());
  for (unsigned number = 1; number <= all; number *= 2) {
    for (const Method method : {Method::local, Method::published}) {
      Variant variant{method};
      variant.number_of_threads = number;
      add("threads/" + input.name + '/' + std::to_string(number) + (method == Method::local ? "/local" : "/published"),
          input, variant)
          ->UseRealTime();
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  return CSCD::benchmark::run_benchmarks(argc, argv, [] {
    std::vector<Input> inputs;
    for (const CSCD::benchmark::Sized_shape& shape : CSCD::benchmark::generated_shapes) {
      inputs.push_back(input_of(shape));
    }
    for (const std::string& path : CSCD::benchmark::mesh_paths(
             {"armadillo", "camel", "cow", "dino", "elephant", "femur", "hand", "homer", "knot1", "triceratops"})) {
      inputs.push_back(input_of(path));
    }
    add_methods(inputs);
    const std::vector<Input> two = {input_of(CSCD::benchmark::cgal_mesh("camel")),
                                    input_of(CSCD::benchmark::cgal_mesh("elephant"))};
    add_numbers_of_sources(two);
    std::vector<Input> altered = {input_of(CSCD::benchmark::cgal_mesh("armadillo")), two[0], two[1]};
    const std::map<std::string, std::string> models = CSCD::benchmark::models();
    if (const auto fertility = models.find("fertility_4494"); fertility != models.end()) {
      altered.push_back(input_of(fertility->second));
    }
    add_noise_and_resolution_and_holes(altered);
    add_ring(inputs.front());
    add_threads(input_of(CSCD::benchmark::cgal_mesh("armadillo")));
  });
}
