// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces with the right topology around the voxels of an image that have the same label.
//
// Eight voxels, the octants, meet in a corner. Bit i of an octant tells on which side of the corner it is along axis i.
// On a small sphere around the corner, two octants with a common face meet in one of twelve arcs, and arcs
// meet in six points, the half-axes: half-axis 2 i + s is the edge of voxels that leaves the corner along axis i,
// in positive direction if s is 1. The arcs between octants of a label and others form closed curves: one for each
// sheet.

#ifndef CSCD_VOLUME_VOXEL_SURFACE_H
#define CSCD_VOLUME_VOXEL_SURFACE_H

#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangles.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CSCD {

/// Where the voxels of an image are in space.
struct Volume_grid
{
  /// The numbers of voxels along the three axes. The first axis runs fastest in memory.
  std::array<std::size_t, 3> size{};
  /// The center of the first voxel.
  Vector3 origin;
  /// From a voxel to the next along each axis: the direction times the spacing.
  std::array<Vector3, 3> axes{Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};

  /// The number of voxels in a slice, which has a fixed index along the last axis.
  std::size_t slice_size() const { return size[0] * size[1]; }
  /// The number of voxels.
  std::size_t number_of_voxels() const { return slice_size() * size[2]; }
  /// The point in space that has these indices, between voxels too.
  Vector3 point(const Vector3& index) const
  {
    return origin + index.x() * axes[0] + index.y() * axes[1] + index.z() * axes[2];
  }
  /// The volume of a voxel, negative where the axes are left-handed.
  double signed_voxel_volume() const { return axes[0].dot(axes[1].cross(axes[2])); }
};

/// The number of the body that a voxel belongs to. Segmentations of large volumes number bodies by 64 bits.
using Voxel_label = std::uint64_t;

/// An image in memory.
struct Volume
{
  /// Where the voxels are.
  Volume_grid grid;
  /// The label of each voxel; 0 for the background.
  std::vector<Voxel_label> labels;
};

/// Which voxels of a body belong together; voxels of the background are joined by the other rule, so that every closed
/// surface of the body separates something.
enum class Voxel_connectivity
{
  six,       ///< those that share a face; voxels of the background also through edges and corners
  twenty_six ///< those that share a face, an edge or a corner; voxels of the background through faces only
};

/// How surfaces are made of voxels.
struct Voxel_surface_settings
{
  /// Which voxels belong together.
  Voxel_connectivity connectivity = Voxel_connectivity::twenty_six;
  /// Whether the surfaces of cavities are left out. The pipeline takes each for the surface of another body after
  /// `Voxel_surface::turn_cavities()`.
  bool fills_cavities = true;
};

/// The closed surface of the voxels that have a label.
struct Voxel_surface
{
  /// The label.
  Voxel_label label = 0;
  /// Oriented outwards, in space.
  Indexed_triangles triangles;
  /// The number of voxels with the label.
  std::size_t number_of_voxels = 0;
  /// The number of cavities, whether filled or not.
  std::size_t number_of_cavities = 0;

  /// Turns the surfaces of cavities that were kept outwards, as those of bodies: the pipeline fills cavities of meshes.
  /// Linear.
  void turn_cavities()
  {
    if (number_of_cavities > 0) {
      internal::Surface_components components(triangles);
      internal::orient_outwards(triangles, components);
    }
  }
};

namespace internal {

inline constexpr unsigned number_of_octants = 8;
inline constexpr unsigned number_of_half_axes = 6;

/// The number of the arc between `octant` and its neighbor along `axis`.
constexpr unsigned arc_of_octant(unsigned octant, unsigned axis)
{
  const unsigned low = octant >> (axis == 0 ? 1U : 0U) & 1U;
  const unsigned high = octant >> (axis == 2 ? 1U : 2U) & 1U;
  return 4 * axis + low + 2 * high;
}

/// The sheets that a corner becomes.
struct Corner_sheets
{
  std::array<std::uint8_t, 12> sheet_of_arc{}; ///< of arcs that bound the label
  std::uint8_t number_of_vertices = 0;         ///< one a sheet; one a half-axis if there is a tube
  std::uint8_t singular_half_axes = 0;         ///< a bit for each where four faces meet
  bool has_tube = false;                       ///< whether two sheets are joined
};

/// The sheets around a corner. \param octants a bit for each that has the label
/// \param joins_diagonally whether octants of the label are joined through edges and corners
inline Corner_sheets make_corner_sheets(unsigned octants, bool joins_diagonally)
{
  const auto has = [octants](unsigned octant) { return (octants >> octant & 1U) != 0; };
  // Where four faces meet in an edge, sheets go around octants of the background if the body is joined through it.
  const auto is_enclosed = [&](unsigned octant) { return has(octant) != joins_diagonally; };
  Corner_sheets result;
  Disjoint_sets sheets(result.sheet_of_arc.size());
  for (unsigned half_axis = 0; half_axis < number_of_half_axes; ++half_axis) {
    const unsigned axis = half_axis / 2;
    const unsigned base = (half_axis & 1U) << axis;
    const unsigned b = 1U << (axis + 1) % 3;
    const unsigned c = 1U << (axis + 2) % 3;
    const std::array<unsigned, 4> around{base, base | b, base | b | c, base | c};
    const auto arc_after = [&](unsigned i) { return arc_of_octant(around[i % 4], (axis + 1 + i % 2) % 3); };
    unsigned number_of_runs = 0; // of enclosed octants, which two arcs bound that are of one sheet
    for (unsigned i = 0; i < around.size(); ++i) {
      if (!is_enclosed(around[i]) || is_enclosed(around[(i + 3) % 4])) {
        continue;
      }
      unsigned last = i;
      while (is_enclosed(around[(last + 1) % 4])) {
        ++last;
      }
      sheets.join(arc_after(i + 3), arc_after(last));
      ++number_of_runs;
    }
    if (number_of_runs > 1) {
      result.singular_half_axes = std::uint8_t(result.singular_half_axes | 1U << half_axis);
    }
  }
  std::array<int, 12> number{};
  number.fill(-1);
  for (unsigned octant = 0; octant < number_of_octants; ++octant) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (has(octant) && !has(octant ^ 1U << axis)) {
        const unsigned arc = arc_of_octant(octant, axis);
        int& its_number = number[sheets.find(arc)];
        its_number = its_number < 0 ? result.number_of_vertices++ : its_number;
        result.sheet_of_arc[arc] = std::uint8_t(its_number);
      }
    }
  }
  const unsigned all = (1U << number_of_octants) - 1;
  const unsigned joined = joins_diagonally ? octants : all ^ octants;
  for (unsigned octant = 0; octant < number_of_octants / 2; ++octant) { // two that meet in the corner alone
    result.has_tube = result.has_tube || joined == (1U << octant | 1U << (number_of_octants - 1 - octant));
  }
  result.number_of_vertices = result.has_tube ? std::uint8_t(number_of_half_axes) : result.number_of_vertices;
  return result;
}

/// Adds to `sums`, for every vertex, `values` of its neighbors, each once, as the surface is closed.
template <class Value>
void add_neighbors(const std::vector<std::array<Index, 3>>& faces, const std::vector<Value>& values,
                   std::vector<Value>& sums)
{
  for (const auto& [a, b, c] : faces) {
    sums[a] += values[b];
    sums[b] += values[c];
    sums[c] += values[a];
  }
}

/// Smooths the vertices of a closed surface in units of voxels; linear. Limbs stay as thick as they are: vertices move
/// outwards again by their depth below the surface of the voxels, averaged over the neighborhood.
inline void smooth_voxel_surface(Indexed_triangles& triangles)
{
  constexpr int number_of_steps = 20; // in turns shrinking and growing: an even terrace of six voxels becomes a slope
  constexpr double shrinking = 0.5;   // the factors of Taubin, for a pass band of 0.1
  constexpr double growing = 1 / (0.1 - 1 / shrinking);
  constexpr double max_displacement = 0.45; // voxels: neighbors in a row never change places
  std::vector<Vector3>& points = triangles.points;
  const std::vector<Vector3> places = points;
  std::vector<Index> degree(points.size(), 0);
  for (const std::array<Index, 3>& face : triangles.faces) {
    for (const Index vertex : face) {
      ++degree[vertex];
    }
  }
  const auto move = [&](std::size_t i, const Vector3& way) {
    points[i] = (points[i] + way)
                    .cwiseMax(places[i] - Vector3::Constant(max_displacement))
                    .cwiseMin(places[i] + Vector3::Constant(max_displacement));
  };
  std::vector<Vector3> sums(points.size());
  for (int step = 0; step < number_of_steps; ++step) {
    std::fill(sums.begin(), sums.end(), Vector3::Zero());
    add_neighbors(triangles.faces, points, sums);
    const double factor = step % 2 == 0 ? shrinking : growing;
    for (std::size_t i = 0; i < points.size(); ++i) {
      move(i, factor * (sums[i] / double(degree[i]) - points[i]));
    }
  }

  std::vector<Vector3>& normals = sums;
  std::fill(normals.begin(), normals.end(), Vector3::Zero());
  for (const auto& [a, b, c] : triangles.faces) {
    const Vector3 normal = (points[b] - points[a]).cross(points[c] - points[a]);
    for (const Index vertex : {a, b, c}) {
      normals[vertex] += normal;
    }
  }
  std::vector<double> depths(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    normals[i] = normals[i].normalized();
    depths[i] = normals[i].dot(places[i] - points[i]);
  }
  std::vector<double> sums_of_depths(points.size());
  for (int step = 0; step < number_of_steps; ++step) {
    std::fill(sums_of_depths.begin(), sums_of_depths.end(), 0.);
    add_neighbors(triangles.faces, depths, sums_of_depths);
    for (std::size_t i = 0; i < points.size(); ++i) {
      depths[i] = (depths[i] + sums_of_depths[i] / double(degree[i])) / 2;
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    move(i, depths[i] * normals[i]);
  }
}

/// Leaves out two of three vertices where the surface of a thick body is finer than its curvature needs; the topology
/// stays the same. A second round would leave long faces along thin limbs, whose ends are lost then. Linear.
inline void coarsen_voxel_surface(Indexed_triangles& triangles, std::size_t number_of_voxels)
{
  // Vertices: fewer than a third of them hardly sample a body.
  constexpr std::size_t fine_size = 3000;
  // Voxels for each vertex: a tube has about 0.4 for each voxel of its radius. Radii of thinner vessels would lose in
  // precision, and cycles of pipes with thinner walls get lost in these.
  constexpr double min_thickness = 1.4;
  // Of the turn of a normal, 30 degrees: with more, ends are lost.
  constexpr double min_squared_cosine = 0.75;
  if (triangles.points.size() > fine_size &&
      double(number_of_voxels) > min_thickness * double(triangles.points.size())) {
    const Triangulated_surface fine(std::move(triangles));
    triangles = Coarsening(fine, 1, min_squared_cosine).triangles();
  }
}

} // namespace internal

/// Makes the surfaces of all labels of an image, slice by slice: only two slices are in memory, apart from the
/// surfaces that have not been taken.
///
/// The surface of a label is made of the faces that its voxels have in common with others. Where more than two such
/// faces meet in an edge, or several sheets in a corner, edges and corners are doubled so that sheets are joined as the
/// connectivity demands; two voxels that meet in a corner alone are joined there by a tube, if they are. So the surface
/// is a closed manifold that is homotopy equivalent to the body of voxels, whose handles, components and cavities it
/// has. Then vertices are smoothed by the method of G. Taubin, *A signal processing approach to fair surface design*,
/// SIGGRAPH 1995, and moved outwards by as much as the surface around them has shrunk, so that thin limbs stay as
/// thick; they stay within half a voxel of where they were. Where the surface is finer than its curvature needs, some
/// are left out. Linear in the number of voxels.
class Voxel_surface_builder
{
public:
  /// A volume has at most so many labels that are bodies of their own.
  static constexpr std::size_t max_number_of_labels = 65536;

  /// Refuses volumes that hold other values than labels. \throw Input_error if there are more labels
  static void check_number_of_labels(std::size_t number)
  {
    if (number > max_number_of_labels) {
      throw Input_error("the volume has more than " + std::to_string(max_number_of_labels) +
                        " labels: it seems to hold no labels; choose one of them, or a threshold");
    }
  }

  /// \throw Input_error if the grid has no voxels, or the axes do not span the space
  Voxel_surface_builder(const Volume_grid& grid, const Voxel_surface_settings& settings)
      : m_grid(grid), m_joins_diagonally(settings.connectivity == Voxel_connectivity::twenty_six),
        m_fills_cavities(settings.fills_cavities), m_row(grid.size[0] + 2)
  {
    if (grid.number_of_voxels() == 0) {
      throw Input_error("the volume has no voxels: check how it was written");
    }
    if (!(std::abs(grid.signed_voxel_volume()) > 0) || !grid.origin.allFinite()) {
      throw Input_error(
          "the axes of the volume do not span the space, or are not finite: correct spacing, directions and "
          "origin");
    }
    for (unsigned octants = 0; octants < 1U << internal::number_of_octants; ++octants) {
      m_sheets.push_back(internal::make_corner_sheets(octants, m_joins_diagonally));
    }
    m_lower_slice.assign(m_row * (grid.size[1] + 2), 0);
    m_upper_slice = m_lower_slice;
  }

  /// Takes the next slice.
  /// \param labels of its `slice_size()` voxels; 0 for the background
  /// \throw Input_error if there are too many labels, or too many triangles around one of them
  /// \pre there are not as many yet as the volume has
  void push_slice(const Voxel_label* labels)
  {
    CGAL_precondition(m_number_of_slices < m_grid.size[2]);
    number_bodies(labels);
    make_faces();
  }

  /// Closes the surfaces that reach the last slice.
  /// \pre all slices have been pushed, and this was not called before
  void close()
  {
    CGAL_precondition(m_number_of_slices == m_grid.size[2]);
    std::fill(m_upper_slice.begin(), m_upper_slice.end(), 0);
    make_faces();
  }

  /// The labels whose surfaces have not been taken, in ascending order.
  std::vector<Voxel_label> labels() const
  {
    std::vector<Voxel_label> result;
    for (const Shape& shape : m_shapes) {
      if (!shape.triangles.faces.empty()) {
        result.push_back(shape.label);
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// The surface of `label`, which leaves the memory of the builder. Linear.
  /// \pre a slice without `label` has been pushed after its last slice, or the surfaces have been closed; it is one of
  ///      `labels()`
  Voxel_surface take_surface(Voxel_label label)
  {
    Shape& shape = m_shapes[m_body_of_label.at(label) - 1];
    CGAL_precondition(!shape.triangles.faces.empty());
    return make_surface(std::exchange(shape, Shape()));
  }

private:
  /// How the sheets of one body meet in a corner of voxels, which has eight of these around it.
  struct Corner
  {
    Index body;
    std::uint8_t octants; ///< a bit for each voxel of the body
    Index first_vertex;   ///< of the vertices that the corner has become
  };
  /// The corners between two slices.
  struct Corner_plane
  {
    std::vector<Index> first; ///< of `corners`, for each place
    std::vector<Corner> corners;
  };
  struct Shape
  {
    Voxel_label label = 0;
    std::size_t number_of_voxels = 0;
    Indexed_triangles triangles; ///< in indices of corners: those of voxels less a half
  };
  /// An edge of voxels, one of the four voxels around it, and a body.
  using Edge_copy = std::pair<std::uint64_t, Index>;
  using Place = std::array<std::size_t, 3>;

  /// The number of the body with `label`, counted from 1.
  Index body_of(Voxel_label label)
  {
    const auto [entry, is_new] = m_body_of_label.emplace(label, Index(m_shapes.size() + 1));
    if (is_new) {
      check_number_of_labels(m_body_of_label.size());
      m_shapes.emplace_back();
      m_shapes.back().label = label;
    }
    return entry->second;
  }

  /// Writes the bodies of the voxels to the upper slice, and counts their voxels.
  void number_bodies(const Voxel_label* labels)
  {
    for (std::size_t y = 0; y < m_grid.size[1]; ++y) {
      auto body = m_upper_slice.begin() + std::ptrdiff_t((y + 1) * m_row + 1);
      const Voxel_label* const end = labels + m_grid.size[0];
      while (labels != end) {
        const Voxel_label* const first = labels;
        labels = std::find_if(first, end, [first](Voxel_label label) { return label != *first; });
        const Index its_body = *first != 0 ? body_of(*first) : 0;
        if (its_body != 0) {
          m_shapes[its_body - 1].number_of_voxels += std::size_t(labels - first);
        }
        body = std::fill_n(body, labels - first, its_body);
      }
    }
  }

  /// Makes the faces below the upper slice and within the lower one, whose place the upper one takes.
  void make_faces()
  {
    make_corners();
    for_each_place([this](std::size_t x, std::size_t y, std::size_t voxel) {
      emit_faces(2, {x, y, m_number_of_slices}, m_lower_slice[voxel], m_upper_slice[voxel]);
    });
    for_each_place([this](std::size_t x, std::size_t y, std::size_t voxel) {
      const Place place{x, y, m_number_of_slices - 1};
      emit_faces(0, place, m_lower_slice[voxel - 1], m_lower_slice[voxel]);
      emit_faces(1, place, m_lower_slice[voxel - m_row], m_lower_slice[voxel]);
    });
    std::swap(m_lower_slice, m_upper_slice);
    std::swap(m_lower_corners, m_upper_corners);
    ++m_number_of_slices;
  }

  /// Calls `function(x, y, voxel)` for the voxels of a slice and those of the background at the end of rows and of
  /// columns, with their places in the slice.
  template <class Function>
  void for_each_place(const Function& function) const
  {
    for (std::size_t y = 0; y <= m_grid.size[1]; ++y) {
      for (std::size_t x = 0; x <= m_grid.size[0]; ++x) {
        function(x, y, (y + 1) * m_row + x + 1);
      }
    }
  }

  /// Makes the corners below the upper slice.
  void make_corners()
  {
    m_upper_corners.first.clear();
    m_upper_corners.corners.clear();
    for_each_place([this](std::size_t x, std::size_t y, std::size_t voxel) {
      m_upper_corners.first.push_back(Index(m_upper_corners.corners.size()));
      const Index* const lower = m_lower_slice.data() + voxel - m_row - 1;
      const Index* const upper = m_upper_slice.data() + voxel - m_row - 1;
      const std::array<Index, 8> bodies{lower[0], lower[1], lower[m_row], lower[m_row + 1],
                                        upper[0], upper[1], upper[m_row], upper[m_row + 1]};
      Index differences = 0;
      for (const Index body : bodies) {
        differences |= body ^ bodies[0];
      }
      if (differences != 0) {
        add_corner(bodies, x, y);
      }
    });
    m_upper_corners.first.push_back(Index(m_upper_corners.corners.size()));
  }

  /// Adds the corner at a place for each body that is there.
  void add_corner(const std::array<Index, 8>& bodies, std::size_t x, std::size_t y)
  {
    for (std::size_t octant = 0; octant < bodies.size(); ++octant) {
      const Index body = bodies[octant];
      const auto here = bodies.begin() + std::ptrdiff_t(octant);
      if (body == 0 || std::find(bodies.begin(), here, body) != here) {
        continue;
      }
      unsigned octants = 0;
      for (unsigned other = 0; other < bodies.size(); ++other) {
        octants |= (bodies[other] == body ? 1U : 0U) << other;
      }
      Shape& shape = m_shapes[body - 1];
      std::vector<Vector3>& points = shape.triangles.points;
      m_upper_corners.corners.push_back({body, std::uint8_t(octants), Index(points.size())});
      const internal::Corner_sheets& sheets = m_sheets[octants];
      const Vector3 place{double(x), double(y), double(m_number_of_slices)};
      points.insert(points.end(), sheets.number_of_vertices, place);
      if (!sheets.has_tube) {
        continue;
      }
      const Index first_vertex = m_upper_corners.corners.back().first_vertex;
      constexpr double tube_radius = 0.25; // voxels: half way to the middles of edges
      for (unsigned half_axis = 0; half_axis < internal::number_of_half_axes; ++half_axis) {
        points[first_vertex + half_axis][half_axis / 2] += (half_axis & 1U) != 0 ? tube_radius : -tube_radius;
      }
      add_tube(shape, first_vertex, octants);
    }
  }

  /// Adds the octahedron around a corner, except its faces in the two octants that it joins.
  void add_tube(Shape& shape, Index first_vertex, unsigned octants) const
  {
    for (unsigned octant = 0; octant < internal::number_of_octants; ++octant) {
      const bool has_label = (octants >> octant & 1U) != 0;
      if (has_label == m_joins_diagonally) {
        continue; // here the tube ends
      }
      const Index a = first_vertex + (octant & 1U);
      const Index b = first_vertex + 2 + (octant >> 1U & 1U);
      const Index c = first_vertex + 4 + (octant >> 2U & 1U);
      const bool is_counterclockwise = ((octant ^ octant >> 1U ^ octant >> 2U) & 1U) != 0;
      const bool is_turned = is_counterclockwise != m_joins_diagonally;
      shape.triangles.faces.push_back({a, is_turned ? c : b, is_turned ? b : c});
    }
  }

  /// Emits the face between two voxels for both of their bodies, if they differ.
  void emit_faces(int axis, const Place& lower_corner, Index below, Index above)
  {
    if (below != above && below != 0) {
      emit_face(axis, lower_corner, below, true);
    }
    if (below != above && above != 0) {
      emit_face(axis, lower_corner, above, false);
    }
  }

  const Corner& corner(const Place& place, Index body) const
  {
    const Corner_plane& plane = place[2] == m_number_of_slices ? m_upper_corners : m_lower_corners;
    const std::size_t position = place[1] * (m_row - 1) + place[0];
    Index number = plane.first[position];
    while (plane.corners[number].body != body) {
      ++number;
    }
    CGAL_assertion(number < plane.first[position + 1]);
    return plane.corners[number];
  }

  /// \param lower_corner the corner of the face that is least along all axes
  /// \param is_below whether the voxel of the body is the one before the face
  void emit_face(int axis, const Place& lower_corner, Index body, bool is_below)
  {
    Shape& shape = m_shapes[body - 1];
    const auto a = unsigned(axis);
    // Counterclockwise seen from outside: b, then c, around the positive axis, or the other way round.
    const unsigned b = is_below ? (a + 1) % 3 : (a + 2) % 3;
    const unsigned c = 3 - a - b;
    constexpr std::array<std::array<unsigned, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    m_polygon.clear();
    for (unsigned i = 0; i < square.size(); ++i) {
      Place place = lower_corner;
      place[b] += square[i][0];
      place[c] += square[i][1];
      const unsigned towards_b = 1 - square[i][0]; // on which side of the corner the face is
      const unsigned towards_c = 1 - square[i][1];
      const Corner& its_corner = corner(place, body);
      const internal::Corner_sheets& sheets = m_sheets[its_corner.octants];
      const unsigned octant = towards_b << b | towards_c << c; // before the face
      const unsigned half_axis_b = 2 * b + towards_b;
      const unsigned half_axis_c = 2 * c + towards_c;
      const unsigned next_half_axis = i % 2 == 0 ? half_axis_b : half_axis_c;
      if (sheets.has_tube) {
        m_polygon.push_back(its_corner.first_vertex + (i % 2 == 0 ? half_axis_c : half_axis_b));
        m_polygon.push_back(its_corner.first_vertex + next_half_axis);
      } else {
        m_polygon.push_back(its_corner.first_vertex + sheets.sheet_of_arc[internal::arc_of_octant(octant, a)]);
      }
      if ((sheets.singular_half_axes >> next_half_axis & 1U) != 0) {
        // The sheet goes around one of the two voxels at the face.
        const unsigned turned = octant | (is_below != m_joins_diagonally ? 0U : 1U) << a;
        const unsigned edge_axis = next_half_axis / 2;
        place[edge_axis] -= (next_half_axis & 1U) != 0 ? 0U : 1U;
        m_polygon.push_back(middle_of_edge(body, place, int(edge_axis), turned & ~(1U << edge_axis)));
      }
    }
    append_polygon(shape, axis, lower_corner);
  }

  /// The vertex in the middle of an edge where four faces meet, on the sheet that goes around one of its voxels.
  /// \param place where the edge begins
  /// \param octant of the voxel, seen from there
  Index middle_of_edge(Index body, const Place& place, int axis, unsigned octant)
  {
    const std::uint64_t position = (place[2] * (m_grid.size[1] + 1) + place[1]) * (m_row - 1) + place[0];
    const Edge_copy key{(position * 3 + unsigned(axis)) * internal::number_of_octants + octant, body};
    std::vector<Vector3>& points = m_shapes[body - 1].triangles.points;
    const auto [entry, is_new] = m_open_middles.emplace(key, Index(points.size()));
    const Index middle = entry->second;
    if (is_new) {
      points.emplace_back(double(place[0]), double(place[1]), double(place[2]));
      points.back()[axis] += 0.5;
    } else {
      m_open_middles.erase(entry);
    }
    return middle;
  }

  /// Adds the triangles of a face that has become a polygon: two, or those around its center.
  void append_polygon(Shape& shape, int axis, const Place& lower_corner)
  {
    constexpr std::size_t max_number_of_triangles = std::size_t(1) << 26U; // as for meshes
    std::vector<std::array<Index, 3>>& faces = shape.triangles.faces;
    if (faces.size() > max_number_of_triangles) {
      throw Input_error("the surface of label " + std::to_string(shape.label) +
                        " has more than 2^26 triangles: use a coarser image");
    }
    if (m_polygon.size() == 4) {
      faces.push_back({m_polygon[0], m_polygon[1], m_polygon[2]});
      faces.push_back({m_polygon[0], m_polygon[2], m_polygon[3]});
      return;
    }
    Vector3 center{double(lower_corner[0]) + 0.5, double(lower_corner[1]) + 0.5, double(lower_corner[2]) + 0.5};
    center[axis] -= 0.5;
    shape.triangles.points.push_back(center);
    const Index center_vertex = Index(shape.triangles.points.size() - 1);
    for (std::size_t i = 0; i < m_polygon.size(); ++i) {
      faces.push_back({m_polygon[i], m_polygon[(i + 1) % m_polygon.size()], center_vertex});
    }
  }

  Voxel_surface make_surface(Shape&& shape) const
  {
    Voxel_surface result{shape.label, std::move(shape.triangles), shape.number_of_voxels, 0};
    Indexed_triangles& triangles = result.triangles;
    triangles.first_hole_filling_face = triangles.faces.size();
    const internal::Surface_components components(triangles);
    const auto is_cavity = [](const auto& measure) { return measure.volume < 0; };
    result.number_of_cavities =
        std::size_t(std::count_if(components.measures.begin(), components.measures.end(), is_cavity));
    if (result.number_of_cavities > 0 && m_fills_cavities) {
      remove_components(triangles, components, [&](Index i) { return is_cavity(components.measures[i]); });
    }
    internal::smooth_voxel_surface(triangles);
    for (Vector3& point : triangles.points) {
      point = m_grid.point(point - Vector3::Constant(0.5));
    }
    internal::coarsen_voxel_surface(triangles, result.number_of_voxels);
    if (m_grid.signed_voxel_volume() < 0) {
      for (std::array<Index, 3>& face : triangles.faces) {
        std::swap(face[1], face[2]);
      }
    }
    return result;
  }

  Volume_grid m_grid;
  bool m_joins_diagonally; ///< the voxels of a body, and not those of the background
  bool m_fills_cavities;
  std::vector<internal::Corner_sheets> m_sheets; ///< for all sets of octants that have a label
  std::size_t m_row;                             ///< voxels in a row of a padded slice
  std::vector<Index> m_lower_slice; ///< the body of each voxel, 0 for the background, which is around it, too
  std::vector<Index> m_upper_slice;
  std::size_t m_number_of_slices = 0;        ///< that were taken
  Corner_plane m_lower_corners;              ///< below the lower slice
  Corner_plane m_upper_corners;              ///< between the slices
  std::map<Edge_copy, Index> m_open_middles; ///< of edges with one of two faces made
  std::vector<Shape> m_shapes;               ///< of the bodies, in the order of their numbers
  std::unordered_map<Voxel_label, Index> m_body_of_label;
  std::vector<Index> m_polygon;
};

/// makes the surfaces of all labels of `volume`; see `Voxel_surface_builder`.
/// \throw Input_error if the volume has no voxels, labels that do not fit the size, too many labels or triangles, or
///        axes that do not span the space
inline std::vector<Voxel_surface> make_voxel_surfaces(const Volume& volume, const Voxel_surface_settings& settings = {})
{
  if (volume.labels.size() != volume.grid.number_of_voxels()) {
    throw Input_error("the volume has " + std::to_string(volume.labels.size()) + " labels for " +
                      std::to_string(volume.grid.number_of_voxels()) + " voxels: give each voxel one");
  }
  Voxel_surface_builder builder(volume.grid, settings);
  for (std::size_t z = 0; z < volume.grid.size[2]; ++z) {
    builder.push_slice(volume.labels.data() + z * volume.grid.slice_size());
  }
  builder.close();
  std::vector<Voxel_surface> result;
  for (const Voxel_label label : builder.labels()) {
    result.push_back(builder.take_surface(label));
  }
  return result;
}

} // namespace CSCD

#endif // CSCD_VOLUME_VOXEL_SURFACE_H
