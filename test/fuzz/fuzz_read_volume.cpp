// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, read as the file of a volume. The results are closed surfaces, or the content is refused in
// one line that names the file; everything else is a bug and aborts.
//
// The bytes: the format, then the content of the file.

#include "Coded_file.h"
#include "support/Temporary_folder.h"
#include <CSCD/IO/read_volume.h>
#include <CSCD/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const test_support::Temporary_folder folder;
  const CSCD::test::Coded_file coded({data, size}, CSCD::test::endings_of_volumes);
  const std::string file = folder.write("fuzz" + coded.ending, coded.content.str());
  try {
    for (const CSCD::Voxel_surface& surface : CSCD::read_voxel_surfaces(file, {std::nullopt, std::nullopt, true})) {
      const CSCD::Halfedge_pairing pairing(surface.triangles.faces, surface.triangles.points.size());
      if (pairing.conflict() != CSCD::no_index || pairing.has_border() || surface.triangles.faces.empty()) {
        CSCD::test::fail("not closed");
      }
    }
  } catch (const CSCD::File_error& error) {
    CSCD::test::check_refusal(error, file);
  } catch (const CSCD::Input_error& error) {
    CSCD::test::check_refusal(error, file);
  }
  return 0;
}
