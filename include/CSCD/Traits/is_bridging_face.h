// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that only bridge a border, asked of any triangulation.

#ifndef CSCD_TRAITS_IS_BRIDGING_FACE_H
#define CSCD_TRAITS_IS_BRIDGING_FACE_H

#include <CSCD/internal/Vector_3.h>

#include <type_traits>
#include <utility>

namespace CSCD::internal {

template <class Triangulation, class = void>
struct Has_bridging_faces : std::false_type
{
};

template <class Triangulation>
struct Has_bridging_faces<Triangulation,
                          std::void_t<decltype(std::declval<const Triangulation&>().is_bridging(Index(0)))>>
    : std::true_type
{
};

/// Whether `face` only bridges a border, and is no part of the surface; no face of a triangulation without a member
/// `is_bridging(f)` does.
template <class Triangulation>
bool is_bridging_face([[maybe_unused]] const Triangulation& triangulation, [[maybe_unused]] Index face)
{
  if constexpr (Has_bridging_faces<Triangulation>::value) {
    return triangulation.is_bridging(face);
  } else {
    return false;
  }
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_IS_BRIDGING_FACE_H
