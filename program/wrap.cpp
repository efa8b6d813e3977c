// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One closed surface around a mesh of any kind.

#include "other_methods.h"
#include "types.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <array>
#include <cmath>
#include <utility>
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

/// The surface that CGAL's alpha wrapping puts around a mesh: closed, without parts that cut each other, and solid
/// where the inside is reached by narrow holes only. It does not keep the vertices.
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

} // namespace

void wrap_input(Input& input, double size)
{
  Input wrapped =
      make_input(CSCD::internal::make_manifold(wrap_mesh(input.points, input.faces, size), "the wrap").triangles);
  input.points = std::move(wrapped.points);
  input.faces = std::move(wrapped.faces);
  input.is_wrapped = true;
}

} // namespace cscd
