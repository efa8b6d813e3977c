// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flat arrays for local work: rows of values, marks that are removed at once, and disjoint sets.

#ifndef CSCD_INTERNAL_FLAT_ARRAYS_H
#define CSCD_INTERNAL_FLAT_ARRAYS_H

#include <CSCD/Vector3.h>

#include <CGAL/Iterator_range.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Values by the number of their row, one row after the other.
/// \tparam Size counts the values of all rows
template <class Value, class Size = Index>
class Compressed_rows
{
public:
  /// No rows.
  Compressed_rows() = default;

  /// Sorts values into rows by counting; linear. Values of a row keep their order.
  /// \param for_each_value calls its argument by `(row, value)` for all values; it is called twice
  template <class ForEachValue>
  Compressed_rows(std::size_t number_of_rows, const ForEachValue& for_each_value) : m_begin(number_of_rows + 1, 0)
  {
    for_each_value([this](std::size_t row, const Value&) { ++m_begin[row + 1]; });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    std::vector<Size> end(m_begin.begin(), m_begin.end() - 1); // of each row so far
    m_values.resize(m_begin.back());
    for_each_value([this, &end](std::size_t row, const Value& value) { m_values[end[row]++] = value; });
  }

  std::size_t number_of_rows() const { return m_begin.size() - 1; }
  std::size_t number_of_values() const { return m_values.size(); }
  /// The number of values of `row`.
  Size size(std::size_t row) const { return m_begin[row + 1] - m_begin[row]; }
  /// The place of the first value of `row` among all values.
  Size begin(std::size_t row) const { return m_begin[row]; }

  CGAL::Iterator_range<const Value*> operator[](std::size_t row) const
  {
    return {m_values.data() + m_begin[row], m_values.data() + m_begin[row + 1]};
  }
  CGAL::Iterator_range<Value*> operator[](std::size_t row)
  {
    return {m_values.data() + m_begin[row], m_values.data() + m_begin[row + 1]};
  }

  /// The values of all rows.
  const std::vector<Value>& values() const& { return m_values; }
  /// Moves the values of all rows out.
  std::vector<Value> values() && { return std::move(m_values); }

  /// Shortens every row by `reduce(first, last)`, which returns the new end; linear in the calls.
  template <class Reduce>
  void reduce_rows(const Reduce& reduce)
  {
    Value* to = m_values.data();
    for (std::size_t row = 0; row < number_of_rows(); ++row) {
      Value* const first = m_values.data() + m_begin[row];
      Value* const last = reduce(first, m_values.data() + m_begin[row + 1]);
      m_begin[row] = Size(to - m_values.data());
      to = to == first ? last : std::move(first, last, to);
    }
    m_begin.back() = Size(to - m_values.data());
    m_values.resize(m_begin.back());
  }

private:
  std::vector<Size> m_begin{0}; // of every row, and the end of the last one
  std::vector<Value> m_values;
};

/// The values at the places `order`; empty if `values` is.
template <class Value>
std::vector<Value> reordered(const std::vector<Value>& values, const std::vector<Index>& order)
{
  std::vector<Value> result(values.empty() ? 0 : order.size());
  std::transform(order.begin(), order.begin() + std::ptrdiff_t(result.size()), result.begin(),
                 [&values](Index place) { return values[place]; });
  return result;
}

/// 0 to `n` - 1.
inline std::vector<Index> all_indices(std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

/// A set of indices that is emptied in constant time, so that local work costs nothing of the size of the surface.
class Epoch_marks
{
public:
  explicit Epoch_marks(std::size_t size = 0) : m_epoch_of(size, 0) {}

  /// Removes all marks; constant time, except once in 2^32 calls.
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
  std::vector<std::uint32_t> m_epoch_of; // the number of the last set that has it
  std::uint32_t m_epoch = 1;             // the number of the set
};

/// Boost's disjoint sets with their own memory, which can be copied.
class Disjoint_sets
{
public:
  /// Makes a set of each index from 0 to `size` - 1.
  explicit Disjoint_sets(std::size_t size = 0) : m_parent(all_indices(size)), m_rank(size, 0) {}

  /// Likewise, then joins the ends of each of `edges`.
  template <class Edges>
  Disjoint_sets(std::size_t size, const Edges& edges) : Disjoint_sets(size)
  {
    for (const auto& [a, b] : edges) {
      join(a, b);
    }
  }

  Index size() const { return Index(m_parent.size()); }

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
  // Plain pointers are property maps too, but the lookup of their functions depends on earlier includes.
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

#endif // CSCD_INTERNAL_FLAT_ARRAYS_H
