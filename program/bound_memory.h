// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes that are too large for the memory that the user allows.

#ifndef CSCD_PROGRAM_BOUND_MEMORY_H
#define CSCD_PROGRAM_BOUND_MEMORY_H

#include "types.h"
#include <CSCD/IO/internal/Polygon_soup.h>

#include <cstddef>
#include <optional>
#include <string>

namespace cscd {

/// Makes the triangles of `soup` fewer, if the skeletonization of what it holds is estimated to take more than
/// `options.max_memory` bytes, and as few as needed.
/// \param file_bytes what was in memory beside it while it was read
/// \param other_bytes what else is in memory until the end
/// \param makes_mesh whether a mesh is made of the triangles
/// \return how, if that was done
/// \throw `CSCD::Input_error` if not even that fits
std::optional<Coarse_triangles> bound_memory(CSCD::internal::Polygon_soup& soup, const Skeletonize_options& options,
                                             std::size_t file_bytes, std::size_t other_bytes, bool makes_mesh);

/// As `to_input()`, of triangles that may have been coarsened.
Input to_input(CSCD::internal::Polygon_soup&& soup, std::optional<Coarse_triangles>&& coarse,
               const Skeletonize_options& options, bool makes_mesh);

/// As `read_input()`, coarsened as `bound_memory()` does.
Input read_within_memory(const Skeletonize_options& options, bool makes_mesh);

/// Says that a mesh was coarsened.
std::string sentence(const Memory_bound& bound);

} // namespace cscd

#endif // CSCD_PROGRAM_BOUND_MEMORY_H
