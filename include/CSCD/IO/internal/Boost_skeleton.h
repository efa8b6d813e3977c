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
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The nodes and edges alone.
using Boost_skeleton = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                             boost::property<boost::edge_index_t, std::size_t>>;

inline Boost_skeleton boost_skeleton(const Skeleton_content& skeleton)
{
  Boost_skeleton result(skeleton.number_of_nodes());
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    add_edge(skeleton.edges[e][0], skeleton.edges[e][1], e, result);
  }
  return result;
}

/// A read-only dynamic property of type double for the nodes or edges of a `Boost_skeleton`.
/// `boost::dynamic_properties::property` writes doubles with six digits and in the global locale; this one exactly.
/// \tparam IndexMap from nodes or edges to places in the values
template <class IndexMap>
class Exact_property : public boost::dynamic_property_map
{
public:
  Exact_property(IndexMap index, std::vector<double> values) : m_index(index), m_values(std::move(values)) {}

  boost::any get(const boost::any& key) override { return value_of(key); }

  std::string get_string(const boost::any& key) override
  {
    std::ostringstream out;
    const Exact_format format(out);
    out << value_of(key);
    return out.str();
  }

  void put(const boost::any& /* key */, const boost::any& /* value */) override
  {
    throw std::logic_error("a property of a skeleton is read-only");
  }

  const std::type_info& key() const override { return typeid(Key); }
  const std::type_info& value() const override { return typeid(double); }

private:
  using Key = typename boost::property_traits<IndexMap>::key_type;

  double value_of(const boost::any& key) const { return m_values[boost::get(m_index, boost::any_cast<Key>(key))]; }

  IndexMap m_index;
  std::vector<double> m_values;
};

template <class IndexMap>
void insert_property(boost::dynamic_properties& properties, const char* name, IndexMap index,
                     std::vector<double> values)
{
  properties.insert(name, boost::make_shared<Exact_property<IndexMap>>(index, std::move(values)));
}

/// The properties `x`, `y`, `z` of nodes and, if the nodes have one, `radius`, and then `significance` of edges.
/// \param graph made of `skeleton`, is referred to
inline boost::dynamic_properties skeleton_properties(const Skeleton_content& skeleton, const Boost_skeleton& graph)
{
  const auto node_index = boost::get(boost::vertex_index, graph);
  boost::dynamic_properties properties;
  const char* names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    std::vector<double> coordinates;
    for (const Vector_3& point : skeleton.points) {
      coordinates.push_back(point[i]);
    }
    insert_property(properties, names[i], node_index, std::move(coordinates));
  }
  if (skeleton.has_radius) {
    insert_property(properties, "radius", node_index, skeleton.radii);
    std::vector<double> significances = edge_significances(skeleton);
    std::transform(significances.begin(), significances.end(), significances.begin(), finite_significance);
    insert_property(properties, "significance", boost::get(boost::edge_index, graph), std::move(significances));
  }
  return properties;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_BOOST_SKELETON_H
