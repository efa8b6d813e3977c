// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances by the heat method, several sources at a time.

#ifndef CSCD_PUBLISHED_HEAT_METHOD_H
#define CSCD_PUBLISHED_HEAT_METHOD_H

#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CSCD::internal {

/// A point of a surface from which distance is measured, seen from the vertices around it: so it is a source on every
/// triangulation of the surface with the same vertices.
struct Geodesic_source
{
  static Geodesic_source at_vertex(Index vertex) { return {{vertex, vertex, vertex}, {1, 0, 0}, {0, 0, 0}}; }

  /// The point in a face of `triangulation` with these barycentric coordinates with respect to the origins of the
  /// halfedges 3 `face`, 3 `face` + 1 and 3 `face` + 2.
  /// \pre the coordinates are not negative, and their sum is 1; the face carries area
  template <class Triangulation>
  static Geodesic_source in_face(const Triangulation& triangulation, Index face,
                                 const std::array<double, 3>& coordinates)
  {
    const std::array<double, 3> lengths{triangulation.length(3 * face), triangulation.length(3 * face + 1),
                                        triangulation.length(3 * face + 2)};
    const double unit = (lengths[0] + lengths[1] + lengths[2]) / 3;
    const Face_layout layout = lay_out_face(lengths, unit > 0 ? unit : 1.);
    const std::array<double, 2> point = layout.point(coordinates);
    Geodesic_source result{};
    for (Index k = 0; k < 3; ++k) {
      const Index corner = triangulation.origin(3 * face + k);
      if (coordinates[k] == 1) {
        return at_vertex(corner);
      }
      const std::array<double, 2> position = layout.corner(k);
      result.vertices[k] = corner;
      result.weights[k] = coordinates[k];
      result.distances[k] = std::hypot(position[0] - point[0], position[1] - point[1]);
    }
    return result;
  }

  bool is_vertex() const { return weights[0] == 1; }

  std::array<Index, 3> vertices;   ///< around the point
  std::array<double, 3> weights;   ///< its barycentric coordinates
  std::array<double, 3> distances; ///< from it to the vertices, in the unit of the lengths
};

struct Heat_operators;

/// Geodesic distance from any number of sources, on a triangulation given by its edge lengths: factored once.
///
/// On Delaunay triangulations a distance is exact to a few tenths of an edge where the surface is smooth, and rounded
/// off over two or three edges on ridges, where shortest paths from different sides meet. Other triangulations should
/// be made Delaunay first. Distances of any number of edges are right. All members are const and may be called by
/// several threads at once, each with its own workspace. Copies share what is factored.
class Heat_method
{
public:
  /// As many sets of sources are solved for at once.
  static constexpr std::size_t batch_size = 8;

  /// Working memory, 200 bytes a vertex where batches are solved, reused from call to call.
  class Workspace
  {
  public:
    Workspace();
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;

  private:
    friend class Heat_method;
    struct Batches;
    std::unique_ptr<Batches> m_batches;
  };

  /// Factors the equations of `triangulation`, which is not referred to later; O(n^1.5), and usually nearly linear.
  /// \tparam Triangulation see `Cotangent_elements`
  /// \param time_step_factor the duration of the heat flow, in squared mean edge lengths of the component: more is
  ///        smoother and less exact
  /// \pre `time_step_factor` is positive
  /// \throw Input_error if the equations cannot be factored
  template <class Triangulation>
  explicit Heat_method(const Triangulation& triangulation, double time_step_factor = 1)
      : Heat_method(Cotangent_elements(triangulation), time_step_factor)
  {
  }

  /// Computes the distance of every vertex from the nearest one of `sources`, in the unit of the lengths: 0 at vertices
  /// that are sources, infinite on components without a source. Close to several sources, or to one inside a face,
  /// values may be a little below 0. Near linear in the number of vertices.
  void operator()(const std::vector<Geodesic_source>& sources, std::vector<double>& distances,
                  Workspace& workspace) const;

  /// Computes the distances from each of `source_sets` by itself, eight at a time, in about a third of the time.
  /// They are the same as one by one, bit for bit unless the compiler fuses multiplications and additions as it likes.
  void operator()(const std::vector<std::vector<Geodesic_source>>& source_sets,
                  std::vector<std::vector<double>>& distances, Workspace& workspace) const;

  const Cotangent_elements& elements() const;

private:
  Heat_method(Cotangent_elements&& elements, double time_step_factor);

  std::shared_ptr<const Heat_operators> m_operators;
};

/// Estimates the distance of every vertex from the nearest one of `sources` by the heat method, for callers that ask
/// once; infinite on components without a source. O(n^1.5), and usually nearly linear.
/// \tparam Triangulation Delaunay; see `Cotangent_elements`
/// \throw Input_error if the equations cannot be factored
template <class Triangulation>
std::vector<double> distances_from_vertices(const Triangulation& triangulation, const std::vector<Index>& sources)
{
  std::vector<Geodesic_source> geodesic_sources;
  geodesic_sources.reserve(sources.size());
  for (const Index source : sources) {
    geodesic_sources.push_back(Geodesic_source::at_vertex(source));
  }
  std::vector<double> distances;
  Heat_method::Workspace workspace;
  const Heat_method method(triangulation);
  method(geodesic_sources, distances, workspace);
  return distances;
}

} // namespace CSCD::internal

#ifndef CSCD_COMPILED
#include <CSCD/Published/Heat_method_impl.h>
#endif

#endif // CSCD_PUBLISHED_HEAT_METHOD_H
