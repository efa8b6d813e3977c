// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of two segmentations of a mesh, by common faces and by boundaries.

#ifndef CSCD_BENCHMARK_COMPARE_SEGMENTATIONS_H
#define CSCD_BENCHMARK_COMPARE_SEGMENTATIONS_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Traits/collect_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace benchmark_applications {

using CSCD::Index;

/// How two segmentations of the same faces differ: the measures of the Princeton segmentation benchmark (X. Chen,
/// A. Golovinskiy, T. Funkhouser, "A benchmark for 3D mesh segmentation", 2009). Each face counts once, whatever its
/// area. All are 0 for equal segmentations.
struct Segmentation_comparison
{
  double rand_error = 0;       ///< part of the pairs of faces that are together in one, apart in the other
  double hamming_distance = 0; ///< part of the faces outside of the part that covers theirs best, mean both ways
  double global_consistency_error = 0; ///< 0 if one segmentation refines the other
  double local_consistency_error = 0;  ///< 0 if at each place one segmentation refines the other
  /// Mean distances along edges from the boundaries of each segmentation to those of the other, added and divided by
  /// the mean distance of the faces from their centroid; not a number if just one of the segmentations has boundaries,
  /// or some lie in components where the other has none.
  double cut_discrepancy = 0;
};

/// How many faces each part of one segmentation shares with each part of another one.
class Common_faces
{
public:
  Common_faces(const std::vector<Index>& first, const std::vector<Index>& second)
      : m_number_of_faces(double(first.size())), m_first(number_of_parts(first), 0),
        m_second(number_of_parts(second), 0)
  {
    std::vector<std::array<Index, 2>> parts;
    parts.reserve(first.size());
    for (std::size_t f = 0; f < first.size(); ++f) {
      ++m_first[first[f]];
      ++m_second[second[f]];
      parts.push_back({first[f], second[f]});
    }
    std::sort(parts.begin(), parts.end());
    for (std::size_t f = 0; f < parts.size(); ++f) {
      if (f == 0 || parts[f] != parts[f - 1]) {
        m_parts.push_back(parts[f]);
        m_common.push_back(0);
      }
      ++m_common.back();
    }
  }

  void measure_pairs(Segmentation_comparison& result) const
  {
    const double all = pairs(m_number_of_faces);
    const double in_both = number_of_pairs(m_common);
    const double in_first = number_of_pairs(m_first);
    const double in_second = number_of_pairs(m_second);
    result.rand_error = all > 0 ? (in_first + in_second - 2 * in_both) / all : 0;
  }

  void measure_covering(Segmentation_comparison& result) const
  {
    std::vector<double> best_in_first(m_second.size(), 0);
    std::vector<double> best_in_second(m_first.size(), 0);
    for_each_common([&](std::size_t i, std::size_t j, double common) {
      best_in_first[j] = std::max(best_in_first[j], common);
      best_in_second[i] = std::max(best_in_second[i], common);
    });
    result.hamming_distance = 1 - (sum(best_in_first) + sum(best_in_second)) / (2 * m_number_of_faces);
  }

  void measure_refinement(Segmentation_comparison& result) const
  {
    double of_first = 0; // sums over the faces of the part of their part that is not in their other part
    double of_second = 0;
    double of_least = 0;
    for_each_common([&](std::size_t i, std::size_t j, double common) {
      const double first = (m_first[i] - common) / m_first[i];
      const double second = (m_second[j] - common) / m_second[j];
      of_first += common * first;
      of_second += common * second;
      of_least += common * std::min(first, second);
    });
    result.global_consistency_error = std::min(of_first, of_second) / m_number_of_faces;
    result.local_consistency_error = of_least / m_number_of_faces;
  }

private:
  static std::size_t number_of_parts(const std::vector<Index>& labels)
  {
    return std::size_t(*std::max_element(labels.begin(), labels.end())) + 1;
  }
  static double pairs(double n) { return n * (n - 1) / 2; }
  static double number_of_pairs(const std::vector<double>& sizes)
  {
    return std::accumulate(sizes.begin(), sizes.end(), 0., [](double sum, double size) { return sum + pairs(size); });
  }
  static double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.); }

  /// Calls `use(i, j, n)` for the parts i of the first and j of the second that share n > 0 faces.
  template <class Use>
  void for_each_common(const Use& use) const
  {
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
      use(m_parts[k][0], m_parts[k][1], m_common[k]);
    }
  }

  double m_number_of_faces;
  std::vector<double> m_first; // sizes of the parts
  std::vector<double> m_second;
  std::vector<std::array<Index, 2>> m_parts; // the pairs of parts that share faces
  std::vector<double> m_common;              // their numbers of faces
};

/// The boundaries between the parts of segmentations of one surface, and distances to them along edges.
class Segment_boundaries
{
public:
  Segment_boundaries(const CSCD::Indexed_triangles& triangles, const CSCD::Halfedge_pairing& pairing)
      : m_triangles(triangles), m_pairing(pairing)
  {
  }

  /// The vertices of edges between faces of different labels, marked by 1.
  std::vector<char> boundary_vertices(const std::vector<Index>& labels) const
  {
    std::vector<char> is_on_boundary(m_triangles.points.size(), 0);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      const Index twin = m_pairing.twin(h);
      if (twin != CSCD::no_index &&
          labels[CSCD::Halfedge_pairing::face(h)] != labels[CSCD::Halfedge_pairing::face(twin)]) {
        is_on_boundary[origin(h)] = is_on_boundary[origin(CSCD::Halfedge_pairing::next(h))] = 1;
      }
    }
    return is_on_boundary;
  }

  /// The mean distance from the vertices `from` to the nearest one of `to`, along edges.
  double mean_distance(const std::vector<char>& from, const std::vector<char>& to) const
  {
    CSCD::internal::Dijkstra_search search(m_triangles.points.size());
    for (Index v = 0; v < to.size(); ++v) {
      if (to[v] != 0) {
        search.reach(v, 0);
      }
    }
    std::vector<Index> halfedge_of(m_triangles.points.size(), CSCD::no_index);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      halfedge_of[origin(h)] = h;
    }
    search.spread([&](Index vertex, float distance) {
      CSCD::for_each_in_fan(m_pairing, halfedge_of[vertex], [&](Index h) {
        for (const Index end :
             {CSCD::Halfedge_pairing::next(h), CSCD::Halfedge_pairing::previous(h)}) { // both sides of the face
          const CSCD::Vector_3 edge = m_triangles.points[origin(end)] - m_triangles.points[vertex];
          search.reach(origin(end), distance + float(edge.norm()));
        }
      });
    });
    double sum = 0;
    std::size_t number = 0;
    for (Index v = 0; v < from.size(); ++v) {
      if (from[v] != 0) {
        sum += search.is_reached(v) ? double(search.distance(v)) : std::numeric_limits<double>::quiet_NaN();
        ++number;
      }
    }
    return number > 0 ? sum / double(number) : 0;
  }

  /// The mean distance of the centers of the faces, weighted by area, from their centroid.
  double mean_radius() const
  {
    const std::vector<double> areas = CSCD::internal::face_areas(m_triangles);
    std::vector<CSCD::Vector_3> centers;
    centers.reserve(areas.size());
    CSCD::Vector_3 moment = CSCD::Vector_3::Zero();
    double area = 0;
    for (std::size_t f = 0; f < areas.size(); ++f) {
      const auto& [a, b, c] = m_triangles.faces[f];
      centers.push_back((m_triangles.points[a] + m_triangles.points[b] + m_triangles.points[c]) / 3);
      moment += areas[f] * centers.back();
      area += areas[f];
    }
    double sum = 0;
    for (std::size_t f = 0; f < centers.size(); ++f) {
      sum += areas[f] * (centers[f] - moment / area).norm();
    }
    return sum / area;
  }

private:
  Index origin(Index halfedge) const { return m_triangles.faces[CSCD::Halfedge_pairing::face(halfedge)][halfedge % 3]; }

  const CSCD::Indexed_triangles& m_triangles;
  const CSCD::Halfedge_pairing& m_pairing;
};

/// The labels of the faces of `mesh` in their order, numbered anew from 0.
template <class Mesh, class Labels>
std::vector<Index> numbered_labels(const Mesh& mesh, const Labels& labels)
{
  std::map<std::size_t, Index> numbers;
  std::vector<Index> result;
  for (const auto face : mesh.faces()) {
    result.push_back(numbers.emplace(labels[face], Index(numbers.size())).first->second);
  }
  return result;
}

/// Measures how alike two segmentations of a `CGAL::Surface_mesh` are. O(n log n).
template <class Mesh, class Labels>
Segmentation_comparison compare_segmentations(const Mesh& mesh, const Labels& first_labels, const Labels& second_labels)
{
  const std::vector<Index> first = numbered_labels(mesh, first_labels);
  const std::vector<Index> second = numbered_labels(mesh, second_labels);
  Segmentation_comparison result;
  const Common_faces common(first, second);
  common.measure_pairs(result);
  common.measure_covering(result);
  common.measure_refinement(result);
  const auto collected = CSCD::internal::collect_triangles(mesh, get(CGAL::vertex_point, mesh));
  const Segment_boundaries boundaries(collected.triangles, collected.pairing);
  const std::vector<char> of_first = boundaries.boundary_vertices(first);
  const std::vector<char> of_second = boundaries.boundary_vertices(second);
  result.cut_discrepancy =
      (boundaries.mean_distance(of_first, of_second) + boundaries.mean_distance(of_second, of_first)) /
      boundaries.mean_radius();
  return result;
}

} // namespace benchmark_applications

#endif // CSCD_BENCHMARK_COMPARE_SEGMENTATIONS_H
