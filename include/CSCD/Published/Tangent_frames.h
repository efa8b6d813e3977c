// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent planes of vertices: on a triangulation, by lengths alone (G.1), and on a point complex (G.2), with its
// tufted cover.

#ifndef CSCD_PUBLISHED_TANGENT_FRAMES_H
#define CSCD_PUBLISHED_TANGENT_FRAMES_H

#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CSCD::internal {

/// The dual area of a vertex of a regular triangulation with edges of length 1.
inline constexpr double area_of_unit_spacing = 0.8660254037844386;

/// A polar frame at every vertex, where vectors are complex numbers: angles between the edges around a vertex are
/// scaled to add up to a full turn; on a border they stay as they are. The first outgoing halfedge points along the
/// real axis. The faces around each vertex form one fan.
class Tangent_frames
{
public:
  using Complex = std::complex<double>;

  /// The corner of a face at the origin of a halfedge.
  struct Corner
  {
    double length = 0; ///< of the halfedge
    double cosine = 1; ///< of the angle at its origin
    double sine = 0;   ///< 0 if the face has no area, and is to be ignored
    Complex turn = 1;  ///< turns a vector of the face, seen from the halfedge, into the frame of the origin
  };

  /// Computes all frames; linear.
  /// \param triangulation is referred to and must outlive this object
  explicit Tangent_frames(const Intrinsic_triangulation& triangulation)
      : m_triangulation(triangulation), m_corners(triangulation.number_of_halfedges()),
        m_direction(triangulation.number_of_halfedges(), 0), m_first(triangulation.number_of_vertices(), no_index),
        m_scale(triangulation.number_of_vertices(), 1), m_area(triangulation.number_of_vertices(), 0)
  {
    measure_corners();
    for (Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
      Index& first = m_first[triangulation.origin(h)];
      if (first == no_index || triangulation.is_border(h)) {
        first = h;
      }
    }
    for (Index vertex = 0; vertex < triangulation.number_of_vertices(); ++vertex) {
      lay_out(vertex);
    }
  }
  explicit Tangent_frames(Intrinsic_triangulation&&) = delete;

  const Intrinsic_triangulation& triangulation() const { return m_triangulation; }
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
      halfedge = m_triangulation.next_around_origin(halfedge);
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
      last = Triangle_halfedges::previous(halfedge);
    });
    if (last != no_index && m_triangulation.twin(last) == no_index) {
      function(m_triangulation.origin(last), last);
    }
  }

  /// The direction of `halfedge` in the frame of its origin, in radians.
  double direction_at_origin(Index halfedge) const { return m_direction[halfedge]; }
  /// The direction of the twin of `halfedge`, in the frame of its target.
  double direction_at_target(Index halfedge) const
  {
    const Index twin = m_triangulation.twin(halfedge);
    if (twin != no_index) {
      return m_direction[twin];
    }
    const Index next = Triangle_halfedges::next(halfedge);
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
  double angle(Index halfedge) const { return std::atan2(m_corners[halfedge].sine, m_corners[halfedge].cosine); }
  void measure_corners()
  {
    double sum = 0;
    for (Index h = 0; h < m_triangulation.number_of_halfedges(); ++h) {
      m_corners[h].length = m_triangulation.length(h);
      sum += m_corners[h].length;
      measure_corner(h);
    }
    m_mean_edge_length = m_corners.empty() ? 0 : sum / double(m_corners.size());
  }

  void measure_corner(Index h)
  {
    // Faces of less height than this, relative to their longest side, have no direction that can be trusted.
    constexpr double min_height = 1e-8;
    const double a = m_corners[h].length;
    const double b = m_triangulation.length(Triangle_halfedges::next(h));
    const double c = m_triangulation.length(Triangle_halfedges::previous(h));
    const double area = Flat_triangle{a, b, c}.area();
    const double longest = std::max({a, b, c});
    if (!(2 * area > min_height * longest * longest)) {
      return;
    }
    Corner& corner = m_corners[h];
    corner.cosine = std::clamp((a * a + c * c - b * b) / (2 * a * c), -1., 1.);
    corner.sine = 2 * area / (a * c);
    m_area[m_triangulation.origin(h)] += area / 3;
  }

  void lay_out(Index vertex)
  {
    double sum = 0;
    for_each_outgoing(vertex, [&](Index h) { sum += angle(h); });
    double& scale = m_scale[vertex];
    scale = sum > 0 && !m_triangulation.is_border(m_first[vertex]) ? boost::math::double_constants::two_pi / sum : 1;
    double direction = 0;
    for_each_outgoing(vertex, [&](Index h) {
      const double own = angle(h);
      m_direction[h] = direction;
      // A face is turned so that its bisector keeps its place in the scaled fan.
      m_corners[h].turn = std::polar(1., direction + (scale - 1) * own / 2);
      direction += scale * own;
    });
  }

  const Intrinsic_triangulation& m_triangulation;
  std::vector<Corner> m_corners;
  std::vector<double> m_direction;
  std::vector<Index> m_first;
  std::vector<double> m_scale;
  std::vector<double> m_area;
  double m_mean_edge_length = 0;
};

/// The tufted cover of a point complex (N. Sharp, K. Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020): each
/// triangle has a front, face 2f, and a back, face 2f + 1, turned the other way. At an edge, what looks into the space
/// between two neighboring triangles is glued together; at an edge with one triangle, its front and its back. So no
/// edge is a border, whatever the complex is, and edges can be flipped until all are Delaunay, which gives the points a
/// Laplacian with a maximum principle.
///
/// It is an input of `Intrinsic_triangulation`. Its vertices are
/// those of the complex: the fronts and the backs around a vertex are two fans, or more. So walks around a vertex see
/// one of them only, and masses and stiffnesses of its elements are twice those of the complex.
class Tufted_cover : public Triangle_halfedges
{
public:
  /// Glues the copies; O(n log n).
  /// \param complex is referred to and must outlive this object
  explicit Tufted_cover(const Point_complex& complex) : m_complex(complex)
  {
    m_sides.reserve(6 * std::size_t(complex.number_of_faces()));
    for (Index f = 0; f < complex.number_of_faces(); ++f) {
      const auto [a, b, c] = complex.face_halfedges(f);
      m_sides.insert(m_sides.end(), {a, b, c, complex.twin(c), complex.twin(b), complex.twin(a)});
    }
    glue();
  }
  explicit Tufted_cover(Point_complex&&) = delete;

  Index number_of_vertices() const { return m_complex.number_of_vertices(); }
  Index number_of_halfedges() const { return Index(m_sides.size()); }
  Index number_of_faces() const { return Index(m_sides.size() / 3); }

  Index origin(Index halfedge) const { return m_complex.origin(m_sides[halfedge]); }
  Index target(Index halfedge) const { return m_complex.target(m_sides[halfedge]); }
  Index twin(Index halfedge) const { return m_twins[halfedge]; }
  double length(Index halfedge) const { return m_complex.length(m_sides[halfedge]); }
  /// The same side of the other copy of the face.
  static Index other_copy(Index halfedge) { return 6 * (halfedge / 6) + 5 - halfedge % 6; }

private:
  /// A triangle at an edge.
  struct Wing
  {
    Index edge;
    double angle;   // around the edge, counterclockwise for who looks against its direction
    Index halfedge; // of the copy that runs with the edge: it looks to where the angle grows

    bool operator<(const Wing& other) const
    {
      return std::tie(edge, angle, halfedge) < std::tie(other.edge, other.angle, other.halfedge);
    }
  };

  void glue()
  {
    std::vector<Wing> wings;
    wings.reserve(m_sides.size() / 2);
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      if (m_complex.edge(m_sides[h]) == m_sides[h]) {
        wings.push_back({m_sides[h], angle(h), h});
      }
    }
    std::sort(wings.begin(), wings.end());
    m_twins.resize(m_sides.size());
    for (auto begin = wings.cbegin(); begin != wings.cend();) {
      const auto end = std::find_if(begin, wings.cend(), [&](const Wing& wing) { return wing.edge != begin->edge; });
      for (auto wing = begin; wing != end; ++wing) {
        const Index next = other_copy((wing + 1 == end ? begin : wing + 1)->halfedge);
        m_twins[wing->halfedge] = next;
        m_twins[next] = wing->halfedge;
      }
      begin = end;
    }
  }

  /// The angle of the face of `halfedge` around it, from a direction that is the same for all faces of the edge.
  double angle(Index halfedge) const
  {
    const Vector3& from = m_complex.point(origin(halfedge));
    const Vector3 axis = m_complex.point(target(halfedge)) - from;
    const Vector3 x = axis.unitOrthogonal();
    const Vector3 to_apex = m_complex.point(origin(previous(halfedge))) - from;
    return std::atan2(axis.normalized().cross(x).dot(to_apex), x.dot(to_apex));
  }

  const Point_complex& m_complex;
  std::vector<Index> m_sides; // of every halfedge, the one of the complex
  std::vector<Index> m_twins; // of every halfedge
};

/// A frame across the normal of every vertex, where tangent vectors are complex numbers. It has the members of
/// `Tangent_frames` that cut loci and loops need. Directions are those of the edges as seen along the normal, since the
/// triangles of a cloud need not go once around a vertex. The first halfedge points along the real axis.
///
/// Functions on the complex are differentiated in these frames: gradients by least squares over the immediate
/// neighbors, and the Laplacian of the finite elements that the heat method uses.
class Point_frames
{
public:
  using Complex = std::complex<double>;

  /// Computes all frames; linear.
  /// \param complex is referred to and must outlive this object
  /// \param elements those of the intrinsic Delaunay triangulation of the tufted cover; not referred to later
  Point_frames(const Point_complex& complex, const Cotangent_elements& elements)
      : m_complex(complex), m_axis(complex.number_of_vertices()), m_direction(complex.number_of_halfedges()),
        m_transport(complex.number_of_halfedges()), m_gradient(complex.number_of_halfedges(), 0)
  {
    CGAL_precondition(elements.number_of_vertices() == complex.number_of_vertices());
    for (Index vertex = 0; vertex < complex.number_of_vertices(); ++vertex) {
      lay_out(vertex);
      fit_gradient(vertex);
    }
    for (Index h = 0; h < complex.number_of_halfedges(); ++h) {
      m_transport[h] = carry_to_origin(h);
    }
    collect_couplings(elements);
  }
  Point_frames(Point_complex&&, const Cotangent_elements&) = delete;

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

  /// The gradient of the linear function that fits `values` best at the neighbors of `vertex`, in its frame.
  Complex gradient(Index vertex, const std::vector<double>& values) const
  {
    Complex sum = 0;
    for (const Index h : m_complex.outgoing(vertex)) {
      sum += m_gradient[h] * (values[m_complex.target(h)] - values[vertex]);
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
  struct Coupling
  {
    Index neighbor;
    double weight;
  };

  /// The projection of `vector` to the tangent plane of `vertex`.
  Complex in_frame(Index vertex, const Vector3& vector) const
  {
    return {vector.dot(m_axis[vertex]), m_complex.normal(vertex).cross(m_axis[vertex]).dot(vector)};
  }

  void lay_out(Index vertex)
  {
    const Vector3& normal = m_complex.normal(vertex);
    // Any axis, for vertices without edges and edges along the normal.
    m_axis[vertex] = normal.unitOrthogonal();
    bool is_first = true;
    for (const Index h : m_complex.outgoing(vertex)) {
      const Vector3 along = m_complex.point(m_complex.target(h)) - m_complex.point(vertex);
      if (is_first) {
        const Vector3 projection = along - along.dot(normal) * normal;
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
    const Vector3& axis = m_axis[from];
    const Vector3 sum = m_complex.normal(from) + m_complex.normal(to);
    // Of opposite normals, any rotation is the least.
    const double squared_norm = std::max(sum.squaredNorm(), min_projection);
    const Complex result = in_frame(to, axis - 2 * axis.dot(sum) / squared_norm * sum);
    const double norm = std::abs(result);
    return norm > 0 ? result / norm : Complex(1);
  }

  /// Solves the normal equations of the slopes along the edges: each counts the same, however long its edge is.
  void fit_gradient(Index vertex)
  {
    // The least determinant of a matrix with a meaningful inverse, relative to the square of its trace.
    constexpr double min_determinant = 1e-3;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Index h : m_complex.outgoing(vertex)) {
      const Complex d = std::polar(1., m_direction[h]);
      xx += d.real() * d.real();
      xy += d.real() * d.imag();
      yy += d.imag() * d.imag();
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > min_determinant * (xx + yy) * (xx + yy))) {
      return;
    }
    for (const Index h : m_complex.outgoing(vertex)) {
      const Complex d = std::polar(1. / m_complex.length(h), m_direction[h]);
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
    const double area = m_complex.vertex_area(vertex);
    return mass > 0 ? std::max(m_complex.mean_edge_length(), std::sqrt(area / area_of_unit_spacing)) / mass : 0;
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

  /// Relative to the projected vector: shorter projections have no direction that can be trusted.
  static constexpr double min_projection = 1e-8;

  const Point_complex& m_complex;
  std::vector<Vector3> m_axis;           // of every vertex
  std::vector<double> m_direction;       // of every halfedge
  std::vector<Complex> m_transport;      // of every halfedge
  std::vector<Complex> m_gradient;       // of every halfedge: what the difference of values along it adds
  Compressed_rows<Coupling> m_couplings; // of every vertex
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_TANGENT_FRAMES_H
