// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The refusals of a program without the other methods and wraps.

#include "other_methods.h"

namespace cscd {

const bool has_all_methods = false;

void wrap_input(Input& /*input*/, double /*size*/)
{
  refuse_left_out("--wrap");
}

void compute_other_skeleton(Input& /*input*/, const Skeletonize_options& /*options*/, Progress_visitor& /*visitor*/,
                            Skeletonization_result& /*result*/)
{
  refuse_left_out("graphs, --method published");
}

} // namespace cscd
