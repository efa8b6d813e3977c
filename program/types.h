// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The types and functions that the parts of the program share.

#ifndef CSCD_PROGRAM_TYPES_H
#define CSCD_PROGRAM_TYPES_H

#include "options.h"
#include "write_report.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_skeleton.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/IO/write_file.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Measure/Skeleton_measures.h>
#include <CSCD/Measure/simplify_skeleton.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Vector3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iostream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace cscd {

using CSCD::Index;
using CSCD::Skeleton;
using CSCD::Vector3;

/// A mesh, or points, if the file has no faces.
struct Input
{
  bool is_point_set = false;
  /// The vertices of the mesh; or the points, and behind them vertices that the surface made of these has besides.
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> faces; ///< of the mesh, or of the surface that is made of the points
  bool is_kept = true; ///< whether points and faces of a mesh are needed after the computation of the skeleton
  CSCD::Mesh_repair_report repairs;
  std::size_t number_of_points = 0;  ///< of a point set
  std::vector<Vector3> normals;      ///< of the points, or empty
  std::optional<Skeleton> graph;     ///< if treated as a graph: its vertices are the points
  std::optional<Volume_body> volume; ///< if the mesh is the surface of voxels
  bool is_wrapped = false;           ///< whether the mesh is a wrap around that of the file
  CSCD::Shape_file as_read;          ///< the contents of the file, if kept, with its points where repairs moved them
};

/// Called with a stage and the part of it that is done, in [0, 1]; an exception that it throws ends the work.
using Stage_progress = std::function<void(CSCD::Skeletonization_stage stage, double fraction)>;

/// Reads the file `name`, or standard input if that is `standard_stream`.
/// \param format of the input, or empty for that of its ending
/// \param contents that are asked for
/// \throw Usage_error if standard input has no format; `CSCD::File_error` if it has none of the contents
CSCD::Shape_file read_file(const std::string& name, const std::string& format, unsigned contents);

/// Reads a mesh or points as `read_file()` does, and writes the repairs to standard error unless `is_quiet`.
/// \param keeps_file whether the input is also kept as it was read
/// \param number_of_threads 0 for all of the machine
/// \throw `CSCD::Input_error` if it cannot be repaired
Input read_input(const std::string& name, const std::string& format, bool is_quiet, bool keeps_file = false,
                 unsigned number_of_threads = 1);

/// As `read_input()`, for commands that need a mesh. \throw `CSCD::Input_error` for points, too
Input read_mesh(const std::string& name, const std::string& format, bool is_quiet, bool keeps_file = false);

/// Makes triangles or points of `soup`, as `read_input()` does, and reports repairs.
Input to_input(CSCD::Shape_file&& soup, const std::string& name, bool is_quiet, bool keeps_file,
               unsigned number_of_threads);

/// The input whose mesh has these triangles.
Input make_input(CSCD::Indexed_triangles&& triangles);

/// Reads a graph: that of a skeleton file, the edges of a mesh, or points joined to their neighbors.
/// \throw Usage_error, `CSCD::File_error`
Input read_graph(const Skeletonize_options& options);

/// The graph of the lines of `soup` and of the sides of its polygons; without any, of each point and its neighbors.
/// \param number_of_neighbors 0 for the default
Skeleton make_graph(const CSCD::Shape_file& soup, unsigned int number_of_neighbors);

/// The input that is this graph.
Input make_input(Skeleton graph);

/// The name of an input in messages.
std::string name_of(const std::string& input);

/// Writes a sentence about an input to standard error.
void say(const std::string& input, const std::string& sentence);

/// The mesh of `input`, and the node of each of its vertices.
CSCD::internal::Assigned_surface assigned_surface(const Input& input, const Skeleton& skeleton);

/// Refuses files whose ending is not that of a format of skeletons.
/// \param other_endings that the command knows, for messages
/// \throw Usage_error
void check_skeleton_argument(const std::string& filename, const std::string& other_endings = "");

/// Reads the skeleton from a file in the format that its ending names, or from standard input as a graph of GEL.
/// \throw CSCD::File_error
Skeleton read_skeleton_argument(const std::string& filename);

/// The coordinates that the value of `--root` gives; none if it names a rule.
/// \pre `check_root()` has accepted it
std::optional<Vector3> root_point(const std::string& root);

/// The roots that the value of `--root` chooses; none if it is empty.
/// \throw CSCD::Input_error if they cannot be chosen
std::vector<Index> find_roots(const Skeleton& skeleton, const std::string& root);

/// Writes a skeleton to a file of `files` in the format of its ending, or to standard output as a graph of GEL.
void write_skeleton_output(CSCD::File_group& files, const std::string& output, const Skeleton& skeleton,
                           const std::vector<Index>& roots, CSCD::Swc_options swc);

/// Removes and joins components as `options` demand.
void treat_fragments(const CSCD::internal::Simplification_parameters& options, Skeletonization_result& result);

/// Skeletonizes `input` as `options` demand. If it is a point set, its mesh becomes the surface made of the points.
/// \param progress is informed, or is empty
/// \throw CSCD::Input_error if it cannot be skeletonized
Skeletonization_result compute_skeleton(Input& input, const Skeletonize_options& options,
                                        const Stage_progress& progress);

/// The label of each vertex or point of the file, in its order.
/// \pre `input` has kept the contents of the file
std::vector<CSCD::Vertex_label> labels_of_file(const Input& input, const Skeletonization_result& result);

/// Skeletonizes `input`, which messages call by the name that `options` have for it. Nothing is written. If it is a
/// point set, its mesh becomes the surface made of the points.
/// \param progress is informed, or is empty
/// \throw Usage_error if the options do not apply to this input; `CSCD::Input_error` if it cannot be skeletonized
Skeletonization_result skeletonize_input(Input& input, const Skeletonize_options& options,
                                         const Stage_progress& progress);

/// Chooses roots and measures branches, with the parts of the surface that belong to them if these are known and
/// `options` ask for a table of branches or a report.
void measure_branches(const Input& input, const Skeletonize_options& options, Skeletonization_result& result);

/// Writes the files that `options` name; they appear when `files` are published.
/// \throw `CSCD::File_error`; `CSCD::Input_error` if a file cannot hold this
void write_results(CSCD::File_group& files, const Input& input, const Skeletonization_result& result,
                   const Skeletonize_options& options);

/// Calls `write(out)` with a stream to the file `filename` of `files`, or with standard output; not if that is empty.
template <class Write>
void write_to(CSCD::File_group& files, const std::string& filename, const Write& write)
{
  if (filename == standard_stream) {
    write(static_cast<std::ostream&>(std::cout));
  } else if (!filename.empty()) {
    files.write(filename, write);
  }
}

/// Whether the input is a volume, by its ending.
bool is_volume(const Skeletonize_options& options);

/// Whether `output` is a volume of node numbers.
bool is_node_volume(const std::string& output);

/// Refuses options of volumes that exclude each other, and outputs that need a volume.
/// \throw Usage_error
void check_volume_options(const Skeletonize_options& options);

/// `skeletonize_input()` that shows the progress on a terminal unless `options` are quiet.
Skeletonization_result skeletonize_with_progress(Input& input, const Skeletonize_options& options);

/// Tells warnings and counts, and writes all results except volumes to `files`.
void tell_and_write(CSCD::File_group& files, const Input& input, const Skeletonization_result& result,
                    const Skeletonize_options& options);

/// Reads the surfaces of the bodies in a volume, skeletonizes each soon after its last slice, and writes the results
/// and volumes of node numbers. If each label is a body, the names of the files hold it; its files are published
/// together, those of a few dozen small bodies at once.
/// \throw `CSCD::File_error`, `CSCD::Input_error`
void skeletonize_volume(CSCD::File_group& files, const Skeletonize_options& options);

/// Whether `output` is a viewer page, by its ending.
bool is_page(const std::string& output);

/// Writes the viewer page.
/// \param name of the input, without its folder, which has no meaning for other readers of the page
/// \throw Usage_error as `check_viewer_source()`
void write_page(std::ostream& out, const Input& input, const Skeletonization_result& result, const std::string& name);

/// Checks that pages can be written. \throw Usage_error
void check_viewer_source();

/// Measures `skeleton` against `input`. \throw `CSCD::Input_error`
CSCD::Skeleton_measures measure_skeleton(const Input& input, const Skeleton& skeleton, const Evaluate_options& options);

/// Writes the measures as a JSON object; undefined measures are null.
void write_measures_as_json(std::ostream& out, const Evaluate_options& options,
                            const CSCD::Skeleton_measures& measures);

/// Simplifies a skeleton that has radii.
/// \param mesh that the skeleton stays inside of, or null
/// \throw `CSCD::Input_error`
CSCD::Simplification_report simplify_skeleton(const Simplify_options& options, const Input* mesh, Skeleton& skeleton);

/// Refuses an output file that is the input, under any name.
/// \param option that names the output
/// \throw Usage_error if it is
void check_is_not_input(const std::string& output, const std::string& input, const std::string& option);

} // namespace cscd

#endif // CSCD_PROGRAM_TYPES_H
