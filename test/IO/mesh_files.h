// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small mesh files.

#ifndef CSCD_TEST_IO_MESH_FILES_H
#define CSCD_TEST_IO_MESH_FILES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace test_support {

/// Points and polygons from which files are made.
struct Mesh_file_content
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// A cube of 8 points and 6 outward squares.
inline Mesh_file_content cube_of_squares()
{
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

/// The same as 12 triangles.
inline Mesh_file_content cube()
{
  Mesh_file_content result = cube_of_squares();
  std::vector<std::vector<std::size_t>> triangles;
  for (const std::vector<std::size_t>& p : result.polygons) {
    triangles.push_back({p[0], p[1], p[2]});
    triangles.push_back({p[0], p[2], p[3]});
  }
  result.polygons = triangles;
  return result;
}

inline std::string off(const Mesh_file_content& mesh)
{
  std::ostringstream out;
  out << "OFF\n" << mesh.points.size() << ' ' << mesh.polygons.size() << " 0\n";
  for (const auto& [x, y, z] : mesh.points) {
    out << x << ' ' << y << ' ' << z << '\n';
  }
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    out << polygon.size();
    for (std::size_t i : polygon) {
      out << ' ' << i;
    }
    out << '\n';
  }
  return out.str();
}

inline std::string obj(const Mesh_file_content& mesh)
{
  std::ostringstream out;
  for (const auto& [x, y, z] : mesh.points) {
    out << "v " << x << ' ' << y << ' ' << z << '\n';
  }
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    out << 'f';
    for (std::size_t i : polygon) {
      out << ' ' << i + 1;
    }
    out << '\n';
  }
  return out.str();
}

/// The header of a PLY file with coordinates of type float and faces as lists of int.
inline std::string ply_header(const Mesh_file_content& mesh, const std::string& encoding)
{
  return "ply\nformat " + encoding + " 1.0\ncomment a test\nelement vertex " + std::to_string(mesh.points.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.polygons.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ascii_ply(const Mesh_file_content& mesh)
{
  const std::string as_off = off(mesh);
  return ply_header(mesh, "ascii") + as_off.substr(as_off.find('\n', 4) + 1);
}

/// Appends the bytes of a number, least significant first or last.
template <class Number>
void append_bytes(std::string& bytes, Number number, bool is_little_endian = true)
{
  static_assert(sizeof(Number) == 4);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  for (unsigned i = 0; i < 4; ++i) {
    bytes.push_back(static_cast<char>(bits >> (8 * (is_little_endian ? i : 3 - i)) & 0xff));
  }
}

inline std::string binary_ply(const Mesh_file_content& mesh, bool is_little_endian)
{
  std::string result = ply_header(mesh, is_little_endian ? "binary_little_endian" : "binary_big_endian");
  for (const auto& point : mesh.points) {
    for (double coordinate : point) {
      append_bytes(result, static_cast<float>(coordinate), is_little_endian);
    }
  }
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    result.push_back(static_cast<char>(polygon.size()));
    for (std::size_t i : polygon) {
      append_bytes(result, static_cast<std::int32_t>(i), is_little_endian);
    }
  }
  return result;
}

/// STL of a mesh of triangles.
inline std::string ascii_stl(const Mesh_file_content& mesh)
{
  std::ostringstream out;
  out << "solid cube of facets\n";
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    out << " facet normal 0 0 0\n  outer loop\n";
    for (std::size_t i : polygon) {
      const auto& [x, y, z] = mesh.points[i];
      out << "   vertex " << x << ' ' << y << ' ' << z << '\n';
    }
    out << "  endloop\n endfacet\n";
  }
  out << "endsolid cube of facets\n";
  return out.str();
}

/// STL of a mesh of triangles.
/// \param text what the first 80 bytes begin with
inline std::string binary_stl(const Mesh_file_content& mesh, std::string text)
{
  text.resize(80, ' ');
  append_bytes(text, static_cast<std::uint32_t>(mesh.polygons.size()));
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    text.append(12, '\0'); // the normal
    for (std::size_t i : polygon) {
      for (double coordinate : mesh.points[i]) {
        append_bytes(text, static_cast<float>(coordinate));
      }
    }
    text.append(2, '\0');
  }
  return text;
}

} // namespace test_support

#endif // CSCD_TEST_IO_MESH_FILES_H
