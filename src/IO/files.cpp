// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of all formats, their file names, and the reading and writing of files.

#include "IO/decompress.h"
#include "IO/formats.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Vector3.h>
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
#include <ostream>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {
namespace {

constexpr std::array<File_format, 21> formats{{
    {".graph", skeleton_content, parse_gel_graph, write_gel_graph},
    {".json", skeleton_content, parse_json_skeleton, write_json},
    {".off", mesh_content | point_content, parse_off, nullptr},
    {".obj", mesh_content | skeleton_content, parse_obj, write_obj},
    {".ply", mesh_content | point_content | skeleton_content, parse_ply, write_ply},
    {".stl", mesh_content, parse_stl, nullptr},
    {".polylines.txt", skeleton_content, parse_polylines, write_polylines},
    {".swc", skeleton_content, parse_swc,
     [](std::ostream& out, const Skeleton_content& skeleton) { write_swc(out, skeleton); }},
    {".vtp", mesh_content | point_content | skeleton_content, parse_vtk, write_vtp},
    {".vtk", mesh_content | point_content, parse_vtk, nullptr},
    {".glb", mesh_content, parse_gltf, nullptr},
    {".gltf", mesh_content, parse_gltf, nullptr},
    {".xyz", point_content, parse_point_table, nullptr},
    {".pwn", point_content, parse_point_table, nullptr},
    {".pts", point_content, parse_point_table, nullptr},
    {".txt", point_content, parse_point_table, nullptr},
    {".csv", point_content, parse_point_table, nullptr},
    {".asc", point_content, parse_point_table, nullptr},
    {".pcd", point_content, parse_pcd, nullptr},
    {".las", point_content, parse_las, nullptr},
    {".laz", point_content, parse_las, nullptr},
}};

constexpr const char* gzip_ending = ".gz";

bool has_ending(const std::string& filename, const char* ending)
{
  return boost::algorithm::iends_with(filename, ending, std::locale::classic());
}

/// The endings of the formats that hold some of `contents`.
std::vector<std::string> endings(unsigned contents)
{
  std::vector<std::string> result;
  for (const File_format& format : formats) {
    if ((format.contents & contents) != 0) {
      result.emplace_back(format.ending);
    }
  }
  return result;
}

/// The format that holds some of `contents` and that the ending of `filename` names; null if there is none.
const File_format* find_format(const std::string& filename, unsigned contents)
{
  const auto* const found = std::find_if(formats.begin(), formats.end(), [&](const File_format& format) {
    return (format.contents & contents) != 0 && has_ending(filename, format.ending);
  });
  return found == formats.end() ? nullptr : found;
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

using Line = std::pair<std::int64_t, std::int64_t>;

/// Checks nodes and lines. Lines from a node to itself and repeated ones are left out: they add nothing to a drawing
/// but would count as cycles.
void check_skeleton(Shape_file& shape)
{
  constexpr const char* remedy = "correct or write the file again";
  if (shape.has_polygons && shape.lines.empty()) {
    fail("the file has faces but no lines: a mesh, not a skeleton", "name a file with lines");
  }
  if (shape.points.empty()) {
    fail("the file has no nodes", "fetch or write it again");
  }
  if (!shape.radii.empty() && shape.radii.size() != shape.points.size()) {
    fail("some nodes have a radius and some have none", remedy);
  }
  for (std::size_t v = 0; v < shape.radii.size(); ++v) {
    if (!(shape.radii[v] >= 0 && shape.radii[v] <= std::numeric_limits<double>::max())) {
      fail("node " + std::to_string(v) + " (counted from 0) has a radius that is negative or not finite", remedy);
    }
  }
  boost::unordered_set<Line> seen;
  std::size_t kept = 0;
  for (const auto& line : shape.lines) {
    for (const std::int64_t node : line) {
      if (node < 0 || std::uint64_t(node) >= shape.points.size()) {
        fail("an edge names node " + std::to_string(node) + ", but there are only " +
                 std::to_string(shape.points.size()) + " (counted from 0)",
             remedy);
      }
    }
    if (line[0] != line[1] && seen.insert(std::minmax(line[0], line[1])).second) {
      shape.lines[kept++] = line;
    }
  }
  shape.lines.resize(kept);
}

/// \throw Content_error if a polygon has a corner that is not one of the points
void check_corners(const Shape_file& shape)
{
  for (const Index corner : shape.corners) {
    if (corner >= shape.points.size()) {
      fail("a face names vertex " + std::to_string(corner) + ", but there are only " +
               std::to_string(shape.points.size()) + " (counted from 0)",
           "the file may be truncated, fetch or write it again");
    }
  }
}

/// \param contents that are asked for and that the format holds
void check(Shape_file& shape, unsigned contents)
{
  check_points(shape.points);
  check_corners(shape);
  if (contents == skeleton_content || ((contents & skeleton_content) != 0 && !shape.lines.empty())) {
    check_skeleton(shape);
    return;
  }
  shape.radii.clear();
  const bool may_be_skeleton = (contents & skeleton_content) != 0;
  if ((contents & point_content) != 0 || (may_be_skeleton && shape.number_of_polygons() == 0)) {
    if (shape.points.empty()) {
      fail("the file has no points", "fetch or write it again");
    }
  } else if (shape.number_of_polygons([](std::size_t size) { return size > 2; }) == 0) {
    fail("the file has no faces", shape.points.empty() ? "a triangle mesh is needed"
                                                       : "name a triangle mesh, or write the points as .xyz or .ply");
  }
}

} // namespace

void check_points(const std::vector<Vector3>& points)
{
  if (points.size() >= no_index) {
    fail("there are more than 4 billion points", "split or simplify the mesh");
  }
  const auto place =
      std::find_if(points.begin(), points.end(), [](const Vector3& point) { return !point.allFinite(); });
  if (place != points.end()) {
    fail("vertex " + std::to_string(place - points.begin()) +
             " has a coordinate that is not finite (vertices count from 0)",
         "correct or write the file again");
  }
}

const File_format& get_format(const std::string& filename, unsigned contents)
{
  const bool may_be_compressed = contents != skeleton_content;
  const File_format* const format =
      find_format(may_be_compressed ? without_compression_ending(filename) : filename, contents);
  if (format == nullptr) {
    throw File_error(filename + ": the ending names no known format; use one of " +
                     boost::algorithm::join(endings(contents), " "));
  }
  return *format;
}

std::string read_content(std::istream& in, const std::string& format)
{
  if (has_ending(format, gzip_ending)) {
    Inflating_buffer buffer(in);
    std::istream inflated(&buffer);
    inflated.exceptions(std::ios::badbit); // passes on those of the buffer
    return read_content(inflated, "");
  }
  std::string content;
  content.reserve(remaining_size(in) + read_block_size); // growing, it would be in memory twice
  while (in) {
    const std::size_t size = content.size();
    content.resize(size + read_block_size);
    in.read(content.data() + size, static_cast<std::streamsize>(read_block_size));
    content.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) {
    fail("cannot be read to its end", "check the disk or the connection");
  }
  return content;
}

std::ifstream open_file(const std::string& filename)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error)) {
    throw File_error(filename + ": is a folder; name a file in it");
  }
  errno = 0;
  std::ifstream in(filename, std::ios::binary);
  if (!in) {
    throw File_error(filename + ": cannot be opened (" + (errno != 0 ? std::strerror(errno) : "unknown reason") +
                     "); check the name and the permissions");
  }
  return in;
}

Shape_file read_shape(std::istream& in, const std::string& ending, const std::string& name, unsigned contents)
{
  const File_format& format = get_format(ending, contents);
  return naming(name, [&] {
    const std::string content = read_content(in, ending);
    if (content.empty()) {
      fail("the file is empty", "fetch or write it again");
    }
    const std::string beginning = content.substr(0, 2);
    const bool has_byte_order_mark = beginning == "\xFF\xFE" || beginning == "\xFE\xFF";
    if (has_byte_order_mark && content.find('\0') < 4) {
      fail("the file is text in UTF-16", "save it as UTF-8");
    }
    Shape_file shape = format.parse(content, name, contents);
    check(shape, contents & format.contents);
    return shape;
  });
}

Shape_file read_shape(const std::string& filename, unsigned contents)
{
  get_format(filename, contents); // before it is opened
  std::ifstream in = open_file(filename);
  return read_shape(in, filename, filename, contents);
}

bool is_graph_filename(const std::string& filename)
{
  const File_format* const format = find_format(without_compression_ending(filename), any_content);
  return format != nullptr && format->contents == skeleton_content;
}

Skeleton to_skeleton(Shape_file&& shape)
{
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

} // namespace internal

std::string without_compression_ending(const std::string& filename)
{
  return internal::has_ending(filename, internal::gzip_ending) ? filename.substr(0, filename.rfind('.')) : filename;
}

std::vector<std::string> mesh_endings()
{
  return internal::endings(internal::mesh_content);
}

std::vector<std::string> point_endings()
{
  return internal::endings(internal::point_content);
}

void check_skeleton_filename(const std::string& filename)
{
  internal::get_format(filename, internal::skeleton_content);
}

namespace {

[[noreturn]] void throw_not_writable(const std::string& filename, const std::string& reason)
{
  throw File_error(filename + ": cannot be written (" + reason + "); check the folder, its permissions and the disk");
}

/// Opens `path`, lets `write` write to it and closes it.
void write_directly(const std::filesystem::path& path, const std::string& filename, const File_group::Write& write)
{
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "no such place");
  }
  write(out);
  out.close();
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "the disk may be full");
  }
}

/// Where a file of this name is, or would be: links are followed.
std::filesystem::path place_of(const std::string& filename)
{
  namespace fs = std::filesystem;
  constexpr int max_number_of_links = 40; // as on Linux
  std::error_code error;
  fs::path place = filename;
  for (int i = 0; i < max_number_of_links && fs::is_symlink(fs::symlink_status(place, error)); ++i) {
    place = place.parent_path() / fs::read_symlink(place, error);
  }
  return place;
}

} // namespace

File_group::~File_group()
{
  for (const File& file : m_files) {
    std::error_code error;
    std::filesystem::remove(file.temporary, error);
  }
}

void File_group::write(const std::string& filename, const Write& write)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  if (fs::is_directory(status)) {
    throw_not_writable(filename, "it is a folder");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_directly(filename, filename, write);
    return;
  }
  const fs::path place = place_of(filename);
  // Next to the file, a name that no other process uses; not with that of the file, which may be as long as names can
  // be.
  const fs::path temporary = place.parent_path() / (".cscd_" + std::to_string(std::random_device()()) + ".part");
  m_files.push_back({filename, place, temporary});
  if (fs::exists(status)) {
    // Before the file holds anything, only those who may read the old one get to read it.
    write_directly(temporary, filename, [](std::ostream&) {});
    fs::permissions(temporary, status.permissions(), error);
  }
  write_directly(temporary, filename, write);
}

void File_group::publish()
{
  // Needs no memory, which might be lacking between two files.
  for (const File& file : m_files) {
    std::error_code error;
    std::filesystem::rename(file.temporary, file.place, error);
    if (error) {
      throw_not_writable(file.name, error.message());
    }
  }
  m_files.clear();
}

void write_file(const std::string& filename, const File_group::Write& write)
{
  File_group file;
  file.write(filename, write);
  file.publish();
}

} // namespace CSCD
