// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks on indices that are all removed in constant time.

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
/// \tparam Epoch an unsigned integer type that numbers the sets
template <class Epoch>
class Basic_epoch_marks
{
public:
  explicit Basic_epoch_marks(std::size_t size = 0) : m_epoch_of(size, 0) {}

  /// Removes all marks; constant time, but for once in as many calls as there are epochs.
  void clear()
  {
    if (m_epoch == std::numeric_limits<Epoch>::max()) {
      std::fill(m_epoch_of.begin(), m_epoch_of.end(), Epoch(0));
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
  std::vector<Epoch> m_epoch_of;
  Epoch m_epoch = 1;
};

using Epoch_marks = Basic_epoch_marks<std::uint32_t>;

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_EPOCH_MARKS_H
