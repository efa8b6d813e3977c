// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One closed surface around a mesh of any kind.

#ifndef CSCD_EXAMPLES_WRAP_H
#define CSCD_EXAMPLES_WRAP_H

#include "types.h"

namespace cscd {

/// Replaces the mesh of `input` by the surface that CGAL's alpha wrapping puts around it: closed, without parts that
/// cut each other, and solid where the inside is reached by narrow holes only. It does not keep the vertices.
/// \param size holes, gaps and hollows that are narrower are closed; relative to the diagonal of the bounding box
/// \throw CSCD::Input_error if nothing can be wrapped
void wrap_mesh(Input& input, double size);

} // namespace cscd

#endif // CSCD_EXAMPLES_WRAP_H
