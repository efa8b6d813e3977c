// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long each stage takes on generated shapes of growing size, with the order of growth: one thread, CPU time.
// "read" makes a manifold of the bytes of a binary file. "coarsen" is a part of "compile"; the other stages follow each
// other.

#include "convert_shape.h"
#include "support/generated_shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using Skeletonization = CSCD::Curve_skeletonization<Traits>;

using CSCD::benchmark::Sized_shape;

/// Numbers of vertices to aim at.
constexpr std::int64_t sizes[] = {3125, 12500, 50000, 200000, 800000};
/// The same for one of the shapes.
constexpr std::int64_t largest_size = 2800000;

/// A skeletonization ready for any of its stages.
struct Prepared
{
  Prepared(const Sized_shape& shape, std::int64_t number_of_vertices)
      : name(shape.name), size(number_of_vertices), mesh(CSCD::test::to_mesh<Mesh>(shape.make(number_of_vertices))),
        traits(mesh), skeletonization(traits)
  {
    std::ostringstream out(std::ios::binary);
    CGAL::IO::set_binary_mode(out);
    CGAL::IO::write_PLY(out, mesh);
    file = out.str();
    skeletonization.run(skeleton);
  }

  std::string name;
  std::int64_t size;
  Mesh mesh;
  Traits traits;
  Skeletonization skeletonization;
  std::string file; ///< the mesh as binary PLY
  Skeletonization::Skeleton skeleton;
};

/// The result of the last call is kept: each is used several times in a row.
Prepared& prepared(const Sized_shape& shape, std::int64_t number_of_vertices)
{
  static std::unique_ptr<Prepared> last;
  if (!last || last->name != shape.name || last->size != number_of_vertices) {
    last.reset();
    last = std::make_unique<Prepared>(shape, number_of_vertices);
  }
  return *last;
}

void read(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    state.PauseTiming();
    std::istringstream in(input.file);
    state.ResumeTiming();
    const auto manifold = CSCD::internal::make_manifold(
        CSCD::internal::read_polygons(in, CSCD::Mesh_format::ply, input.name), input.name);
    benchmark::DoNotOptimize(manifold.triangles.faces.size());
  }
}

void compile(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    const Traits traits(input.mesh);
    benchmark::DoNotOptimize(traits.surface().triangulation().number_of_vertices());
  }
}

void coarsen(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    state.PauseTiming();
    CSCD::Triangulated_surface surface = input.traits.surface().triangulation();
    state.ResumeTiming();
    const CSCD::Surface_levels levels(std::move(surface));
    benchmark::DoNotOptimize(levels.size());
  }
}

void find(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    Skeletonization skeletonization(input.traits);
    benchmark::DoNotOptimize(skeletonization.find_separators());
  }
}

void pack(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    benchmark::DoNotOptimize(input.skeletonization.pack_separators());
  }
}

void build(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    Skeletonization::Skeleton skeleton;
    input.skeletonization.convert_to_skeleton(skeleton);
    benchmark::DoNotOptimize(num_vertices(skeleton));
  }
}

void write(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    std::ostringstream out;
    CSCD::write_json(out, input.skeleton);
    benchmark::DoNotOptimize(out.tellp());
  }
}

struct Stage
{
  const char* name;
  void (*run)(benchmark::State&, Prepared&);
};

constexpr Stage stages[] = {{"read", read}, {"compile", compile}, {"coarsen", coarsen}, {"find", find},
                            {"pack", pack}, {"build", build},     {"write", write}};

void run(benchmark::State& state, const Stage& stage, const Sized_shape& shape)
{
  Prepared& input = prepared(shape, state.range(0));
  stage.run(state, input);
  state.SetComplexityN(std::int64_t(num_vertices(input.mesh)));
  state.counters["vertices"] = double(num_vertices(input.mesh));
  state.counters["separators"] = double(input.skeletonization.separators().size());
}

bool register_benchmarks()
{
  for (const Stage& stage : stages) {
    for (const Sized_shape& shape : CSCD::benchmark::generated_shapes) {
      const std::string name = std::string(stage.name) + '/' + shape.name;
      auto* registered =
          benchmark::RegisterBenchmark(name.c_str(), [&](benchmark::State& state) { run(state, stage, shape); });
      for (const std::int64_t size : sizes) {
        registered->Arg(size);
      }
      if (&shape == &CSCD::benchmark::generated_shapes[0]) {
        registered->Arg(largest_size);
      }
      registered->Unit(benchmark::kMillisecond)->Complexity();
    }
  }
  return true;
}

[[maybe_unused]] const bool are_registered = register_benchmarks();

} // namespace
