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

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>
#include <boost/container/small_vector.hpp>
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

/// A face around a vertex, or a neighbor: where it lies, and its gradient, both in the frame of the vertex.
struct Gradient_sample
{
  std::complex<double> direction; ///< from the vertex to there, of length 1
  std::complex<double> gradient;  ///< of length 1
};

/// The samples around one vertex, counterclockwise.
using Gradient_samples = boost::container::small_vector<Gradient_sample, 16>;

/// Collects the neighbors of `vertex`, counterclockwise, unless their gradients are those of a ridge or a source, which
/// are short and have no direction.
/// \param gradient_of returns the gradient of a vertex, in its frame
template <class Frames, class GradientOf>
void collect_neighbors(const Frames& frames, Index vertex, const GradientOf& gradient_of, Gradient_samples& samples)
{
  constexpr double min_gradient = 0.1; // away from ridges and sources it is 1
  samples.clear();
  frames.for_each_neighbor(vertex, [&](Index neighbor, Index h) {
    const std::complex<double> gradient = gradient_of(neighbor);
    const double norm = std::abs(gradient);
    if (norm > min_gradient && std::isfinite(norm)) {
      const bool is_outgoing = frames.triangulation().origin(h) == vertex;
      const double direction = is_outgoing ? frames.direction_at_origin(h) : frames.direction_at_target(h);
      const std::complex<double> transport = frames.transport_to_origin(h);
      samples.push_back(
          {std::polar(1., direction), (is_outgoing ? transport : std::conj(transport)) * gradient / norm});
    }
  });
}

/// A polar frame at every vertex, where vectors are complex numbers: angles between the edges around a vertex are
/// scaled to add up to a full turn; on a border they stay as they are. The first outgoing halfedge points along the
/// real axis. The faces around each vertex form one fan.
///
/// Functions on the triangulation are differentiated in these frames, from lengths alone (supplement, appendix G.1).
class Tangent_frames
{
public:
  using Complex = std::complex<double>;

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
  double length(Index halfedge) const { return m_corners[halfedge].length; }
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

  /// The mean of the unit gradients in the faces around `vertex`, weighted by angle, in its frame: it is shorter than 1
  /// where they disagree.
  Complex mean_gradient(Index vertex, const std::vector<double>& values) const
  {
    Complex sum = 0;
    double weight = 0;
    for_each_outgoing(vertex, [&](Index h) {
      sum += angle(h) * unit_gradient(h, values);
      weight += angle(h);
    });
    return weight > 0 ? sum / weight : Complex(0);
  }

  /// The Laplacian of `values` at `vertex`, times the spacing of the vertices there.
  double laplacian(Index vertex, const std::vector<double>& values) const
  {
    const double area = m_area[vertex];
    if (!(area > 0)) {
      return 0;
    }
    double sum = 0;
    for_each_outgoing(vertex, [&](Index h) {
      const Index next = Triangle_halfedges::next(h);
      const Index last = Triangle_halfedges::previous(h);
      sum += cotangent(last) * (values[m_triangulation.origin(next)] - values[vertex]) / 2 +
             cotangent(next) * (values[m_triangulation.origin(last)] - values[vertex]) / 2;
    });
    return sum / area * std::max(m_mean_edge_length, std::sqrt(area / area_of_unit_spacing));
  }

  /// Collects the faces around `vertex`.
  void collect_samples(Index vertex, const std::vector<double>& values, Gradient_samples& samples) const
  {
    samples.clear();
    for_each_outgoing(vertex, [&](Index h) {
      const Complex gradient = unit_gradient(h, values);
      if (gradient != Complex(0)) {
        const Corner& corner = m_corners[h];
        // The bisector of the corner, by the half-angle formulas.
        const Complex bisector(std::sqrt((1 + corner.cosine) / 2), std::sqrt((1 - corner.cosine) / 2));
        samples.push_back({corner.turn * bisector, gradient});
      }
    });
  }

private:
  /// The corner of a face at the origin of a halfedge.
  struct Corner
  {
    double length = 0; ///< of the halfedge
    double cosine = 1; ///< of the angle at its origin
    double sine = 0;   ///< 0 if the face has no area, and is to be ignored
    Complex turn = 1;  ///< turns a vector of the face, seen from the halfedge, into the frame of the origin
  };

  double angle(Index halfedge) const { return std::atan2(m_corners[halfedge].sine, m_corners[halfedge].cosine); }
  /// Of the angle at the origin of `halfedge`; 0 where the face has no area.
  double cotangent(Index halfedge) const
  {
    return m_corners[halfedge].sine > 0 ? m_corners[halfedge].cosine / m_corners[halfedge].sine : 0;
  }

  /// The unit gradient in the face of `halfedge`, in the frame of the origin of `halfedge`; 0 where there is none.
  Complex unit_gradient(Index halfedge, const std::vector<double>& values) const
  {
    const Corner& corner = m_corners[halfedge];
    if (corner.sine == 0) {
      return 0;
    }
    const double here = values[m_triangulation.origin(halfedge)];
    const Index last = Triangle_halfedges::previous(halfedge);
    const double along = (values[m_triangulation.target(halfedge)] - here) / corner.length;
    const double along_last = (values[m_triangulation.origin(last)] - here) / m_corners[last].length;
    const Complex gradient(along, (along_last - along * corner.cosine) / corner.sine);
    const double norm = std::abs(gradient);
    return norm > 0 && std::isfinite(norm) ? corner.turn * gradient / norm : Complex(0);
  }

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
  void glue()
  {
    // Of each triangle at an edge: the edge, the angle around it, counterclockwise for who looks against its direction,
    // and the halfedge of the copy that runs with the edge, which looks to where the angle grows.
    std::vector<std::tuple<Index, double, Index>> wings;
    wings.reserve(m_sides.size() / 2);
    for (Index h = 0; h < number_of_halfedges(); ++h) {
      if (m_complex.edge(m_sides[h]) == m_sides[h]) {
        wings.emplace_back(m_sides[h], angle(h), h);
      }
    }
    std::sort(wings.begin(), wings.end());
    m_twins.resize(m_sides.size());
    for (auto begin = wings.cbegin(); begin != wings.cend();) {
      const auto is_of_other_edge = [edge = std::get<0>(*begin)](const auto& wing) {
        return std::get<0>(wing) != edge;
      };
      const auto end = std::find_if(begin, wings.cend(), is_of_other_edge);
      for (auto wing = begin; wing != end; ++wing) {
        const Index h = std::get<2>(*wing);
        const Index next = other_copy(std::get<2>(wing + 1 == end ? *begin : *(wing + 1)));
        m_twins[h] = next;
        m_twins[next] = h;
      }
      begin = end;
    }
  }

  /// The angle of the face of `halfedge` around it, from a direction that is the same for all faces of the edge.
  double angle(Index halfedge) const
  {
    const Vector3& from = m_complex.point(origin(halfedge));
    const Vector3 axis = m_complex.point(target(halfedge)) - from;
    return angle_around(axis.normalized(), axis.unitOrthogonal(), m_complex.point(origin(previous(halfedge))) - from);
  }

  const Point_complex& m_complex;
  std::vector<Index> m_sides; // of every halfedge, the one of the complex
  std::vector<Index> m_twins; // of every halfedge
};

/// A frame across the normal of every vertex, where tangent vectors are complex numbers. It has the members of
/// `Tangent_frames` that cut loci and loops need. Directions are those of the edges as seen along the normal, since the
/// triangles of a cloud need not go once around a vertex. The first halfedge points along the real axis.
///
/// Functions on the complex are differentiated in these frames (supplement, appendix G.2): gradients by least squares
/// over the immediate neighbors, and the Laplacian of the finite elements that the heat method uses.
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
    set_laplacian(elements);
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

  /// The mean gradient of `vertex` and its neighbors, in its frame: it is shorter than 1 where they disagree. A single
  /// one follows the noise of a few points. O(d^2) for degree d.
  Complex mean_gradient(Index vertex, const std::vector<double>& values) const
  {
    Complex sum = gradient(vertex, values);
    double number = 1;
    for_each_neighbor(vertex, [&](Index neighbor, Index h) {
      sum += transport_to_origin(h) * gradient(neighbor, values);
      number += 1;
    });
    return sum / number;
  }

  /// The Laplacian of `values` at `vertex`, times the spacing of the points there.
  double laplacian(Index vertex, const std::vector<double>& values) const
  {
    double sum = 0;
    for (Laplacian::InnerIterator entry(m_laplacian, Eigen::Index(vertex)); entry; ++entry) {
      sum += entry.value() * (values[std::size_t(entry.col())] - values[vertex]);
    }
    return sum;
  }

  /// Collects the neighbors of `vertex`.
  void collect_samples(Index vertex, const std::vector<double>& values, Gradient_samples& samples) const
  {
    collect_neighbors(
        *this, vertex, [&](Index neighbor) { return mean_gradient(neighbor, values); }, samples);
  }

private:
  using Laplacian = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// The gradient of the linear function that fits `values` best at the neighbors of `vertex`, in its frame.
  Complex gradient(Index vertex, const std::vector<double>& values) const
  {
    Complex sum = 0;
    for (const Index h : m_complex.outgoing(vertex)) {
      sum += m_gradient[h] * (values[m_complex.target(h)] - values[vertex]);
    }
    return sum;
  }

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

  void set_laplacian(const Cotangent_elements& elements)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Cotangent_elements::Face& face : elements.faces) {
      const std::array<double, 3> couplings = face.layout.couplings();
      for (std::size_t k = 0; k < 3; ++k) {
        const Index i = face.vertices[(k + 1) % 3];
        const Index j = face.vertices[(k + 2) % 3];
        entries.emplace_back(int(i), int(j), -couplings[k] * scale(elements, i));
        entries.emplace_back(int(j), int(i), -couplings[k] * scale(elements, j));
      }
    }
    m_laplacian.resize(elements.number_of_vertices(), elements.number_of_vertices());
    m_laplacian.setFromTriplets(entries.begin(), entries.end());
  }

  /// What turns sums of stiffnesses into Laplacians times the spacing: that around `vertex` or, if it is larger, the
  /// mean edge length, over which the heat method smooths its distances.
  double scale(const Cotangent_elements& elements, Index vertex) const
  {
    const double unit = elements.units[elements.component[vertex]];
    const double mass = elements.masses[vertex] * unit * unit;
    const double area = m_complex.vertex_area(vertex);
    return mass > 0 ? std::max(m_complex.mean_edge_length(), std::sqrt(area / area_of_unit_spacing)) / mass : 0;
  }

  /// Relative to the projected vector: shorter projections have no direction that can be trusted.
  static constexpr double min_projection = 1e-8;

  const Point_complex& m_complex;
  std::vector<Vector3> m_axis;      // of every vertex
  std::vector<double> m_direction;  // of every halfedge
  std::vector<Complex> m_transport; // of every halfedge
  std::vector<Complex> m_gradient;  // of every halfedge: what the difference of values along it adds
  Laplacian m_laplacian;            // times the spacing, without the diagonal
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_TANGENT_FRAMES_H
