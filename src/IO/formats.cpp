// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of all formats, and what file names say by it.

#include "formats.h"

#include "parse.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <locale>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD {
namespace internal {
namespace {

using Mesh = Mesh_format;
using Points = Point_format;

constexpr std::nullopt_t none = std::nullopt;

/// The formats of written meshes come before the other formats of meshes.
constexpr std::array<File_format, 24> formats{{
    {".graph", none, none, true, parse_gel_graph, write_gel_graph},
    {".json", none, none, true, parse_json_skeleton, write_json},
    {".off", Mesh::off, Points::off, false, parse_off, nullptr},
    {".obj", Mesh::obj, none, true, parse_obj, write_obj},
    {".ply", Mesh::ply, Points::ply, true, parse_ply, write_ply},
    {".stl", Mesh::stl, none, false, parse_stl, nullptr},
    {".polylines.txt", none, none, true, parse_polylines, write_polylines},
    {".swc", none, none, true, parse_swc, write_swc},
    {".vtp", Mesh::vtk, Points::vtk, true, parse_vtk, write_vtp},
    {".vtk", Mesh::vtk, Points::vtk, false, parse_vtk, nullptr},
    {".glb", Mesh::gltf, none, false, parse_gltf, nullptr},
    {".gltf", Mesh::gltf, none, false, parse_gltf, nullptr},
    {".ngmesh", Mesh::neuroglancer, none, false, parse_neuroglancer, nullptr},
    {".graphml", none, none, false, nullptr, write_graphml},
    {".edges", none, none, false, parse_edge_list, nullptr},
    {".xyz", none, Points::xyz, false, parse_point_table, nullptr},
    {".pwn", none, Points::xyz, false, parse_point_table, nullptr},
    {".pts", none, Points::pts, false, parse_point_table, nullptr},
    {".txt", none, Points::xyz, false, parse_point_table, nullptr},
    {".csv", none, Points::xyz, false, parse_point_table, nullptr},
    {".asc", none, Points::xyz, false, parse_point_table, nullptr},
    {".pcd", none, Points::pcd, false, parse_pcd, nullptr},
    {".las", none, Points::las, false, parse_las, nullptr},
    {".laz", none, Points::las, false, parse_las, nullptr},
}};

bool has_ending(const std::string& filename, const char* ending)
{
  return boost::algorithm::iends_with(filename, ending, std::locale::classic());
}

template <class Predicate>
const File_format* find_format(const std::string& filename, const Predicate& is_allowed)
{
  const auto* const found = std::find_if(formats.begin(), formats.end(), [&](const File_format& format) {
    return is_allowed(format) && has_ending(filename, format.ending);
  });
  return found == formats.end() ? nullptr : found;
}

template <class Predicate>
std::vector<std::string> endings(const Predicate& is_counted)
{
  std::vector<std::string> result;
  for (const File_format& format : formats) {
    if (is_counted(format)) {
      result.emplace_back(format.ending);
    }
  }
  return result;
}

bool is_mesh(const File_format& format)
{
  return format.mesh.has_value();
}
bool is_written_mesh(const File_format& format)
{
  return format.mesh && *format.mesh <= Mesh::stl;
}
bool is_points(const File_format& format)
{
  return format.points.has_value();
}
bool is_written_skeleton(const File_format& format)
{
  return format.write != nullptr;
}
bool is_read_skeleton(const File_format& format)
{
  return format.is_skeleton || format.parse == parse_edge_list;
}

/// \param kind for messages
template <class Predicate>
const File_format& get_format(const std::string& filename, const char* kind, const Predicate& is_allowed)
{
  const File_format* const format = find_format(filename, is_allowed);
  if (format == nullptr) {
    fail_in_file(filename, std::string("the ending names no ") + kind,
                 "use one of " + boost::algorithm::join(endings(is_allowed), " "));
  }
  return *format;
}

} // namespace

std::optional<Compression> find_compression(const std::string& filename)
{
  return has_ending(filename, ".gz")    ? std::optional(Compression::gzip)
         : has_ending(filename, ".zst") ? std::optional(Compression::zstd)
                                        : std::nullopt;
}

const File_format& file_format(Mesh_format format)
{
  return *std::find_if(formats.begin(), formats.end(), [format](const File_format& f) { return f.mesh == format; });
}

const File_format& file_format(Point_format format)
{
  return *std::find_if(formats.begin(), formats.end(), [format](const File_format& f) { return f.points == format; });
}

const File_format& written_skeleton_format(const std::string& filename)
{
  return get_format(filename, "known skeleton format", is_written_skeleton);
}

const File_format& read_skeleton_format(const std::string& filename)
{
  const File_format* const written = find_format(filename, is_written_skeleton);
  if (written != nullptr && written->parse == nullptr) {
    fail_in_file(filename, std::string("skeletons are written as ") + written->ending + ", but not read from it",
                 "use one of " + boost::algorithm::join(endings(is_read_skeleton), " "));
  }
  return get_format(filename, "known skeleton format", is_read_skeleton);
}

Shape_file parse(std::string_view content, const File_format& format, const std::string& filename, Wanted wanted)
{
  if (content.empty()) {
    fail_in_file(filename, "the file is empty", "fetch or write it again");
  }
  return format.parse(content, filename, wanted);
}

} // namespace internal

std::string without_compression_ending(const std::string& filename)
{
  return internal::find_compression(filename) ? filename.substr(0, filename.rfind('.')) : filename;
}

std::optional<Mesh_format> find_mesh_format(const std::string& filename)
{
  const auto* const format = internal::find_format(without_compression_ending(filename), internal::is_mesh);
  return format != nullptr ? format->mesh : std::nullopt;
}

Mesh_format mesh_format(const std::string& filename)
{
  const std::optional<Mesh_format> format = find_mesh_format(filename);
  return format ? *format : *internal::get_format(filename, "known mesh format", internal::is_mesh).mesh;
}

Mesh_format written_mesh_format(const std::string& filename)
{
  return *internal::get_format(filename, "format that meshes are written in", internal::is_written_mesh).mesh;
}

std::optional<Point_format> find_point_format(const std::string& filename)
{
  const auto* const format = internal::find_format(without_compression_ending(filename), internal::is_points);
  return format != nullptr ? format->points : std::nullopt;
}

Point_format point_format(const std::string& filename)
{
  const std::optional<Point_format> format = find_point_format(filename);
  return format ? *format : *internal::get_format(filename, "known format of points", internal::is_points).points;
}

std::vector<std::string> mesh_endings()
{
  return internal::endings(internal::is_mesh);
}

std::vector<std::string> point_endings()
{
  return internal::endings(internal::is_points);
}

void check_readable_skeleton_filename(const std::string& filename)
{
  internal::read_skeleton_format(filename);
}

void check_skeleton_filename(const std::string& filename)
{
  internal::written_skeleton_format(filename);
}

} // namespace CSCD
