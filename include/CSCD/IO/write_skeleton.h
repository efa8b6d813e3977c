// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons to files and streams of all formats.

#ifndef CSCD_IO_WRITE_SKELETON_H
#define CSCD_IO_WRITE_SKELETON_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector3.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

/// The content of SWC files besides the skeleton.
struct Swc_options
{
  /// The type of all nodes except the soma, from 0 to 7: 1 soma, 2 axon, 3 dendrite, 4 apical dendrite, 5 fork, 6 end,
  /// 7 custom. By default forks are 5, ends 6 and others 0, which some readers of neurons refuse.
  std::optional<int> type{};
  /// The thickest node is the soma, of type 1, if its radius is at least this, in the unit of the skeleton. It is the
  /// root of its component then. Without a value, the skeleton has no soma.
  std::optional<double> min_soma_radius{};
  /// The factor of coordinates and radii, such as 0.001 from nanometers to micrometers.
  double scale = 1;
  /// Nodes, counted from 0; of a component without any the first one is the root. See `find_roots()`.
  std::vector<Index> roots{};
};

/// checks that `read_skeleton()` and `write_skeleton()` know the ending of `filename`, before anything else is done.
/// \throw File_error if not
void check_skeleton_filename(const std::string& filename);

/// writes `skeleton` to the file `filename` in the format that its ending names: `.graph`, `.json`, `.obj`, `.ply`,
/// `.polylines.txt`, `.swc` or `.vtp`. A failure leaves no new file. Linear.
/// \param skeleton a `Skeleton_graph`, the skeleton type of CGAL's `Mean_curvature_flow_skeletonization`, or another
///        model of `CurveSkeletonGraph`, as for all writers
/// \throw File_error if the ending is unknown or the file cannot be written
void write_skeleton(const std::string& filename, const internal::Skeleton_content& skeleton);

/// writes `skeleton` to `out` in the format that the ending of `filename` names. Linear.
/// \throw File_error if the ending is unknown or the stream fails
void write_skeleton(std::ostream& out, const std::string& filename, const internal::Skeleton_content& skeleton);

/// writes `skeleton` in GEL's `.graph` format: a line `n x y z` for each node, then a line `c i j` for each edge, with
/// nodes counted from 0. Linear.
/// \throw File_error if `out` fails
void write_gel_graph(std::ostream& out, const internal::Skeleton_content& skeleton);

/// writes `skeleton` as a JSON object of arrays: `nodes`, each with `point` (three numbers), `radius` (if the nodes
/// have one), `degree` and `number_of_sites`, the number of vertices or points of the input that belong to the node;
/// `edges`, each an array of two nodes counted from 0; `branches` (if the nodes have radii), each with the members of
/// `Skeleton_branch` that need no surface and no root, null for infinite ones; and `joined_edges`, the edges that were
/// added to join components, if any. O(n log n). \throw File_error if `out` fails
void write_json(std::ostream& out, const internal::Skeleton_content& skeleton);

/// writes `skeleton` in OBJ format: a line `v x y z` for each node, then a line `l i j k ...` for each branch, with
/// nodes counted from 1; an isolated node is a line `p i`. Linear.
/// \throw File_error if `out` fails
void write_obj(std::ostream& out, const internal::Skeleton_content& skeleton);

/// writes `skeleton` in ASCII PLY: elements `vertex` with `x y z` and, if the nodes have one, `radius`, and elements
/// `edge` with `vertex1 vertex2` and, if the nodes have radii, `significance`, the greatest double for edges that are
/// never cut. O(n log n).
/// \throw File_error if `out` fails
void write_ply(std::ostream& out, const internal::Skeleton_content& skeleton);

/// writes `skeleton` in the format `.polylines.txt`: a line for each branch, the number of its nodes and then
/// `x y z` of each; closed branches repeat their first node. Linear.
/// \throw File_error if `out` fails
void write_polylines(std::ostream& out, const internal::Skeleton_content& skeleton);

/// writes `skeleton` in SWC format: a line `id type x y z radius parent` for each node, identifiers counted from 1,
/// parents before children, -1 as the parent of the root of each component; radius 0 if the nodes have none.
/// SWC holds forests only: each cycle is cut at its thinnest edge, which stands in a comment line `# loop i j` instead,
/// with the identifiers of its ends. O(n log n).
/// \throw File_error if `out` fails
void write_swc(std::ostream& out, const internal::Skeleton_content& skeleton, const Swc_options& options = {});

/// writes `skeleton` as an ASCII `.vtp` file, XML PolyData of VTK: a poly-line for each branch (a vertex cell for each
/// isolated node), the cell array `BranchId`, the numbers of `measure_branches()`, and, if the nodes have radii, the
/// point arrays `Radius` and, the same for VMTK, `MaximumInscribedSphereRadius`, and the cell array `Significance`, the
/// greatest double for edges that are never cut. O(n log n).
/// \throw File_error if `out` fails
void write_vtp(std::ostream& out, const internal::Skeleton_content& skeleton);

} // namespace CSCD

#endif // CSCD_IO_WRITE_SKELETON_H
