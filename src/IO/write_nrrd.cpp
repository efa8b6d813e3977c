// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_nrrd.h.

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <CGAL/assertions.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <ostream>
#include <vector>

namespace CSCD {

namespace {

/// Writes the header of NRRD for labels of 32 bits that follow raw.
void write_nrrd_header(std::ostream& out, const Volume_grid& grid)
{
  const internal::Exact_format format(out);
  const auto vector = [&out](const Vector3& v) -> std::ostream& {
    return out << '(' << v.x() << ',' << v.y() << ',' << v.z() << ')';
  };
  out << "NRRD0004\ntype: uint32\ndimension: 3\nspace dimension: 3\nsizes: " << grid.size[0] << ' ' << grid.size[1]
      << ' ' << grid.size[2] << "\nspace directions: ";
  vector(grid.axes[0]) << ' ';
  vector(grid.axes[1]) << ' ';
  vector(grid.axes[2]) << "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: ";
  vector(grid.origin) << "\n\n";
}

void write_nrrd_labels(std::ostream& out, std::vector<std::uint32_t> labels)
{
  for (std::uint32_t& label : labels) {
    boost::endian::native_to_little_inplace(label);
  }
  out.write(reinterpret_cast<const char*>(labels.data()), std::streamsize(labels.size() * sizeof(std::uint32_t)));
}

} // namespace

void write_nrrd(std::ostream& out, const Volume& volume)
{
  CGAL_precondition(volume.labels.size() == volume.grid.number_of_voxels());
  write_nrrd_header(out, volume.grid);
  write_nrrd_labels(out, volume.labels);
}

void write_node_volume(std::ostream& out, Volume_reader& reader, const std::vector<Voxel_surface>& surfaces,
                       const std::vector<std::vector<std::uint32_t>>& node_of_vertex)
{
  CGAL_precondition(surfaces.size() == node_of_vertex.size());
  std::map<std::uint32_t, std::size_t> surface_of_label;
  std::deque<internal::Point_tree> vertices; // of each surface; trees cannot be moved
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surface_of_label.emplace(surfaces[i].label, i);
    vertices.emplace_back(surfaces[i].triangles.points);
  }
  const Volume_grid& grid = reader.grid();
  write_nrrd_header(out, grid);
  std::vector<std::uint32_t> labels;
  for (std::size_t z = 0; z < grid.size[2]; ++z) {
    reader.read_slice(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto found = labels[i] == 0 ? surface_of_label.end() : surface_of_label.find(labels[i]);
      const bool has_node = found != surface_of_label.end();
      const std::size_t y = i / grid.size[0];
      const Vector3 point = grid.point({double(i % grid.size[0]), double(y), double(z)});
      labels[i] = has_node ? node_of_vertex[found->second][vertices[found->second].nearest(point)] : 0;
    }
    write_nrrd_labels(out, labels);
  }
}

} // namespace CSCD
