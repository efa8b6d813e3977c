// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks on indices that are all taken back in constant time.

#ifndef CSCD_INTERNAL_EPOCH_MARKS_H
#define CSCD_INTERNAL_EPOCH_MARKS_H

#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// A set of indices that is emptied in constant time, so that local work costs nothing of the size of the surface.
class Epoch_marks
{
public:
  explicit Epoch_marks(std::size_t size = 0) : m_epoch_of(size, 0) {}

  /// Takes all marks back.
  void clear()
  {
    if (m_epoch == std::numeric_limits<std::uint32_t>::max()) {
      std::fill(m_epoch_of.begin(), m_epoch_of.end(), 0);
      m_epoch = 0;
    }
    ++m_epoch;
  }

  bool is_marked(Index index) const { return m_epoch_of[index] == m_epoch; }

  /// Marks `index` and returns whether it had not been marked before.
  bool mark(Index index)
  {
    const bool is_new = !is_marked(index);
    m_epoch_of[index] = m_epoch;
    return is_new;
  }

private:
  std::vector<std::uint32_t> m_epoch_of;
  std::uint32_t m_epoch = 1;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_EPOCH_MARKS_H
