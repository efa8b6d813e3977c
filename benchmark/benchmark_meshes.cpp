// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time, memory and quality of CSCD, of CGAL's mean curvature flow (MCF) and of other skeletonizers on meshes.
//
// Usage: benchmark_meshes [--benchmark_...] [--peer=NAME=COMMAND]... [--growing=ROUNDS] MESH...
// COMMAND is run by the shell with {mesh} and {skeleton} replaced by names of files. It writes the skeleton in GEL's
// format. If it prints a number, that is the CPU seconds of its skeletonization; else those of the whole command count.
// --growing also measures the first mesh after 0 to ROUNDS rounds of Loop subdivision. CPU time is that of the whole
// process, all threads.

#include "Inside_count.h"
#include "Surface_facts.h"
#include "invariants.h"
#include <CSCD/Skeleton_graph.h>
#include <CSCD/extract_curve_skeleton.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <utility>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Skeleton = CSCD::Skeleton_graph<Mesh::Point, Mesh::Vertex_index>;
using Mcf_skeleton = CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton;

/// MCF and the measures take seconds beyond this number of vertices.
constexpr std::size_t max_vertices = 50000;

/// A file and how often its mesh is subdivided after Loop.
struct Source
{
  std::string path;
  unsigned subdivisions = 0;
};

/// The mesh of the last call is kept.
const Mesh& mesh_of(const Source& source)
{
  static Source last;
  static Mesh mesh;
  if (source.path != last.path || source.subdivisions != last.subdivisions) {
    mesh = Mesh();
    if (!CGAL::IO::read_polygon_mesh(source.path, mesh)) {
      throw std::runtime_error(source.path + ": cannot be read as a mesh");
    }
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(source.subdivisions));
    mesh.collect_garbage();
    mesh.shrink_to_fit();
    last = source;
  }
  return mesh;
}

/// The greatest resident memory of the process since this object was made, on Linux.
class Peak_memory
{
public:
  Peak_memory()
  {
    malloc_trim(0);                                // memory that earlier work has freed shall not count
    std::ofstream("/proc/self/clear_refs") << "5"; // resets the peak
  }

  /// In megabytes of 10^6 bytes, the input included; 0 on other systems.
  double megabytes() const
  {
    constexpr double megabytes_per_kibibyte = 1.024e-3;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word; status.ignore(std::numeric_limits<std::streamsize>::max(), '\n')) {
      if (word == "VmHWM:") {
        double kibibytes = 0;
        status >> kibibytes;
        return megabytes_per_kibibyte * kibibytes;
      }
    }
    return 0;
  }
};

template <class AnySkeleton>
void count_measures(benchmark::State& state, const Mesh& mesh, const AnySkeleton& skeleton)
{
  state.counters["vertices"] = double(num_vertices(mesh));
  if (num_vertices(mesh) <= max_vertices) {
    const CSCD::test::Skeleton_facts facts = CSCD::test::skeleton_facts(skeleton);
    state.counters["nodes"] = double(facts.number_of_nodes);
    state.counters["tips"] = double(facts.number_of_tips);
    state.counters["betti_number"] = double(facts.betti_number);
    state.counters["genus"] = double(CSCD::test::surface_facts(mesh).genus);
    state.counters["percent_inside"] = 100 * CSCD::test::count_inside(mesh, skeleton).fraction_of_length_inside();
  }
}

/// Runs `extract(mesh, skeleton)`.
template <class AnySkeleton, class Extract>
void run(benchmark::State& state, const Source& source, const Extract& extract)
{
  const Mesh& mesh = mesh_of(source);
  const Peak_memory peak_memory;
  AnySkeleton skeleton;
  for (auto _ : state) {
    skeleton = AnySkeleton();
    extract(mesh, skeleton);
  }
  state.counters["megabytes"] = peak_memory.megabytes();
  count_measures(state, mesh, skeleton);
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
  if (!CGAL::is_closed(mesh_of(source))) {
    throw std::runtime_error("MCF needs a closed mesh");
  }
  run<Mcf_skeleton>(state, source, [](const Mesh& mesh, Mcf_skeleton& skeleton) {
    CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
  });
}

/// The CPU seconds of all commands that have ended.
double seconds_of_commands()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Runs a command of the shell. \return its CPU seconds, or the number that it prints
double run_command(const std::string& command)
{
  const double begin = seconds_of_commands();
  std::FILE* output = popen(command.c_str(), "r");
  double printed = 0;
  const bool has_printed = output != nullptr && std::fscanf(output, "%lf", &printed) == 1;
  if (output == nullptr || pclose(output) != 0) {
    throw std::runtime_error(command + ": fails");
  }
  return has_printed ? printed : seconds_of_commands() - begin;
}

Skeleton read_skeleton(const std::string& path)
{
  Skeleton skeleton;
  std::ifstream in(path);
  for (std::string kind; in >> kind; in.ignore(std::numeric_limits<std::streamsize>::max(), '\n')) {
    if (Mesh::Point point; kind == "n" && in >> point) {
      skeleton[add_vertex(skeleton)].point = point;
    } else if (std::size_t a = 0, b = 0; kind == "c" && in >> a >> b) {
      add_edge(a, b, skeleton);
    }
  }
  return skeleton;
}

void peer(benchmark::State& state, const Source& source, std::string command)
{
  const std::string skeleton = std::filesystem::temp_directory_path() / "benchmark_meshes.graph";
  boost::replace_all(command, "{mesh}", '\'' + source.path + '\'');
  boost::replace_all(command, "{skeleton}", skeleton);
  for (auto _ : state) {
    state.SetIterationTime(run_command(command));
  }
  count_measures(state, mesh_of(source), read_skeleton(skeleton));
  std::filesystem::remove(skeleton);
}

template <class Function, class... Arguments>
benchmark::internal::Benchmark* add(const std::string& name, Function function, const Source& source,
                                    const Arguments&... arguments)
{
  const auto run_or_skip = [=](benchmark::State& state) {
    try {
      function(state, source, arguments...);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), run_or_skip)
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime();
}

void add_mesh(const std::string& path, const std::vector<std::pair<std::string, std::string>>& peers)
{
  const std::string name = "mesh/" + std::filesystem::path(path).stem().string();
  add(name + "/CSCD", sequential, Source{path});
  add(name + "/CSCD_2_threads", on_two_threads, Source{path})->UseRealTime();
  add(name + "/MCF", mean_curvature_flow, Source{path});
  for (const auto& [peer_name, command] : peers) {
    add(name + '/' + peer_name, peer, Source{path}, command)->UseManualTime();
  }
}

void add_growing_mesh(const std::string& path, unsigned rounds)
{
  for (unsigned subdivisions = 0; subdivisions <= rounds; ++subdivisions) {
    const std::string name = "growing/" + std::to_string(subdivisions);
    add(name + "/CSCD", sequential, Source{path, subdivisions});
    add(name + "/CSCD_2_threads", on_two_threads, Source{path, subdivisions})->UseRealTime();
  }
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  std::vector<std::pair<std::string, std::string>> peers;
  std::vector<std::string> meshes;
  int rounds = -1;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (boost::starts_with(argument, "--peer=")) {
      const std::size_t begin = argument.find('=') + 1;
      const std::size_t end = argument.find('=', begin);
      peers.emplace_back(argument.substr(begin, end - begin), argument.substr(end + 1));
    } else if (boost::starts_with(argument, "--growing=")) {
      rounds = std::stoi(argument.substr(argument.find('=') + 1));
    } else {
      meshes.push_back(argument);
    }
  }
  for (const std::string& mesh : meshes) {
    add_mesh(mesh, peers);
  }
  if (rounds >= 0 && !meshes.empty()) {
    add_growing_mesh(meshes.front(), unsigned(rounds));
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
