// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables as CSV: branches, nodes, and the cylinders of trees.

#ifndef CSCD_IO_WRITE_TABLES_H
#define CSCD_IO_WRITE_TABLES_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Tree/Tree_cylinders.h>
#include <CSCD/Tree/Tree_report.h>

#include <ostream>
#include <vector>

namespace CSCD {

/// writes the table of branches as CSV, a line for each branch under a line of names: the number of the branch, its end
/// nodes and their kinds, the number of its nodes, and the members of `Skeleton_branch`. Unknown values are empty,
/// infinite ones are `inf`. Linear.
/// \throw File_error if `out` fails
void write_branch_table(std::ostream& out, const Skeleton_branches& branches);

/// writes the table of nodes as CSV, a line for each node under a line of names: number, coordinates, degree, branch,
/// radius, how many vertices or points belong to it, and the members of `Node_measures`. Unknown values are empty.
/// Linear.
/// \param skeleton a model of `CurveSkeletonGraph`
/// \param branches of `skeleton`, as `measure_branches()` gives them
/// \param measures of the nodes of `skeleton`, as `measure_nodes()` gives them; may be empty
/// \throw File_error if `out` fails
void write_node_table(std::ostream& out, const internal::Skeleton_content& skeleton, const Skeleton_branches& branches,
                      const std::vector<Node_measures>& measures = {});

/// writes cylinders as CSV in the columns of TreeQSM's text files (`save_model_text`, version 2.4): indices are counted
/// from 1, 0 is none. The columns on the fit of TreeQSM (`mad`, `SurfCov`) are `NaN`. Linear.
/// \param report of the skeleton that the cylinders were made from
/// \throw File_error if `out` fails
void write_cylinders(std::ostream& out, const std::vector<Tree_cylinder>& cylinders, const Tree_report& report);

} // namespace CSCD

#endif // CSCD_IO_WRITE_TABLES_H
