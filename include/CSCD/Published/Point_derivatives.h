// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent frames and derivatives of functions on a point complex.

#ifndef CSCD_PUBLISHED_POINT_DERIVATIVES_H
#define CSCD_PUBLISHED_POINT_DERIVATIVES_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Compressed_rows.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
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
        if (projection.norm() > min_projection * along.norm()) {
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
    const double squared_norm = std::max(sum.squaredNorm(), min_projection);
    const Complex result = in_frame(to, axis - 2 * axis.dot(sum) / squared_norm * sum);
    const double norm = std::abs(result);
    return norm > 0 ? result / norm : Complex(1);
  }

  /// Relative to what is projected: shorter projections have no direction that can be trusted.
  static constexpr double min_projection = 1e-8;

  const Point_complex& m_complex;
  std::vector<Vector_3> m_axis;     // of every vertex
  std::vector<double> m_direction;  // of every halfedge
  std::vector<Complex> m_transport; // of every halfedge
};

/// What is needed to differentiate functions on a point complex, prepared once: gradients by least squares over the
/// immediate neighbors, and the Laplacian of the finite elements that the heat method uses.
class Point_derivatives
{
public:
  using Complex = Point_frames::Complex;

  /// Linear. \param frames is referred to and must outlive this object
  /// \param elements those of the intrinsic Delaunay triangulation of the tufted cover; not referred to later
  Point_derivatives(const Point_frames& frames, const Cotangent_elements& elements) : m_frames(frames)
  {
    CGAL_precondition(elements.number_of_vertices() == frames.triangulation().number_of_vertices());
    fit_gradients();
    collect_couplings(elements);
  }

  const Point_frames& frames() const { return m_frames; }

  /// The gradient of the linear function that fits `values` best at the neighbors of `vertex`, in its frame.
  Complex gradient(Index vertex, const std::vector<double>& values) const
  {
    const Point_complex& complex = m_frames.triangulation();
    Complex sum = 0;
    for (const Index h : complex.outgoing(vertex)) {
      sum += m_gradient[h] * (values[complex.target(h)] - values[vertex]);
    }
    return sum;
  }

  /// The Laplacian of `values` at `vertex`, times the spacing of the points there.
  double laplacian(Index vertex, const std::vector<double>& values) const
  {
    double sum = 0;
    for (const Coupling& coupling : m_couplings[vertex]) {
      sum += coupling.weight * (values[coupling.neighbor] - values[vertex]);
    }
    return sum;
  }

private:
  /// The dual area of a vertex of a regular triangulation with edges of length 1.
  static constexpr double area_of_unit_spacing = 0.8660254037844386;

  struct Coupling
  {
    Index neighbor;
    double weight;
  };

  void fit_gradients()
  {
    const Point_complex& complex = m_frames.triangulation();
    m_gradient.assign(complex.number_of_halfedges(), 0);
    for (Index vertex = 0; vertex < complex.number_of_vertices(); ++vertex) {
      fit_gradient(vertex);
    }
  }

  /// Solves the normal equations of the slopes along the edges: each counts the same, however long its edge is.
  void fit_gradient(Index vertex)
  {
    // Relative to its trace, the least determinant of a matrix of which the inverse is meaningful.
    constexpr double min_determinant = 1e-3;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Index h : m_frames.triangulation().outgoing(vertex)) {
      const Complex d = std::polar(1., m_frames.direction_at_origin(h));
      xx += d.real() * d.real();
      xy += d.real() * d.imag();
      yy += d.imag() * d.imag();
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > min_determinant * (xx + yy) * (xx + yy))) {
      return;
    }
    for (const Index h : m_frames.triangulation().outgoing(vertex)) {
      const Complex d = std::polar(1. / m_frames.length(h), m_frames.direction_at_origin(h));
      m_gradient[h] = Complex(yy * d.real() - xy * d.imag(), xx * d.imag() - xy * d.real()) / determinant;
    }
  }

  void collect_couplings(const Cotangent_elements& elements)
  {
    m_couplings = Compressed_rows<Coupling>(elements.number_of_vertices(), [&](const auto& add) {
      for (const Cotangent_elements::Face& face : elements.faces()) {
        const std::array<double, 3> couplings = face.layout.couplings();
        for (std::size_t k = 0; k < 3; ++k) {
          const Index i = face.vertices[(k + 1) % 3];
          const Index j = face.vertices[(k + 2) % 3];
          add(i, Coupling{j, -couplings[k] * scale(elements, i)});
          add(j, Coupling{i, -couplings[k] * scale(elements, j)});
        }
      }
    });
    m_couplings.reduce_rows(merge_couplings);
  }

  /// What turns sums of stiffnesses into Laplacians times the spacing: that around `vertex` or, if it is larger, the
  /// mean edge length, over which the heat method smooths its distances.
  double scale(const Cotangent_elements& elements, Index vertex) const
  {
    const double unit = elements.unit(elements.component(vertex));
    const double mass = elements.mass(vertex) * unit * unit;
    const double area = m_frames.triangulation().vertex_area(vertex);
    return mass > 0 ? std::max(m_frames.mean_edge_length(), std::sqrt(area / area_of_unit_spacing)) / mass : 0;
  }

  /// Adds up what a vertex has with the same neighbor through several faces.
  static Coupling* merge_couplings(Coupling* first, Coupling* last)
  {
    std::sort(first, last, [](const Coupling& a, const Coupling& b) { return a.neighbor < b.neighbor; });
    Coupling* end = first;
    for (const Coupling* coupling = first; coupling != last; ++coupling) {
      if (end != first && (end - 1)->neighbor == coupling->neighbor) {
        (end - 1)->weight += coupling->weight;
      } else {
        *end++ = *coupling;
      }
    }
    return end;
  }

  const Point_frames& m_frames;
  std::vector<Complex> m_gradient;       // of every halfedge: what the difference of values along it adds
  Compressed_rows<Coupling> m_couplings; // of every vertex
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_POINT_DERIVATIVES_H
