// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons to files of any known format.

#ifndef CSCD_IO_WRITE_SKELETON_H
#define CSCD_IO_WRITE_SKELETON_H

#include <CSCD/IO/internal/skeleton_access.h>
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

#include <array>
#include <ostream>
#include <string>

namespace CSCD {

namespace internal {

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
