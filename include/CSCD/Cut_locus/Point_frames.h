// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tangent plane of every vertex of a point complex.

#ifndef CSCD_CUT_LOCUS_POINT_FRAMES_H
#define CSCD_CUT_LOCUS_POINT_FRAMES_H

#include <CSCD/Point_cloud/Point_complex.h>
#include <CSCD/internal/Vector_3.h>

#include <cmath>
#include <complex>
#include <vector>

namespace CSCD::internal {

/// A frame across the normal of every vertex, in which tangent vectors are complex numbers. It has the members of
/// `Tangent_frames` that cut loci and loops ask for; directions are those of the edges as seen along the normal, since
/// the triangles of a cloud need not go once around a vertex. The first halfedge points along the real axis.
class Point_frames
{
public:
  using Complex = std::complex<double>;

  /// Computes all frames; linear.
  /// \param complex is referred to and must outlive this object
  explicit Point_frames(const Point_complex& complex)
      : m_complex(complex), m_axis(complex.number_of_vertices()), m_direction(complex.number_of_halfedges()),
        m_transport(complex.number_of_halfedges())
  {
    for (Index vertex = 0; vertex < complex.number_of_vertices(); ++vertex) {
      lay_out(vertex);
    }
    for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
      m_transport[h] = carry_to_origin(h);
    }
  }
  explicit Point_frames(Point_complex&&) = delete;

  /// The complex, by the name that generic code uses.
  const Point_complex& triangulation() const { return m_complex; }
  double length(Index halfedge) const { return m_complex.length(halfedge); }
  double mean_edge_length() const { return m_complex.mean_edge_length(); }

  /// Calls `function(neighbor, h)` for all halfedges `h` from `vertex`, counterclockwise.
  template <class Function>
  void for_each_neighbor(Index vertex, const Function& function) const
  {
    for (const Index h : m_complex.outgoing(vertex)) {
      function(m_complex.target(h), h);
    }
  }

  /// The direction of `halfedge` in the frame of its origin, in radians.
  double direction_at_origin(Index halfedge) const { return m_direction[halfedge]; }
  /// That of its twin in the frame of its target.
  double direction_at_target(Index halfedge) const { return m_direction[m_complex.twin(halfedge)]; }

  /// The factor that carries vectors from the frame of the target of `halfedge` to that of its origin: by the least
  /// rotation that takes one normal to the other.
  const Complex& transport_to_origin(Index halfedge) const { return m_transport[halfedge]; }

  /// The tangent vector `vector` of `vertex`, in space.
  Vector_3 in_space(Index vertex, const Complex& vector) const
  {
    return vector.real() * m_axis[vertex] + vector.imag() * m_complex.normal(vertex).cross(m_axis[vertex]);
  }
  /// The projection of `vector` to the tangent plane of `vertex`.
  Complex in_frame(Index vertex, const Vector_3& vector) const
  {
    return {vector.dot(m_axis[vertex]), m_complex.normal(vertex).cross(m_axis[vertex]).dot(vector)};
  }

private:
  void lay_out(Index vertex)
  {
    const Vector_3& normal = m_complex.normal(vertex);
    // Any axis, for vertices without edges and edges along the normal.
    m_axis[vertex] = normal.unitOrthogonal();
    bool is_first = true;
    for (const Index h : m_complex.outgoing(vertex)) {
      const Vector_3 along = m_complex.point(m_complex.target(h)) - m_complex.point(vertex);
      if (is_first) {
        const Vector_3 projection = along - along.dot(normal) * normal;
        if (projection.norm() > least_projection * along.norm()) {
          m_axis[vertex] = projection.normalized();
        }
        is_first = false;
      }
      m_direction[h] = std::arg(in_frame(vertex, along));
    }
  }

  Complex carry_to_origin(Index halfedge) const
  {
    const Index from = m_complex.target(halfedge);
    const Index to = m_complex.origin(halfedge);
    const Vector_3& axis = m_axis[from];
    const Vector_3 sum = m_complex.normal(from) + m_complex.normal(to);
    // Of opposite normals, any rotation is the least.
    const double squared_norm = std::max(sum.squaredNorm(), least_projection);
    const Complex result = in_frame(to, axis - 2 * axis.dot(sum) / squared_norm * sum);
    const double norm = std::abs(result);
    return norm > 0 ? result / norm : Complex(1);
  }

  /// Relative to what is projected: shorter projections have no direction that can be trusted.
  static constexpr double least_projection = 1e-8;

  const Point_complex& m_complex;
  std::vector<Vector_3> m_axis;     // of every vertex
  std::vector<double> m_direction;  // of every halfedge
  std::vector<Complex> m_transport; // of every halfedge
};

} // namespace CSCD::internal

#endif // CSCD_CUT_LOCUS_POINT_FRAMES_H
