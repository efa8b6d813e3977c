// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes separators of curves along edges of a mesh, by either rule.

#ifndef CSCD_SEPARATOR_SEPARATOR_SHORTENING_H
#define CSCD_SEPARATOR_SEPARATOR_SHORTENING_H

#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Separator_flip_shortening.h>
#include <CSCD/Separator/Separator_variational_shortening.h>
#include <CSCD/Separator/Shortening_outcome.h>
#include <CSCD/Traits/Solid_queries.h>
#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/Traits/Vertex_loop.h>
#include <CSCD/internal/Vector_3.h>

#include <optional>

namespace CSCD::internal {

/// Shortening on meshes by edge flips or by the variational flow, as is chosen once. One object serves one thread.
class Separator_shortening
{
public:
  /// \param surface is referred to
  /// \param queries those of `surface`, for the variational flow; null for edge flips
  explicit Separator_shortening(const Triangulated_surface& surface, const Solid_queries* queries = nullptr)
      : m_flips(surface)
  {
    if (queries != nullptr) {
      m_flow.emplace(surface, *queries);
    }
  }

  /// Shortens the closed curve along the edges between consecutive vertices of `loop` within the ball around `source`
  /// that holds it, and sets the crossings and measures of `separator`.
  /// \return `collapsed` where nothing is left that separates; `separator` then stays as it was
  Shortening_outcome shorten_vertex_loop(const Vertex_loop& loop, Index source, Separator& separator)
  {
    return m_flow ? m_flow->shorten_vertex_loop(loop, source, separator)
                  : m_flips.shorten_vertex_loop(loop, source, separator);
  }

private:
  Separator_flip_shortening m_flips;
  std::optional<Separator_variational_shortening> m_flow;
};

} // namespace CSCD::internal

#endif // CSCD_SEPARATOR_SEPARATOR_SHORTENING_H
