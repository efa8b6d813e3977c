// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as the file of a volume. The results are closed surfaces, or the content is refused in
// one line that names the file; everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Bytes.h"
#include "support/Temporary_folder.h"
#include <CSCD/IO/read_volume.h>
#include <CSCD/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

namespace {

const std::array<const char*, 4> volume_names{"fuzz.nrrd", "fuzz.nii", "fuzz.mha", "fuzz.tif"};

void check_volume_message(const std::exception& error)
{
  const std::string message = error.what();
  if (message.find('\n') != std::string::npos || message.find("fuzz.") == std::string::npos) {
    std::cerr << "refused badly: " << message << '\n';
    std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const test_support::Temporary_folder folder;
  CSCD::test::Bytes bytes(data, size);
  const char* const name = volume_names[bytes.take() % volume_names.size()];
  const std::string file = folder.write(name, bytes.rest());
  try {
    for (const CSCD::Voxel_surface& surface : CSCD::read_voxel_surfaces(file, {std::nullopt, std::nullopt, true})) {
      const CSCD::Halfedge_pairing pairing(surface.triangles.faces, surface.triangles.points.size());
      if (pairing.conflict() != CSCD::no_index || pairing.has_border() || surface.triangles.faces.empty()) {
        std::cerr << "not closed\n";
        std::abort();
      }
    }
  } catch (const CSCD::File_error& error) {
    check_volume_message(error);
  } catch (const CSCD::Input_error& error) {
    check_volume_message(error);
  }
  return 0;
}
