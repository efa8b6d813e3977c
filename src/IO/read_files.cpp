// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of all formats, their file names, and the reading of files.

#include "IO/decompress.h"
#include "IO/formats.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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
    {".swc", none, none, true, parse_swc,
     [](std::ostream& out, const Skeleton_content& skeleton) { write_swc(out, skeleton); }},
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

constexpr auto is_mesh = [](const File_format& format) { return format.mesh.has_value(); };
constexpr auto is_written_mesh = [](const File_format& format) { return format.mesh && *format.mesh <= Mesh::stl; };
constexpr auto is_points = [](const File_format& format) { return format.points.has_value(); };
constexpr auto is_readable = [](const File_format& format) { return format.parse != nullptr; };
constexpr auto is_written_skeleton = [](const File_format& format) { return format.write != nullptr; };
constexpr auto is_graph = [](const File_format& format) {
  return is_readable(format) && !format.mesh && !format.points;
};
constexpr auto is_read_skeleton = [](const File_format& format) { return format.is_skeleton || is_graph(format); };

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

/// The number of bytes that are left in `in`, or 0 where that is not known, as of a pipe.
std::size_t remaining_size(std::istream& in)
{
  const std::istream::pos_type begin = in.tellg();
  if (begin == std::istream::pos_type(-1)) {
    return 0;
  }
  in.seekg(0, std::ios::end);
  const std::istream::pos_type end = in.tellg();
  in.clear();
  in.seekg(begin);
  return end > begin ? static_cast<std::size_t>(end - begin) : 0;
}

[[noreturn]] void fail_to_read(const std::string& name)
{
  fail_in_file(name, "cannot be read to its end", "check the disk or the connection");
}

/// \throw File_error if `content` is empty, or malformed
Shape_file parse(std::string_view content, const File_format& format, const std::string& filename, Wanted wanted)
{
  if (content.empty()) {
    fail_in_file(filename, "the file is empty", "fetch or write it again");
  }
  return format.parse(content, filename, wanted);
}

void check_polygons(const Shape_file& shape, const std::string& filename)
{
  if (shape.number_of_polygons([](std::size_t size) { return size > 2; }) == 0) {
    fail_in_file(filename, "the file has no faces", "a triangle mesh is needed");
  }
}

void check_points(const Shape_file& shape, const std::string& filename)
{
  if (shape.points.empty()) {
    fail_in_file(filename, "the file has no points", "fetch or write it again");
  }
}

Shape_file parse_polygons(std::string_view content, Mesh_format format, const std::string& filename)
{
  const auto* const found =
      std::find_if(formats.begin(), formats.end(), [format](const File_format& f) { return f.mesh == format; });
  Shape_file shape = parse(content, *found, filename, Wanted::surface);
  check_polygons(shape, filename);
  return shape;
}

Shape_file parse_points(std::string_view content, Point_format format, const std::string& filename)
{
  const auto* const found =
      std::find_if(formats.begin(), formats.end(), [format](const File_format& f) { return f.points == format; });
  Shape_file shape = parse(content, *found, filename, Wanted::surface);
  check_points(shape, filename);
  return shape;
}

[[noreturn]] void fail_at_ending(const std::string& filename)
{
  fail_in_file(filename, "the ending names no known format",
               "use one of " + boost::algorithm::join(mesh_endings(), " ") + " for meshes, " +
                   boost::algorithm::join(point_endings(), " ") + " for points");
}

/// The format of a skeleton, or a graph, to be read from `filename`. \throw File_error if its ending names none
const File_format& read_skeleton_format(const std::string& filename)
{
  const File_format* const written = find_format(filename, is_written_skeleton);
  if (written != nullptr && written->parse == nullptr) {
    fail_in_file(filename, std::string("skeletons are written as ") + written->ending + ", but not read from it",
                 "use one of " + boost::algorithm::join(endings(is_read_skeleton), " "));
  }
  return get_format(filename, "known skeleton format", is_read_skeleton);
}

using Line = std::pair<std::int64_t, std::int64_t>;

/// Checks nodes and lines. Lines from a node to itself and repeated ones are left out: they add nothing to a drawing
/// but would count as cycles.
void check_skeleton(Shape_file& shape, const std::string& filename)
{
  const auto fail = [&filename](const std::string& fault) {
    fail_in_file(filename, fault, "correct or write the file again");
  };
  if (shape.points.empty()) {
    fail_in_file(filename, "the file has no nodes", "fetch or write it again");
  }
  check_number_of_points(shape.points.size(), filename);
  if (!shape.radii.empty() && shape.radii.size() != shape.points.size()) {
    fail("some nodes have a radius and some have none");
  }
  for (std::size_t v = 0; v < shape.radii.size(); ++v) {
    if (!(shape.radii[v] >= 0 && shape.radii[v] <= std::numeric_limits<double>::max())) {
      fail("node " + std::to_string(v) + " (counted from 0) has a radius that is negative or not finite");
    }
  }
  boost::unordered_set<Line> seen;
  std::size_t kept = 0;
  for (const auto& line : shape.lines) {
    for (const std::int64_t node : line) {
      if (node < 0 || std::uint64_t(node) >= shape.points.size()) {
        fail("an edge names node " + std::to_string(node) + ", but there are only " +
             std::to_string(shape.points.size()) + " (counted from 0)");
      }
    }
    if (line[0] != line[1] && seen.insert(std::minmax(line[0], line[1])).second) {
      shape.lines[kept++] = line;
    }
  }
  shape.lines.resize(kept);
}

Skeleton parse_skeleton(std::string_view content, const File_format& format, const std::string& filename)
{
  Shape_file shape = parse(content, format, filename, Wanted::skeleton);
  check_skeleton(shape, filename);
  boost::unordered_set<Line> joined;
  for (const auto& [source, target] : shape.joined_lines) {
    joined.insert(std::minmax(source, target));
  }
  Skeleton result;
  for (const auto& [source, target] : shape.lines) {
    result.edges.push_back({Index(source), Index(target)});
    result.is_joined.push_back(joined.count(std::minmax(source, target)) > 0 ? 1 : 0);
  }
  result.points = std::move(shape.points);
  result.radii = std::move(shape.radii);
  if (std::count(shape.openings.begin(), shape.openings.end(), 1) > 0) {
    result.is_opening = std::move(shape.openings);
  }
  return result;
}

} // namespace

std::optional<Compression> find_compression(const std::string& filename)
{
  return has_ending(filename, ".gz")    ? std::optional(Compression::gzip)
         : has_ending(filename, ".zst") ? std::optional(Compression::zstd)
                                        : std::nullopt;
}

const File_format& written_skeleton_format(const std::string& filename)
{
  return get_format(filename, "known skeleton format", is_written_skeleton);
}

std::string read_content(std::istream& in, const std::string& name, const std::string& format)
{
  if (const std::optional<Compression> compression = find_compression(format)) {
    return *compression == Compression::gzip ? Inflating_stream(in, name).read_all() : read_zstd(in, name);
  }
  constexpr std::size_t block_size = std::size_t(1) << 20; // bytes; large enough that the calls do not count
  std::string content;
  content.reserve(remaining_size(in) + block_size); // growing, it would be in memory twice
  while (in) {
    const std::size_t size = content.size();
    content.resize(size + block_size);
    in.read(content.data() + size, static_cast<std::streamsize>(block_size));
    content.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) {
    fail_to_read(name);
  }
  return content;
}

std::ifstream open_file(const std::string& filename)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error)) {
    fail_in_file(filename, "is a folder", "name a file in it");
  }
  errno = 0;
  std::ifstream in(filename, std::ios::binary);
  if (!in) {
    fail_in_file(filename,
                 std::string("cannot be opened (") + (errno != 0 ? std::strerror(errno) : "unknown reason") + ")",
                 "check the name and the permissions");
  }
  return in;
}

std::string read_content(const std::string& filename)
{
  std::ifstream in = open_file(filename);
  std::error_code error;
  const auto size = std::filesystem::file_size(filename, error);
  if (error || find_compression(filename)) {
    return read_content(in, filename, filename); // a pipe, or of another size
  }
  std::string content(static_cast<std::size_t>(size), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) {
    fail_to_read(filename);
  }
  return content;
}

Shape_file read_polygons(const std::string& filename)
{
  const Mesh_format format = mesh_format(filename);
  return parse_polygons(read_content(filename), format, filename);
}

Shape_file read_polygons(std::istream& in, Mesh_format format, const std::string& name)
{
  return parse_polygons(read_content(in, name), format, name);
}

Shape_file read_polygons_or_points(std::istream& in, const std::string& ending, const std::string& name)
{
  const std::string content = read_content(in, name, ending);
  if (const std::optional<Point_format> points_only = find_point_format(ending)) {
    return parse_points(content, *points_only, name);
  }
  const std::optional<Mesh_format> format = find_mesh_format(ending);
  if (!format) {
    fail_at_ending(ending);
  }
  return parse_polygons(content, *format, name);
}

bool is_graph_filename(const std::string& filename)
{
  const File_format* const format = find_format(without_compression_ending(filename), is_readable);
  return format != nullptr && is_graph(*format);
}

Shape_file read_shape(std::string_view content, const std::string& ending, const std::string& name)
{
  const File_format* const format = find_format(without_compression_ending(ending), is_readable);
  if (format == nullptr) {
    fail_at_ending(ending);
  }
  Shape_file shape = parse(content, *format, name, Wanted::all);
  if (is_graph(*format) || !shape.lines.empty()) {
    check_skeleton(shape, name);
    return shape;
  }
  shape.radii.clear();
  if (format->points || (format->is_skeleton && shape.number_of_polygons() == 0)) {
    check_points(shape, name);
  } else {
    check_polygons(shape, name);
  }
  return shape;
}

Shape_file read_point_file(const std::string& filename)
{
  const Point_format format = point_format(filename);
  return parse_points(read_content(filename), format, filename);
}

Shape_file read_point_file(std::istream& in, Point_format format, const std::string& name)
{
  return parse_points(read_content(in, name), format, name);
}

Skeleton read_indexed_skeleton(const std::string& filename)
{
  const File_format& format = read_skeleton_format(filename);
  return parse_skeleton(read_content(filename), format, filename);
}

Skeleton read_indexed_skeleton(std::istream& in, const std::string& ending, const std::string& name)
{
  const File_format& format = read_skeleton_format(ending);
  return parse_skeleton(read_content(in, name), format, name);
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
