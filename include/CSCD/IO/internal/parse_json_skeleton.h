// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading skeletons from JSON.

#ifndef CSCD_IO_INTERNAL_PARSE_JSON_SKELETON_H
#define CSCD_IO_INTERNAL_PARSE_JSON_SKELETON_H

#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CSCD::internal {

/// The array `name` of the object `document`.
/// \throw File_error if there is none
inline const nlohmann::json& json_array(const nlohmann::json& document, const char* name,
                                        const Skeleton_collector& collector)
{
  if (!document.is_object() || !document.contains(name) || !document[name].is_array()) {
    collector.fail(std::string("it is no JSON object with an array ") + name);
  }
  return document[name];
}

inline void add_json_node(const nlohmann::json& node, Skeleton_collector& collector)
{
  const std::string name = "node " + std::to_string(collector.number_of_nodes());
  if (!node.is_object() || !node.contains("point") || !node["point"].is_array() || node["point"].size() != 3) {
    collector.fail(name + " has no point of three numbers");
  }
  Vector_3 point = Vector_3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const nlohmann::json& coordinate = node["point"][i];
    if (!coordinate.is_number()) {
      collector.fail(name + " has a coordinate that is no number");
    }
    point[Eigen::Index(i)] = coordinate.get<double>();
  }
  if (!node.contains("radius")) {
    collector.add_node(point);
  } else if (node["radius"].is_number()) {
    collector.add_node(point, node["radius"].get<double>());
  } else {
    collector.fail(name + " has a radius that is no number");
  }
}

/// Reads `text`, a JSON object as `write_json()` writes it: `nodes`, each with `point` and perhaps `radius`, and
/// `edges`, each an array of two nodes; all else is passed over.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_json_skeleton(std::string_view text, const std::string& filename)
{
  Skeleton_collector collector(filename);
  constexpr bool has_exceptions = false;
  const nlohmann::json document = nlohmann::json::parse(text.begin(), text.end(), nullptr, has_exceptions);
  if (document.is_discarded()) {
    collector.fail("it is no valid JSON");
  }
  for (const nlohmann::json& node : json_array(document, "nodes", collector)) {
    add_json_node(node, collector);
  }
  for (const nlohmann::json& edge : json_array(document, "edges", collector)) {
    if (!edge.is_array() || edge.size() != 2 || !edge[0].is_number_unsigned() || !edge[1].is_number_unsigned()) {
      collector.fail("an edge is no array of two numbers of nodes");
    }
    collector.add_edge(edge[0].get<std::int64_t>(), edge[1].get<std::int64_t>());
  }
  return collector.finish();
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_JSON_SKELETON_H
