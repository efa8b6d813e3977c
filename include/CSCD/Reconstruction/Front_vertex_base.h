// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vertices of CGAL's advancing front, made to give the same answer each time.

#ifndef CSCD_RECONSTRUCTION_FRONT_VERTEX_BASE_H
#define CSCD_RECONSTRUCTION_FRONT_VERTEX_BASE_H

#include <CSCD/Reconstruction/Time_stamp.h>

#include <CGAL/Advancing_front_surface_reconstruction_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_3.h>

#include <cstddef>
#include <tuple>
#include <unordered_map>

namespace CSCD::internal {

/// The order in which a front has met its border edges, in each thread.
class Front_edge_numbers
{
public:
  /// Forgets all edges: to be called before each reconstruction.
  static void clear() { numbers().clear(); }
  /// The number of an edge, the next one if it is met for the first time.
  static std::size_t number(const void* edge) { return numbers().emplace(edge, numbers().size()).first->second; }

private:
  static std::unordered_map<const void*, std::size_t>& numbers()
  {
    thread_local std::unordered_map<const void*, std::size_t> result;
    return result;
  }
};

/// The vertex base of CGAL's advancing front with another order of border edges. The front takes its edges from a set
/// that is ordered by priority and, where that is equal, by address, which differs from call to call; both edges of an
/// ear have equal priority, and so have all whose candidates are bad. Here the edge that was met first comes first. The
/// address serves as a name only: a front keeps its edges in a list to which it appends, and never takes from, while it
/// runs.
template <class Traits, class Base = CGAL::Triangulation_vertex_base_3<Traits>>
class Front_vertex_base : public CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>,
                          public Time_stamp
{
  using Front_base = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Traits, Base>;

public:
  // CGAL looks these names up.
  template <class Tds>
  struct Rebind_TDS // NOLINT(readability-identifier-naming): what CGAL calls
  {
    using Rebound_base = typename Base::template Rebind_TDS<Tds>::Other;
    using Other = Front_vertex_base<Traits, Rebound_base>;
  };

  struct Radius_ptr_type
  {
    using Criteria = typename Front_base::criteria;
    using Edge = typename Front_base::IO_edge_type;

    Radius_ptr_type(Criteria priority, Edge* edge)
        : first(priority), second(edge), number(Front_edge_numbers::number(edge))
    {
    }
    bool operator<(const Radius_ptr_type& other) const
    {
      return std::tie(first, number) < std::tie(other.first, other.number);
    }

    Criteria first;
    Edge* second;
    std::size_t number;
  };

  Front_vertex_base() { this->info() = std::size_t(-1); } // else undefined: no number of a point
};

} // namespace CSCD::internal

#endif // CSCD_RECONSTRUCTION_FRONT_VERTEX_BASE_H
