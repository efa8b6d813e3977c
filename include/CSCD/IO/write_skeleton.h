// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons to files of any known format.

#ifndef CSCD_IO_WRITE_SKELETON_H
#define CSCD_IO_WRITE_SKELETON_H

#include <CSCD/IO/write_dot.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_gel_graph.h>
#include <CSCD/IO/write_graphml.h>
#include <CSCD/IO/write_json.h>
#include <CSCD/IO/write_obj.h>
#include <CSCD/IO/write_ply.h>
#include <CSCD/IO/write_polylines.h>
#include <CSCD/IO/write_swc.h>
#include <CSCD/IO/write_vtp.h>
#include <CSCD/exceptions.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <locale>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

namespace internal {

/// The endings of the formats that skeletons are written in.
inline constexpr std::array<const char*, 9> skeleton_endings{".graph", ".json", ".obj", ".ply",    ".polylines.txt",
                                                             ".swc",   ".vtp",  ".dot", ".graphml"};

/// The position in `skeleton_endings` of the ending of `filename`, in lower or upper case.
/// \throw File_error if it is not one of them
inline std::size_t skeleton_ending(const std::string& filename)
{
  const std::string lower = boost::algorithm::to_lower_copy(filename, std::locale::classic());
  const auto* ending = std::find_if(skeleton_endings.begin(), skeleton_endings.end(), [&](const char* candidate) {
    return boost::algorithm::ends_with(lower, candidate);
  });
  if (ending == skeleton_endings.end()) {
    throw File_error(
        filename + ": the ending names no known skeleton format; use one of " +
        boost::algorithm::join(std::vector<std::string>(skeleton_endings.begin(), skeleton_endings.end()), " "));
  }
  return static_cast<std::size_t>(ending - skeleton_endings.begin());
}

/// The writers, in the order of `skeleton_endings`.
template <class Skeleton>
inline constexpr std::array<void (*)(std::ostream&, const Skeleton&), skeleton_endings.size()> skeleton_writers{
    write_gel_graph<Skeleton>, write_json<Skeleton>,      write_obj<Skeleton>,
    write_ply<Skeleton>,       write_polylines<Skeleton>, write_swc<Skeleton>,
    write_vtp<Skeleton>,       write_dot<Skeleton>,       write_graphml<Skeleton>};

} // namespace internal

/// checks that `write_skeleton()` knows the ending of `filename`, before there is anything to write.
/// \throw File_error if not
inline void check_skeleton_filename(const std::string& filename)
{
  internal::skeleton_ending(filename);
}

/// writes `skeleton` to the file `filename` in the format that its ending names: `.graph`, `.json`, `.obj`, `.ply`,
/// `.polylines.txt`, `.swc`, `.vtp`, `.dot` or `.graphml`. When it fails there is no new file. Linear.
/// \tparam Skeleton a `Skeleton_graph`, or the skeleton type of CGAL's `Mean_curvature_flow_skeletonization`
/// \throw File_error if the ending is unknown or the file cannot be written
template <class Skeleton>
void write_skeleton(const std::string& filename, const Skeleton& skeleton)
{
  const auto write = internal::skeleton_writers<Skeleton>[internal::skeleton_ending(filename)];
  write_file(filename, [&](std::ostream& out) { write(out, skeleton); });
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SKELETON_H
