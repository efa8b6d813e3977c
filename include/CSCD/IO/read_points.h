// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point sets from files.

#ifndef CSCD_IO_READ_POINTS_H
#define CSCD_IO_READ_POINTS_H

#include <CSCD/IO/Shape_file.h>

#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CSCD {

namespace internal {

/// Writes points and normals to ranges of any type.
template <class Point, class Vector>
void convert_to_points(const Shape_file& file, std::vector<Point>& points, std::vector<Vector>& normals)
{
  std::vector<Point> new_points = make_triples<Point>(file.points);
  normals = make_triples<Vector>(file.normals);
  points = std::move(new_points);
}

} // namespace internal

/// reads the points that the file `filename` holds, and their normals, if there are any for all points. Its ending, in
/// lower or upper case, names the format:
/// - `.xyz`, `.pwn`, `.pts`, `.txt`, `.csv`, `.asc`: a point a line, with or without a normal; or a table with commas
///   or names of columns;
/// - `.off`, `.ply`, `.vtp`, `.vtk`: as meshes, without their faces;
/// - `.pcd` of the Point Cloud Library, and `.las`, both not compressed.
///
/// With a further ending `.gz` it is decompressed first. Linear.
/// \tparam Point, Vector constructible from three coordinates
/// \param points, normals are replaced; when an exception is thrown they are as they were
/// \throw File_error if the file cannot be read, is malformed, or has no points
template <class Point, class Vector>
void read_points(const std::string& filename, std::vector<Point>& points, std::vector<Vector>& normals)
{
  internal::convert_to_points(internal::read_shape(filename, internal::point_content), points, normals);
}

/// reads points from a stream, which for binary formats must not translate line ends; see the function for files.
/// \param ending of the format, such as `.xyz`
/// \param name the name of the stream in messages
template <class Point, class Vector>
void read_points(std::istream& in, const std::string& ending, const std::string& name, std::vector<Point>& points,
                 std::vector<Vector>& normals)
{
  internal::convert_to_points(internal::read_shape(in, ending, name, internal::point_content), points, normals);
}

} // namespace CSCD

#endif // CSCD_IO_READ_POINTS_H
