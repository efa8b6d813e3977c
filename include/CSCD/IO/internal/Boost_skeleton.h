// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons as the writers of Boost.Graph take them.

#ifndef CSCD_IO_INTERNAL_BOOST_SKELETON_H
#define CSCD_IO_INTERNAL_BOOST_SKELETON_H

#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/Vector_3.h>

#include <boost/any.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The nodes and edges alone.
using Boost_skeleton = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

inline Boost_skeleton boost_skeleton(const Skeleton_content& skeleton)
{
  Boost_skeleton result(skeleton.number_of_nodes());
  for (const auto& [source, target] : skeleton.edges) {
    add_edge(source, target, result);
  }
  return result;
}

/// A read-only dynamic property of type double for nodes.
/// `boost::dynamic_properties::property` writes doubles with six digits and in the global locale; this one exactly.
class Exact_node_property : public boost::dynamic_property_map
{
public:
  explicit Exact_node_property(std::vector<double> values) : m_values(std::move(values)) {}

  boost::any get(const boost::any& key) override { return m_values[boost::any_cast<std::size_t>(key)]; }

  std::string get_string(const boost::any& key) override
  {
    std::ostringstream out;
    const Exact_format format(out);
    out << m_values[boost::any_cast<std::size_t>(key)];
    return out.str();
  }

  void put(const boost::any& /* key */, const boost::any& /* value */) override
  {
    throw std::logic_error("a node property is read-only");
  }

  const std::type_info& key() const override { return typeid(std::size_t); }
  const std::type_info& value() const override { return typeid(double); }

private:
  std::vector<double> m_values;
};

/// The properties `x`, `y`, `z` and, if the nodes have one, `radius`.
inline boost::dynamic_properties node_properties(const Skeleton_content& skeleton)
{
  boost::dynamic_properties properties;
  const char* names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    std::vector<double> coordinates;
    for (const Vector_3& point : skeleton.points) {
      coordinates.push_back(point[i]);
    }
    properties.insert(names[i], boost::make_shared<Exact_node_property>(std::move(coordinates)));
  }
  if (skeleton.has_radius) {
    properties.insert("radius", boost::make_shared<Exact_node_property>(skeleton.radii));
  }
  return properties;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_BOOST_SKELETON_H
