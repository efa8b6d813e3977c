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

#include <istream>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

/// Points are checked behind the parser, and so are corners of polygons, as files may have faces before vertices.
/// \param filename of the file, for others next to it
/// \param contents that are read: points, normals and polygons for a mesh or points; points, radii, openings and lines for
///        a skeleton. The rest is passed over: faults there do not matter, and it takes no memory
/// \throw Content_error if `content` is malformed
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

/// A fault in the content of a file, found where the name of the file is not known. \see naming()
struct Content_error
{
  std::string message; ///< to follow the name of the file
};

/// \param place in the file, as it follows its name
/// \throw Content_error naming the place, `fault` and `remedy`
[[noreturn]] inline void fail(const std::string& fault, const std::string& remedy = "write the file again",
                              const std::string& place = "")
{
  throw Content_error{place + ": " + fault + "; " + remedy};
}

/// \throw Content_error telling that the file ends before `what`
[[noreturn]] inline void fail_at_end(const std::string& what)
{
  fail("the file ends before " + what, "it seems truncated, fetch or write it again");
}

/// The result of `work`, whose messages get the name of the file.
/// \throw File_error, Input_error
template <class Work>
decltype(auto) naming(const std::string& filename, const Work& work)
{
  try {
    return work();
  } catch (const Content_error& error) {
    throw File_error(filename + error.message);
  } catch (const Input_error& error) {
    throw Input_error(filename + ": " + error.what());
  }
}

/// All that is left in `in`, decompressed if `format` ends as the name of a compressed file.
/// \throw Content_error if reading fails, or if it cannot be decompressed
std::string read_content(std::istream& in, const std::string& format);

/// \throw Content_error if there are more points than indices, or one is not finite
void check_points(const std::vector<Vector3>& points);

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
