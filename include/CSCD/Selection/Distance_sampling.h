// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The random choice of sources far from earlier ones.

#ifndef CSCD_SELECTION_DISTANCE_SAMPLING_H
#define CSCD_SELECTION_DISTANCE_SAMPLING_H

#include <CSCD/internal/Vector_3.h>

#include <CGAL/assertions.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Draws vertices at random, with a probability in proportion to the area that a vertex stands for and to its geodesic
/// distance from the nearest vertex drawn before (section 3.1.7). So sources spread over the surface, however finely
/// parts of it are triangulated, and limbs that have not been visited come first.
class Distance_sampling
{
public:
  /// \param areas for each vertex, the area that it stands for; vertices of no area are never drawn
  Distance_sampling(std::vector<double> areas, unsigned random_seed)
      : m_areas(std::move(areas)), m_distance(m_areas.size(), std::numeric_limits<double>::infinity()),
        m_sums(m_areas.size()), m_generator(random_seed)
  {
  }

  /// Draws up to `size` different vertices to `batch`; fewer if hardly more have an area. Linear.
  void draw(std::size_t size, std::vector<Index>& batch)
  {
    batch.clear();
    const double total = sum_probabilities();
    // What was drawn in this batch has a share of the sums still, and is rejected. The bound is for surfaces of few
    // vertices, where hardly another one may be left.
    constexpr std::size_t most_rejections = 64;
    std::size_t rejections = 0;
    while (batch.size() < size && rejections < most_rejections && total > 0) {
      const double position = boost::random::uniform_01<double>()(m_generator) * total;
      const auto vertex = Index(std::upper_bound(m_sums.begin(), m_sums.end(), position) - m_sums.begin());
      if (vertex < m_sums.size() && std::find(batch.begin(), batch.end(), vertex) == batch.end()) {
        batch.push_back(vertex);
      } else {
        ++rejections;
      }
    }
  }

  /// Takes note of a source: `distance(vertex)` is the geodesic distance from it, infinite where it does not reach.
  template <class Distance>
  void add_source(const Distance& distance)
  {
    for (std::size_t vertex = 0; vertex < m_distance.size(); ++vertex) {
      m_distance[vertex] = std::min(m_distance[vertex], std::max(0., double(distance(Index(vertex)))));
    }
  }

private:
  /// Vertices that no source reaches count as far as the farthest that is reached; where all have been drawn, each
  /// counts alike. \return the sum of all
  double sum_probabilities()
  {
    double farthest = 0;
    for (double distance : m_distance) {
      if (std::isfinite(distance)) {
        farthest = std::max(farthest, distance);
      }
    }
    double sum = 0;
    for (std::size_t vertex = 0; vertex < m_areas.size(); ++vertex) {
      sum += m_areas[vertex] * (farthest > 0 ? std::min(m_distance[vertex], farthest) : 1.);
      m_sums[vertex] = sum;
    }
    return sum;
  }

  std::vector<double> m_areas;
  std::vector<double> m_distance;
  std::vector<double> m_sums;
  boost::random::mt19937 m_generator;
};

} // namespace CSCD::internal

#endif // CSCD_SELECTION_DISTANCE_SAMPLING_H
