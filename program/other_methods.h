// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts that a program may leave out, since they take a third of its compilation: `other_methods.cpp` and
// `wrap.cpp` have them, `local_method_only.cpp` refuses them.

#ifndef CSCD_PROGRAM_OTHER_METHODS_H
#define CSCD_PROGRAM_OTHER_METHODS_H

#include <string>

namespace cscd {

struct Input;
struct Skeletonization_result;
struct Skeletonize_options;
class Progress_visitor;

/// Whether this program has the published method, graphs and wraps.
extern const bool has_all_methods;

/// Puts a wrap around the mesh of `input` in its place. \param size holes, gaps and hollows that are narrower are
/// closed; relative to the diagonal of the bounding box
/// \throw `CSCD::Input_error` if nothing can be wrapped; Usage_error if wraps are left out
void wrap_input(Input& input, double size);

/// Skeletonizes a graph, or other input by the published method. Triangles that join points become the mesh of `input`.
/// \throw `CSCD::Input_error`; Usage_error if these methods are left out
void compute_other_skeleton(Input& input, const Skeletonize_options& options, Progress_visitor& visitor,
                            Skeletonization_result& result);

/// \throw Usage_error that names `argument`, which this program leaves out, and the remedy
[[noreturn]] void refuse_left_out(const std::string& argument);

} // namespace cscd

#endif // CSCD_PROGRAM_OTHER_METHODS_H
