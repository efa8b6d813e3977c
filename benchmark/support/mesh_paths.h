// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The meshes that are measured.

#ifndef CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H
#define CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace CSCD::benchmark {

/// The file of one of CGAL's meshes.
inline std::string cgal_mesh(const std::string& name)
{
  return std::string(CSCD_CGAL_DATA_DIR) + '/' + name + ".off";
}

/// The OFF files in the folder that the environment variable CSCD_BENCHMARK_MESHES names, else those of CGAL's meshes
/// with `default_names`.
inline std::vector<std::string> mesh_paths(const std::vector<std::string>& default_names)
{
  std::vector<std::string> paths;
  const char* folder = std::getenv("CSCD_BENCHMARK_MESHES");
  if (folder == nullptr) {
    std::transform(default_names.begin(), default_names.end(), std::back_inserter(paths), cgal_mesh);
    return paths;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".off") {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

} // namespace CSCD::benchmark

#endif // CSCD_BENCHMARK_SUPPORT_MESH_PATHS_H
