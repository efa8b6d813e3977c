// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as JSON.

#ifndef CSCD_IO_WRITE_JSON_H
#define CSCD_IO_WRITE_JSON_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector_3.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// What is infinite is null.
inline nlohmann::ordered_json json_branches(const std::vector<Branch_content>& branches)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const Branch_content& branch : branches) {
    result.push_back(
        {{"nodes", branch.nodes},
         {"length", branch.length},
         {"mean_radius", branch.mean_radius},
         {"significance", branch.significance < Branch_hierarchy::never ? nlohmann::ordered_json(branch.significance)
                                                                        : nlohmann::ordered_json()}});
  }
  return result;
}

inline void write_json(std::ostream& out, const Skeleton_content& skeleton)
{
  std::vector<std::size_t> degree(skeleton.number_of_nodes(), 0);
  for (const auto& [source, target] : skeleton.edges) {
    ++degree[source];
    ++degree[target];
  }
  nlohmann::ordered_json document{{"nodes", nlohmann::ordered_json::array()},
                                  {"edges", nlohmann::ordered_json::array()}};
  for (std::size_t v = 0; v < skeleton.number_of_nodes(); ++v) {
    const Vector_3& point = skeleton.points[v];
    nlohmann::ordered_json node{{"point", std::array<double, 3>{point.x(), point.y(), point.z()}}};
    if (skeleton.has_radius) {
      node["radius"] = skeleton.radii[v];
    }
    node["degree"] = degree[v];
    if (!skeleton.is_opening.empty() && skeleton.is_opening[v] != 0) {
      node["is_opening"] = true;
    }
    if (!skeleton.number_of_vertices.empty()) {
      node["number_of_sites"] = skeleton.number_of_vertices[v];
    }
    document["nodes"].push_back(std::move(node));
  }
  for (const auto& [source, target] : skeleton.edges) {
    document["edges"].push_back({source, target});
  }
  if (skeleton.has_radius) {
    document["branches"] = json_branches(branch_contents(skeleton));
  }
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    if (skeleton.is_joined[e] != 0) {
      document["joined_edges"].push_back(skeleton.edges[e]);
    }
  }
  Exact_format format(out);
  out << document.dump() << '\n';
  format.finish();
}

} // namespace internal

/// writes `skeleton` as a JSON object of arrays: `nodes`, each with `point` (three numbers), `radius` (if the nodes
/// have one), `degree` and `number_of_sites`, the number of vertices or points of the input that belong to the node;
/// `edges`, each an array of two nodes counted from 0; `branches` (if the nodes have radii), each with `nodes` from end
/// to end, `length`, `mean_radius` over the length, and `significance`, null for what is never cut (see
/// `compute_significance()`); and `joined_edges`, if there are any, those of the edges that were added to join
/// components. O(n log n). \throw File_error if `out` fails
template <class Skeleton>
void write_json(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_json(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_JSON_H
