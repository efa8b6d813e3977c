// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the writers of skeletons share.

#ifndef CSCD_IO_INTERNAL_SKELETON_CONTENT_H
#define CSCD_IO_INTERNAL_SKELETON_CONTENT_H

#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/detection.h>

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

/// What files hold of a skeleton.
struct Skeleton_content : Indexed_skeleton
{
  bool has_radius = false;                     ///< whether the type of the nodes has a radius, even if there are none
  std::vector<std::size_t> number_of_vertices; ///< of the input, that belong to each node; empty if no node has any
};

/// Copies what files hold of `skeleton`, a model of `CurveSkeletonGraph` or a graph of points, such as a
/// `Cut_locus_graph`; expectedly linear.
template <class Skeleton>
Skeleton_content skeleton_content(const Skeleton& skeleton)
{
  Skeleton_content result{index_skeleton(skeleton), has_radius_v<Skeleton>, {}};
  if constexpr (CSCD_IS_VALID(const Skeleton&, t[*vertices(t).first].vertices.size())) {
    result.number_of_vertices.reserve(result.number_of_nodes());
    for (const auto node : boost::make_iterator_range(vertices(skeleton))) {
      result.number_of_vertices.push_back(skeleton[node].vertices.size());
    }
    if (std::none_of(result.number_of_vertices.begin(), result.number_of_vertices.end(),
                     [](std::size_t number) { return number > 0; })) {
      result.number_of_vertices.clear(); // of a skeleton from a file
    }
  }
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_SKELETON_CONTENT_H
