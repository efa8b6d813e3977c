// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of different lengths in one flat array.

#ifndef CSCD_INTERNAL_COMPRESSED_ROWS_H
#define CSCD_INTERNAL_COMPRESSED_ROWS_H

#include <CSCD/Vector_3.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
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
    std::vector<Size> end(m_begin.begin(), m_begin.end() - 1); // of what is in the row so far
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

  /// Shortens every row to what `reduce(first, last)` leaves of it, which returns the new end; linear in the calls.
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

} // namespace CSCD::internal

#endif // CSCD_INTERNAL_COMPRESSED_ROWS_H
