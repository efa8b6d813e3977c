// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CSCD_PROGRAM_WRAP_H
#define CSCD_PROGRAM_WRAP_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>

#include <array>
#include <vector>

namespace cscd {

/// The surface that CGAL's alpha wrapping puts around a mesh: closed, without parts that cut each other, and solid
/// where the inside is reached by narrow holes only. It does not keep the vertices.
/// \param size holes, gaps and hollows that are narrower are closed; relative to the diagonal of the bounding box
/// \throw CSCD::Input_error if nothing can be wrapped
CSCD::Shape_file wrap_mesh(const std::vector<CSCD::Vector3>& points,
                           const std::vector<std::array<CSCD::Index, 3>>& faces, double size);

} // namespace cscd

#endif
