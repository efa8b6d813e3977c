// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number of each node of a skeleton, as Boost.Graph's writers want it.

#ifndef CSCD_IO_INTERNAL_EXACT_NODE_PROPERTY_H
#define CSCD_IO_INTERNAL_EXACT_NODE_PROPERTY_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/IO/internal/skeleton_node_access.h>

#include <boost/any.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>

namespace CSCD::internal {

/// A read-only dynamic property of type double for nodes.
/// `boost::dynamic_properties::property` writes doubles with six digits and in the global locale; this one exactly.
template <class Vertex, class Function>
class Exact_node_property : public boost::dynamic_property_map
{
public:
  explicit Exact_node_property(Function function) : m_function(std::move(function)) {}

  boost::any get(const boost::any& key) override { return m_function(boost::any_cast<Vertex>(key)); }

  std::string get_string(const boost::any& key) override
  {
    std::ostringstream out;
    const Exact_format format(out);
    out << m_function(boost::any_cast<Vertex>(key));
    return out.str();
  }

  void put(const boost::any& /* key */, const boost::any& /* value */) override
  {
    throw std::logic_error("a node property is read-only");
  }

  const std::type_info& key() const override { return typeid(Vertex); }
  const std::type_info& value() const override { return typeid(double); }

private:
  Function m_function;
};

template <class Vertex, class Function>
void insert_node_property(boost::dynamic_properties& properties, const std::string& name, Function function)
{
  properties.insert(name, boost::make_shared<Exact_node_property<Vertex, Function>>(std::move(function)));
}

/// The properties `x`, `y`, `z` and, if the nodes have one, `radius`. They refer to `skeleton`.
template <class Skeleton>
boost::dynamic_properties node_properties(const Skeleton& skeleton)
{
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  boost::dynamic_properties properties;
  const char* names[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    insert_node_property<Vertex>(properties, names[i],
                                 [&skeleton, i](Vertex v) { return coordinates(skeleton, v)[i]; });
  }
  if constexpr (has_radius_v<Skeleton>) {
    insert_node_property<Vertex>(properties, "radius", [&skeleton](Vertex v) { return radius(skeleton, v); });
  }
  return properties;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_EXACT_NODE_PROPERTY_H
