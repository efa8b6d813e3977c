// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small mesh files.

#ifndef CSCD_TEST_IO_MESH_FILES_H
#define CSCD_TEST_IO_MESH_FILES_H

#include "support/Shape.h"

#include <boost/endian/conversion.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace test_support {

/// Points and polygons to make files from.
struct Mesh_file_content
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> polygons;
};

inline Mesh_file_content file_content(const CSCD::test::Shape& shape)
{
  Mesh_file_content result{shape.points, {}};
  for (const CSCD::test::Triangle& triangle : shape.triangles) {
    result.polygons.emplace_back(triangle.begin(), triangle.end());
  }
  return result;
}

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

/// The bytes of a number, least significant first or last.
template <class Number>
std::string number_bytes(Number number, bool is_little_endian = true)
{
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  const bool is_native = is_little_endian == (boost::endian::order::native == boost::endian::order::little);
  return is_native ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

/// The bytes of numbers, each as a `Number`.
template <class Number, class Range>
std::string bytes_of(const Range& numbers, bool is_little_endian = true)
{
  std::string result;
  for (const auto number : numbers) {
    result += number_bytes(static_cast<Number>(number), is_little_endian);
  }
  return result;
}

inline std::string binary_ply(const Mesh_file_content& mesh, bool is_little_endian)
{
  std::string result = ply_header(mesh, is_little_endian ? "binary_little_endian" : "binary_big_endian");
  for (const auto& point : mesh.points) {
    result += bytes_of<float>(point, is_little_endian);
  }
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    result += char(polygon.size()) + bytes_of<std::int32_t>(polygon, is_little_endian);
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
  text += number_bytes(std::uint32_t(mesh.polygons.size()));
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    text.append(12, '\0'); // the normal
    for (std::size_t i : polygon) {
      text += bytes_of<float>(mesh.points[i]);
    }
    text.append(2, '\0');
  }
  return text;
}

/// The coordinates of all points.
inline std::vector<double> coordinates(const Mesh_file_content& mesh)
{
  std::vector<double> result;
  for (const auto& point : mesh.points) {
    result.insert(result.end(), point.begin(), point.end());
  }
  return result;
}

/// The corners of all polygons, before each its size if they are to be.
inline std::vector<std::size_t> corners(const Mesh_file_content& mesh, bool has_sizes = false)
{
  std::vector<std::size_t> result;
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    if (has_sizes) {
      result.push_back(polygon.size());
    }
    result.insert(result.end(), polygon.begin(), polygon.end());
  }
  return result;
}

/// The bytes of text in Base64.
inline std::string from_base64(const std::string& text)
{
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  unsigned bits = 0;
  unsigned number_of_bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | unsigned(digits.find(c));
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      result.push_back(char(bits >> number_of_bits & 0xffU));
    }
  }
  return result;
}

/// Where the polygons end among their corners.
inline std::vector<std::size_t> ends(const Mesh_file_content& mesh)
{
  std::vector<std::size_t> result;
  for (const std::vector<std::size_t>& polygon : mesh.polygons) {
    result.push_back((result.empty() ? 0 : result.back()) + polygon.size());
  }
  return result;
}

template <class Range>
std::string as_text(const Range& numbers)
{
  std::ostringstream out;
  for (const auto number : numbers) {
    out << number << ' ';
  }
  return out.str() + '\n';
}

inline std::string base64(const std::string& bytes)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      bits = bits << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      result.push_back(i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63U]);
    }
  }
  return result;
}

/// Legacy PolyData of VTK.
inline std::string legacy_vtk(const Mesh_file_content& mesh, bool is_binary, bool is_version_5)
{
  const auto ints = [&](const auto& numbers) {
    return is_binary ? bytes_of<std::int32_t>(numbers, false) + '\n' : as_text(numbers);
  };
  const auto floats = [&](const auto& numbers) {
    return is_binary ? bytes_of<float>(numbers, false) + '\n' : as_text(numbers);
  };
  std::string result = "# vtk DataFile Version " + std::string(is_version_5 ? "5.1" : "3.0") + "\na cube\n" +
                       (is_binary ? "BINARY" : "ASCII") + "\nDATASET POLYDATA\nPOINTS " +
                       std::to_string(mesh.points.size()) + " float\n" + floats(coordinates(mesh));
  if (is_version_5) {
    std::vector<std::size_t> offsets = ends(mesh);
    offsets.insert(offsets.begin(), 0);
    result += "METADATA\nINFORMATION 0\n\nPOLYGONS " + std::to_string(offsets.size()) + ' ' +
              std::to_string(corners(mesh).size()) + "\nOFFSETS int\n" + ints(offsets) + "CONNECTIVITY int\n" +
              ints(corners(mesh));
  } else {
    const std::vector<std::size_t> cells = corners(mesh, true);
    result +=
        "POLYGONS " + std::to_string(mesh.polygons.size()) + ' ' + std::to_string(cells.size()) + '\n' + ints(cells);
  }
  const std::vector<double> normals(3 * mesh.points.size(), 0.5);
  const std::vector<int> ids(mesh.points.size(), 7);
  return result + "CELL_DATA " + std::to_string(mesh.polygons.size()) + "\nSCALARS part int 1\nLOOKUP_TABLE default\n" +
         ints(std::vector<int>(mesh.polygons.size(), 3)) + "POINT_DATA " + std::to_string(mesh.points.size()) +
         "\nNORMALS direction float\n" + floats(normals) + "FIELD more 1\nid 1 " + std::to_string(ids.size()) +
         " int\n" + ints(ids);
}

/// XML PolyData of VTK.
/// \param format ascii, binary, or appended
/// \param encoding of appended data: raw or base64
inline std::string vtp(const Mesh_file_content& mesh, const std::string& format, const std::string& encoding = "raw")
{
  std::string appended;
  const auto array = [&](const std::string& attributes, const std::string& text, const std::string& bytes) {
    const std::string size = bytes_of<std::uint32_t>(std::vector<std::size_t>{bytes.size()});
    std::string result = "<DataArray " + attributes + " format=\"" + format + '"';
    if (format == "appended") {
      result += " offset=\"" + std::to_string(appended.size()) + "\"/>\n";
      // the size may be encoded with the data or alone
      appended += encoding == "raw" ? size + bytes : base64(size) + base64(bytes);
      return result;
    }
    return result + ">\n" + (format == "ascii" ? text : base64(size + bytes)) + "\n</DataArray>\n";
  };
  std::string result = "<?xml version=\"1.0\"?>\n<!-- a > cube -->\n<VTKFile type=\"PolyData\" version=\"0.1\" "
                       "byte_order='LittleEndian'>\n<PolyData>\n<Piece NumberOfPoints=\"" +
                       std::to_string(mesh.points.size()) + "\" NumberOfPolys=\"" +
                       std::to_string(mesh.polygons.size()) + "\">\n<Points>\n";
  result += array("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", as_text(coordinates(mesh)),
                  bytes_of<float>(coordinates(mesh))) +
            "</Points>\n<Polys>\n";
  result +=
      array("type=\"Int32\" Name=\"connectivity\"", as_text(corners(mesh)), bytes_of<std::int32_t>(corners(mesh)));
  result += array("type=\"UInt32\" Name=\"offsets\"", as_text(ends(mesh)), bytes_of<std::uint32_t>(ends(mesh))) +
            "</Polys>\n</Piece>\n</PolyData>\n";
  if (format == "appended") {
    result += "<AppendedData encoding=\"" + encoding + "\">\n_" + appended + "\n</AppendedData>\n";
  }
  return result + "</VTKFile>\n";
}

/// The JSON of glTF of a mesh of triangles whose node mirrors, turns and moves it.
/// \param uri what the buffer has besides its length
/// \param other_buffers behind the first one
inline std::string gltf_json(const Mesh_file_content& mesh, const std::string& uri,
                             const std::string& other_buffers = "")
{
  const std::size_t size_of_points = 12 * mesh.points.size();
  const std::size_t number_of_corners = 3 * mesh.polygons.size();
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[1]}],"nodes":[{"mesh":0,"scale":[-1,1,1],"rotation":[)"
         R"(0.5,0.5,0.5,0.5]},{"children":[0],"translation":[2,0,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
         R"("indices":1},{"mode":1,"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
         R"("type":"VEC3","count":)" +
         std::to_string(mesh.points.size()) + R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
         std::to_string(number_of_corners) + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" +
         std::to_string(size_of_points) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(size_of_points) +
         R"(,"byteLength":)" + std::to_string(4 * number_of_corners) + R"(}],"buffers":[{)" + uri + R"("byteLength":)" +
         std::to_string(size_of_points + 4 * number_of_corners) + "}" + other_buffers + "]}";
}

inline std::string gltf(const Mesh_file_content& mesh)
{
  const std::string data = bytes_of<float>(coordinates(mesh)) + bytes_of<std::uint32_t>(corners(mesh));
  return gltf_json(mesh, R"("uri":"data:application/octet-stream;base64,)" + base64(data) + R"(",)");
}

/// \param more_data at the end of the binary chunk
inline std::string glb(const Mesh_file_content& mesh, const std::string& more_data = "",
                       const std::string& other_buffers = "")
{
  const std::string data = bytes_of<float>(coordinates(mesh)) + bytes_of<std::uint32_t>(corners(mesh)) + more_data;
  std::string json = gltf_json(mesh, "", other_buffers);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return "glTF" + bytes_of<std::uint32_t>(std::vector<std::size_t>{2, 28 + json.size() + data.size(), json.size()}) +
         "JSON" + json + bytes_of<std::uint32_t>(std::vector<std::size_t>{data.size()}) + std::string("BIN\0", 4) +
         data;
}

} // namespace test_support

#endif // CSCD_TEST_IO_MESH_FILES_H
