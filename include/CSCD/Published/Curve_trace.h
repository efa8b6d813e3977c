// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From closed polygons among points to the edges that they cross.

#ifndef CSCD_PUBLISHED_CURVE_TRACE_H
#define CSCD_PUBLISHED_CURVE_TRACE_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Variational_shortening.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// Finds the edges of a point complex that closed curves on its surface cross.
///
/// A curve need not meet any edge: it is widened to a ribbon along the normals of the surface. All vertices around it
/// are given the side of the ribbon on which they are, at the point of the curve that is nearest to them; those exactly
/// in it are on the left. Edges whose ends are on different sides are crossed. So whatever the complex looks like, with
/// edges of three triangles or triangles through each other, no way of edges leads through the curve but over a crossed
/// one. Where the curve leads over a hole there is nothing to cross, and it separates all the same. One object serves
/// one thread; reuse it.
class Complex_trace
{
public:
  /// \param complex is referred to and must outlive this object
  explicit Complex_trace(const Point_complex& complex)
      : m_complex(complex), m_is_met(complex.number_of_vertices()), m_foot(complex.number_of_vertices()),
        m_is_taken(complex.number_of_halfedges())
  {
  }

  /// Writes to `crossings` the edges that the closed polygon `curve` crosses, in the order of the polygon. The work is
  /// that of the vertices along the curve.
  /// \param curve points of the surface with their normals, each with a vertex nearby as its site
  /// \return false if they do not go around: if fewer than three edges are crossed, or too much of the curve leads over
  ///         holes
  bool operator()(const std::vector<Projected_point>& curve, std::vector<Edge_crossing>& crossings)
  {
    measure(curve);
    spread();
    collect();
    crossings.clear();
    for (const Located_crossing& located : m_located) {
      crossings.push_back(located.crossing);
    }
    return crossings.size() >= 3 && length_of_gaps() <= max_gap_share * length();
  }

private:
  /// The point of the curve that is nearest to a vertex.
  struct Foot
  {
    double position; ///< along the curve, from its first point
    double distance;
    double height; ///< of the vertex on the left side of the ribbon, negative on the right
    Vector3 normal;
  };

  struct Located_crossing
  {
    double position;
    Edge_crossing crossing;

    bool operator<(const Located_crossing& other) const
    {
      return std::tie(position, crossing.halfedge) < std::tie(other.position, other.crossing.halfedge);
    }
  };

  /// Vertices are given a side up to this distance from the curve, relative to their longest edge: the ends of a
  /// crossed edge are not farther away than it is long, or a little, since the edges do not run in the surface.
  static constexpr double band_width = 1.5;
  /// The feet of the ends of a crossed edge are not farther from each other than twice its length, by the triangle
  /// inequality; along the curve, a little more.
  static constexpr double longest_way = 3;
  /// So much of a curve may lead over holes, relative to its length: those are narrow compared with the limb.
  static constexpr double max_gap_share = 0.25;
  /// Crossings keep this distance from the ends of their edge, relative to its length.
  static constexpr double end_margin = 1e-6;

  std::size_t size() const { return m_points.size(); }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }

  void measure(const std::vector<Projected_point>& curve)
  {
    m_points = curve;
    m_begin.assign(1, 0.);
    m_left.clear();
    for (std::size_t i = 0; i < size(); ++i) {
      m_begin.push_back(m_begin.back() + (m_points[after(i)].point - m_points[i].point).norm());
      const Vector3 along = m_points[after(i)].point - m_points[before(i)].point;
      m_left.push_back(m_points[i].normal.cross(along).normalized());
    }
  }

  double length() const { return m_begin.back(); }
  double side_length(std::size_t side) const { return m_begin[side + 1] - m_begin[side]; }

  /// Finds the feet of the vertices around the curve, outwards from the sites of its points.
  void spread()
  {
    m_is_met.clear();
    m_band.clear();
    for (std::size_t i = 0; i < size(); ++i) {
      visit(m_points[i].site, i);
    }
    for (std::size_t i = 0; i < m_band.size(); ++i) {
      const std::size_t side = side_at(m_foot[m_band[i]].position);
      for (const Index h : m_complex.outgoing(m_band[i])) {
        visit(m_complex.target(h), side);
      }
    }
  }

  std::size_t side_at(double position) const
  {
    const auto end = std::upper_bound(m_begin.begin() + 1, m_begin.end() - 1, position);
    return std::size_t(end - m_begin.begin()) - 1;
  }

  /// Gives a foot to `vertex`, and adds it to the band, if that foot, which is sought around a side of the curve, is
  /// near enough.
  void visit(Index vertex, std::size_t side)
  {
    if (m_is_met.is_marked(vertex)) {
      return;
    }
    double longest = 0;
    for (const Index h : m_complex.outgoing(vertex)) {
      longest = std::max(longest, m_complex.length(h));
    }
    const double width = band_width * longest;
    const Foot foot = find_foot(vertex, side, 2 * width);
    if (foot.distance <= width) {
      m_is_met.mark(vertex);
      m_foot[vertex] = foot;
      // One that looks the other way is of a fold, or of another sheet: there one does not go on.
      if (m_complex.normal(vertex).dot(foot.normal) > 0) {
        m_band.push_back(vertex);
      }
    }
  }

  /// The foot of `vertex` among the sides not farther than `reach` along the curve from `first`.
  Foot find_foot(Index vertex, std::size_t first, double reach) const
  {
    Foot foot{0, std::numeric_limits<double>::max(), 0, Vector3::Zero()};
    try_side(vertex, first, foot);
    const double half = length() / 2;
    for (const bool is_forward : {true, false}) {
      std::size_t side = first;
      double passed = 0;
      while (passed < std::min(reach, half)) {
        side = is_forward ? after(side) : before(side);
        try_side(vertex, side, foot);
        passed += side_length(side);
      }
    }
    return foot;
  }

  void try_side(Index vertex, std::size_t side, Foot& foot) const
  {
    const Projected_point& a = m_points[side];
    const Projected_point& b = m_points[after(side)];
    const Vector3 way = b.point - a.point;
    const Vector3 offset = m_complex.point(vertex) - a.point;
    const double squared_length = way.squaredNorm();
    const double part = squared_length > 0 ? std::clamp(offset.dot(way) / squared_length, 0., 1.) : 0.;
    const Vector3 from_foot = offset - part * way;
    const double distance = from_foot.norm();
    if (distance < foot.distance) {
      const Vector3 left = (1 - part) * m_left[side] + part * m_left[after(side)];
      foot = {m_begin[side] + part * side_length(side), distance, from_foot.dot(left),
              (1 - part) * a.normal + part * b.normal};
    }
  }

  /// Collects the crossed edges of the vertices of the band.
  void collect()
  {
    m_located.clear();
    m_is_taken.clear();
    for (const Index vertex : m_band) {
      for (const Index h : m_complex.outgoing(vertex)) {
        if (m_is_met.is_marked(m_complex.target(h)) && m_is_taken.mark(m_complex.edge(h))) {
          collect(is_on_left(vertex) ? m_complex.twin(h) : h);
        }
      }
    }
    std::sort(m_located.begin(), m_located.end());
  }

  bool is_on_left(Index vertex) const { return m_foot[vertex].height >= 0; }

  /// Collects `halfedge`, with its origin on the right, if it is crossed.
  void collect(Index halfedge)
  {
    const Foot& from = m_foot[m_complex.origin(halfedge)];
    const Foot& to = m_foot[m_complex.target(halfedge)];
    const double difference = std::remainder(to.position - from.position, length()); // the shorter way
    if (from.height < 0 && to.height >= 0 && std::abs(difference) <= longest_way * m_complex.length(halfedge)) {
      const double part = from.height / (from.height - to.height);
      const double position = std::fmod(from.position + part * difference + length(), length());
      m_located.push_back({position, {halfedge, std::clamp(part, end_margin, 1 - end_margin)}});
    }
  }

  /// How far consecutive crossings are from each other, along the curve, where their edges are not joined.
  double length_of_gaps() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_located.size(); ++i) {
      const Located_crossing& here = m_located[i];
      const bool is_last = i + 1 == m_located.size();
      const Located_crossing& next = m_located[is_last ? 0 : i + 1];
      if (!are_joined(here.crossing.halfedge, next.crossing.halfedge)) {
        sum += next.position - here.position + (is_last ? length() : 0);
      }
    }
    return sum;
  }

  /// Whether the edges have an end in common or are joined by an edge.
  bool are_joined(Index g, Index h) const
  {
    for (const Index end : {m_complex.origin(g), m_complex.target(g)}) {
      for (const Index other : {m_complex.origin(h), m_complex.target(h)}) {
        if (end == other || m_complex.find_halfedge(end, other) != no_index) {
          return true;
        }
      }
    }
    return false;
  }

  const Point_complex& m_complex;
  std::vector<Projected_point> m_points;
  std::vector<double> m_begin; // of every side, along the curve, and its end
  std::vector<Vector3> m_left; // of every point, in the surface
  Epoch_marks m_is_met;
  std::vector<Foot> m_foot; // of the vertices that were met
  std::vector<Index> m_band;
  Epoch_marks m_is_taken; // of edges
  std::vector<Located_crossing> m_located;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_CURVE_TRACE_H
