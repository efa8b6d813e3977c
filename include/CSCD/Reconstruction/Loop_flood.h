// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a loop separates a surface.

#ifndef CSCD_RECONSTRUCTION_LOOP_FLOOD_H
#define CSCD_RECONSTRUCTION_LOOP_FLOOD_H

#include <CSCD/Traits/Triangulated_surface.h>
#include <CSCD/Traits/Vertex_loop.h>
#include <CSCD/internal/Epoch_marks.h>
#include <CSCD/internal/Vector_3.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Floods the faces on both sides of a loop in lock step, so that the work is about that for the smaller side where the
/// loop separates, and until the floods meet where it does not. Loops can be made barriers that no flood crosses.
/// Nothing of the size of the surface is touched for a loop; reuse one object.
class Loop_flood
{
public:
  explicit Loop_flood(const Triangulated_surface& surface)
      : m_surface(surface), m_is_barrier(surface.number_of_halfedges(), 0),
        m_on_loop(surface.number_of_halfedges()), m_side{Epoch_marks(surface.number_of_faces()),
                                                         Epoch_marks(surface.number_of_faces())}
  {
  }

  /// Whether `loop` separates its component of the surface, cut along all barriers.
  /// \pre consecutive vertices are neighbors
  bool separates(const Vertex_loop& loop)
  {
    start(loop);
    for (std::size_t next = 0;; ++next) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (next >= m_front[side].size()) {
          return true;
        }
        if (!expand(m_front[side][next], side)) {
          return false;
        }
      }
    }
  }

  /// The number of faces that the last flood visited.
  std::size_t number_of_visits() const { return m_front[0].size() + m_front[1].size(); }

  /// Keeps all later floods from crossing `loop`.
  void add_barrier(const Vertex_loop& loop)
  {
    for_each_halfedge(loop, [this](Index h) {
      m_is_barrier[h] = 1;
      m_is_barrier[m_surface.twin(h)] = 1;
    });
  }

private:
  template <class Use>
  void for_each_halfedge(const Vertex_loop& loop, const Use& use) const
  {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      use(m_surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
    }
  }

  void start(const Vertex_loop& loop)
  {
    m_on_loop.clear();
    for (std::size_t side = 0; side < 2; ++side) {
      m_front[side].clear();
      m_side[side].clear();
    }
    for_each_halfedge(loop, [this](Index h) {
      m_on_loop.mark(h);
      m_on_loop.mark(m_surface.twin(h));
    });
    for_each_halfedge(loop, [this](Index h) {
      add(Triangulated_surface::face(h), 0);
      add(Triangulated_surface::face(m_surface.twin(h)), 1);
    });
  }

  void add(Index face, std::size_t side)
  {
    if (m_side[side].mark(face)) {
      m_front[side].push_back(face);
    }
  }

  /// Floods the neighbors of `face`. \return whether the other side has not been met
  bool expand(Index face, std::size_t side)
  {
    if (m_side[1 - side].is_marked(face)) {
      return false;
    }
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (m_on_loop.is_marked(h) || m_is_barrier[h] != 0) {
        continue;
      }
      const Index neighbor = Triangulated_surface::face(m_surface.twin(h));
      if (m_side[1 - side].is_marked(neighbor)) {
        return false;
      }
      add(neighbor, side);
    }
    return true;
  }

  const Triangulated_surface& m_surface;
  std::vector<std::uint8_t> m_is_barrier;
  Epoch_marks m_on_loop;
  Epoch_marks m_side[2];
  std::vector<Index> m_front[2];
};

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_LOOP_FLOOD_H
