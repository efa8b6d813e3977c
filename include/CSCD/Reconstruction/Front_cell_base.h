// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of CGAL's advancing front, made to give the same answer each time.

#ifndef CSCD_RECONSTRUCTION_FRONT_CELL_BASE_H
#define CSCD_RECONSTRUCTION_FRONT_CELL_BASE_H

#include <CSCD/Reconstruction/Time_stamp.h>

#include <CGAL/Advancing_front_surface_reconstruction_cell_base_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>

namespace CSCD::internal {

/// The cell base of CGAL's advancing front, ordered by time: of the two cells at a facet, the front sees it from the
/// lesser one.
template <class Traits, class Base = CGAL::Delaunay_triangulation_cell_base_3<Traits>>
class Front_cell_base : public CGAL::Advancing_front_surface_reconstruction_cell_base_3<Traits, Base>, public Time_stamp
{
  using Front_base = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Traits, Base>;

public:
  // CGAL looks these names up.
  template <class Tds>
  struct Rebind_TDS // NOLINT(readability-identifier-naming): what CGAL calls
  {
    using Rebound_base = typename Base::template Rebind_TDS<Tds>::Other;
    using Other = Front_cell_base<Traits, Rebound_base>;
  };

  using Front_base::Front_base;
};

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_FRONT_CELL_BASE_H
