// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as poly-lines of VTK.

#ifndef CSCD_IO_WRITE_VTP_H
#define CSCD_IO_WRITE_VTP_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <vector>

namespace CSCD {
namespace internal {

/// Writes the branches with the numbers from `first` to `last` as cells of a PolyData, each a sequence of nodes.
inline void write_vtp_cells(std::ostream& out, const char* tag, const std::vector<Skeleton_branch>& branches,
                            std::vector<std::size_t>::const_iterator first,
                            std::vector<std::size_t>::const_iterator last)
{
  out << '<' << tag << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (auto number = first; number != last; ++number) {
    for (const Index v : branches[*number].nodes) {
      out << v << ' ';
    }
    out << '\n';
  }
  out << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t offset = 0;
  for (auto number = first; number != last; ++number) {
    offset += branches[*number].nodes.size();
    out << offset << '\n';
  }
  out << "</DataArray>\n</" << tag << ">\n";
}

inline void write_vtp(std::ostream& out, const Skeleton_content& skeleton)
{
  const std::vector<Skeleton_branch> branches = internal::measure_branches(skeleton).branches;
  std::vector<std::size_t> numbers(branches.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const auto lines = std::stable_partition(
      numbers.begin(), numbers.end(), [&branches](std::size_t number) { return branches[number].nodes.size() == 1; });
  Exact_format format(out);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << skeleton.number_of_nodes() << "\" NumberOfVerts=\"" << lines - numbers.begin() << "\" NumberOfLines=\""
      << numbers.end() - lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  if (skeleton.has_radius) {
    out << "<PointData Scalars=\"Radius\">\n<DataArray type=\"Float64\" Name=\"Radius\" format=\"ascii\">\n";
    for (const double radius : skeleton.radii) {
      out << radius << '\n';
    }
    out << "</DataArray>\n";
    if (std::find(skeleton.is_opening.begin(), skeleton.is_opening.end(), 1) != skeleton.is_opening.end()) {
      out << "<DataArray type=\"UInt8\" Name=\"IsOpening\" format=\"ascii\">\n";
      for (const char is_opening : skeleton.is_opening) {
        out << int(is_opening) << '\n';
      }
      out << "</DataArray>\n";
    }
    out << "</PointData>\n";
  }
  out << "<CellData Scalars=\"BranchId\">\n<DataArray type=\"Int64\" Name=\"BranchId\" format=\"ascii\">\n";
  for (const std::size_t number : numbers) {
    out << number << '\n';
  }
  if (skeleton.has_radius) {
    out << "</DataArray>\n<DataArray type=\"Float64\" Name=\"Significance\" format=\"ascii\">\n";
    for (const std::size_t number : numbers) {
      out << finite_significance(branches[number].significance) << '\n';
    }
  }
  out << "</DataArray>\n</CellData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
         "format=\"ascii\">\n";
  for (const Vector_3& point : skeleton.points) {
    write_coordinates(out, point);
    out << '\n';
  }
  out << "</DataArray>\n</Points>\n";
  write_vtp_cells(out, "Verts", branches, numbers.begin(), lines);
  write_vtp_cells(out, "Lines", branches, lines, numbers.end());
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  format.finish();
}

} // namespace internal

/// writes `skeleton` as an ASCII `.vtp` file, XML PolyData of VTK: a poly-line for each branch (a vertex cell for each
/// isolated node), the cell array `BranchId`, the numbers of `measure_branches()`, and, if the nodes have radii, the
/// point array `Radius` and the cell array `Significance`, the greatest double for what is never cut. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_vtp(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_vtp(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_VTP_H
