// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles in the plane: of the lengths that were asked for, and never degenerate.

#include <CSCD/Published/Cotangent_elements.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using CSCD::internal::Face_layout;
using CSCD::internal::lay_out_face;

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

TEST(Face_layout, has_the_lengths_and_the_cotangents)
{
  const std::array<std::array<double, 3>, 4> triangles{{{3, 4, 5}, {5, 3, 4}, {1, 1, 1}, {1e-3, 1, 1}}};
  for (const std::array<double, 3>& lengths : triangles) {
    const Face_layout layout = lay_out_face(lengths, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(distance(layout.corner(k), layout.corner((k + 1) % 3)), lengths[k], 1e-12);
      const double before = lengths[(k + 2) % 3];
      const double opposite = lengths[(k + 1) % 3];
      const double cosine =
          (lengths[k] * lengths[k] + before * before - opposite * opposite) / (2 * lengths[k] * before);
      EXPECT_NEAR(layout.couplings()[k], -cosine / std::sqrt(1 - cosine * cosine) / 2, 1e-10 / lengths[0]);
    }
  }
  EXPECT_NEAR(lay_out_face({3, 4, 5}, 1).area(), 6, 1e-12);
}

TEST(Face_layout, puts_points_where_barycentric_coordinates_say)
{
  const Face_layout layout = lay_out_face({3, 4, 5}, 1);
  EXPECT_NEAR(distance(layout.point({0, 0, 1}), layout.corner(2)), 0, 1e-15);
  const std::array<double, 2> center = layout.point({1. / 3, 1. / 3, 1. / 3});
  EXPECT_NEAR(center[0], (3 + layout.apex_x) / 3, 1e-15);
  EXPECT_NEAR(center[1], layout.apex_y / 3, 1e-15);
}

TEST(Face_layout, is_never_degenerate)
{
  const std::array<std::array<double, 3>, 7> triangles{
      {{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 2, 3}, {3, 1, 2}, {1, 2, 3 + 1e-13}, {1, 1e-300, 1}}};
  for (const std::array<double, 3>& lengths : triangles) {
    for (const double scale : {1e-3, 1., 1e3}) {
      const Face_layout layout = lay_out_face({scale * lengths[0], scale * lengths[1], scale * lengths[2]}, scale);
      EXPECT_GT(layout.base, 0);
      EXPECT_GT(layout.apex_y, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(std::isfinite(layout.couplings()[k]));
        EXPECT_NEAR(distance(layout.corner(k), layout.corner((k + 1) % 3)), scale * lengths[k], 5e-5 * scale);
      }
    }
  }
}

} // namespace
