// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parsers and writers of all formats, and the table of these.

#ifndef CSCD_SRC_IO_FORMATS_H
#define CSCD_SRC_IO_FORMATS_H

#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

/// Points are checked behind the parser, and so are corners of polygons, as files may have faces before vertices.
/// \param filename for messages
/// \param contents that are read: points, normals and polygons for a mesh or points; points, radii, openings and lines for
///        a skeleton. The rest is passed over: faults there do not matter, and it takes no memory
/// \throw File_error if `content` is malformed
using Parser = Shape_file(std::string_view content, const std::string& filename, unsigned contents);

// Meshes; some of these formats also hold points alone, or skeletons.
Parser parse_off;
Parser parse_obj;
Parser parse_ply;
Parser parse_stl;
Parser parse_vtk;
Parser parse_gltf;
// Points.
Parser parse_point_table;
Parser parse_pcd;
Parser parse_las;
// Skeletons.
Parser parse_gel_graph;
Parser parse_json_skeleton;
Parser parse_polylines;
Parser parse_swc;

/// \throw File_error naming the file, `fault` and `remedy`
[[noreturn]] inline void fail_in_file(const std::string& filename, const std::string& fault,
                                      const std::string& remedy = "write the file again")
{
  throw File_error(filename + ": " + fault + "; " + remedy);
}

/// \throw File_error telling that the file ends before `what`
[[noreturn]] inline void fail_at_end_of_file(const std::string& filename, const std::string& what)
{
  fail_in_file(filename, "the file ends before " + what, "it seems truncated, fetch or write it again");
}

/// \throw File_error if there are more points than indices, or one is not finite
void check_points(const std::vector<Vector3>& points, const std::string& filename);

/// The meaning of an ending of file names.
struct File_format
{
  const char* ending;
  unsigned contents; ///< that files of this format may have
  Parser* parse;
  void (*write)(std::ostream& out, const Skeleton_content& skeleton); ///< for formats of skeletons
};

/// The format that holds some of `contents` and that the ending of `filename` names. \throw File_error if there is none
const File_format& get_format(const std::string& filename, unsigned contents);

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_FORMATS_H
