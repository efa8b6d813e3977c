// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How well a separator cuts a limb, as the published method scores it.

#ifndef CSCD_PUBLISHED_BALANCE_AND_ROUNDNESS_H
#define CSCD_PUBLISHED_BALANCE_AND_ROUNDNESS_H

#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/Epoch_marks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Measures the surface on the two sides of separators, one after the other. The work is that of the surface near a
/// separator, up to a distance and an area that are given. One object serves one thread.
/// \tparam Surface what separators lie on
template <class Surface>
class Separator_sides
{
public:
  /// One side of a separator.
  struct Side
  {
    double band_area = 0; ///< of the surface within a distance of the separator
    double area = 0;      ///< of all the surface on this side, or something above a limit
  };

  /// \param surface is referred to
  explicit Separator_sides(const Surface& surface)
      : m_surface(surface), m_crossed(surface.number_of_halfedges()), m_front(surface.number_of_vertices())
  {
  }

  /// Measures one side.
  /// \param width the distance along edges that bounds the band \param limit where the area need not be counted further
  Side measure(const Separator& separator, bool is_left, double width, double limit)
  {
    m_crossed.clear();
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_crossed.mark(edge_of(m_surface, crossing.halfedge));
    }
    for (const Edge_crossing& crossing : separator.crossings) {
      // The target of the halfedge lies on the left.
      const Index vertex = is_left ? m_surface.target(crossing.halfedge) : m_surface.origin(crossing.halfedge);
      const double part = is_left ? 1 - crossing.position : crossing.position;
      m_front.reach(vertex, float(part * m_surface.length(crossing.halfedge)));
    }
    Side side = spread(width, limit);
    if (separator.is_open) {
      side.area += (is_left ? 1 : -1) * missing_on_left(separator);
    }
    return side;
  }

private:
  /// What the faces that `separator` cuts have on its left beyond what their vertices there stand for, a third each. In
  /// corners of sheets, this is most of the area.
  double missing_on_left(const Separator& separator) const
  {
    double result = 0;
    for (std::size_t i = 0; i < separator.crossings.size(); ++i) {
      const Edge_crossing& a = separator.crossings[i];
      const Edge_crossing& b = separator.crossings[i + 1 < separator.crossings.size() ? i + 1 : 0];
      const bool is_corner_left = m_surface.target(a.halfedge) == m_surface.target(b.halfedge);
      const auto end = [&](const Edge_crossing& crossing, bool is_corner) {
        return m_surface.points()[is_corner == is_corner_left ? m_surface.target(crossing.halfedge)
                                                              : m_surface.origin(crossing.halfedge)];
      };
      const Vector_3& corner = end(a, true);
      const double area = triangle_area(corner, end(a, false), end(b, false));
      const double part_at_corner = is_corner_left ? (1 - a.position) * (1 - b.position) : a.position * b.position;
      result += area * (is_corner_left ? part_at_corner - 1. / 3 : 1. / 3 - part_at_corner);
    }
    return result;
  }

  Side spread(double width, double limit)
  {
    Side side;
    m_front.spread([&](Index vertex, float distance) {
      const double area = double(m_surface.vertex_area(vertex));
      side.area += area;
      // The part of the vertex that is in the band, as if it was a square along it.
      const double extent = std::sqrt(area);
      const double from = std::max(double(distance) - extent / 2, 0.);
      const double to = std::min(double(distance) + extent / 2, width);
      side.band_area += std::max(to - from, 0.) * extent;
      if (from > width && side.area > limit) {
        return;
      }
      for (Index halfedge : m_surface.outgoing(vertex)) {
        if (!m_crossed.is_marked(edge_of(m_surface, halfedge))) {
          m_front.reach(m_surface.target(halfedge), distance + float(m_surface.length(halfedge)));
        }
      }
    });
    return side;
  }

  const Surface& m_surface;
  Epoch_marks m_crossed;
  Dijkstra_search m_front;
};

/// Weighs separators by the balance of the surface on their two sides and by their roundness (section 3.2.1), and
/// prunes those that cut no limb (section 3.2.2). One object serves one thread.
///
/// The published text says that local separators are weighed as Baerentzen and Rotenberg do, by the ratio of the sizes
/// of their two fronts: 1 on a tube, less at its ends and where a limb branches off. The areas of two bands are that
/// for a curve. Roundness is the square root of the isoperimetric quotient; open separators have none.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Balance_and_roundness
{
public:
  enum class Verdict
  {
    good,
    bump,  ///< one side is as small as that of a curve around a bump
    tunnel ///< the curve does not span the body
  };

  explicit Balance_and_roundness(const Surface& surface, Weight_rule rule = Weight_rule::balance_and_roundness)
      : m_surface(surface), m_rule(rule), m_sides(surface.triangulation())
  {
  }

  /// Judges `separator` and sets `weight`, above 0 for a good one and 0 for others; but for `shortness` it is at
  /// most 1.
  Verdict operator()(const Separator& separator, double& weight)
  {
    weight = 0;
    const double squared_length = separator.length * separator.length;
    const double width = band_width * separator.length;
    const double min_area = min_area_ratio(separator) * squared_length;
    const typename Sides::Side left = m_sides.measure(separator, true, width, min_area);
    const typename Sides::Side right = m_sides.measure(separator, false, width, min_area);
    if (std::min(left.area, right.area) < min_area) {
      return Verdict::bump;
    }
    curve_points(m_surface.triangulation(), separator, m_points);
    // Between the two sides of a sheet there is nothing to be spanned.
    if (!separator.is_open && span_inside_share(m_surface, m_points, separator.center) < min_inside_share) {
      return Verdict::tunnel;
    }
    weight = weight_of_good(separator,
                            std::min(left.band_area, right.band_area) / std::max(left.band_area, right.band_area));
    return Verdict::good;
  }

private:
  using Sides = Separator_sides<std::decay_t<decltype(std::declval<const Surface&>().triangulation())>>;

  /// Width of the bands, relative to the length of the separator.
  static constexpr double band_width = 1. / 8;
  /// Least share of the spanned surface that lies inside: bent limbs have 0.8 and more, tunnels about 0.
  static constexpr double min_inside_share = 0.7;

  static double min_area_ratio(const Separator& separator)
  {
    return separator.is_open ? open_area_factor * Detail().min_branch_area_ratio() : Detail::max_loop_area_ratio;
  }

  double weight_of_good(const Separator& separator, double balance) const
  {
    switch (m_rule) {
    case Weight_rule::none:
      return 1;
    case Weight_rule::shortness:
      return 1 / separator.length; // coordinates are those of a surface of unit area
    case Weight_rule::balance:
      return balance;
    default:
      return separator.is_open ? balance : balance * std::sqrt(std::min(1., separator.roundness()));
    }
  }

  const Surface& m_surface;
  Weight_rule m_rule;
  Sides m_sides;
  std::vector<Vector_3> m_points;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_BALANCE_AND_ROUNDNESS_H
