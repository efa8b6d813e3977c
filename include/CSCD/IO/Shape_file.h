// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The content of a file of a mesh, of points or of a skeleton, whatever its format.

#ifndef CSCD_IO_SHAPE_FILE_H
#define CSCD_IO_SHAPE_FILE_H

#include <CSCD/Vector3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <string>
#include <vector>

namespace CSCD {

/// Points, polygons and lines as they stand in a file, in flat arrays.
struct Shape_file
{
  /// The points.
  std::vector<Vector3> points;
  /// The normals at the points, if the file has them, else empty.
  std::vector<Vector3> normals;
  /// Whether the file has three further numbers for each point, which are not normals: colors or the like.
  bool has_other_columns = false;
  /// The corners of all polygons, one polygon after the other, as indices into `points`.
  std::vector<Index> corners;
  /// Where each polygon's corners begin in `corners`, and at last their number.
  std::vector<std::size_t> first_corner{0};
  /// Whether the file has polygons, even where these are passed over. Only parsers of formats
  /// that have lines, too, set it: OBJ, PLY and VTK.
  bool has_polygons = false;
  /// The ends of segments, as indices into `points`; not checked yet.
  std::vector<std::array<std::int64_t, 2>> lines;
  /// Those of `lines` that were added to join components, in any order and direction.
  std::vector<std::array<std::int64_t, 2>> joined_lines;
  /// The radii at the points, if the file has them, else empty.
  std::vector<double> radii;
  /// For each point, whether a limb ends there at a border; empty where nothing is known.
  std::vector<char> openings;

  /// How many polygons there are.
  std::size_t number_of_polygons() const { return first_corner.size() - 1; }
  /// How many corners a polygon has.
  std::size_t size_of_polygon(std::size_t polygon) const { return first_corner[polygon + 1] - first_corner[polygon]; }
  /// The number of polygons whose number of corners `is_counted` says to count.
  template <class Predicate>
  std::size_t number_of_polygons(Predicate is_counted) const
  {
    std::size_t number = 0;
    for (std::size_t polygon = 0; polygon < number_of_polygons(); ++polygon) {
      number += is_counted(size_of_polygon(polygon)) ? 1 : 0;
    }
    return number;
  }
  /// Ends the polygon whose corners were appended last.
  void end_polygon() { first_corner.push_back(corners.size()); }
  /// Adds the triangles of a strip: a vertex makes one with the two before it, and every other one is turned.
  void add_strip(const std::vector<Index>& strip)
  {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      corners.insert(corners.end(), {strip[i], strip[i + 1 + i % 2], strip[i + 2 - i % 2]});
      end_polygon();
    }
  }
};

/// The endings of the meshes that are read, each with its dot.
std::vector<std::string> mesh_endings();

/// The endings of the points that are read, each with its dot.
std::vector<std::string> point_endings();

/// `filename` without the ending of a file that gzip has compressed; the same if it does not have one.
std::string without_compression_ending(const std::string& filename);

namespace internal {

/// `vectors` as points or vectors of any type that is constructible from three coordinates.
template <class Triple>
std::vector<Triple> make_triples(const std::vector<Vector3>& vectors)
{
  std::vector<Triple> result;
  result.reserve(vectors.size());
  for (const Vector3& v : vectors) {
    result.emplace_back(v.x(), v.y(), v.z());
  }
  return result;
}

/// Opens a file. \throw File_error if that fails, or it is a folder
std::ifstream open_file(const std::string& filename);

/// \name Contents of files, to be joined by `|`
/// @{
inline constexpr unsigned mesh_content = 1;
inline constexpr unsigned point_content = 2;
inline constexpr unsigned skeleton_content = 4;
inline constexpr unsigned any_content = mesh_content | point_content | skeleton_content;
/// @}

/// Reads what a stream has of `contents`: polygons for a mesh, or else points; for a skeleton nodes, radii and lines.
/// \param name for messages
/// \throw File_error if no format with `contents` has this ending, if `in` cannot be read, is malformed, or has none of
///        them
Shape_file read_shape(std::istream& in, const std::string& ending, const std::string& name, unsigned contents);
/// The same for a file.
Shape_file read_shape(const std::string& filename, unsigned contents);

} // namespace internal

} // namespace CSCD

#endif // CSCD_IO_SHAPE_FILE_H
