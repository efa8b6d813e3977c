// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures of two segmentations by common faces and by boundaries.

#include <CSCD/Measure/compare_segmentations.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD::internal {

std::vector<Index> number_labels(const std::vector<long long>& labels)
{
  std::vector<long long> different = labels;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  std::vector<Index> numbers;
  numbers.reserve(labels.size());
  for (const long long label : labels) {
    numbers.push_back(Index(std::lower_bound(different.begin(), different.end(), label) - different.begin()));
  }
  return numbers;
}

namespace {

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
    const double expected = all > 0 ? in_first * in_second / all : 0;
    const double greatest = (in_first + in_second) / 2;
    result.adjusted_rand_index = greatest > expected ? (in_both - expected) / (greatest - expected) : 1;
  }

  void measure_covering(Segmentation_comparison& result) const
  {
    std::vector<double> best_in_first(m_second.size(), 0);
    std::vector<double> best_in_second(m_first.size(), 0);
    for_each_common([&](std::size_t i, std::size_t j, double common) {
      best_in_first[j] = std::max(best_in_first[j], common);
      best_in_second[i] = std::max(best_in_second[i], common);
    });
    result.missing_rate = 1 - sum(best_in_first) / m_number_of_faces;
    result.false_alarm_rate = 1 - sum(best_in_second) / m_number_of_faces;
    result.hamming_distance = (result.missing_rate + result.false_alarm_rate) / 2;
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
  Segment_boundaries(const Indexed_triangles& triangles, const Halfedge_pairing& pairing)
      : m_triangles(triangles), m_pairing(pairing)
  {
  }

  /// The vertices of edges between faces of different labels, marked by 1.
  std::vector<char> boundary_vertices(const std::vector<Index>& labels) const
  {
    std::vector<char> is_on_boundary(m_triangles.points.size(), 0);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      const Index twin = m_pairing.twin(h);
      if (twin != no_index && labels[Halfedge_pairing::face(h)] != labels[Halfedge_pairing::face(twin)]) {
        is_on_boundary[origin(h)] = is_on_boundary[origin(Halfedge_pairing::next(h))] = 1;
      }
    }
    return is_on_boundary;
  }

  /// The mean distance from the vertices `from` to the nearest one of `to`, along edges.
  double mean_distance(const std::vector<char>& from, const std::vector<char>& to) const
  {
    Dijkstra_search search(m_triangles.points.size());
    for (Index v = 0; v < to.size(); ++v) {
      if (to[v] != 0) {
        search.reach(v, 0);
      }
    }
    std::vector<Index> halfedge_of(m_triangles.points.size(), no_index);
    for (Index h = 0; h < m_pairing.number_of_halfedges(); ++h) {
      halfedge_of[origin(h)] = h;
    }
    search.spread([&](Index vertex, float distance) {
      for_each_in_fan(m_pairing, halfedge_of[vertex], [&](Index h) {
        for (const Index end : {Halfedge_pairing::next(h), Halfedge_pairing::previous(h)}) { // both sides of the face
          const Vector_3 edge = m_triangles.points[origin(end)] - m_triangles.points[vertex];
          search.reach(origin(end), distance + float(edge.norm()));
        }
      });
    });
    double sum = 0;
    std::size_t number = 0;
    for (Index v = 0; v < from.size(); ++v) {
      if (from[v] != 0) {
        sum += search.is_reached(v) ? double(search.distance(v)) : undefined_measure;
        ++number;
      }
    }
    return number > 0 ? sum / double(number) : 0;
  }

  /// The mean distance of the centers of the faces, weighted by area, from their centroid.
  double mean_radius() const
  {
    const std::vector<double> areas = face_areas(m_triangles);
    std::vector<Vector_3> centers;
    centers.reserve(areas.size());
    Vector_3 moment = Vector_3::Zero();
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
  Index origin(Index halfedge) const { return m_triangles.faces[Halfedge_pairing::face(halfedge)][halfedge % 3]; }

  const Indexed_triangles& m_triangles;
  const Halfedge_pairing& m_pairing;
};

} // namespace

Segmentation_comparison compare_segmentations(const Indexed_triangles& triangles, const Halfedge_pairing& pairing,
                                              const std::vector<Index>& first, const std::vector<Index>& second)
{
  CGAL_precondition(first.size() == triangles.faces.size() && second.size() == triangles.faces.size());
  Segmentation_comparison result;
  const Common_faces common(first, second);
  common.measure_pairs(result);
  common.measure_covering(result);
  common.measure_refinement(result);
  const Segment_boundaries boundaries(triangles, pairing);
  const std::vector<char> of_first = boundaries.boundary_vertices(first);
  const std::vector<char> of_second = boundaries.boundary_vertices(second);
  result.cut_discrepancy =
      (boundaries.mean_distance(of_first, of_second) + boundaries.mean_distance(of_second, of_first)) /
      boundaries.mean_radius();
  return result;
}

} // namespace CSCD::internal
