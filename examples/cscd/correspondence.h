// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which node the vertices of the input belong to.

#ifndef CSCD_PROGRAM_CORRESPONDENCE_H
#define CSCD_PROGRAM_CORRESPONDENCE_H

#include "types.h"
#include <CSCD/IO/write_correspondence.h>

#include <vector>

namespace cscd {

/// The label of each vertex or point of the file, in its order.
/// \pre `input` has kept what was read
std::vector<CSCD::Vertex_label> labels_of_file(const Input& input, const Skeletonization_result& result);

} // namespace cscd

#endif // CSCD_PROGRAM_CORRESPONDENCE_H
