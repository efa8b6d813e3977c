// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of meshes and points.

#ifndef CSCD_IO_MESH_FORMAT_H
#define CSCD_IO_MESH_FORMAT_H

#include <optional>
#include <string>
#include <vector>

namespace CSCD {

/// A file format for polygon meshes.
enum class Mesh_format
{
  off,         ///< Object File Format, ASCII
  obj,         ///< Wavefront OBJ
  ply,         ///< PLY, ASCII or binary
  stl,         ///< STL, ASCII or binary
  vtk,         ///< PolyData of VTK, XML or legacy; read only, as the following ones
  gltf,        ///< glTF 2.0, binary or with its data in it
  neuroglancer ///< the raw mesh of Neuroglancer and DVID
};

/// A file format for point sets.
enum class Point_format
{
  xyz, ///< a line for each point: coordinates, perhaps a normal; or a table with commas or names of columns
  pts, ///< the same, perhaps with the number of points in the first line
  ply, ///< PLY, ASCII or binary, faces ignored
  off, ///< Object File Format, ASCII, faces ignored
  vtk, ///< PolyData of VTK, XML or legacy, cells ignored
  pcd, ///< PCD of the Point Cloud Library, not compressed
  las  ///< LAS, not compressed
};

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd; nothing if
/// there is none.
std::optional<Mesh_format> find_mesh_format(const std::string& filename);

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd.
/// \throw File_error if it names none
Mesh_format mesh_format(const std::string& filename);

/// The format of a mesh to be written to `filename`, as its ending has it.
/// \throw File_error if the format is unknown, or is read only
Mesh_format written_mesh_format(const std::string& filename);

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd; nothing if
/// there is none.
std::optional<Point_format> find_point_format(const std::string& filename);

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd.
/// \throw File_error if it names none
Point_format point_format(const std::string& filename);

/// The endings of the meshes that are read, each with its dot.
std::vector<std::string> mesh_endings();

/// The endings of the points that are read, each with its dot.
std::vector<std::string> point_endings();

/// `filename` without the ending of a file that gzip or zstd has compressed; the same if it does not have one.
std::string without_compression_ending(const std::string& filename);

} // namespace CSCD

#endif // CSCD_IO_MESH_FORMAT_H
