// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where geodesic distance is measured from.

#ifndef CSCD_GEODESIC_GEODESIC_SOURCE_H
#define CSCD_GEODESIC_GEODESIC_SOURCE_H

#include <CSCD/internal/Vector_3.h>

#include <array>

namespace CSCD::internal {

/// A point of a triangulation from which distance is measured: a vertex, or a point of a face.
struct Geodesic_source
{
  static Geodesic_source at_vertex(Index vertex) { return {vertex, no_index, {}}; }
  /// \param coordinates barycentric: of the origins of the halfedges 3 `face`, 3 `face` + 1 and 3 `face` + 2; not
  ///        negative, and with the sum 1
  static Geodesic_source in_face(Index face, const std::array<double, 3>& coordinates)
  {
    return {no_index, face, coordinates};
  }

  bool is_vertex() const { return face == no_index; }

  Index vertex = no_index; ///< `no_index` for a point of a face
  Index face = no_index;   ///< `no_index` for a vertex
  std::array<double, 3> coordinates{};
};

} // namespace CSCD::internal

#endif // CSCD_GEODESIC_GEODESIC_SOURCE_H
