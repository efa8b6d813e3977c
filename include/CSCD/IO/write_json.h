// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as JSON.

#ifndef CSCD_IO_WRITE_JSON_H
#define CSCD_IO_WRITE_JSON_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_access.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range_core.hpp>
#include <nlohmann/json.hpp>

#include <ostream>
#include <utility>

namespace CSCD {

/// writes `skeleton` as a JSON object of two arrays: `nodes`, each with `point` (three numbers), `radius` (if the nodes
/// have one), `degree` and `number_of_sites`; and `edges`, each an array of two nodes counted from 0. Linear.
/// \throw File_error if `out` fails
template <class Skeleton>
void write_json(std::ostream& out, const Skeleton& skeleton)
{
  nlohmann::ordered_json document{{"nodes", nlohmann::ordered_json::array()},
                                  {"edges", nlohmann::ordered_json::array()}};
  for (auto v : boost::make_iterator_range(vertices(skeleton))) {
    nlohmann::ordered_json node{{"point", internal::coordinates(skeleton, v)}};
    if constexpr (has_radius_v<Skeleton>) {
      node["radius"] = internal::radius(skeleton, v);
    }
    node["degree"] = out_degree(v, skeleton);
    node["number_of_sites"] = skeleton[v].vertices.size();
    document["nodes"].push_back(std::move(node));
  }
  for (auto e : boost::make_iterator_range(edges(skeleton))) {
    document["edges"].push_back({source(e, skeleton), target(e, skeleton)});
  }
  internal::Exact_format format(out);
  out << document.dump() << '\n';
  format.finish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_JSON_H
