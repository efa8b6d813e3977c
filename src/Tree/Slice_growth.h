// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts an object into slices by the distance from its root.

#ifndef CSCD_SRC_TREE_SLICE_GROWTH_H
#define CSCD_SRC_TREE_SLICE_GROWTH_H

#include "Tree/Neighbor_graph.h"
#include "Tree/Tree_limb.h"
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Cuts an object into slices, from the root outwards. Every slice grows into the points whose shortest paths leave it,
/// as far as its own thickness demands: so there are as many slices to a thick limb as to a thin one of the same
/// proportions, and a limb forks where the points fall apart.
class Slice_growth
{
public:
  Slice_growth(const std::vector<Vector_3>& points, const Neighbor_graph& graph, const Root_distances& distances)
      : m_points(points), m_graph(graph), m_distances(distances), m_slice_of_point(points.size(), no_index),
        m_group(points.size(), no_index), m_children_begin(points.size() + 1, 0)
  {
    for (Index point = 0; point < points.size(); ++point) {
      if (distances.parent(point) != no_index) {
        ++m_children_begin[distances.parent(point) + 1];
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_children_begin[i + 1] += m_children_begin[i];
    }
    std::vector<Index> fill(m_children_begin.begin(), m_children_begin.end() - 1);
    m_children.resize(m_children_begin.back());
    for (Index point = 0; point < points.size(); ++point) {
      if (distances.parent(point) != no_index) {
        m_children[fill[distances.parent(point)]++] = point;
      }
    }
  }

  /// Appends the slices of the object with the given roots to `slices`, each after its parent.
  void grow(const std::vector<Index>& roots, std::vector<Slice>& slices)
  {
    Slice foot;
    foot.points = roots;
    measure(foot, nullptr);
    std::vector<Task> tasks{{no_index, roots, width_beyond(foot)}};
    while (!tasks.empty()) {
      Task task = std::move(tasks.back());
      tasks.pop_back();
      grow_band(task, slices, tasks);
    }
  }

private:
  /// The width of a band, relative to the spacing of the points: wide enough for what is around a limb to hang
  /// together.
  static constexpr double min_width = 3;
  /// And relative to the radius.
  static constexpr double width_in_radii = 1;
  /// How far back points still connect those of a band, relative to its width.
  static constexpr double overlap = 0.5;

  static constexpr Index unnumbered = no_index - 1;

  /// Points that begin a band beyond a slice, and what is beyond them.
  struct Task
  {
    Index parent;
    std::vector<Index> starts;
    float width;
  };

  /// Collects the points of a band by going up the tree of shortest paths; those behind it are the ends.
  void gather(const std::vector<Index>& starts, float end, std::vector<Index>& band, std::vector<Index>& ends) const
  {
    std::vector<Index> open = starts;
    while (!open.empty()) {
      const Index point = open.back();
      open.pop_back();
      if (m_distances.distance(point) >= end) {
        ends.push_back(point);
        continue;
      }
      band.push_back(point);
      open.insert(open.end(), m_children.begin() + m_children_begin[point],
                  m_children.begin() + m_children_begin[point + 1]);
    }
    std::sort(band.begin(), band.end());
  }

  void grow_band(const Task& task, std::vector<Slice>& slices, std::vector<Task>& tasks)
  {
    float begin = std::numeric_limits<float>::max();
    for (Index point : task.starts) {
      begin = std::min(begin, m_distances.distance(point));
    }
    if (task.parent != no_index) {
      begin = std::max(begin, slices[task.parent].end); // a shortest path may leap over its end
    }
    // Where all points are at one place, the width is 0.
    const float end = std::max(begin + task.width, std::nextafter(begin, std::numeric_limits<float>::max()));
    std::vector<Index> band;
    std::vector<Index> ends;
    gather(task.starts, end, band, ends);
    const auto first = Index(slices.size());
    split(task, begin, end, band, slices);
    for (Index slice = first; slice < slices.size(); ++slice) {
      measure(slices[slice], task.parent == no_index ? nullptr : &slices[task.parent]);
    }
    // What a path reaches over the whole band belongs to the slice that it comes from.
    std::vector<std::vector<Index>> starts(slices.size() - first);
    std::vector<Index> leaps;
    for (Index point : ends) {
      const Index from = m_slice_of_point[m_distances.parent(point)];
      if (from >= first && from != no_index) {
        starts[from - first].push_back(point);
      } else {
        leaps.push_back(point);
      }
    }
    if (!leaps.empty()) {
      tasks.push_back({task.parent, leaps, task.width});
    }
    for (Index slice = first; slice < slices.size(); ++slice) {
      if (!starts[slice - first].empty()) {
        tasks.push_back({slice, std::move(starts[slice - first]), width_beyond(slices[slice])});
      }
    }
  }

  /// Numbers the connected groups of the points of a band, connected if need be by points just before it.
  /// \return the number of groups
  Index connect(const Task& task, float begin, const std::vector<Index>& band, const std::vector<Slice>& slices)
  {
    std::vector<Index> connecting = band;
    if (task.parent != no_index) {
      for (Index point : slices[task.parent].points) {
        if (m_distances.distance(point) >= begin - float(overlap) * task.width) {
          connecting.push_back(point);
        }
      }
    }
    for (Index point : connecting) {
      m_group[point] = unnumbered;
    }
    if (task.parent == no_index) {
      for (Index point : band) {
        m_group[point] = 0; // an object has one root, though its foot may have gaps
      }
      return 1;
    }
    Index number = 0;
    std::vector<Index> open;
    for (Index start : band) {
      if (m_group[start] != unnumbered) {
        continue;
      }
      m_group[start] = number;
      open.assign(1, start);
      while (!open.empty()) {
        const Index point = open.back();
        open.pop_back();
        for (Index neighbor : m_graph.neighbors(point)) {
          if (m_group[neighbor] == unnumbered) {
            m_group[neighbor] = number;
            open.push_back(neighbor);
          }
        }
      }
      ++number;
    }
    return number;
  }

  /// Makes a slice of each group of the points of a band.
  void split(const Task& task, float begin, float end, const std::vector<Index>& band, std::vector<Slice>& slices)
  {
    const Index number_of_groups = connect(task, begin, band, slices);
    const auto first = Index(slices.size());
    slices.resize(first + number_of_groups, {task.parent, begin, end, {}, Vector_3::Zero(), 0, 0});
    for (Index point : band) {
      m_slice_of_point[point] = first + m_group[point];
      slices[m_slice_of_point[point]].points.push_back(point);
    }
    for (Index point : band) {
      m_group[point] = no_index;
    }
    if (task.parent != no_index) {
      for (Index point : slices[task.parent].points) {
        m_group[point] = no_index;
      }
    }
  }

  /// Measures a slice beyond another one, or a root.
  void measure(Slice& slice, const Slice* parent) const
  {
    const double number = double(slice.points.size());
    for (Index point : slice.points) {
      slice.centroid += m_points[point] / number;
      slice.spacing += m_graph.spacing(point) / number;
    }
    const Vector_3 step = parent != nullptr ? Vector_3(slice.centroid - parent->centroid) : Vector_3::UnitZ();
    const Vector_3 direction = step.norm() > 0 ? Vector_3(step.normalized()) : Vector_3::UnitZ();
    double sum = 0;
    for (Index point : slice.points) {
      sum += (m_points[point] - slice.centroid).cross(direction).squaredNorm() / number;
    }
    slice.radius = std::sqrt(sum);
  }

  /// The width of the bands beyond a slice.
  static float width_beyond(const Slice& slice)
  {
    return float(std::max(min_width * slice.spacing, width_in_radii * slice.radius));
  }

  const std::vector<Vector_3>& m_points;
  const Neighbor_graph& m_graph;
  const Root_distances& m_distances;
  std::vector<Index> m_slice_of_point;
  std::vector<Index> m_group; // of the points of the band at work
  std::vector<Index> m_children_begin;
  std::vector<Index> m_children; // in the tree of shortest paths
};

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_SLICE_GROWTH_H
