// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long each stage takes on generated shapes of growing size, with the order of growth: one thread, CPU time.
// "coarsen" is a part of "compile"; the other stages follow each other.

#include "convert_shape.h"
#include "limb_shapes.h"
#include "shape_operations.h"
#include "swept_shapes.h"
#include <CSCD/Curve_skeletonization.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/Surface_levels.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>
#include <CSCD/Traits/Triangulated_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;
using Skeletonization = CSCD::Curve_skeletonization<Traits>;

/// A shape by name, at any size.
struct Sized_shape
{
  const char* name;
  CSCD::test::Shape (*make)(std::int64_t number_of_vertices);
};

/// Edges around a tube of which every `area` squared radii of surface have so many vertices.
std::size_t edges_around(std::int64_t number_of_vertices, double area)
{
  const double edge_length = std::sqrt(area / double(number_of_vertices));
  return std::size_t(std::lround(2 * CSCD::test::pi / edge_length));
}

CSCD::test::Shape make_torus(std::int64_t number_of_vertices)
{
  const double area = 4 * CSCD::test::pi * CSCD::test::pi * 3;
  return CSCD::test::torus(3, 1, edges_around(number_of_vertices, area));
}

CSCD::test::Shape make_knot(std::int64_t number_of_vertices)
{
  constexpr double radius = 0.4;
  constexpr double length = 32; // of the knot's curve
  return CSCD::test::trefoil_knot(radius, edges_around(number_of_vertices, 2 * CSCD::test::pi * length / radius));
}

/// Five limbs; its sizes are those of repeated subdivision.
CSCD::test::Shape make_star(std::int64_t number_of_vertices)
{
  CSCD::test::Shape shape = CSCD::test::star(5, 3, 0.35, 0.22);
  while (2 * std::int64_t(shape.points.size()) < number_of_vertices) {
    shape = CSCD::test::midpoint_subdivided(shape);
  }
  return shape;
}

constexpr Sized_shape shapes[] = {{"torus", make_torus}, {"knot", make_knot}, {"star", make_star}};

/// Numbers of vertices to aim at.
constexpr std::int64_t sizes[] = {3125, 12500, 50000, 200000, 800000};

/// A skeletonization ready for any of its stages.
struct Prepared
{
  Prepared(const Sized_shape& shape, std::int64_t number_of_vertices)
      : name(shape.name), size(number_of_vertices), mesh(CSCD::test::to_mesh<Mesh>(shape.make(number_of_vertices))),
        traits(mesh), skeletonization(traits)
  {
    skeletonization.find_separators();
    skeletonization.pack_separators();
  }

  std::string name;
  std::int64_t size;
  Mesh mesh;
  Traits traits;
  Skeletonization skeletonization;
};

/// The one that was asked for last is kept: each is asked for several times in a row.
Prepared& prepared(const Sized_shape& shape, std::int64_t number_of_vertices)
{
  static std::unique_ptr<Prepared> last;
  if (!last || last->name != shape.name || last->size != number_of_vertices) {
    last.reset();
    last = std::make_unique<Prepared>(shape, number_of_vertices);
  }
  return *last;
}

void compile(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    const Traits traits(input.mesh);
    benchmark::DoNotOptimize(traits.number_of_sites());
  }
}

void coarsen(benchmark::State& state, Prepared& input)
{
  for (auto _ : state) {
    state.PauseTiming();
    CSCD::internal::Triangulated_surface surface = input.traits.levels().finest().surface;
    state.ResumeTiming();
    const CSCD::internal::Surface_levels levels(std::move(surface));
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

struct Stage
{
  const char* name;
  void (*run)(benchmark::State&, Prepared&);
};

constexpr Stage stages[] = {
    {"compile", compile}, {"coarsen", coarsen}, {"find", find}, {"pack", pack}, {"build", build}};

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
    for (const Sized_shape& shape : shapes) {
      const std::string name = std::string(stage.name) + '/' + shape.name;
      auto* registered =
          benchmark::RegisterBenchmark(name.c_str(), [&](benchmark::State& state) { run(state, stage, shape); });
      for (const std::int64_t size : sizes) {
        registered->Arg(size);
      }
      registered->Unit(benchmark::kMillisecond)->Complexity();
    }
  }
  return true;
}

[[maybe_unused]] const bool are_registered = register_benchmarks();

} // namespace
