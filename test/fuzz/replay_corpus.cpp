// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Usage: replay_corpus TARGET FILE_OR_FOLDER...
// Gives every file of the folders and files to a fuzz target, for compilers without libFuzzer.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

// The targets, as write_unit.cmake names them.
using Target = int(const std::uint8_t* data, std::size_t size);
extern "C" {
Target LLVMFuzzerTestOneInput_fuzz_extract_curve_skeleton;
Target LLVMFuzzerTestOneInput_fuzz_read_points;
Target LLVMFuzzerTestOneInput_fuzz_read_skeleton;
Target LLVMFuzzerTestOneInput_fuzz_read_triangle_mesh;
Target LLVMFuzzerTestOneInput_fuzz_read_volume;
Target LLVMFuzzerTestOneInput_fuzz_use_skeleton;
}

namespace {

const std::map<std::string, Target*> targets{
    {"fuzz_extract_curve_skeleton", &LLVMFuzzerTestOneInput_fuzz_extract_curve_skeleton},
    {"fuzz_read_points", &LLVMFuzzerTestOneInput_fuzz_read_points},
    {"fuzz_read_skeleton", &LLVMFuzzerTestOneInput_fuzz_read_skeleton},
    {"fuzz_read_triangle_mesh", &LLVMFuzzerTestOneInput_fuzz_read_triangle_mesh},
    {"fuzz_read_volume", &LLVMFuzzerTestOneInput_fuzz_read_volume},
    {"fuzz_use_skeleton", &LLVMFuzzerTestOneInput_fuzz_use_skeleton}};

std::vector<std::filesystem::path> files_in(const std::filesystem::path& path)
{
  if (!std::filesystem::is_directory(path)) {
    return {path};
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::uint8_t> content_of(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

int main(int argc, char* argv[])
{
  Target* const target = argc > 1 ? targets.at(argv[1]) : nullptr;
  std::size_t count = 0;
  for (int i = 2; i < argc; ++i) {
    for (const std::filesystem::path& file : files_in(argv[i])) {
      std::cout << file.filename().string() << std::endl;
      const std::vector<std::uint8_t> content = content_of(file);
      target(content.data(), content.size());
      ++count;
    }
  }
  std::cout << count << " inputs replayed\n";
  return count == 0 ? 1 : 0;
}
