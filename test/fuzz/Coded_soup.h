// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polygon soup as the bytes of fuzz_extract_curve_skeleton.

#ifndef CSCD_TEST_FUZZ_CODED_SOUP_H
#define CSCD_TEST_FUZZ_CODED_SOUP_H

#include "Bytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CSCD::test {

/// The bytes: options, the maximum number of sources, the number of points less one; three signed bytes for each point;
/// then triangles, as three numbers of points each, which count modulo the number of points.
struct Coded_soup
{
  using Triple = std::array<std::uint8_t, 3>;

  static constexpr std::size_t max_number_of_points = 256;
  /// As the surface of a body with all points and some handles has; more make each execution slow.
  static constexpr std::size_t max_number_of_triangles = 600;

  Coded_soup(const std::uint8_t* data, std::size_t size)
  {
    Bytes bytes(data, size);
    options = bytes.take();
    maximum_number_of_sources = bytes.take();
    points.resize(std::size_t(1) + bytes.take());
    for (Triple& point : points) {
      point = take_triple(bytes);
    }
    while (!bytes.is_at_end() && triangles.size() < max_number_of_triangles) {
      Triple triangle = take_triple(bytes);
      for (std::uint8_t& corner : triangle) {
        corner = std::uint8_t(corner % points.size());
      }
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
        triangles.push_back(triangle);
      }
    }
  }

  std::vector<std::uint8_t> bytes() const
  {
    std::vector<std::uint8_t> result{options, maximum_number_of_sources, std::uint8_t(points.size() - 1)};
    for (const std::vector<Triple>* triples : {&points, &triangles}) {
      for (const Triple& triple : *triples) {
        result.insert(result.end(), triple.begin(), triple.end());
      }
    }
    return result;
  }

  std::uint8_t options;
  std::uint8_t maximum_number_of_sources;
  std::vector<Triple> points;
  std::vector<Triple> triangles;

private:
  static Triple take_triple(Bytes& bytes)
  {
    const std::uint8_t first = bytes.take();
    const std::uint8_t second = bytes.take();
    return {first, second, bytes.take()};
  }
};

} // namespace CSCD::test

#endif // CSCD_TEST_FUZZ_CODED_SOUP_H
