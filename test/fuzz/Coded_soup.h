// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polygon soup as the bytes of fuzz_extract_curve_skeleton, and its mesh.

#ifndef CSCD_TEST_FUZZ_CODED_SOUP_H
#define CSCD_TEST_FUZZ_CODED_SOUP_H

#include "Bytes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CSCD::test {

/// The bytes: options, the maximum number of sources, the number of points less one; three signed bytes for each point;
/// then triangles, as three numbers of points each, which count modulo the number of points.
struct Coded_soup
{
  using Triple = std::array<std::uint8_t, 3>;

  /// Bits of the first byte.
  enum Option : unsigned
  {
    huge = 1,      ///< coordinates near the largest numbers
    tiny = 2,      ///< coordinates near the smallest numbers
    far_away = 4,  ///< a body much smaller than its distance from the origin
    not_finite = 8 ///< extreme bytes stand for infinity and NaN
  };

  static constexpr std::size_t max_number_of_points = 256;
  /// As the surface of a body with all points and some handles has; more make each execution slow.
  static constexpr std::size_t max_number_of_triangles = 600;

  explicit Coded_soup(Bytes bytes)
  {
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

  double coordinate(std::uint8_t byte) const
  {
    const int value = byte < 128 ? byte : byte - 256;
    if ((options & not_finite) != 0 && (value == 127 || value == -128)) {
      return value == 127 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    }
    const double scale = (options & huge) != 0 ? 1e288 : (options & tiny) != 0 ? 1e-290 : 1;
    return scale * value + ((options & far_away) != 0 ? scale * 1e9 : 0);
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

/// The oriented mesh of a soup; empty if its triangles are not a manifold.
template <class Mesh>
Mesh to_mesh(const Coded_soup& soup)
{
  std::vector<typename Mesh::Point> points;
  for (const Coded_soup::Triple& p : soup.points) {
    points.emplace_back(soup.coordinate(p[0]), soup.coordinate(p[1]), soup.coordinate(p[2]));
  }
  std::vector<std::vector<std::size_t>> polygons;
  for (const Coded_soup::Triple& triangle : soup.triangles) {
    polygons.emplace_back(triangle.begin(), triangle.end());
  }
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons);
  Mesh mesh;
  if (CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons)) {
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  }
  return mesh;
}

} // namespace CSCD::test

#endif // CSCD_TEST_FUZZ_CODED_SOUP_H
