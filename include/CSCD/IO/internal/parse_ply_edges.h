// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading the vertices and edges of PLY.

#ifndef CSCD_IO_INTERNAL_PARSE_PLY_EDGES_H
#define CSCD_IO_INTERNAL_PARSE_PLY_EDGES_H

#include <CSCD/IO/internal/Scanner.h>
#include <CSCD/IO/internal/Skeleton_collector.h>
#include <CSCD/IO/internal/parse_ply.h>
#include <CSCD/Skeleton/Indexed_skeleton.h>
#include <CSCD/Vector_3.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

/// Reads elements `vertex` with `x y z` and perhaps `radius`, and `edge` with `vertex1 vertex2`; all else is passed
/// over.
template <class Source>
class Ply_edge_parser
{
public:
  Ply_edge_parser(const Source& source, const std::string& filename) : m_source(source), m_collector(filename) {}

  Indexed_skeleton parse(const Ply_header& header)
  {
    bool has_edges = false;
    bool has_faces = false;
    for (const Ply_element& element : header.elements) {
      if (element.name == "vertex" || element.name == "vertices") {
        read_nodes(element);
      } else if (element.name == "edge" || element.name == "edges") {
        has_edges = true;
        read_edges(element);
      } else {
        has_faces = has_faces || element.name == "face" || element.name == "faces";
        read_items(element, {}, [](const std::vector<double>&) {});
      }
    }
    if (has_faces && !has_edges) {
      m_collector.fail("it has faces but no edges: a mesh, no skeleton");
    }
    return m_collector.finish();
  }

private:
  /// Reads all items of `element` and gives the numbers of those properties that `names` names to `use`, item by item.
  template <class Use>
  void read_items(const Ply_element& element, std::initializer_list<std::string_view> names, const Use& use)
  {
    if (element.properties.empty()) {
      return; // such items take no room in the file, so that their number proves nothing
    }
    std::vector<double> numbers(names.size(), 0.);
    for (std::size_t item = 0; item < element.number_of_items; ++item) {
      for (const Ply_property& property : element.properties) {
        const std::size_t size = property.is_list ? next_size(property) : 1;
        const std::ptrdiff_t place = std::find(names.begin(), names.end(), property.name) - names.begin();
        for (std::size_t i = 0; i < size; ++i) {
          const double number = m_source.number(property.type);
          if (!property.is_list && std::size_t(place) < names.size()) {
            numbers[std::size_t(place)] = number;
          }
        }
      }
      use(numbers);
    }
  }

  std::size_t next_size(const Ply_property& property)
  {
    const double size = m_source.number(property.size_type);
    if (!(size >= 0 && size <= double(m_source.remaining()))) {
      m_collector.fail("the list " + property.name + " is longer than the file");
    }
    return std::size_t(size);
  }

  static bool has_property(const Ply_element& element, std::string_view name)
  {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Ply_property& p) { return p.name == name && !p.is_list; });
  }

  void check_properties(const Ply_element& element, std::initializer_list<std::string_view> names) const
  {
    for (const std::string_view name : names) {
      if (!has_property(element, name)) {
        m_collector.fail("its element " + element.name + " has no property " + std::string(name));
      }
    }
  }

  void read_nodes(const Ply_element& element)
  {
    check_properties(element, {"x", "y", "z"});
    const bool has_radius = has_property(element, "radius");
    read_items(element, {"x", "y", "z", "radius"}, [&](const std::vector<double>& numbers) {
      const Vector_3 point(numbers[0], numbers[1], numbers[2]);
      if (!point.allFinite()) {
        m_collector.fail("vertex " + std::to_string(m_collector.number_of_nodes()) +
                         " has a coordinate that is not finite");
      }
      if (has_radius) {
        m_collector.add_node(point, numbers[3]);
      } else {
        m_collector.add_node(point);
      }
    });
  }

  void read_edges(const Ply_element& element)
  {
    check_properties(element, {"vertex1", "vertex2"});
    read_items(element, {"vertex1", "vertex2"}, [&](const std::vector<double>& numbers) {
      m_collector.add_edge(to_node(numbers[0]), to_node(numbers[1]));
    });
  }

  std::int64_t to_node(double number) const
  {
    if (!(number >= 0 && number < double(no_index) && std::floor(number) == number)) {
      m_collector.fail("an edge has a vertex that is negative or no integer");
    }
    return std::int64_t(number);
  }

  Source m_source;
  Skeleton_collector m_collector;
};

/// Reads `content`, that of a PLY file, ASCII or binary.
/// \throw File_error if it is malformed
inline Indexed_skeleton parse_ply_edges(std::string_view content, const std::string& filename)
{
  Text_scanner scanner(content, filename);
  const Ply_header header = read_ply_header(scanner);
  if (header.encoding == Ply_header::Encoding::ascii) {
    return Ply_edge_parser<Ply_text_source>(Ply_text_source(scanner), filename).parse(header);
  }
  const boost::endian::order order = header.encoding == Ply_header::Encoding::binary_little_endian
                                         ? boost::endian::order::little
                                         : boost::endian::order::big;
  const Byte_scanner bytes(content.substr(content.size() - scanner.remaining()), order, filename);
  return Ply_edge_parser<Ply_binary_source>(Ply_binary_source(bytes), filename).parse(header);
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PARSE_PLY_EDGES_H
