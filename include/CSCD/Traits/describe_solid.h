// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The counts that all adapters to triangulated solids report.

#ifndef CSCD_TRAITS_DESCRIBE_SOLID_H
#define CSCD_TRAITS_DESCRIBE_SOLID_H

#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>

namespace CSCD::internal {

/// Writes the counts of `solid` to `report`.
inline void describe_solid(const Triangulated_solid& solid, Skeletonization_report& report)
{
  report.number_of_surface_components = solid.number_of_components();
  report.number_of_bridged_borders = solid.number_of_bridged_borders();
  report.number_of_inserted_vertices = solid.number_of_inserted_vertices();
  report.number_of_degenerate_faces = solid.number_of_degenerate_faces();
  report.number_of_levels = solid.levels().size();
  report.genus = solid.genus();
}

} // namespace CSCD::internal

#endif // CSCD_TRAITS_DESCRIBE_SOLID_H
