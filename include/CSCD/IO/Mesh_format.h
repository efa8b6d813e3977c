// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of meshes and points.

#ifndef CSCD_IO_MESH_FORMAT_H
#define CSCD_IO_MESH_FORMAT_H

#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <locale>
#include <optional>
#include <string>

namespace CSCD {

/// A file format for polygon meshes.
enum class Mesh_format
{
  off, ///< Object File Format, ASCII
  obj, ///< Wavefront OBJ
  ply, ///< PLY, ASCII or binary
  stl  ///< STL, ASCII or binary
};

/// The format that the ending of `filename` names, in lower or upper case.
/// \throw File_error if it names none
inline Mesh_format mesh_format(const std::string& filename)
{
  const std::string::size_type dot = filename.rfind('.');
  const std::string ending =
      boost::algorithm::to_lower_copy(dot == std::string::npos ? "" : filename.substr(dot + 1), std::locale::classic());
  if (ending == "off") {
    return Mesh_format::off;
  }
  if (ending == "obj") {
    return Mesh_format::obj;
  }
  if (ending == "ply") {
    return Mesh_format::ply;
  }
  if (ending == "stl") {
    return Mesh_format::stl;
  }
  throw File_error(filename + ": the ending names no known mesh format; use one of .off .obj .ply .stl");
}

/// A file format for point sets.
enum class Point_format
{
  xyz, ///< a line for each point: coordinates, perhaps a normal
  pts, ///< the same, perhaps with the number of points in the first line
  ply, ///< PLY, ASCII or binary, faces ignored
  off  ///< Object File Format, ASCII, faces ignored
};

/// The format that the ending of `filename` names, in lower or upper case; nothing if it names none.
inline std::optional<Point_format> find_point_format(const std::string& filename)
{
  const std::string::size_type dot = filename.rfind('.');
  const std::string ending =
      boost::algorithm::to_lower_copy(dot == std::string::npos ? "" : filename.substr(dot + 1), std::locale::classic());
  if (ending == "xyz" || ending == "pwn") {
    return Point_format::xyz;
  }
  if (ending == "pts") {
    return Point_format::pts;
  }
  if (ending == "ply") {
    return Point_format::ply;
  }
  if (ending == "off") {
    return Point_format::off;
  }
  return std::nullopt;
}

/// The format that the ending of `filename` names, in lower or upper case.
/// \throw File_error if it names none
inline Point_format point_format(const std::string& filename)
{
  const std::optional<Point_format> format = find_point_format(filename);
  if (!format) {
    throw File_error(filename + ": the ending names no known format of points; use one of .xyz .pwn .pts .ply .off");
  }
  return *format;
}

} // namespace CSCD

#endif // CSCD_IO_MESH_FORMAT_H
