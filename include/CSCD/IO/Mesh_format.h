// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file formats that triangle meshes are read from.

#ifndef CSCD_IO_MESH_FORMAT_H
#define CSCD_IO_MESH_FORMAT_H

#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <locale>
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

} // namespace CSCD

#endif // CSCD_IO_MESH_FORMAT_H
