// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common parts of the writers of skeletons.

#ifndef CSCD_IO_INTERNAL_SKELETON_CONTENT_H
#define CSCD_IO_INTERNAL_SKELETON_CONTENT_H

#include <CSCD/Skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/input_concepts.h>

#include <boost/io/ios_state.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <vector>

namespace CSCD::internal {

/// While it lives, its stream writes numbers in the C locale, and doubles with so many digits that reading them gives
/// the same value again; afterwards the stream is formatted as before.
class Exact_format
{
public:
  explicit Exact_format(std::ostream& out) : m_flags(out), m_precision(out), m_locale(out), m_out(out)
  {
    out.imbue(std::locale::classic());
    out.precision(std::numeric_limits<double>::max_digits10);
    out.setf(std::ios::dec, std::ios::basefield);
    out.unsetf(std::ios::floatfield | std::ios::showpos | std::ios::showbase);
  }

  /// Flushes the stream.
  /// \throw File_error if not everything could be written
  void finish()
  {
    if (!m_out.flush()) {
      throw File_error("the skeleton could not be written to the stream: check that it is open and that the disk "
                       "is not full");
    }
  }

private:
  boost::io::ios_flags_saver m_flags;
  boost::io::ios_precision_saver m_precision;
  boost::io::ios_locale_saver m_locale;
  std::ostream& m_out;
};

/// How many vertices of the input belong to each node; nothing if none belong to any, as of a skeleton from a file.
template <class Graph>
std::vector<std::size_t> numbers_of_vertices([[maybe_unused]] const Graph& graph)
{
  std::vector<std::size_t> result;
  if constexpr (CSCD_IS_VALID(const Graph&, t[*vertices(t).first].vertices.size())) {
    for (const auto node : boost::make_iterator_range(vertices(graph))) {
      result.push_back(graph[node].vertices.size());
    }
  }
  const bool has_any = std::any_of(result.begin(), result.end(), [](std::size_t number) { return number > 0; });
  return has_any ? result : std::vector<std::size_t>();
}

/// The content of skeleton files: writers take it, and it is made from any argument of theirs.
struct Skeleton_content : Skeleton
{
  bool has_radius;                             ///< whether the type of the nodes has a radius, even if there are none
  std::vector<std::size_t> number_of_vertices; ///< see `numbers_of_vertices()`

  /// Copies the content of files from `graph`, a model of `CurveSkeletonGraph` or a graph of points, such as a
  /// `Cut_locus_graph`; expectedly linear.
  template <class Graph>
  Skeleton_content(const Graph& graph)
      : Skeleton(index_skeleton(graph)), has_radius(has_radius_v<Graph>), number_of_vertices(numbers_of_vertices(graph))
  {
  }

  /// The content of a plain skeleton.
  Skeleton_content(const Skeleton& skeleton) : Skeleton(skeleton), has_radius(skeleton.has_radii())
  {
    is_joined.resize(edges.size(), 0);
    for (const std::vector<Index>& sites : skeleton.vertices) {
      number_of_vertices.push_back(sites.size());
    }
    if (std::all_of(number_of_vertices.begin(), number_of_vertices.end(), [](std::size_t n) { return n == 0; })) {
      number_of_vertices.clear(); // as of a skeleton from a file
    }
  }
};

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SKELETON_CONTENT_H
