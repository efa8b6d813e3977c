// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the viewer page shows of a point set beside the surface that was made of it.

#ifndef CSCD_IO_HTML_PAGE_CLOUD_H
#define CSCD_IO_HTML_PAGE_CLOUD_H

#include <cstddef>
#include <vector>

namespace CSCD {

/// The points of a point set, and where the surface was mended.
template <class Point>
struct Html_page_cloud
{
  std::size_t number_of_points =
      0; ///< the first vertices of the mesh are the points; 0 for a mesh that is no such surface
  std::vector<Point> cut_handles; ///< where handles were cut
  std::vector<Point> joined_gaps; ///< where fragments were joined
};

} // namespace CSCD

#endif // CSCD_IO_HTML_PAGE_CLOUD_H
