// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes as input of `cscd skeletonize`.

#ifndef CSCD_PROGRAM_VOLUMES_H
#define CSCD_PROGRAM_VOLUMES_H

#include "types.h"

#include <functional>
#include <string>

namespace cscd {

/// Whether the input is a volume, by its ending.
bool is_volume(const Skeletonize_options& options);

/// Whether `output` is a volume of node numbers.
bool is_node_volume(const std::string& output);

/// Refuses options of volumes that exclude each other, and outputs that need a volume.
/// \throw Usage_error
void check_volume_options(const Skeletonize_options& options);

/// Skeletonizes the surface of a body in a volume and writes the results, except volumes, to `files`.
using Skeletonize_body =
    std::function<Skeletonization_result(CSCD::File_group& files, Input& body, const Skeletonize_options& options)>;

/// Reads the surfaces of the bodies in a volume, calls `skeletonize_body` for each after its last slice, and writes
/// volumes of node numbers. If each label is a body, the names of the files hold it, and its files are published before
/// the next label begins.
/// \throw `CSCD::File_error`, `CSCD::Input_error`
void skeletonize_volume(CSCD::File_group& files, const Skeletonize_options& options,
                        const Skeletonize_body& skeletonize_body);

} // namespace cscd

#endif // CSCD_PROGRAM_VOLUMES_H
