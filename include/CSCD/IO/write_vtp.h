// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as poly-lines of VTK.

#ifndef CSCD_IO_WRITE_VTP_H
#define CSCD_IO_WRITE_VTP_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>
#include <CSCD/Skeleton/split_into_branches.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CSCD {

namespace internal {

/// Writes the cells `first` to `last` of a PolyData, each a range of nodes.
template <class BranchIterator>
void write_vtp_cells(std::ostream& out, const char* tag, BranchIterator first, BranchIterator last)
{
  out << '<' << tag << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (BranchIterator branch = first; branch != last; ++branch) {
    for (auto v : *branch) {
      out << v << ' ';
    }
    out << '\n';
  }
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t offset = 0;
  for (BranchIterator branch = first; branch != last; ++branch) {
    offset += branch->size();
    out << offset << '\n';
  }
  out << "</DataArray>\n</" << tag << ">\n";
}

/// Writes the point array `Radius` of a PolyData, if the nodes have a radius.
template <class Skeleton>
void write_vtp_radii(std::ostream& out, const Skeleton& skeleton)
{
  if constexpr (has_radius_v<Skeleton>) {
    out << "<PointData Scalars=\"Radius\">\n<DataArray type=\"Float64\" Name=\"Radius\" format=\"ascii\">\n";
    for (auto v : boost::make_iterator_range(vertices(skeleton))) {
      out << radius(skeleton, v) << '\n';
    }
    out << "</DataArray>\n</PointData>\n";
  }
}

} // namespace internal

/// writes `skeleton` as an ASCII `.vtp` file, XML PolyData of VTK: a poly-line for each branch (a vertex cell for each
/// isolated node), the point array `Radius` if the nodes have one, and the cell array `BranchId`. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_vtp(std::ostream& out, const Skeleton& skeleton)
{
  auto branches = split_into_branches(skeleton);
  const auto lines =
      std::stable_partition(branches.begin(), branches.end(), [](const auto& branch) { return branch.size() == 1; });
  internal::Exact_format format(out);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << num_vertices(skeleton) << "\" NumberOfVerts=\"" << lines - branches.begin() << "\" NumberOfLines=\""
      << branches.end() - lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  internal::write_vtp_radii(out, skeleton);
  out << "<CellData Scalars=\"BranchId\">\n<DataArray type=\"Int64\" Name=\"BranchId\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < branches.size(); ++i) {
    out << i << '\n';
  }
  out << "</DataArray>\n</CellData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">\n";
  for (auto v : boost::make_iterator_range(vertices(skeleton))) {
    internal::write_coordinates(out, skeleton, v);
    out << '\n';
  }
  out << "</DataArray>\n</Points>\n";
  internal::write_vtp_cells(out, "Verts", branches.begin(), lines);
  internal::write_vtp_cells(out, "Lines", lines, branches.end());
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_VTP_H
