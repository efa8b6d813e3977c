// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of read_content.h, read_points.h and read_skeleton.h, and how meshes are read.

#include "decompress.h"
#include "formats.h"
#include "parse.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/internal/read_content.h>
#include <CSCD/IO/read_points.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CSCD::internal {

namespace {

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

Shape_file parse_polygons(std::string_view content, Mesh_format format, const std::string& filename)
{
  Shape_file shape = parse(content, file_format(format), filename, Wanted::surface);
  if (shape.number_of_polygons([](std::size_t size) { return size > 2; }) == 0) {
    fail_in_file(filename, "the file has no faces", "a triangle mesh is needed");
  }
  return shape;
}

Shape_file parse_points(std::string_view content, Point_format format, const std::string& filename)
{
  Shape_file shape = parse(content, file_format(format), filename, Wanted::surface);
  if (shape.points.empty()) {
    fail_in_file(filename, "the file has no points", "fetch or write it again");
  }
  return shape;
}

using Segment = std::pair<std::int64_t, std::int64_t>;

/// Checks nodes and lines. Lines from a node to itself and repeated ones are left out: they add nothing to a drawing
/// but would count as cycles.
class Skeleton_maker
{
public:
  Skeleton_maker(Shape_file&& shape, const std::string& filename) : m_shape(std::move(shape)), m_filename(filename) {}

  Indexed_skeleton make()
  {
    if (m_shape.points.empty()) {
      fail_in_file(m_filename, "the file has no nodes", "fetch or write it again");
    }
    check_number_of_points(m_shape.points.size(), m_filename);
    Indexed_skeleton result;
    check_radii();
    add_edges(result);
    result.points = std::move(m_shape.points);
    result.radii = std::move(m_shape.radii);
    if (std::count(m_shape.openings.begin(), m_shape.openings.end(), 1) > 0) {
      result.is_opening = std::move(m_shape.openings);
    }
    return result;
  }

private:
  void check_radii() const
  {
    if (!m_shape.radii.empty() && m_shape.radii.size() != m_shape.points.size()) {
      fail("some nodes have a radius and some have none");
    }
    for (std::size_t v = 0; v < m_shape.radii.size(); ++v) {
      if (!(m_shape.radii[v] >= 0 && m_shape.radii[v] <= std::numeric_limits<double>::max())) {
        fail("node " + std::to_string(v) + " (counted from 0) has a radius that is negative or not finite");
      }
    }
  }

  void add_edges(Indexed_skeleton& result) const
  {
    boost::unordered_set<Segment> joined;
    for (const auto& [source, target] : m_shape.joined_lines) {
      joined.insert(std::minmax(source, target));
    }
    boost::unordered_set<Segment> seen;
    for (const auto& [source, target] : m_shape.lines) {
      check_node(source);
      check_node(target);
      if (source != target && seen.insert(std::minmax(source, target)).second) {
        result.edges.push_back({Index(source), Index(target)});
        result.is_joined.push_back(joined.count(std::minmax(source, target)) > 0 ? 1 : 0);
      }
    }
  }

  void check_node(std::int64_t node) const
  {
    if (node < 0 || std::uint64_t(node) >= m_shape.points.size()) {
      fail("an edge names node " + std::to_string(node) + ", but there are only " +
           std::to_string(m_shape.points.size()) + " (counted from 0)");
    }
  }

  [[noreturn]] void fail(const std::string& fault) const
  {
    fail_in_file(m_filename, fault, "correct or write the file again");
  }

  Shape_file m_shape;
  std::string m_filename;
};

Indexed_skeleton parse_skeleton(std::string_view content, const File_format& format, const std::string& filename)
{
  return Skeleton_maker(parse(content, format, filename, Wanted::skeleton), filename).make();
}

} // namespace

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

std::string read_content(const std::string& filename)
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
  return read_polygons_or_points(read_content(in, name, ending), ending, name);
}

Shape_file read_polygons_or_points(std::string_view content, const std::string& ending, const std::string& name)
{
  if (const std::optional<Point_format> points_only = find_point_format(ending)) {
    return parse_points(content, *points_only, name);
  }
  const std::optional<Mesh_format> format = find_mesh_format(ending);
  if (!format) {
    fail_in_file(ending, "the ending names no known format",
                 "use one of " + boost::algorithm::join(mesh_endings(), " ") + " for meshes, " +
                     boost::algorithm::join(point_endings(), " ") + " for points");
  }
  return parse_polygons(content, *format, name);
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

Indexed_skeleton read_indexed_skeleton(const std::string& filename)
{
  const File_format& format = read_skeleton_format(filename);
  return parse_skeleton(read_content(filename), format, filename);
}

Indexed_skeleton read_indexed_skeleton(std::istream& in, const std::string& ending, const std::string& name)
{
  return read_indexed_skeleton(read_content(in, name), ending, name);
}

Indexed_skeleton read_indexed_skeleton(std::string_view content, const std::string& ending, const std::string& name)
{
  return parse_skeleton(content, read_skeleton_format(ending), name);
}

} // namespace CSCD::internal
