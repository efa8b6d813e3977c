// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of meshes and points.

#ifndef CSCD_IO_MESH_FORMAT_H
#define CSCD_IO_MESH_FORMAT_H

#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <array>
#include <cstddef>
#include <locale>
#include <optional>
#include <string>
#include <utility>

namespace CSCD {

/// A file format for polygon meshes.
enum class Mesh_format
{
  off,         ///< Object File Format, ASCII
  obj,         ///< Wavefront OBJ
  ply,         ///< PLY, ASCII or binary
  stl,         ///< STL, ASCII or binary
  vtk,         ///< PolyData of VTK, XML or legacy; read only, as what follows
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
  pcd, ///< PCD of the Point Cloud Library
  las  ///< LAS, not compressed
};

namespace internal {

/// The value that `endings` have for the ending of `filename`, in lower or upper case; nothing if there is none.
template <class Format, std::size_t size>
std::optional<Format> find_format(const std::array<std::pair<const char*, Format>, size>& endings,
                                  const std::string& filename)
{
  const std::string::size_type dot = filename.rfind('.');
  const std::string its_ending =
      boost::algorithm::to_lower_copy(dot == std::string::npos ? "" : filename.substr(dot), std::locale::classic());
  for (const auto& [ending, format] : endings) {
    if (its_ending == ending) {
      return format;
    }
  }
  return std::nullopt;
}

/// How a whole file is compressed.
enum class Compression
{
  gzip,
  zstd
};

inline constexpr std::array<std::pair<const char*, Compression>, 2> compression_endings{
    {{".gz", Compression::gzip}, {".zst", Compression::zstd}}};

/// What the last ending of `filename` tells, in lower or upper case; nothing if that is not of a compressed file.
inline std::optional<Compression> find_compression(const std::string& filename)
{
  return find_format(compression_endings, filename);
}

/// `filename` without the ending of a compressed file; the same if it does not have one.
inline std::string without_compression_ending(const std::string& filename)
{
  return find_compression(filename) ? filename.substr(0, filename.rfind('.')) : filename;
}

/// The endings of meshes; those that are written, too, come first.
inline constexpr std::array<std::pair<const char*, Mesh_format>, 9> mesh_endings{
    {{".off", Mesh_format::off},
     {".obj", Mesh_format::obj},
     {".ply", Mesh_format::ply},
     {".stl", Mesh_format::stl},
     {".vtp", Mesh_format::vtk},
     {".vtk", Mesh_format::vtk},
     {".glb", Mesh_format::gltf},
     {".gltf", Mesh_format::gltf},
     {".ngmesh", Mesh_format::neuroglancer}}};

/// The endings of points.
inline constexpr std::array<std::pair<const char*, Point_format>, 13> point_endings{{{".xyz", Point_format::xyz},
                                                                                     {".pwn", Point_format::xyz},
                                                                                     {".pts", Point_format::pts},
                                                                                     {".txt", Point_format::xyz},
                                                                                     {".csv", Point_format::xyz},
                                                                                     {".asc", Point_format::xyz},
                                                                                     {".ply", Point_format::ply},
                                                                                     {".off", Point_format::off},
                                                                                     {".vtp", Point_format::vtk},
                                                                                     {".vtk", Point_format::vtk},
                                                                                     {".pcd", Point_format::pcd},
                                                                                     {".las", Point_format::las},
                                                                                     {".laz", Point_format::las}}};

/// Endings, separated by blanks.
template <class Format, std::size_t size>
std::string list_of_endings(const std::array<std::pair<const char*, Format>, size>& endings)
{
  std::string result;
  for (const auto& [ending, format] : endings) {
    result += std::string(result.empty() ? "" : " ") + ending;
  }
  return result;
}

} // namespace internal

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd.
/// \throw File_error if it names none
inline Mesh_format mesh_format(const std::string& filename)
{
  const std::optional<Mesh_format> format =
      internal::find_format(internal::mesh_endings, internal::without_compression_ending(filename));
  if (!format) {
    throw File_error(filename + ": the ending names no known mesh format; use one of " +
                     internal::list_of_endings(internal::mesh_endings));
  }
  return *format;
}

/// The format of a mesh to be written to `filename`, as its ending has it.
/// \throw File_error if the format is unknown, or is read only
inline Mesh_format written_mesh_format(const std::string& filename)
{
  const std::optional<Mesh_format> format = internal::find_format(internal::mesh_endings, filename);
  if (!format || *format > Mesh_format::stl) {
    throw File_error(filename +
                     ": the ending names no format that meshes are written in; use one of .off .obj .ply .stl");
  }
  return *format;
}

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd; nothing if
/// there is none.
inline std::optional<Point_format> find_point_format(const std::string& filename)
{
  return internal::find_format(internal::point_endings, internal::without_compression_ending(filename));
}

/// The format that the ending of `filename` names, in lower or upper case, before that of gzip or zstd.
/// \throw File_error if it names none
inline Point_format point_format(const std::string& filename)
{
  const std::optional<Point_format> format = find_point_format(filename);
  if (!format) {
    throw File_error(filename + ": the ending names no known format of points; use one of " +
                     internal::list_of_endings(internal::point_endings));
  }
  return *format;
}

} // namespace CSCD

#endif // CSCD_IO_MESH_FORMAT_H
