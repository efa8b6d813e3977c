// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One closed surface around a mesh of any kind.

#include "wrap.h"

#include <CSCD/exceptions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cscd {

namespace {

using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Wrap = CGAL::Surface_mesh<Exact_kernel::Point_3>;

double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

CSCD::Shape_file to_soup(const Wrap& wrap)
{
  CSCD::Shape_file soup;
  for (const auto vertex : wrap.vertices()) {
    const Exact_kernel::Point_3& p = wrap.point(vertex);
    soup.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : wrap.faces()) {
    for (const auto vertex : wrap.vertices_around_face(wrap.halfedge(face))) {
      soup.corners.push_back(CSCD::Index(vertex));
    }
    soup.end_polygon();
  }
  return soup;
}

} // namespace

CSCD::Shape_file wrap_mesh(const std::vector<CSCD::Vector3>& points,
                           const std::vector<std::array<CSCD::Index, 3>>& faces, double size)
{
  // The distance of the wrap from the mesh, relative to the size of closed gaps, as in CGAL's examples.
  constexpr double offset = 1. / 30;
  std::vector<Exact_kernel::Point_3> exact_points;
  CGAL::Bbox_3 box;
  for (const CSCD::Vector3& p : points) {
    exact_points.emplace_back(p.x(), p.y(), p.z());
    box += exact_points.back().bbox();
  }
  const double alpha = size * diagonal(box);
  Wrap wrap;
  if (alpha > 0) {
    CGAL::alpha_wrap_3(exact_points, faces, alpha, offset * alpha, wrap);
  }
  if (wrap.is_empty()) {
    throw CSCD::Input_error("cannot be wrapped; leave --wrap out");
  }
  return to_soup(wrap);
}

} // namespace cscd
