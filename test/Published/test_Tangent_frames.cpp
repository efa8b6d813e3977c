// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent frames: transport is that of the plane where the surface is flat, and turns by the curvature elsewhere.

#include "Published/to_surface_with_borders.h"
#include "Surface/to_surface.h"
#include "support/shapes.h"
#include <CSCD/Published/Tangent_frames.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Surface/close_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Triangulated_surface;
using CSCD::internal::Tangent_frames;
using Complex = std::complex<double>;

/// The direction of a halfedge of a flat surface in the plane z = 0.
Complex direction_in_plane(const Triangulated_surface& surface, Index halfedge)
{
  const CSCD::Vector_3 d = surface.point(surface.target(halfedge)) - surface.point(surface.origin(halfedge));
  return Complex(d.x(), d.y()) / std::abs(Complex(d.x(), d.y()));
}

TEST(Tangent_frames, carry_vectors_as_the_plane_does)
{
  const CSCD::test::Shape shape = CSCD::test::noisy(CSCD::test::flat_grid(6, 5, 1), 0.2, 3);
  const Triangulated_surface surface =
      CSCD::test::to_surface_with_borders(CSCD::test::moved(shape, [](const CSCD::test::Triple& p) {
        return CSCD::test::Triple{p[0], p[1], 0};
      }));
  const Tangent_frames<Triangulated_surface> frames(surface);
  // The angle of the real axis of each vertex's frame in the plane.
  std::vector<Complex> axis(surface.number_of_vertices());
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    frames.for_each_outgoing(v, [&](Index h) {
      const Complex own = direction_in_plane(surface, h) * std::polar(1., -frames.direction_at_origin(h));
      if (axis[v] == Complex(0)) {
        axis[v] = own;
      }
      EXPECT_LT(std::abs(own - axis[v]), 1e-12);
    });
  }
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    const Complex expected = axis[surface.target(h)] / axis[surface.origin(h)];
    EXPECT_LT(std::abs(frames.transport_to_origin(h) - expected), 1e-12);
  }
}

TEST(Tangent_frames, carry_back_what_they_carried)
{
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(2));
  const Tangent_frames<Triangulated_surface> frames(surface);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    EXPECT_LT(std::abs(frames.transport_to_origin(h) * frames.transport_to_origin(surface.twin(h)) - 1.), 1e-12);
  }
}

TEST(Tangent_frames, turn_by_the_curvature_around_a_face)
{
  // On a sphere of many faces, what is carried around a face turns by its area.
  const Triangulated_surface surface = CSCD::test::to_surface(CSCD::test::sphere(4));
  const Tangent_frames<Triangulated_surface> frames(surface);
  double total = 0;
  for (Index h = 0; h < surface.number_of_halfedges(); h += 3) {
    const Complex around =
        frames.transport_to_origin(h) * frames.transport_to_origin(h + 1) * frames.transport_to_origin(h + 2);
    EXPECT_NEAR(std::fabs(std::arg(around)), surface.face_area(h / 3), 0.2 * surface.face_area(h / 3));
    total += std::arg(around);
  }
  EXPECT_NEAR(std::fabs(total), 4 * CSCD::test::pi, 1e-9) << "all together turn by 2 pi times the Euler number";
}

TEST(Tangent_frames, of_a_border_are_not_scaled_however_it_is_closed)
{
  const CSCD::test::Shape shape = CSCD::test::tube(4, 1, 12, CSCD::test::Tube_end::open);
  const Triangulated_surface open = CSCD::test::to_surface_with_borders(shape);
  CSCD::Indexed_triangles triangles = CSCD::test::to_indexed_triangles(shape);
  const CSCD::Halfedge_pairing pairing(triangles.faces, triangles.points.size());
  CSCD::internal::bridge_borders(triangles, pairing);
  const Triangulated_surface bridged(std::move(triangles));
  const Tangent_frames<Triangulated_surface> open_frames(open);
  const Tangent_frames<Triangulated_surface> bridged_frames(bridged);
  EXPECT_DOUBLE_EQ(open_frames.mean_edge_length(), bridged_frames.mean_edge_length());
  std::size_t on_border = 0;
  for (Index h = 0; h < open.number_of_halfedges(); ++h) {
    on_border += open.twin(h) == CSCD::no_index ? 1u : 0u;
    EXPECT_LT(std::abs(open_frames.corner(h).turn - bridged_frames.corner(h).turn), 1e-12) << h;
    EXPECT_DOUBLE_EQ(open_frames.area(open.origin(h)), bridged_frames.area(open.origin(h)));
  }
  EXPECT_EQ(on_border, 24u);
}

TEST(Tangent_frames, show_every_neighbor_once)
{
  const Triangulated_surface surface =
      CSCD::test::to_surface_with_borders(CSCD::test::tube(4, 1, 12, CSCD::test::Tube_end::open));
  const Tangent_frames<Triangulated_surface> frames(surface);
  std::size_t number_of_ends = 0;
  std::size_t number_of_borders = 0;
  for (Index v = 0; v < surface.number_of_vertices(); ++v) {
    frames.for_each_neighbor(v, [&](Index neighbor, Index h) {
      EXPECT_TRUE((surface.origin(h) == v && surface.target(h) == neighbor) ||
                  (surface.target(h) == v && surface.origin(h) == neighbor));
      ++number_of_ends;
    });
  }
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    number_of_borders += surface.twin(h) == CSCD::no_index ? 1u : 0u;
  }
  EXPECT_EQ(number_of_ends, surface.number_of_halfedges() + number_of_borders);
}

} // namespace
