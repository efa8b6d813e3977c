// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks that are taken back at once, the one time in four thousand million included at which the counter ends.

#include <CSCD/Vector_3.h>
#include <CSCD/internal/flat_arrays.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace {

using CSCD::Index;
using CSCD::internal::Epoch_marks;

TEST(Epoch_marks, tells_whether_a_mark_is_new)
{
  Epoch_marks marks(3);
  for (Index index = 0; index < 3; ++index) {
    EXPECT_FALSE(marks.is_marked(index));
  }
  EXPECT_TRUE(marks.mark(1));
  EXPECT_FALSE(marks.mark(1));
  EXPECT_FALSE(marks.is_marked(0));
  EXPECT_TRUE(marks.is_marked(1));
}

TEST(Epoch_marks, takes_all_marks_back)
{
  Epoch_marks marks(3);
  for (int round = 0; round < 5; ++round) {
    EXPECT_FALSE(marks.is_marked(2));
    EXPECT_TRUE(marks.mark(2));
    marks.clear();
  }
}

TEST(Epoch_marks, survives_the_end_of_its_counter)
{
  CSCD::internal::Basic_epoch_marks<std::uint8_t> marks(2);
  ASSERT_TRUE(marks.mark(0));
  for (int i = 0; i < std::numeric_limits<std::uint8_t>::max(); ++i) {
    marks.clear();
  }
  EXPECT_FALSE(marks.is_marked(0)) << "the first epoch has come back";
  EXPECT_FALSE(marks.is_marked(1));
  EXPECT_TRUE(marks.mark(1));
  marks.clear();
  EXPECT_FALSE(marks.is_marked(1));
}

} // namespace
