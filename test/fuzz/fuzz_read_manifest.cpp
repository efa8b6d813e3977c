// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fuzz target: any bytes, as the manifest of a batch that is resumed. What it was opened with and a row more are there
// when it is opened again, or it is refused by name; everything else is a bug and aborts.

#include "../../program/Batch_manifest.h"
#include "../../program/commands.h"
#include "support/Temporary_folder.h"
#include <CSCD/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace {

void check_manifest_message(const std::exception& error)
{
  const std::string message = error.what();
  if (message.find('\n') != std::string::npos || message.find("fuzz.csv") == std::string::npos) {
    std::cerr << "refused badly: " << message << '\n';
    std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const test_support::Temporary_folder folder;
  const std::string content(data, data + size);
  const std::string filename = folder.write("fuzz.csv", content);
  const std::string input = "a, \"mesh\"\nof two lines.off";
  try {
    {
      cscd::Batch_manifest manifest(filename, true);
      if (!manifest.has(input)) {
        manifest.append({input, cscd::done_status, {"1", "2"}, 0.5, 7, "none"});
      }
    }
    const std::string written = test_support::read_file(filename);
    const cscd::Batch_manifest again(filename, true);
    if (!again.has(input) || test_support::read_file(filename) != written) {
      std::cerr << "a row was lost or changed\n";
      std::abort();
    }
  } catch (const cscd::Usage_error& error) {
    check_manifest_message(error);
  } catch (const CSCD::File_error& error) {
    check_manifest_message(error);
  }
  return 0;
}
