// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tangent plane of every vertex of a triangulation, known from the lengths of its edges alone.

#ifndef CSCD_PUBLISHED_TANGENT_FRAMES_H
#define CSCD_PUBLISHED_TANGENT_FRAMES_H

#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// A polar frame at every vertex, in which vectors are complex numbers: angles between the edges around a vertex are
/// scaled so that they add up to a full turn; on a border they stay as they are. The first outgoing halfedge points
/// along the real axis.
///
/// \tparam Triangulation halfedge `h` runs along side `h % 3` of face `h / 3`, counterclockwise. It has the members
///         `number_of_vertices()`, `number_of_halfedges()`, `number_of_faces()`, static `next(h)`, `previous(h)` and
///         `face(h)`, and `origin(h)`, `target(h)`, `twin(h)`, which is `no_index` on a border, and `length(h)`: so it
///         may be intrinsic, with several edges between two vertices, and edges from a vertex to itself. The faces
///         around each vertex form one fan. Faces for which there is a member `is_hole_filling(f)` that says so are no
///         part of the surface.
template <class Triangulation>
class Tangent_frames
{
public:
  using Complex = std::complex<double>;

  /// The corner of a face at the origin of a halfedge.
  struct Corner
  {
    double length = 0; ///< of the halfedge
    double cosine = 1; ///< of the angle at its origin
    double sine = 0;   ///< 0 if the face has no area or fills a hole, and is to be ignored
    Complex turn = 1;  ///< turns a vector of the face, seen from the halfedge, into the frame of the origin
  };

  /// Computes all frames; linear.
  /// \param triangulation is referred to and must outlive this object
  explicit Tangent_frames(const Triangulation& triangulation)
      : m_triangulation(triangulation), m_corners(triangulation.number_of_halfedges()),
        m_direction(triangulation.number_of_halfedges(), 0), m_first(triangulation.number_of_vertices(), no_index),
        m_scale(triangulation.number_of_vertices(), 1), m_area(triangulation.number_of_vertices(), 0)
  {
    measure_corners();
    for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
      Index& first = m_first[triangulation.origin(h)];
      if (first == no_index) {
        first = first_of_fan(h);
      }
    }
    for (Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
      lay_out(vertex);
    }
  }
  explicit Tangent_frames(Triangulation&&) = delete;

  const Triangulation& triangulation() const { return m_triangulation; }
  const Corner& corner(Index halfedge) const { return m_corners[halfedge]; }
  double length(Index halfedge) const { return m_corners[halfedge].length; }
  /// A third of the area of the faces around `vertex`.
  double area(Index vertex) const { return m_area[vertex]; }
  /// The mean over all halfedges of the surface.
  double mean_edge_length() const { return m_mean_edge_length; }

  /// Calls `function(h)` for the outgoing halfedges of `vertex`, counterclockwise.
  template <class Function>
  void for_each_outgoing(Index vertex, const Function& function) const
  {
    const Index first = m_first[vertex];
    Index halfedge = first;
    while (halfedge != no_index) {
      function(halfedge);
      halfedge = next_around_origin(halfedge);
      if (halfedge == first) {
        break;
      }
    }
  }

  /// Calls `function(neighbor, h)` for all edges of `vertex`, counterclockwise: `h` runs from `vertex` to `neighbor`
  /// or, on a border, possibly only the other way.
  template <class Function>
  void for_each_neighbor(Index vertex, const Function& function) const
  {
    Index last = no_index;
    for_each_outgoing(vertex, [&](Index halfedge) {
      function(m_triangulation.target(halfedge), halfedge);
      last = m_triangulation.previous(halfedge);
    });
    if (last != no_index && m_triangulation.twin(last) == no_index) {
      function(m_triangulation.origin(last), last);
    }
  }

  /// The direction of `halfedge` in the frame of its origin, in radians.
  double direction_at_origin(Index halfedge) const { return m_direction[halfedge]; }
  /// The direction in which `halfedge` comes in: that of its twin, in the frame of its target.
  double direction_at_target(Index halfedge) const
  {
    const Index twin = m_triangulation.twin(halfedge);
    if (twin != no_index) {
      return m_direction[twin];
    }
    const Index next = m_triangulation.next(halfedge);
    return m_direction[next] + m_scale[m_triangulation.origin(next)] * angle(next);
  }

  /// The factor that carries vectors from the frame of the target of `halfedge` to that of its origin, parallel along
  /// the edge (supplement, appendix G.1): the edge runs straight on in both.
  Complex transport_to_origin(Index halfedge) const
  {
    const double turn =
        direction_at_origin(halfedge) + boost::math::double_constants::pi - direction_at_target(halfedge);
    return std::polar(1., turn);
  }

private:
  Index next_around_origin(Index halfedge) const { return m_triangulation.twin(m_triangulation.previous(halfedge)); }
  double angle(Index halfedge) const { return std::atan2(m_corners[halfedge].sine, m_corners[halfedge].cosine); }
  bool is_hole_filling(Index halfedge) const
  {
    return is_hole_filling_face(m_triangulation, m_triangulation.face(halfedge));
  }

  void measure_corners()
  {
    double sum = 0;
    std::size_t number = 0;
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      m_corners[h].length = m_triangulation.length(h);
      if (!is_hole_filling(h)) {
        sum += m_corners[h].length;
        ++number;
      }
    }
    m_mean_edge_length = number > 0 ? sum / double(number) : 0;
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      if (!is_hole_filling(h)) {
        measure_corner(h);
      }
    }
  }

  void measure_corner(Index h)
  {
    // Faces of less height than this, relative to their longest side, have no direction that can be trusted.
    constexpr double min_height = 1e-8;
    const double a = m_corners[h].length;
    const double b = m_corners[m_triangulation.next(h)].length;
    const double c = m_corners[m_triangulation.previous(h)].length;
    // Heron's formula in the stable form of Kahan: the sides by decreasing length.
    double side[] = {a, b, c};
    std::sort(side, side + 3);
    const double product = (side[2] + (side[1] + side[0])) * (side[0] - (side[2] - side[1])) *
                           (side[0] + (side[2] - side[1])) * (side[2] + (side[1] - side[0]));
    const double area = std::sqrt(std::max(0., product)) / 4;
    if (!(2 * area > min_height * side[2] * side[2])) {
      return;
    }
    Corner& corner = m_corners[h];
    corner.cosine = std::clamp((a * a + c * c - b * b) / (2 * a * c), -1., 1.);
    corner.sine = 2 * area / (a * c);
    m_area[m_triangulation.origin(h)] += area / 3;
  }

  /// The halfedge at which the fan around the origin of `halfedge` begins: the first after a border or, where that is
  /// bridged, after the hole-filling faces; else `halfedge` itself.
  Index first_of_fan(Index halfedge) const
  {
    Index at = halfedge;
    do {
      const Index twin = m_triangulation.twin(at);
      if (twin == no_index) {
        return at;
      }
      const Index before = m_triangulation.next(twin);
      if (is_hole_filling(before) && !is_hole_filling(at)) {
        return at;
      }
      at = before;
    } while (at != halfedge);
    return halfedge;
  }

  void lay_out(Index vertex)
  {
    double sum = 0;
    bool is_closed = true;
    for_each_outgoing(vertex, [&](Index h) {
      sum += angle(h);
      is_closed = is_closed && !is_hole_filling(h) && m_triangulation.twin(h) != no_index;
    });
    double& scale = m_scale[vertex];
    scale = is_closed && sum > 0 ? boost::math::double_constants::two_pi / sum : 1;
    double direction = 0;
    for_each_outgoing(vertex, [&](Index h) {
      const double own = angle(h);
      m_direction[h] = direction;
      // A face is turned so that its bisector keeps its place in the scaled fan.
      m_corners[h].turn = std::polar(1., direction + (scale - 1) * own / 2);
      direction += scale * own;
    });
  }

  const Triangulation& m_triangulation;
  std::vector<Corner> m_corners;
  std::vector<double> m_direction;
  std::vector<Index> m_first;
  std::vector<double> m_scale;
  std::vector<double> m_area;
  double m_mean_edge_length = 0;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_TANGENT_FRAMES_H
