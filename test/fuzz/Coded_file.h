// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file as the bytes of a fuzz target that reads files.

#ifndef CSCD_TEST_FUZZ_CODED_FILE_H
#define CSCD_TEST_FUZZ_CODED_FILE_H

#include "Bytes.h"

#include <array>
#include <cstddef>
#include <exception>
#include <sstream>
#include <string>

namespace CSCD::test {

inline constexpr std::array<const char*, 7> endings_of_points{".xyz", ".pts", ".ply", ".off", ".vtk", ".pcd", ".las"};
inline constexpr std::array<const char*, 7> endings_of_skeletons{".graph",         ".json", ".obj", ".ply",
                                                                 ".polylines.txt", ".swc",  ".vtp"};
inline constexpr std::array<const char*, 7> endings_of_meshes{".off", ".obj", ".ply", ".stl", ".vtk", ".glb", ".vtp"};
inline constexpr std::array<const char*, 4> endings_of_volumes{".nrrd", ".nii", ".mha", ".tif"};

/// The bytes: the format, which counts modulo the number of endings, then the content of the file.
struct Coded_file
{
  template <std::size_t n>
  Coded_file(Bytes bytes, const std::array<const char*, n>& endings)
      : ending(endings[bytes.take() % n]), content(bytes.rest())
  {
  }

  std::string ending;
  std::istringstream content;
};

/// Fails unless a file was refused by a message of one line that begins with `name`.
inline void check_refusal(const std::exception& error, const std::string& name)
{
  const std::string message = error.what();
  if (message.find('\n') != std::string::npos || message.rfind(name, 0) != 0) {
    fail("refused badly: " + message);
  }
}

} // namespace CSCD::test

#endif // CSCD_TEST_FUZZ_CODED_FILE_H
