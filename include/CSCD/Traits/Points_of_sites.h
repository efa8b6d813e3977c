// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points of the input the sites of a surface stand for.

#ifndef CSCD_TRAITS_POINTS_OF_SITES_H
#define CSCD_TRAITS_POINTS_OF_SITES_H

#include <CSCD/Point_cloud/collect_points.h>
#include <CSCD/internal/Vector_3.h>
#include <CSCD/internal/point_map.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CSCD::internal {

/// For every site, the points of the input for which it stands, by what identifies them there.
template <class PointRange>
class Points_of_sites
{
public:
  using Descriptor = Point_descriptor<PointRange>;

  /// None.
  Points_of_sites() = default;

  /// \param points the range of which `cloud` was made \param site_of_point of every point of the cloud
  Points_of_sites(const PointRange& points, const Point_cloud& cloud, const std::vector<Index>& site_of_point,
                  std::size_t number_of_sites)
      : m_begin(number_of_sites + 1, 0), m_descriptors(cloud.input_point.size())
  {
    for (const Index point : cloud.input_point) {
      ++m_begin[site_of_point[point] + 1];
    }
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    std::vector<Index> fill(m_begin.begin(), m_begin.end() - 1);
    std::size_t number = 0;
    for ([[maybe_unused]] const auto& element : points) {
      Descriptor& descriptor = m_descriptors[fill[site_of_point[cloud.input_point[number]]]++];
      if constexpr (Is_range_of_indices<PointRange>::value) {
        descriptor = element;
      } else {
        descriptor = number;
      }
      ++number;
    }
  }

  CGAL::Iterator_range<const Descriptor*> operator[](Index site) const
  {
    return {m_descriptors.data() + m_begin[site], m_descriptors.data() + m_begin[site + 1]};
  }
  /// The number of points of all sites together.
  std::size_t number_of_points() const { return m_descriptors.size(); }

private:
  std::vector<Index> m_begin; // of every site
  std::vector<Descriptor> m_descriptors;
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_POINTS_OF_SITES_H
