// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of all formats.

#ifndef CSCD_SRC_IO_FORMATS_H
#define CSCD_SRC_IO_FORMATS_H

#include "parse.h"
#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/write_skeleton.h>

#include <optional>
#include <string>
#include <string_view>

namespace CSCD::internal {

/// What an ending of file names stands for.
struct File_format
{
  const char* ending;
  std::optional<Mesh_format> mesh; ///< if meshes are read
  std::optional<Point_format> points;
  bool is_skeleton; ///< whether skeletons are read
  Parser* parse;    ///< null if the format is only written
  Skeleton_writer* write;
};

/// How a whole file is compressed.
enum class Compression
{
  gzip,
  zstd
};

/// The compression that the last ending of `filename` names, in lower or upper case; nothing if it names none.
std::optional<Compression> find_compression(const std::string& filename);

const File_format& file_format(Mesh_format format);
const File_format& file_format(Point_format format);

/// The format of a skeleton to be written to `filename`. \throw File_error if its ending names none
const File_format& written_skeleton_format(const std::string& filename);
/// The format of a skeleton, or a graph, to be read from `filename`. \throw File_error if its ending names none
const File_format& read_skeleton_format(const std::string& filename);

/// \throw File_error if `content` is empty, or malformed
Shape_file parse(std::string_view content, const File_format& format, const std::string& filename, Wanted wanted);

} // namespace CSCD::internal

#endif // CSCD_SRC_IO_FORMATS_H
