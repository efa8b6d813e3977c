// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of a closed surface, and their measures.

#ifndef CSCD_TRAITS_SURFACE_COMPONENTS_H
#define CSCD_TRAITS_SURFACE_COMPONENTS_H

#include <CSCD/Traits/Halfedge_pairing.h>
#include <CSCD/Traits/Indexed_triangles.h>
#include <CSCD/internal/Vector_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CSCD::internal {

/// The components of faces that are connected through edges, numbered in the order of their first faces.
struct Surface_components
{
  /// Numbers and measures the components of `triangles`; linear.
  /// \pre `triangles` is closed, and `pairing` is that of its faces
  Surface_components(const Indexed_triangles& triangles, const Halfedge_pairing& pairing)
      : component(triangles.faces.size(), no_index)
  {
    std::vector<Index> stack;
    for (Index seed = 0; seed < component.size(); ++seed) {
      if (component[seed] == no_index) {
        flood(seed, pairing, stack);
        measures.emplace_back();
      }
    }
    measure(triangles);
  }

  struct Measure
  {
    double area = 0;                      ///< without bridging faces
    double volume = 0;                    ///< signed: negative where the faces look inwards
    Vector_3 centroid = Vector_3::Zero(); ///< of the area; of the faces' centres where there is no area
  };

  Index number() const { return Index(measures.size()); }

  std::vector<Index> component;  ///< of every face
  std::vector<Measure> measures; ///< of every component

private:
  void flood(Index seed, const Halfedge_pairing& pairing, std::vector<Index>& stack)
  {
    component[seed] = number();
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      for (Index halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge) {
        const Index neighbor = pairing.twin(halfedge) / 3;
        if (component[neighbor] == no_index) {
          component[neighbor] = number();
          stack.push_back(neighbor);
        }
      }
    }
  }

  void measure(const Indexed_triangles& triangles)
  {
    std::vector<Vector_3> center_sum(number(), Vector_3::Zero());
    std::vector<double> number_of_faces(number(), 0.);
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
      const std::array<Index, 3>& face = triangles.faces[f];
      const Vector_3& a = triangles.points[face[0]];
      const Vector_3& b = triangles.points[face[1]];
      const Vector_3& c = triangles.points[face[2]];
      const Vector_3 vector = (b - a).cross(c - a);
      const double area = f < triangles.first_bridging_face ? vector.norm() / 2 : 0.;
      const Vector_3 center = (a + b + c) / 3;
      Measure& result = measures[component[f]];
      result.area += area;
      result.volume += a.dot(vector) / 6;
      result.centroid += area * center;
      center_sum[component[f]] += center;
      number_of_faces[component[f]] += 1;
    }
    for (Index i = 0; i < number(); ++i) {
      Measure& result = measures[i];
      result.centroid =
          result.area > 0 ? Vector_3(result.centroid / result.area) : Vector_3(center_sum[i] / number_of_faces[i]);
    }
  }
};

} // namespace CSCD::internal

#endif // CSCD_TRAITS_SURFACE_COMPONENTS_H
