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
#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <locale>
#include <ostream>
#include <string>

namespace CSCD {

namespace internal {

template <class Skeleton>
struct Skeleton_format
{
  const char* ending;
  void (*write)(std::ostream&, const Skeleton&);
};

template <class Skeleton>
inline constexpr std::array<Skeleton_format<Skeleton>, 9> skeleton_formats{{
    {".graph", write_gel_graph<Skeleton>},
    {".json", write_json<Skeleton>},
    {".obj", write_obj<Skeleton>},
    {".ply", write_ply<Skeleton>},
    {".polylines.txt", write_polylines<Skeleton>},
    {".swc", write_swc<Skeleton>},
    {".vtp", write_vtp<Skeleton>},
    {".dot", write_dot<Skeleton>},
    {".graphml", write_graphml<Skeleton>},
}};

/// The format that the ending of `filename` means, in lower or upper case.
/// \throw File_error if it means none
template <class Skeleton>
const Skeleton_format<Skeleton>& skeleton_format(const std::string& filename)
{
  const std::string lower = boost::algorithm::to_lower_copy(filename, std::locale::classic());
  std::string endings;
  for (const Skeleton_format<Skeleton>& format : skeleton_formats<Skeleton>) {
    if (boost::algorithm::ends_with(lower, format.ending)) {
      return format;
    }
    endings += std::string(endings.empty() ? "" : " ") + format.ending;
  }
  throw File_error(filename + ": the ending names no known skeleton format; use one of " + endings);
}

} // namespace internal

/// writes `skeleton` to the file `filename` in the format that its ending names: `.graph`, `.json`, `.obj`, `.ply`,
/// `.polylines.txt`, `.swc`, `.vtp`, `.dot` or `.graphml`. When it fails there is no new file. Linear.
/// \tparam Skeleton a `Skeleton_graph`, or the skeleton type of CGAL's `Mean_curvature_flow_skeletonization`
/// \throw File_error if the ending is unknown or the file cannot be written
template <class Skeleton>
void write_skeleton(const std::string& filename, const Skeleton& skeleton)
{
  const auto& format = internal::skeleton_format<Skeleton>(filename);
  write_file(filename, [&](std::ostream& out) { format.write(out, skeleton); });
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SKELETON_H
