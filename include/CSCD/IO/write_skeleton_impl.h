// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_skeleton.h.

#ifndef CSCD_IO_WRITE_SKELETON_IMPL_H
#define CSCD_IO_WRITE_SKELETON_IMPL_H

#include <CSCD/IO/internal/skeleton_endings.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/IO/write_gel_graph.h>
#include <CSCD/IO/write_graphml.h>
#include <CSCD/IO/write_json.h>
#include <CSCD/IO/write_obj.h>
#include <CSCD/IO/write_ply.h>
#include <CSCD/IO/write_polylines.h>
#include <CSCD/IO/write_skeleton.h>
#include <CSCD/IO/write_swc.h>
#include <CSCD/IO/write_vtp.h>
#include <CSCD/internal/config.h>

#include <array>
#include <ostream>
#include <string>

namespace CSCD {

CSCD_INLINE void check_skeleton_filename(const std::string& filename)
{
  internal::skeleton_ending(filename);
}

CSCD_INLINE void internal::write_skeleton(std::ostream& out, const std::string& filename,
                                          const Skeleton_content& skeleton)
{
  // In the order of `skeleton_endings`.
  constexpr std::array<void (*)(std::ostream&, const Skeleton_content&), skeleton_endings.size()> writers{
      write_gel_graph, write_json, write_obj, write_ply, write_polylines, write_swc, write_vtp, write_graphml};
  writers[skeleton_ending(filename)](out, skeleton);
}

CSCD_INLINE void internal::write_skeleton(const std::string& filename, const Skeleton_content& skeleton)
{
  write_file(filename, [&](std::ostream& out) { write_skeleton(out, filename, skeleton); });
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SKELETON_IMPL_H
