// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as SWC.

#ifndef CSCD_IO_WRITE_SWC_H
#define CSCD_IO_WRITE_SWC_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/Rooted_forest.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <vector>

namespace CSCD {

/// What SWC files can tell besides the skeleton.
struct Swc_options
{
  /// The type of all nodes but the soma, from 0 to 7: 1 soma, 2 axon, 3 dendrite, 4 apical dendrite, 5 fork, 6 end,
  /// 7 custom. By default forks are 5, ends 6 and others 0, which some readers of neurons refuse.
  std::optional<int> type{};
  /// The thickest node is the soma, of type 1, if its radius is at least this, in the unit of the skeleton. It is the
  /// root of its component then.
  double min_soma_radius = std::numeric_limits<double>::infinity();
  /// By which coordinates and radii are multiplied, as 0.001 from nanometers to micrometers.
  double scale = 1;
  /// Nodes, counted from 0; of a component without any the first one is the root. See `find_roots()`.
  std::vector<Index> roots{};
};

namespace internal {

/// The structure identifier of a node in SWC: 5 a fork, 6 an end, 0 anything else.
inline int swc_type(std::size_t degree)
{
  constexpr int undefined = 0;
  constexpr int fork_point = 5;
  constexpr int end_point = 6;
  return degree > 2 ? fork_point : degree == 1 ? end_point : undefined;
}

/// The thickest node if it is thick enough.
inline Index find_soma(const Skeleton_content& skeleton, double min_radius)
{
  const auto thickest = std::max_element(skeleton.radii.begin(), skeleton.radii.end());
  return thickest != skeleton.radii.end() && *thickest >= min_radius ? Index(thickest - skeleton.radii.begin())
                                                                     : no_index;
}

inline void write_swc(std::ostream& out, const Skeleton_content& skeleton, const Swc_options& options)
{
  constexpr int soma_type = 1;
  const Index soma = find_soma(skeleton, options.min_soma_radius);
  std::vector<Index> roots = options.roots;
  if (soma != no_index) {
    roots.insert(roots.begin(), soma);
  }
  const Rooted_forest forest(skeleton, roots);
  const std::vector<std::vector<Index>> neighbors = node_neighbors(skeleton);
  std::vector<std::size_t> id(skeleton.number_of_nodes());
  for (std::size_t i = 0; i < forest.order().size(); ++i) {
    id[forest.order()[i]] = i + 1;
  }
  Exact_format format(out);
  out << "# id type x y z radius parent\n";
  for (const auto& [u, v] : forest.loops()) {
    out << "# loop " << id[u] << ' ' << id[v] << '\n';
  }
  for (const Index v : forest.order()) {
    out << id[v] << ' ' << (v == soma ? soma_type : options.type.value_or(swc_type(neighbors[v].size()))) << ' ';
    write_coordinates(out, options.scale * skeleton.points[v]);
    out << ' ' << (skeleton.has_radius ? options.scale * skeleton.radii[v] : 0) << ' ';
    if (forest.is_root(v)) {
      out << "-1\n";
    } else {
      out << id[forest.parent(v)] << '\n';
    }
  }
  format.finish();
}

inline void write_swc(std::ostream& out, const Skeleton_content& skeleton)
{
  write_swc(out, skeleton, {});
}

} // namespace internal

/// writes `skeleton` in SWC format: a line `id type x y z radius parent` for each node, identifiers counted from 1,
/// parents before children, -1 as the parent of the root of each component; radius 0 if the nodes have none.
/// SWC holds forests only: each cycle is cut at its thinnest edge, which stands in a comment line `# loop i j` instead,
/// with the identifiers of its ends. O(n log n).
/// \throw File_error if `out` fails
template <class Skeleton>
void write_swc(std::ostream& out, const Skeleton& skeleton, const Swc_options& options = {})
{
  internal::write_swc(out, internal::skeleton_content(skeleton), options);
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_SWC_H
