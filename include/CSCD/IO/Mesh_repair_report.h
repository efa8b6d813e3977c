// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What was mended in a mesh while it was read.

#ifndef CSCD_IO_MESH_REPAIR_REPORT_H
#define CSCD_IO_MESH_REPAIR_REPORT_H

#include <cstddef>
#include <string>
#include <vector>

namespace CSCD {

/// What `read_triangle_mesh()` did so that the polygons of a file became an oriented manifold triangle mesh.
struct Mesh_repair_report
{
  std::size_t number_of_triangulated_polygons = 0; ///< faces of more than three vertices, cut into triangles
  std::size_t number_of_merged_points = 0;         ///< points that repeated the position of another one
  std::size_t number_of_removed_faces = 0;         ///< triangles that named a vertex twice or repeated another triangle
  std::size_t number_of_removed_points = 0;        ///< points left without any face by the repair
  std::size_t number_of_turned_faces = 0;          ///< triangles turned to agree with their neighbours
  std::size_t number_of_duplicated_points = 0;     ///< points doubled where the surface was not a manifold
  std::size_t number_of_turned_components = 0;     ///< closed components turned inside out, as they faced inwards

  /// Whether the mesh is the file's, face by face.
  bool is_empty() const { return sentences().empty(); }

  /// What was done, a sentence each, without a full stop.
  std::vector<std::string> sentences() const
  {
    std::vector<std::string> result;
    const auto add = [&result](std::size_t count, const char* one, const char* many) {
      if (count > 0) {
        result.push_back(std::to_string(count) + ' ' + (count == 1 ? one : many));
      }
    };
    add(number_of_triangulated_polygons, "polygon triangulated", "polygons triangulated");
    add(number_of_merged_points, "duplicate point merged", "duplicate points merged");
    add(number_of_removed_faces, "degenerate or duplicate face removed", "degenerate or duplicate faces removed");
    add(number_of_removed_points, "point without faces removed", "points without faces removed");
    add(number_of_turned_faces, "face turned to agree with its neighbours",
        "faces turned to agree with their neighbours");
    add(number_of_duplicated_points, "point duplicated where the surface is not a manifold",
        "points duplicated where the surface is not a manifold");
    add(number_of_turned_components, "component turned outwards", "components turned outwards");
    return result;
  }
};

} // namespace CSCD

#endif // CSCD_IO_MESH_REPAIR_REPORT_H
