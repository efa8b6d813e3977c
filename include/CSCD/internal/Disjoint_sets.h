// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets of indices.

#ifndef CSCD_INTERNAL_DISJOINT_SETS_H
#define CSCD_INTERNAL_DISJOINT_SETS_H

#include <CSCD/Vector_3.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// Boost's disjoint sets with their own memory, which can be copied and prolonged.
class Disjoint_sets
{
public:
  /// Makes a set of each index from 0 to `size` - 1.
  explicit Disjoint_sets(std::size_t size = 0) : m_parent(size), m_rank(size, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), Index(0));
  }

  Index size() const { return Index(m_parent.size()); }

  /// Adds a set of one more index. \return the index
  Index add()
  {
    m_parent.push_back(size());
    m_rank.push_back(0);
    return size() - 1;
  }

  /// The index that represents the set of `index`.
  Index find(Index index) { return sets().find_set(index); }
  /// Unites the sets of `a` and `b`. \return whether they were two
  bool join(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    if (a == b) {
      return false;
    }
    sets().link(a, b);
    return true;
  }

  /// For each index, the number of its set; sets are counted in the order of their first index.
  /// \param number_of_sets is set to the number of all sets
  std::vector<Index> numbers(Index& number_of_sets)
  {
    std::vector<Index> result(size(), no_index);
    number_of_sets = 0;
    for (Index index = 0; index < size(); ++index) {
      const Index root = find(index);
      result[root] = result[root] == no_index ? number_of_sets++ : result[root];
      result[index] = result[root];
    }
    return result;
  }

private:
  // Plain pointers are property maps too, but which of their functions are found depends on what was included before.
  template <class Value>
  using Map = boost::iterator_property_map<Value*, boost::typed_identity_property_map<Index>>;

  boost::disjoint_sets<Map<std::uint8_t>, Map<Index>> sets()
  {
    return {Map<std::uint8_t>(m_rank.data()), Map<Index>(m_parent.data())};
  }

  std::vector<Index> m_parent;
  std::vector<std::uint8_t> m_rank;
};

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_DISJOINT_SETS_H
