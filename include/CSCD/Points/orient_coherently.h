// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns triangles of any orientation so that neighbors agree.

#ifndef CSCD_POINTS_ORIENT_COHERENTLY_H
#define CSCD_POINTS_ORIENT_COHERENTLY_H

#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Turns faces, component by component, so that the two at an edge agree with each other and all with the first.
class Coherent_orientation
{
public:
  explicit Coherent_orientation(std::vector<std::array<Index, 3>>& faces)
      : m_faces(faces), m_opposite(3 * faces.size(), no_index), m_is_met(faces.size(), 0), m_is_turned(faces.size(), 0)
  {
  }

  void operator()()
  {
    find_opposite_sides();
    for (Index face = 0; face < m_faces.size(); ++face) {
      if (m_is_met[face] == 0) {
        flood(face);
      }
    }
    std::vector<std::array<Index, 3>> result;
    result.reserve(m_faces.size());
    for (Index face = 0; face < m_faces.size(); ++face) {
      if (!contradicts_later_face(face)) {
        const auto [a, b, c] = m_faces[face];
        result.push_back(m_is_turned[face] != 0 ? std::array<Index, 3>{a, c, b} : m_faces[face]);
      }
    }
    m_faces = std::move(result);
  }

private:
  /// A side of a face: side `number % 3` of face `number / 3`.
  struct Side
  {
    Index smaller_end;
    Index larger_end;
    Index number;

    bool operator<(const Side& other) const
    {
      return std::tie(smaller_end, larger_end, number) < std::tie(other.smaller_end, other.larger_end, other.number);
    }
  };

  void find_opposite_sides()
  {
    std::vector<Side> sides;
    sides.reserve(m_opposite.size());
    for (Index side = 0; side < m_opposite.size(); ++side) {
      const auto [smaller, larger] = std::minmax(origin(side), target(side));
      sides.push_back({smaller, larger, side});
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Side& side = sides[i - 1];
      const Side& next = sides[i];
      if (side.smaller_end == next.smaller_end && side.larger_end == next.larger_end) {
        m_opposite[side.number] = next.number;
        m_opposite[next.number] = side.number;
      }
    }
  }

  void flood(Index seed)
  {
    m_is_met[seed] = 1;
    m_stack.push_back(seed);
    while (!m_stack.empty()) {
      const Index face = m_stack.back();
      m_stack.pop_back();
      for (Index side = 3 * face; side < 3 * face + 3; ++side) {
        const Index neighbor = m_opposite[side] == no_index ? face : m_opposite[side] / 3;
        if (m_is_met[neighbor] == 0) {
          m_is_met[neighbor] = 1;
          m_is_turned[neighbor] = ascends(side) == ascends(m_opposite[side]) ? 1 : 0;
          m_stack.push_back(neighbor);
        }
      }
    }
  }

  const Index& origin(Index side) const { return m_faces[side / 3][side % 3]; }
  const Index& target(Index side) const { return m_faces[side / 3][(side + 1) % 3]; }
  /// Whether a side runs from its smaller to its larger end, once its face is turned.
  bool ascends(Index side) const { return (origin(side) < target(side)) != (m_is_turned[side / 3] != 0); }

  bool contradicts_later_face(Index face) const
  {
    const auto contradicts = [&](Index side) {
      const Index other = m_opposite[side];
      return other != no_index && other > side && ascends(side) == ascends(other);
    };
    return contradicts(3 * face) || contradicts(3 * face + 1) || contradicts(3 * face + 2);
  }

  std::vector<std::array<Index, 3>>& m_faces;
  std::vector<Index> m_opposite; // of every side, the other one at the same edge
  std::vector<char> m_is_met;
  std::vector<char> m_is_turned;
  std::vector<Index> m_stack;
};

/// Turns `faces` so that the two faces at an edge run through it in opposite directions; each component of faces that
/// are connected through edges keeps the direction of its first face. Where that cannot be, on a surface with one side,
/// faces are dropped. O(n log n).
/// \pre no edge has more than two faces
inline void orient_coherently(std::vector<std::array<Index, 3>>& faces)
{
  Coherent_orientation orientation(faces);
  orientation();
}

} // namespace CSCD::internal

#endif // CSCD_POINTS_ORIENT_COHERENTLY_H
