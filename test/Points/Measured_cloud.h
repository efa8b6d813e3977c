// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point complex with all that is needed to differentiate functions on it.

#ifndef CSCD_TEST_POINTS_MEASURED_CLOUD_H
#define CSCD_TEST_POINTS_MEASURED_CLOUD_H

#include "Points/to_point_cloud.h"
#include "Points/to_point_complex.h"
#include "support/Shape.h"
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Points/build_point_complex.h>
#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Vector_3.h>

#include <utility>
#include <vector>

namespace CSCD::test {

/// A complex, its derivatives and its distances.
class Measured_cloud
{
public:
  /// Has the triangles of `shape`.
  explicit Measured_cloud(const Shape& shape) : Measured_cloud(to_point_complex(shape)) {}
  /// Joins `points`, in normalized coordinates.
  explicit Measured_cloud(const std::vector<Triple>& points)
      : Measured_cloud(CSCD::internal::build_point_complex(to_point_cloud(points)))
  {
  }
  explicit Measured_cloud(CSCD::Point_complex&& complex)
      : m_complex(std::move(complex)), m_frames(m_complex), m_cover(m_complex),
        m_heat(CSCD::internal::make_intrinsic_delaunay(m_cover)), m_derivatives(m_frames, m_heat.elements())
  {
  }
  Measured_cloud(const Measured_cloud&) = delete;
  Measured_cloud& operator=(const Measured_cloud&) = delete;

  const CSCD::Point_complex& complex() const { return m_complex; }
  const CSCD::internal::Point_frames& frames() const { return m_frames; }
  const CSCD::internal::Point_derivatives& derivatives() const { return m_derivatives; }
  Index size() const { return m_complex.number_of_vertices(); }

  std::vector<double> distances(Index source) const
  {
    std::vector<double> result;
    CSCD::internal::Heat_method::Workspace workspace;
    m_heat({CSCD::internal::Geodesic_source::at_vertex(source)}, result, workspace);
    return result;
  }

  /// The values of `function` at the vertices.
  template <class Function>
  std::vector<double> values(const Function& function) const
  {
    std::vector<double> result;
    for (const Vector_3& p : m_complex.points()) {
      result.push_back(function(p));
    }
    return result;
  }

  /// The vertex with edges that is nearest to `p`.
  Index nearest(const Vector_3& p) const
  {
    Index result = 0;
    for (Index v = 0; v < size(); ++v) {
      if (!m_complex.outgoing(v).empty() && (m_complex.point(v) - p).norm() < (m_complex.point(result) - p).norm()) {
        result = v;
      }
    }
    return result;
  }

private:
  CSCD::Point_complex m_complex;
  CSCD::internal::Point_frames m_frames;
  CSCD::internal::Tufted_cover m_cover;
  CSCD::internal::Heat_method m_heat;
  CSCD::internal::Point_derivatives m_derivatives;
};

} // namespace CSCD::test

#endif // CSCD_TEST_POINTS_MEASURED_CLOUD_H
