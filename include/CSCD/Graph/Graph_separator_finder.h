// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a source to its local separator, in a graph.

#ifndef CSCD_GRAPH_GRAPH_SEPARATOR_FINDER_H
#define CSCD_GRAPH_GRAPH_SEPARATOR_FINDER_H

#include <CSCD/Graph/Spatial_graph.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CSCD::internal {

/// Finds the local separator of a source: a set of vertices, all of them necessary, that divides the graph next to it
/// into two sides (Baerentzen and Rotenberg, Skeletonization via local separators, 2021).
///
/// A front spreads from the source. Its vertices, reached but not passed, are connected as long as the front has not
/// met itself behind a limb; then they fall apart. The passed vertices are a band around the limb then. Vertices are
/// taken away from it, the farthest along the edges first, as long as the sides stay apart. The band around the
/// remaining vertices is gone over again by shortest paths in it, so that the curve unfolds.
///
/// One object serves one thread; its memory is reused.
class Graph_separator_finder
{
public:
  explicit Graph_separator_finder(const Spatial_graph& graph)
      : m_graph(graph), m_heap(graph.number_of_vertices()), m_in_band(graph.number_of_vertices()),
        m_reached(graph.number_of_vertices()), m_passed(graph.number_of_vertices()),
        m_labeled(graph.number_of_vertices()), m_queued(graph.number_of_vertices()), m_key(graph.number_of_vertices()),
        m_label(graph.number_of_vertices())
  {
  }

  /// Writes the separator of `source` to `separator`; nothing where there is none.
  void operator()(Index source, std::vector<Index>& separator)
  {
    separator.clear();
    if (m_graph.outgoing(source).size() == 1) {
      separator.push_back(source); // the end of a wire
      return;
    }
    if (!spread(source)) {
      return;
    }
    separator.assign(m_band.begin(), m_band.end());
    thin(separator);
    for (int step = 0; step < max_unfoldings && separator.size() > 1; ++step) {
      m_shorter = separator;
      if (!unfold(m_shorter) || m_shorter.size() >= separator.size()) {
        break;
      }
      separator.swap(m_shorter);
    }
  }

  /// How even the sides of `separator` are: the number of vertices next to it on the second largest of them, relative
  /// to the largest; small but positive where there is one side only.
  double evenness(const std::vector<Index>& separator)
  {
    clear();
    take(separator);
    label_sides();
    return m_sizes.size() < 2 ? min_evenness : double(m_sizes[1]) / double(m_sizes[0]);
  }

private:
  /// The number of vertices of the second largest part of the front, relative to the largest, that makes it a side: the
  /// value of Baerentzen and Rotenberg's program.
  static constexpr double min_side = 0.09;
  /// The evenness of a separator with one side, as the end of a wire.
  static constexpr double min_evenness = 1e-6;
  /// How many more vertices are passed before the front is looked at again, relative to the number passed.
  static constexpr double growth = 0.15;
  /// Bounds how often a separator is unfolded.
  static constexpr int max_unfoldings = 1;

  void clear()
  {
    m_heap.clear();
    m_reached.clear();
    m_passed.clear();
    m_band.clear();
    m_front.clear();
  }

  /// Lets the front spread until it falls apart. \return whether it does
  bool spread(Index source)
  {
    clear();
    const Vector3& center = m_graph.points()[source];
    reach(source, 0);
    std::size_t next_look = 1;
    while (!m_heap.empty()) {
      const Index vertex = m_heap.pop().vertex;
      m_passed.mark(vertex);
      m_band.push_back(vertex);
      for (const Index halfedge : m_graph.outgoing(vertex)) {
        const Index neighbor = m_graph.target(halfedge);
        if (!m_reached.is_marked(neighbor)) {
          reach(neighbor, float((m_graph.points()[neighbor] - center).norm()));
        }
      }
      if (m_band.size() >= next_look) {
        if (has_two_sides()) {
          return true;
        }
        next_look = m_band.size() + 1 + std::size_t(growth * double(m_band.size()));
      }
    }
    return false;
  }

  void reach(Index vertex, float key)
  {
    m_reached.mark(vertex);
    m_key[vertex] = key;
    m_heap.push(vertex, key);
    m_front.push_back(vertex);
  }

  /// Labels the parts of the front, and lists their sizes, the two largest first.
  void label_sides()
  {
    m_labeled.clear();
    m_front.erase(std::remove_if(m_front.begin(), m_front.end(), [this](Index v) { return m_passed.is_marked(v); }),
                  m_front.end());
    m_sizes.clear();
    for (const Index start : m_front) {
      if (!m_labeled.is_marked(start)) {
        m_sizes.push_back(label_part(start));
      }
    }
    if (m_sizes.size() > 1) {
      std::partial_sort(m_sizes.begin(), m_sizes.begin() + 2, m_sizes.end(), std::greater<>());
    }
  }

  bool has_two_sides()
  {
    label_sides();
    return m_sizes.size() > 1 && double(m_sizes[1]) >= min_side * double(m_sizes[0]);
  }

  /// Labels the part of the front that is connected with `start`. Where cycles of four edges take the place of faces,
  /// two vertices next to one that has not been reached are connected, too. \return the number of its vertices
  std::size_t label_part(Index start)
  {
    m_stack.assign(1, start);
    m_labeled.mark(start);
    std::size_t size = 0;
    while (!m_stack.empty()) {
      const Index vertex = m_stack.back();
      m_stack.pop_back();
      m_label[vertex] = Index(m_sizes.size());
      const bool is_front = m_reached.is_marked(vertex);
      size += is_front ? 1 : 0;
      for (const Index halfedge : m_graph.outgoing(vertex)) {
        const Index neighbor = m_graph.target(halfedge);
        const bool is_connected = m_reached.is_marked(neighbor) || (is_front && !m_graph.is_triangulated());
        if (is_connected && !m_passed.is_marked(neighbor) && m_labeled.mark(neighbor)) {
          m_stack.push_back(neighbor);
        }
      }
    }
    return size;
  }

  /// Takes vertices away from `separator`, the greatest key first, if they are next to one side only; they become part
  /// of that side. \pre the vertices next to `separator` on its sides are labeled
  void thin(std::vector<Index>& separator)
  {
    m_heap.clear();
    m_queued.clear();
    for (const Index vertex : separator) {
      queue_if_spare(vertex);
    }
    while (!m_heap.empty()) {
      const Index vertex = m_heap.pop().vertex;
      Index label = no_index;
      if (number_of_sides(vertex, label) != 1) {
        continue;
      }
      m_labeled.mark(vertex);
      m_label[vertex] = label;
      for (const Index halfedge : m_graph.outgoing(vertex)) {
        const Index neighbor = m_graph.target(halfedge);
        if (m_passed.is_marked(neighbor) && !m_labeled.is_marked(neighbor)) {
          queue_if_spare(neighbor);
        }
      }
    }
    separator.erase(
        std::remove_if(separator.begin(), separator.end(), [this](Index v) { return m_labeled.is_marked(v); }),
        separator.end());
  }

  void queue_if_spare(Index vertex)
  {
    Index label = no_index;
    if (!m_queued.is_marked(vertex) && number_of_sides(vertex, label) == 1) {
      m_queued.mark(vertex);
      m_heap.push(vertex, -m_key[vertex]);
    }
  }

  /// The number of sides next to `vertex`, at most 2; `label` is the first of them.
  int number_of_sides(Index vertex, Index& label) const
  {
    for (const Index halfedge : m_graph.outgoing(vertex)) {
      const Index neighbor = m_graph.target(halfedge);
      if (m_labeled.is_marked(neighbor)) {
        if (label == no_index) {
          label = m_label[neighbor];
        } else if (label != m_label[neighbor]) {
          return 2;
        }
      }
    }
    return label == no_index ? 0 : 1;
  }

  /// Makes `vertices` the passed ones, and the rest of their neighbors the front.
  void take(const std::vector<Index>& vertices)
  {
    for (const Index vertex : vertices) {
      m_passed.mark(vertex);
      m_reached.mark(vertex);
    }
    for (const Index vertex : vertices) {
      for (const Index halfedge : m_graph.outgoing(vertex)) {
        if (m_reached.mark(m_graph.target(halfedge))) {
          m_front.push_back(m_graph.target(halfedge));
        }
      }
    }
  }

  /// Widens `separator` by its neighbors to a band, and thins it by distances along the edges of the band.
  /// \return whether it still has two sides
  bool unfold(std::vector<Index>& separator)
  {
    const Index start =
        *std::min_element(separator.begin(), separator.end(), [this](Index a, Index b) { return m_key[a] < m_key[b]; });
    clear();
    take(separator);
    separator.insert(separator.end(), m_front.begin(), m_front.end());
    clear();
    take(separator);
    if (!has_two_sides()) {
      return false;
    }
    m_in_band.clear();
    m_in_band.reach(start, 0);
    m_in_band.spread([this](Index vertex, float distance) {
      for (const Index halfedge : m_graph.outgoing(vertex)) {
        if (m_passed.is_marked(m_graph.target(halfedge))) {
          m_in_band.reach(m_graph.target(halfedge), distance + float(m_graph.length(halfedge)));
        }
      }
    });
    for (const Index vertex : separator) {
      m_key[vertex] = m_in_band.is_reached(vertex) ? m_in_band.distance(vertex) : std::numeric_limits<float>::max();
    }
    thin(separator);
    return true;
  }

  const Spatial_graph& m_graph;
  Indexed_heap m_heap;
  Dijkstra_search m_in_band; ///< shortest paths in a band
  Epoch_marks m_reached;
  Epoch_marks m_passed;
  Epoch_marks m_labeled;
  Epoch_marks m_queued;
  std::vector<float> m_key; // of the reached vertices
  std::vector<Index> m_label;
  std::vector<Index> m_band;
  std::vector<Index> m_front;
  std::vector<Index> m_stack;
  std::vector<std::size_t> m_sizes;
  std::vector<Index> m_shorter;
};

} // namespace CSCD::internal

#endif // CSCD_GRAPH_GRAPH_SEPARATOR_FINDER_H
