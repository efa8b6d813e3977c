// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points on a triangulation, and how they move straight on over its faces.

#ifndef CSCD_PUBLISHED_SURFACE_WALK_H
#define CSCD_PUBLISHED_SURFACE_WALK_H

#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CSCD::internal {

/// Moves points along geodesics of a triangulation, step by step from face to face.
class Surface_walk
{
public:
  using Frames = Tangent_frames<Triangulated_surface>;

  /// \param frames is referred to and must outlive this object
  explicit Surface_walk(const Frames& frames) : m_frames(frames), m_surface(frames.triangulation()) {}

  Vector_3 position(const Face_point& at) const
  {
    Vector_3 sum = Vector_3::Zero();
    for (Index k = 0; k < 3; ++k) {
      sum += at.weights[k] * corner(3 * at.face + k);
    }
    return sum;
  }

  /// The vertex `vertex`, as a point of the face of its first halfedge.
  Face_point at_vertex(Index vertex) const
  {
    Face_point result;
    m_frames.for_each_outgoing(vertex, [&](Index h) {
      if (result.face == no_index) {
        result.face = Triangulated_surface::face(h);
        result.weights[h % 3] = 1;
      }
    });
    return result;
  }

  /// Moves `from` by `displacement`, projected to the face where it starts and turned at each edge with the surface.
  /// It ends early at a border, and at a face without area.
  Face_point operator()(Face_point from, Vector_3 displacement) const
  {
    // A displacement is about an edge long and crosses a few faces; more is a fan of needles.
    constexpr int max_faces = 100;
    if (const Index vertex = vertex_of(from); vertex != no_index) {
      from = leave_vertex(vertex, displacement);
    }
    for (int i = 0; i < max_faces; ++i) {
      const Index exit = advance(from, displacement);
      if (exit == no_index || !cross(exit, from, displacement)) {
        break;
      }
    }
    return from;
  }

private:
  const Vector_3& corner(Index halfedge) const { return m_surface.point(m_surface.origin(halfedge)); }
  Vector_3 edge(Index halfedge) const { return m_surface.point(m_surface.target(halfedge)) - corner(halfedge); }
  /// Twice the area times the normal.
  Vector_3 face_vector(Index face) const { return edge(3 * face).cross(-edge(3 * face + 2)); }

  Index vertex_of(const Face_point& at) const
  {
    for (Index k = 0; k < 3; ++k) {
      if (at.weights[k] == 1) {
        return m_surface.origin(3 * at.face + k);
      }
    }
    return no_index;
  }

  /// The derivatives of the weights of `face` along `direction`, which is projected to the face.
  std::array<double, 3> weight_rates(Index face, const Vector_3& direction) const
  {
    const Vector_3 normal = face_vector(face);
    std::array<double, 3> rates{};
    for (Index k = 0; k < 3; ++k) {
      rates[k] = normal.cross(edge(Triangulated_surface::next(3 * face + k))).dot(direction) / normal.squaredNorm();
    }
    return rates;
  }

  /// The point `vertex` in the face around it in which `direction` runs into the surface, or nearly so.
  Face_point leave_vertex(Index vertex, const Vector_3& direction) const
  {
    Face_point best = at_vertex(vertex);
    double best_outflow = std::numeric_limits<double>::max();
    m_frames.for_each_outgoing(vertex, [&](Index h) {
      if (m_frames.corner(h).sine == 0) {
        return;
      }
      const Index face = Triangulated_surface::face(h);
      const std::array<double, 3> rates = weight_rates(face, direction);
      // Into the face, the weights of both other corners grow.
      const double outflow = -std::min(rates[(h + 1) % 3], rates[(h + 2) % 3]);
      if (outflow < best_outflow) {
        best_outflow = outflow;
        best = {face, {}};
        best.weights[h % 3] = 1;
      }
    });
    return best;
  }

  /// Moves `at` within its face until `displacement` is used up, or to the edge where it leaves the face.
  /// \return the halfedge where it leaves; then `displacement` is what is left of it, within the plane of the face
  Index advance(Face_point& at, Vector_3& displacement) const
  {
    const Vector_3 normal = face_vector(at.face).normalized();
    displacement -= displacement.dot(normal) * normal;
    const std::array<double, 3> rates = weight_rates(at.face, displacement);
    if (!(std::abs(rates[0]) + std::abs(rates[1]) + std::abs(rates[2]) < std::numeric_limits<double>::max())) {
      return no_index;
    }
    double time = 1;
    Index exit = no_index;
    for (Index k = 0; k < 3; ++k) {
      if (rates[k] < 0 && at.weights[k] < -rates[k] * time) {
        time = at.weights[k] / -rates[k];
        exit = Triangulated_surface::next(3 * at.face + k);
      }
    }
    double sum = 0;
    for (Index k = 0; k < 3; ++k) {
      const bool is_zero = exit != no_index && Triangulated_surface::previous(exit) == 3 * at.face + k;
      at.weights[k] = is_zero ? 0 : std::max(0., at.weights[k] + time * rates[k]);
      sum += at.weights[k];
    }
    for (double& weight : at.weights) {
      weight /= sum;
    }
    displacement *= 1 - time;
    return exit;
  }

  /// Puts `at`, a point of the edge of `exit`, into the face beyond it, and turns `displacement` with the surface.
  /// \return false on a border
  bool cross(Index exit, Face_point& at, Vector_3& displacement) const
  {
    const Index twin = m_surface.twin(exit);
    if (twin == no_index) {
      return false;
    }
    const Vector_3 along = edge(exit).normalized();
    const double outwards = displacement.dot(along.cross(face_vector(at.face).normalized()));
    const Index face = Triangulated_surface::face(twin);
    const Vector_3 inwards = along.cross(face_vector(face).normalized());
    displacement = displacement.dot(along) * along + outwards * inwards;
    const double weight = at.weights[exit % 3];
    at = {face, {}};
    at.weights[Triangulated_surface::next(twin) % 3] = weight;
    at.weights[twin % 3] = 1 - weight;
    return true;
  }

  const Frames& m_frames;
  const Triangulated_surface& m_surface;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_SURFACE_WALK_H
