// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading a skeleton that is named on the command line.

#include "read_skeleton_argument.h"

#include "Skeletonize_options.h"
#include "Usage_error.h"
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/exceptions.h>

#include <iostream>

namespace cscd {

void check_skeleton_argument(const std::string& filename)
{
  if (filename == standard_stream) {
    return;
  }
  try {
    CSCD::check_readable_skeleton_filename(filename);
  } catch (const CSCD::File_error& error) {
    throw Usage_error(error.what());
  }
}

Skeleton read_skeleton_argument(const std::string& filename)
{
  Skeleton skeleton;
  if (filename == standard_stream) {
    CSCD::read_skeleton(std::cin, ".graph", "standard input", skeleton);
  } else {
    CSCD::read_skeleton(filename, skeleton);
  }
  return skeleton;
}

} // namespace cscd
