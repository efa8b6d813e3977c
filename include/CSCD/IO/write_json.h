// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as JSON.

#ifndef CSCD_IO_WRITE_JSON_H
#define CSCD_IO_WRITE_JSON_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Measure/Skeleton_branches.h>
#include <CSCD/Vector_3.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// A number; null if it is infinite or not known.
inline nlohmann::ordered_json json_number(double number)
{
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json();
}

/// The branches as objects. What belongs to a surface, a root or a tree is left out where there is none.
inline nlohmann::ordered_json json_branches(const std::vector<Skeleton_branch>& branches)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const Skeleton_branch& branch : branches) {
    nlohmann::ordered_json object{{"nodes", branch.nodes},
                                  {"ends", {name(branch.ends[0]), name(branch.ends[1])}},
                                  {"length", branch.length},
                                  {"chord", branch.chord},
                                  {"tortuosity", json_number(branch.tortuosity())},
                                  {"min_radius", json_number(branch.min_radius)},
                                  {"mean_radius", json_number(branch.mean_radius)},
                                  {"max_radius", json_number(branch.max_radius)},
                                  {"end_radii", {json_number(branch.end_radii[0]), json_number(branch.end_radii[1])}},
                                  {"cone_area", json_number(branch.cone_area)},
                                  {"cone_volume", json_number(branch.cone_volume)},
                                  {"significance", json_number(branch.significance)}};
    if (!std::isnan(branch.volume)) {
      object["surface_area"] = branch.surface_area;
      object["volume"] = branch.volume;
    }
    if (branch.order) {
      object["parent"] = branch.parent ? nlohmann::ordered_json(*branch.parent) : nlohmann::ordered_json();
      object["order"] = *branch.order;
    }
    if (branch.limb) {
      object["limb"] = *branch.limb;
    }
    result.push_back(std::move(object));
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
    document["branches"] = json_branches(internal::measure_branches(skeleton).branches);
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
/// `edges`, each an array of two nodes counted from 0; `branches` (if the nodes have radii), each with the members of
/// `Skeleton_branch` that need no surface and no root, null for what is infinite; and `joined_edges`, if there are any,
/// those of the edges that were added to join components. O(n log n). \throw File_error if `out` fails
template <class Skeleton>
void write_json(std::ostream& out, const Skeleton& skeleton)
{
  internal::write_json(out, internal::skeleton_content(skeleton));
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_JSON_H
