// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows hold what was sorted into them, in order, before and after they are shortened.

#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

using CSCD::internal::Compressed_rows;

std::vector<int> row_of(const Compressed_rows<int>& rows, std::size_t row)
{
  return {rows[row].begin(), rows[row].end()};
}

TEST(Compressed_rows, sorts_values_into_rows)
{
  const std::vector<std::pair<std::size_t, int>> values{{3, 7}, {0, 1}, {3, 5}, {0, 1}, {4, 2}, {3, 7}};
  Compressed_rows<int> rows(6, [&](const auto& add) {
    for (const auto& [row, value] : values) {
      add(row, value);
    }
  });
  ASSERT_EQ(rows.number_of_rows(), 6u);
  EXPECT_EQ(rows.number_of_values(), 6u);
  EXPECT_EQ(row_of(rows, 0), (std::vector<int>{1, 1}));
  EXPECT_EQ(rows.size(1), 0u);
  EXPECT_EQ(row_of(rows, 3), (std::vector<int>{7, 5, 7}));
  EXPECT_EQ(rows.begin(3), 2u);
  EXPECT_EQ(row_of(rows, 4), std::vector<int>{2});
  EXPECT_EQ(rows.size(5), 0u);

  rows.reduce_rows([](int* first, int* last) {
    std::sort(first, last);
    return std::unique(first, last);
  });
  EXPECT_EQ(rows.number_of_values(), 4u);
  EXPECT_EQ(row_of(rows, 0), std::vector<int>{1});
  EXPECT_EQ(row_of(rows, 3), (std::vector<int>{5, 7}));
  EXPECT_EQ(row_of(rows, 4), std::vector<int>{2});
  EXPECT_EQ(rows.size(5), 0u);
}

TEST(Compressed_rows, may_be_none)
{
  EXPECT_EQ(Compressed_rows<int>().number_of_rows(), 0u);
  const Compressed_rows<int> empty(2, [](const auto&) {});
  EXPECT_EQ(empty.size(1), 0u);
  EXPECT_EQ(empty.number_of_values(), 0u);
}

} // namespace
