// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons to files of any known format.

#ifndef CSCD_IO_WRITE_SKELETON_H
#define CSCD_IO_WRITE_SKELETON_H

#include <CSCD/IO/internal/Skeleton_content.h>

#include <ostream>
#include <string>

namespace CSCD {

namespace internal {

void write_skeleton(std::ostream& out, const std::string& filename, const Skeleton_content& skeleton);
void write_skeleton(const std::string& filename, const Skeleton_content& skeleton);

} // namespace internal

/// checks that `write_skeleton()` knows the ending of `filename`, before there is anything to write.
/// \throw File_error if not
void check_skeleton_filename(const std::string& filename);

/// writes `skeleton` to the file `filename` in the format that its ending names: `.graph`, `.json`, `.obj`, `.ply`,
/// `.polylines.txt`, `.swc`, `.vtp` or `.graphml`. When it fails there is no new file. Linear.
/// \tparam Skeleton a `Skeleton_graph`, or the skeleton type of CGAL's `Mean_curvature_flow_skeletonization`
/// \throw File_error if the ending is unknown or the file cannot be written
template <class Skeleton>
void write_skeleton(const std::string& filename, const Skeleton& skeleton)
{
  check_skeleton_filename(filename);
  internal::write_skeleton(filename, internal::skeleton_content(skeleton));
}

/// writes `skeleton` to `out` in the format that the ending of `filename` names. Linear.
/// \tparam Skeleton as of the other function
/// \throw File_error if the ending is unknown or the stream fails
template <class Skeleton>
void write_skeleton(std::ostream& out, const std::string& filename, const Skeleton& skeleton)
{
  internal::write_skeleton(out, filename, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/IO/write_skeleton_impl.h>
#endif

#endif // CSCD_IO_WRITE_SKELETON_H
