// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The meshes of the benchmarks.

#ifndef CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H
#define CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace CSCD::benchmark {

/// The file of one of CGAL's meshes.
inline std::string cgal_mesh(const std::string& name)
{
  return std::string(CSCD_CGAL_DATA_DIR) + '/' + name + ".off";
}

/// The OFF files in the folder that the environment variable CSCD_MODELS names, if there is one, by name.
inline std::map<std::string, std::string> models()
{
  std::map<std::string, std::string> path_of_name;
  if (const char* folder = std::getenv("CSCD_MODELS")) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".off") {
        path_of_name[entry.path().stem().string()] = entry.path().string();
      }
    }
  }
  return path_of_name;
}

/// The files of CGAL's meshes with `names`, then the models with other names.
inline std::vector<std::string> mesh_paths(const std::vector<std::string>& names)
{
  std::vector<std::string> paths;
  std::map<std::string, std::string> others = models();
  for (const std::string& name : names) {
    paths.push_back(cgal_mesh(name));
    others.erase(name);
  }
  for (const auto& [name, path] : others) {
    paths.push_back(path);
  }
  return paths;
}

} // namespace CSCD::benchmark

#endif // CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H
