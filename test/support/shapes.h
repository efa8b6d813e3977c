// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All generated shapes, and lists of them by property.

#ifndef CSCD_TEST_SUPPORT_SHAPES_H
#define CSCD_TEST_SUPPORT_SHAPES_H

#include "Shape.h"
#include "limb_shapes.h"
#include "shape_operations.h"
#include "simple_shapes.h"
#include "swept_shapes.h"

#include <ostream>
#include <vector>

namespace CSCD::test {

/// A shape by name, made when it is asked for: lists of them cost nothing.
struct Shape_maker
{
  const char* name; ///< letters, digits and underscores
  Shape (*make)();
};

inline void PrintTo(const Shape_maker& maker, std::ostream* out)
{
  *out << maker.name;
}

/// Closed bodies with limbs or handles whose skeleton is beyond doubt: tips, junctions and centreline are known.
inline std::vector<Shape_maker> shapes_with_known_skeleton()
{
  return {{"tube", [] { return tube(10, 1, 24, Tube_end::flat); }},
          {"capsule", [] { return capsule(8, 1, 24); }},
          {"tapered_tube", [] { return tapered_tube(10, 0.4, 1.2, 24); }},
          {"bent_tube", [] { return bent_tube(3, 4, 0.6, 24); }},
          {"torus", [] { return torus(3, 1, 24); }},
          {"trefoil_knot", [] { return trefoil_knot(0.4, 16); }},
          {"chain_of_rings", [] { return chain_of_rings(4, 16); }},
          {"y_tube", [] { return y_tube(0.15); }},
          {"star_of_5", [] { return star(5, 3, 0.35, 0.12); }},
          {"tree", [] { return tree(4, 0.12); }},
          {"double_torus", [] { return double_torus(0.12); }},
          {"genus_4", [] { return ladder(4, 0.15); }},
          {"two_components", [] {
             return merged("", {capsule(8, 1, 16), translated(torus(3, 1, 16), {0, 10, 0})});
           }}};
}

/// Closed bodies that are hard: no limbs, few or huge or uneven triangles, thin limbs, noise.
inline std::vector<Shape_maker> hard_closed_shapes()
{
  return {{"tetrahedron", [] { return tetrahedron(); }},
          {"cube", [] { return cube(); }},
          {"subdivided_cube", [] { return subdivided_cube(4); }},
          {"beam", [] { return beam(); }},
          {"l_bracket", [] { return l_bracket(); }},
          {"plate_with_hole", [] { return plate_with_hole(); }},
          {"subdivided_plate_with_hole", [] { return midpoint_subdivided(plate_with_hole(), 3); }},
          {"icosahedron", [] { return sphere(0); }},
          {"sphere", [] { return sphere(4); }},
          {"ellipsoid",
           [] {
             return ellipsoid({3, 1, 0.5}, 4);
           }},
          {"double_cone", [] { return double_cone(200); }},
          {"long_triangles", [] { return anisotropic_tube(40, 1, 8, 12); }},
          {"flat_triangles", [] { return anisotropic_tube(10, 1, 64, 8); }},
          {"tube_of_4", [] { return tube(20, 1, 4, Tube_end::flat); }},
          {"tube_of_3", [] { return tube(20, 1, 3, Tube_end::flat); }},
          {"thin_limbs", [] { return star(5, 4, 0.2, 0.22); }},
          {"coarse_torus", [] { return torus(3, 1, 5); }},
          {"comb", [] { return comb(8, 0.12); }},
          {"hand", [] { return hand(0.12); }},
          {"jack", [] { return jack(0.15); }},
          {"ball_with_tail", [] { return ball_with_tail(0.12); }},
          {"noisy_capsule", [] { return noisy(capsule(8, 1, 24), 0.2, 1); }},
          {"noisy_torus", [] { return noisy(torus(3, 1, 24), 0.2, 2); }},
          {"subdivided_y_tube", [] { return midpoint_subdivided(y_tube(0.3), 1); }}};
}

/// Bodies without symmetry: in a symmetric one, rounding decides between equals.
inline std::vector<Shape_maker> asymmetric_shapes()
{
  return {{"noisy_y_tube", [] { return noisy(y_tube(0.2), 0.05, 1); }},
          {"noisy_double_torus", [] { return noisy(double_torus(0.2), 0.05, 2); }},
          {"noisy_hand", [] { return noisy(hand(0.2), 0.05, 3); }},
          {"noisy_chain", [] { return noisy(chain_of_rings(3, 12), 0.05, 4); }},
          {"noisy_sphere", [] { return noisy(sphere(3), 0.05, 5); }},
          {"noisy_capsule_with_holes", [] { return with_small_holes(noisy(capsule(8, 1, 24), 0.05, 6), 5, 7); }}};
}

/// Surfaces with borders.
inline std::vector<Shape_maker> open_shapes()
{
  return {{"open_tube", [] { return tube(10, 1, 24, Tube_end::open); }},
          {"slit_tube", [] { return slit_tube(10, 1, 24); }},
          {"sphere_with_small_holes", [] { return with_small_holes(sphere(4), 20, 1); }},
          {"y_tube_with_small_holes", [] { return with_small_holes(y_tube(0.15), 12, 2); }},
          {"flat_disc", [] { return flat_disc(8, 24); }}};
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SHAPES_H
