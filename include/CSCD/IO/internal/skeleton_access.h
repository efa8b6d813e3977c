// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the writers of skeletons share.

#ifndef CSCD_IO_INTERNAL_SKELETON_ACCESS_H
#define CSCD_IO_INTERNAL_SKELETON_ACCESS_H

#include <CSCD/IO/internal/Exact_format.h>
#include <CSCD/Skeleton_graph.h>
#include <CSCD/exceptions.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/any.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The endings of the formats that skeletons are written in; those that are read, too, come first.
inline constexpr std::array<const char*, 9> skeleton_endings{".graph", ".json", ".obj", ".ply",    ".polylines.txt",
                                                             ".swc",   ".vtp",  ".dot", ".graphml"};

/// How many of `skeleton_endings` are read.
inline constexpr std::size_t number_of_read_skeleton_endings = 6;

/// The first `number` endings, separated by blanks.
inline std::string list_of_skeleton_endings(std::size_t number)
{
  return boost::algorithm::join(
      std::vector<std::string>(skeleton_endings.begin(), skeleton_endings.begin() + std::ptrdiff_t(number)), " ");
}

/// The position in `skeleton_endings` of the ending of `filename`, in lower or upper case.
/// \throw File_error if it is not one of them
inline std::size_t skeleton_ending(const std::string& filename)
{
  const std::string lower = boost::algorithm::to_lower_copy(filename, std::locale::classic());
  const auto* ending = std::find_if(skeleton_endings.begin(), skeleton_endings.end(), [&](const char* candidate) {
    return boost::algorithm::ends_with(lower, candidate);
  });
  if (ending == skeleton_endings.end()) {
    throw File_error(filename + ": the ending names no known skeleton format; use one of " +
                     list_of_skeleton_endings(skeleton_endings.size()));
  }
  return static_cast<std::size_t>(ending - skeleton_endings.begin());
}

/// Likewise, of a file to be read.
/// \throw File_error if the format is unknown, or is written only
inline std::size_t readable_skeleton_ending(const std::string& filename)
{
  const std::size_t ending = skeleton_ending(filename);
  if (ending >= number_of_read_skeleton_endings) {
    throw File_error(filename + ": skeletons are written as " + skeleton_endings[ending] +
                     ", but not read from it; use one of " + list_of_skeleton_endings(number_of_read_skeleton_endings));
  }
  return ending;
}

/// The position of node `v`.
template <class Skeleton>
std::array<double, 3> coordinates(const Skeleton& skeleton, typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  const auto& point = skeleton[v].point;
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
}

/// The radius of node `v`; 0 if the nodes of `Skeleton` carry none.
template <class Skeleton>
double radius(const Skeleton& skeleton, typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  if constexpr (has_radius_v<Skeleton>) {
    return skeleton[v].radius;
  } else {
    return 0;
  }
}

/// Writes the position of node `v` as `x y z`.
template <class Skeleton>
void write_coordinates(std::ostream& out, const Skeleton& skeleton,
                       typename boost::graph_traits<Skeleton>::vertex_descriptor v)
{
  const std::array<double, 3> p = coordinates(skeleton, v);
  out << p[0] << ' ' << p[1] << ' ' << p[2];
}

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

#endif // CSCD_IO_INTERNAL_SKELETON_ACCESS_H
