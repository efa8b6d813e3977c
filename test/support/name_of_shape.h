// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names of parameterised tests: that of the shape.

#ifndef CSCD_TEST_SUPPORT_NAME_OF_SHAPE_H
#define CSCD_TEST_SUPPORT_NAME_OF_SHAPE_H

#include "shapes.h"

#include <gtest/gtest.h>

#include <string>

namespace CSCD::test {

inline std::string name_of_shape(const testing::TestParamInfo<Shape_maker>& info)
{
  return info.param.name;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_NAME_OF_SHAPE_H
