// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether triangles form a surface as they are.

#ifndef CSCD_IO_INTERNAL_PAIR_MANIFOLD_H
#define CSCD_IO_INTERNAL_PAIR_MANIFOLD_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/Traits/check_manifold.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <optional>

namespace CSCD::internal {

/// Pairs the halfedges of `triangles` if these form an oriented manifold, with or without borders. Linear.
inline std::optional<Halfedge_pairing> pair_manifold(const Indexed_triangles& triangles)
{
  const auto is_degenerate = [](const std::array<Index, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  if (triangles.faces.empty() || std::any_of(triangles.faces.begin(), triangles.faces.end(), is_degenerate)) {
    return std::nullopt;
  }
  try {
    return check_manifold(triangles, [](Index vertex) { return vertex; });
  } catch (const Input_error&) {
    return std::nullopt;
  }
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PAIR_MANIFOLD_H
