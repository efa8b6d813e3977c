// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `cscd compare`: from two files to figures.

#include "compare.h"

#include "Skeletonize_options.h"
#include "Usage_error.h"
#include "read_skeleton_argument.h"
#include "types.h"
#include "write_measures.h"
#include <CSCD/Measure/Compared_skeleton.h>
#include <CSCD/Measure/compare_skeletons.h>
#include <CSCD/Named_parameters.h>

#include <iostream>

namespace cscd {

void compare(const Compare_options& options)
{
  check_skeleton_argument(options.first);
  check_skeleton_argument(options.second);
  if (options.first == standard_stream && options.second == standard_stream) {
    throw Usage_error("only one of the skeletons can be standard input");
  }
  const Skeleton first = read_skeleton_argument(options.first);
  const Skeleton second = read_skeleton_argument(options.second);
  const CSCD::Skeleton_comparison comparison =
      CSCD::compare_skeletons(first, second, CSCD::parameters::match_distance(options.match_distance));
  if (options.is_json) {
    write_comparison_as_json(std::cout, options, comparison);
  } else {
    write_comparison(std::cout, options, comparison);
  }
}

} // namespace cscd
