// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a scan of a tree to slices by the distance from its root, and from these to limbs.

#ifndef CSCD_SRC_TREE_LIMB_FINDER_H
#define CSCD_SRC_TREE_LIMB_FINDER_H

#include "Tree/Neighbor_graph.h"
#include <CSCD/Tree/Tree_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// A connected piece of a band of distances from the root.
struct Slice
{
  Index parent = no_index; ///< the next slice on the shortest paths to the root
  float begin = 0;         ///< the band
  float end = 0;
  std::vector<Index> points;
  Vector3 centroid = Vector3::Zero();
  double spacing = 0; ///< mean over the points
  double radius = 0;  ///< scatter around the direction of growth
};

/// A section of a limb, derived from a slice.
struct Section
{
  Vector3 center = Vector3::Zero();
  Vector3 direction = Vector3::Zero(); ///< of the limb, unit length
  double radius = 0;
  double confidence = 0; ///< of center and radius, in [0, 1]
  bool is_rough = true;  ///< whether no circle near it gives the radius
  Circle_outcome outcome = Circle_outcome::few_points;

  /// Whether center and radius are those of a circle.
  bool is_circle() const { return outcome == Circle_outcome::fitted; }
};

/// A limb from its base to its tip.
struct Tree_limb
{
  Index parent = no_index; ///< the limb that it grows from; none for a trunk
  Index joint = no_index;  ///< the slice of the parent that it grows from
  std::vector<Index> slices;
};

/// Cuts an object into slices, from the root outwards. Every slice grows into the points whose shortest paths leave it,
/// as far as its own thickness demands: so there are as many slices to a thick limb as to a thin one of the same
/// proportions, and a limb forks where the points fall apart.
class Slice_growth
{
public:
  Slice_growth(const std::vector<Vector3>& points, const Neighbor_graph& graph, const Root_distances& distances)
      : m_points(points), m_graph(graph), m_distances(distances), m_slice_of_point(points.size(), no_index),
        m_place(points.size(), no_index), m_children(points.size(), [&](const auto& add) {
          for (Index point = 0; point < points.size(); ++point) {
            if (distances.parent(point) != no_index) {
              add(distances.parent(point), point);
            }
          }
        })
  {
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
  /// The width of a band, relative to the spacing of the points: wide enough to connect the points around a limb.
  static constexpr double min_width = 3;
  /// And relative to the radius.
  static constexpr double width_in_radii = 1;
  /// How far back points still connect those of a band, relative to its width.
  static constexpr double overlap = 0.5;

  /// A part of an object beyond a slice, by the points that begin its next band.
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
      open.insert(open.end(), m_children[point].begin(), m_children[point].end());
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
    // A point that a path reaches over the whole band belongs to the slice that the path comes from.
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

  /// Makes a slice of each connected group of the points of a band, connected if need be by points just before it.
  void split(const Task& task, float begin, float end, const std::vector<Index>& band, std::vector<Slice>& slices)
  {
    std::vector<Index> connecting = band;
    if (task.parent != no_index) {
      for (Index point : slices[task.parent].points) {
        if (m_distances.distance(point) >= begin - float(overlap) * task.width) {
          connecting.push_back(point);
        }
      }
    }
    for (Index i = 0; i < connecting.size(); ++i) {
      m_place[connecting[i]] = i;
    }
    Disjoint_sets sets(connecting.size());
    for (Index point : connecting) {
      for (Index neighbor : m_graph.neighbors(point)) {
        if (m_place[neighbor] != no_index) {
          sets.join(m_place[point], m_place[neighbor]);
        }
      }
      if (task.parent == no_index) { // an object has one root, though its foot may have gaps
        sets.join(0, m_place[point]);
      }
    }
    Index number_of_groups = 0;
    const std::vector<Index> group = sets.numbers(number_of_groups);
    const auto first = Index(slices.size());
    for (Index i = 0; i < band.size(); ++i) {
      if (first + group[i] == slices.size()) {
        slices.push_back({task.parent, begin, end, {}, Vector3::Zero(), 0, 0});
      }
      m_slice_of_point[band[i]] = first + group[i];
      slices[first + group[i]].points.push_back(band[i]);
    }
    for (Index point : connecting) {
      m_place[point] = no_index;
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
    const Vector3 step = parent != nullptr ? Vector3(slice.centroid - parent->centroid) : Vector3::UnitZ();
    const Vector3 direction = step.norm() > 0 ? Vector3(step.normalized()) : Vector3::UnitZ();
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

  const std::vector<Vector3>& m_points;
  const Neighbor_graph& m_graph;
  const Root_distances& m_distances;
  std::vector<Index> m_slice_of_point;
  std::vector<Index> m_place;        // of the points of the band at work
  Compressed_rows<Index> m_children; // in the tree of shortest paths
};

/// Joins slices to limbs. First, where slices fork, a limb goes on into the part that reaches farthest, and limbs too
/// short to be distinguished from a bump of the bark are given up. Then a limb goes on into the part that carries most
/// and is nearly straight on.
class Limb_finder
{
public:
  explicit Limb_finder(const std::vector<Slice>& slices) : m_slices(slices), m_host(all_indices(slices.size()))
  {
    find_reaches();
    decompose(m_reach);
    give_up_short_limbs();
    find_strengths();
    decompose(m_strength);
  }

  /// Parents first.
  const std::vector<Tree_limb>& limbs() const { return m_limbs; }
  /// For every slice the slice of a limb that its points belong to: itself, unless its limb was given up.
  const std::vector<Index>& hosts() const { return m_host; }

private:
  /// The least length of a limb beyond its parent, relative to the spacing of its points ...
  static constexpr double min_length = 6;
  /// ... and to the radius of its parent.
  static constexpr double min_length_in_radii = 1;
  /// The weight of going straight on, compared with the length that is carried.
  static constexpr int straightness_exponent = 2;
  /// The number of slices that give the direction of a limb.
  static constexpr int direction_slices = 3;

  bool is_alive(Index slice) const { return m_host[slice] == slice; }

  /// For every slice the distance where the part of an object from it on ends.
  void find_reaches()
  {
    m_reach.assign(m_slices.size(), 0);
    for (Index slice = Index(m_slices.size()); slice-- > 0;) {
      m_reach[slice] = std::max(m_reach[slice], m_slices[slice].end);
      if (m_slices[slice].parent != no_index) {
        float& of_parent = m_reach[m_slices[slice].parent];
        of_parent = std::max(of_parent, m_reach[slice]);
      }
    }
  }

  /// For every slice how likely its parent goes on into it: more likely the straighter it is, and the greater the
  /// length of limbs that it carries, which is proportional to the area of its section.
  void find_strengths()
  {
    std::vector<float> carried(m_slices.size(), 0);
    for (Index slice = Index(m_slices.size()); slice-- > 0;) {
      const Index parent = m_slices[slice].parent;
      if (is_alive(slice) && parent != no_index) {
        carried[slice] += float((m_slices[slice].centroid - m_slices[parent].centroid).norm());
        carried[parent] += carried[slice];
      }
    }
    const std::vector<Index> next = successors(carried);
    m_strength.assign(m_slices.size(), 0);
    for (Index slice = 0; slice < m_slices.size(); ++slice) {
      if (m_slices[slice].parent == no_index) {
        continue;
      }
      Index before = m_slices[slice].parent;
      Index after = slice;
      for (int i = 0; i < direction_slices; ++i) {
        before = m_slices[before].parent == no_index ? before : m_slices[before].parent;
        after = next[after] == no_index ? after : next[after];
      }
      const Vector3& fork = m_slices[m_slices[slice].parent].centroid;
      const Vector3 in = fork - m_slices[before].centroid;
      const Vector3 out = m_slices[after].centroid - fork;
      const double cosine = in.norm() > 0 && out.norm() > 0 ? in.normalized().dot(out.normalized()) : 1;
      m_strength[slice] = float(carried[slice] * std::pow((1 + cosine) / 2, straightness_exponent));
    }
  }

  /// For every slice the next one of the greatest key; `no_index` if there is none.
  std::vector<Index> successors(const std::vector<float>& key) const
  {
    std::vector<Index> result(m_slices.size(), no_index);
    for (Index slice = 0; slice < m_slices.size(); ++slice) {
      const Index parent = m_slices[slice].parent;
      if (is_alive(slice) && parent != no_index && (result[parent] == no_index || key[result[parent]] < key[slice])) {
        result[parent] = slice;
      }
    }
    return result;
  }

  void decompose(const std::vector<float>& key)
  {
    const std::vector<Index> successor = successors(key);
    m_limbs.clear();
    std::vector<Index> limb_of_slice(m_slices.size(), no_index);
    for (Index slice = 0; slice < m_slices.size(); ++slice) {
      const Index parent = m_slices[slice].parent;
      if (!is_alive(slice)) {
        continue;
      }
      if (parent != no_index && successor[parent] == slice) {
        limb_of_slice[slice] = limb_of_slice[parent];
      } else {
        limb_of_slice[slice] = Index(m_limbs.size());
        m_limbs.push_back({parent == no_index ? no_index : limb_of_slice[parent], parent, {}});
      }
      m_limbs[limb_of_slice[slice]].slices.push_back(slice);
    }
  }

  void give_up_short_limbs()
  {
    for (const Tree_limb& limb : m_limbs) {
      if (limb.parent == no_index) {
        continue;
      }
      const Slice& joint = m_slices[limb.joint];
      const double length = m_reach[limb.slices.front()] - m_slices[limb.slices.front()].begin;
      if (!is_alive(limb.joint) || length < min_length * joint.spacing || length < min_length_in_radii * joint.radius) {
        for (Index slice : limb.slices) {
          m_host[slice] = m_host[m_slices[slice].parent];
        }
      }
    }
  }

  const std::vector<Slice>& m_slices;
  std::vector<Index> m_host;
  std::vector<float> m_reach;
  std::vector<float> m_strength;
  std::vector<Tree_limb> m_limbs;
};

/// The slices of `parent` next to the first slices of `limb`, one for each, so far as these lie on the bark of it.
inline std::vector<Index> hosts_of_base(const std::vector<Slice>& slices, const std::vector<Section>& sections,
                                        const Tree_limb& parent, const Tree_limb& limb)
{
  constexpr double bark = 1.25;          // how far from the axis of its parent a slice is on its bark, in radii
  constexpr double longest_overhang = 2; // how far beyond the end of its parent a slice may be, likewise
  constexpr double min_part = 0.75;      // of the slices to give away that are on the bark
  auto at = std::find(parent.slices.begin(), parent.slices.end(), limb.joint);
  std::vector<Index> hosts;
  std::size_t number_on_bark = 0;
  std::size_t number = 0; // of the slices to give away
  for (const Index slice : limb.slices) {
    const Vector3& place = slices[slice].centroid;
    const auto distance = [&](Index host) { return (sections[host].center - place).norm(); };
    while (at + 1 != parent.slices.end() && distance(*(at + 1)) < distance(*at)) {
      ++at;
    }
    hosts.push_back(*at);
    const Section& section = sections[*at];
    const Vector3 d = place - section.center;
    if (d.cross(section.direction).norm() <= bark * section.radius &&
        std::abs(d.dot(section.direction)) <= longest_overhang * section.radius) {
      ++number_on_bark;
      number = double(number_on_bark) >= min_part * double(hosts.size()) ? hosts.size() : number;
    }
  }
  hosts.resize(number);
  return hosts;
}

/// Gives the points of slice `from` to slice `to`.
inline void give_points(Slice& from, Slice& to)
{
  const double number = double(to.points.size() + from.points.size());
  to.centroid = (double(to.points.size()) * to.centroid + double(from.points.size()) * from.centroid) / number;
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  from.points.clear();
}

/// Gives the first slices of limbs to their parents as long as they lie on the bark of these. Where a trunk is seen
/// from two sides only, its points fall apart into two strips: so they become one again, and all that grows from them
/// is hung up anew. \return for every slice itself, or the slice that its points went to
inline std::vector<Index> absorb_limb_bases(std::vector<Slice>& slices, const std::vector<Section>& sections,
                                            std::vector<Tree_limb>& limbs)
{
  std::vector<Index> new_slice = all_indices(slices.size());
  std::vector<Index> limb_of_slice(slices.size(), no_index);
  std::vector<Tree_limb> kept;
  for (Tree_limb& limb : limbs) {
    if (limb.joint != no_index) {
      limb.joint = new_slice[limb.joint];
      limb.parent = limb_of_slice[limb.joint];
      const std::vector<Index> hosts = hosts_of_base(slices, sections, kept[limb.parent], limb);
      for (std::size_t i = 0; i < hosts.size(); ++i) {
        give_points(slices[limb.slices[i]], slices[hosts[i]]);
        new_slice[limb.slices[i]] = limb.joint = hosts[i];
      }
      limb.slices.erase(limb.slices.begin(), limb.slices.begin() + std::ptrdiff_t(hosts.size()));
    }
    if (!limb.slices.empty()) {
      for (const Index slice : limb.slices) {
        limb_of_slice[slice] = Index(kept.size());
      }
      kept.push_back(std::move(limb));
    }
  }
  limbs = std::move(kept);
  return new_slice;
}

} // namespace CSCD::internal

#endif // CSCD_SRC_TREE_LIMB_FINDER_H
