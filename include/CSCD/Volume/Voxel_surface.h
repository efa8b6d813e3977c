// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces with the right topology around the voxels of an image that have the same label.

#ifndef CSCD_VOLUME_VOXEL_SURFACE_H
#define CSCD_VOLUME_VOXEL_SURFACE_H

#include <CSCD/Surface/Triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CSCD {

/// Where the voxels of an image are in space.
struct Volume_grid
{
  /// The numbers of voxels along the three axes, of which the first runs fastest in memory.
  std::array<std::size_t, 3> size{};
  /// The center of the first voxel.
  Vector_3 origin;
  /// From a voxel to the next along each axis: the direction times the spacing.
  std::array<Vector_3, 3> axes{Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, 0, 1)};

  /// The number of voxels in a slice, which has a fixed index along the last axis.
  std::size_t slice_size() const { return size[0] * size[1]; }
  /// The number of voxels.
  std::size_t number_of_voxels() const { return slice_size() * size[2]; }
  /// The point in space that has these indices, between voxels too.
  Vector_3 point(const Vector_3& index) const
  {
    return origin + index.x() * axes[0] + index.y() * axes[1] + index.z() * axes[2];
  }
  /// The volume of a voxel, negative where the axes are left-handed.
  double signed_voxel_volume() const { return axes[0].dot(axes[1].cross(axes[2])); }
};

/// An image in memory.
struct Volume
{
  /// Where the voxels are.
  Volume_grid grid;
  /// The label of each voxel; 0 for the background.
  std::vector<std::uint32_t> labels;
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
  std::uint32_t label = 0;
  /// Oriented outwards, in space.
  Indexed_triangles triangles;
  /// The pairing of the halfedges.
  Halfedge_pairing pairing;
  /// The number of voxels with the label.
  std::size_t number_of_voxels = 0;
  /// The number of cavities, whether filled or not.
  std::size_t number_of_cavities = 0;

  /// Turns the surfaces of cavities that were kept outwards, as those of bodies: the pipeline fills cavities of meshes.
  /// Linear.
  void turn_cavities();
};

/// A volume has at most so many labels that are bodies of their own.
inline constexpr std::size_t max_number_of_labels = 65536;

/// Makes the surfaces of all labels of an image, slice by slice: only two slices are in memory beside the surfaces.
///
/// The surface of a label is made of the faces that its voxels have in common with others. Where more than two such
/// faces meet in an edge, or several sheets in a corner, edges and corners are doubled so that sheets are joined as the
/// connectivity demands; two voxels that meet in a corner alone are joined there by a tube, if they are. So the surface
/// is a closed manifold that is homotopy equivalent to the body of voxels, whose handles, components and cavities it
/// has. Then vertices are smoothed by the method of G. Taubin, *A signal processing approach to fair surface design*,
/// SIGGRAPH 1995, and stay within half a voxel of where they were. Linear in the number of voxels.
class Voxel_surface_builder
{
public:
  /// \throw Input_error if there are no voxels, or the axes do not span the space
  Voxel_surface_builder(const Volume_grid& grid, const Voxel_surface_settings& settings);

  /// Takes the next slice.
  /// \param labels of its `slice_size()` voxels; 0 for the background
  /// \throw Input_error if there are too many labels, or too many triangles around one of them
  /// \pre there are not as many yet as the volume has
  void push_slice(const std::uint32_t* labels);

  /// The surfaces of all labels that occur, in ascending order of the labels.
  /// \pre all slices have been taken, and this was not called before
  std::vector<Voxel_surface> finish();

private:
  /// How the sheets of one label meet in a corner of voxels, which has eight of these around it.
  struct Corner
  {
    std::uint32_t label;
    std::uint8_t octants; ///< a bit for each voxel that has the label
    Index first_vertex;   ///< of those that the corner has become
  };
  /// The corners between two slices.
  struct Corner_plane
  {
    std::vector<Index> first; ///< of `corners`, for each place
    std::vector<Corner> corners;
  };
  struct Shape
  {
    std::uint32_t label = 0;
    std::size_t number_of_voxels = 0;
    Indexed_triangles triangles; ///< in indices of corners: those of voxels less a half
  };
  /// An edge of voxels, one of the four voxels around it, and a label.
  using Edge_copy = std::pair<std::uint64_t, std::uint32_t>;

  Index shape_of(std::uint32_t label);
  void count_voxels(const std::uint32_t* labels);
  void make_corners();
  void add_corner(const std::array<std::uint32_t, 8>& labels, std::size_t x, std::size_t y);
  void add_tube(Shape& shape, Index first_vertex, unsigned octants) const;
  void emit_faces_between_slices();
  void emit_faces_in_slice();
  void emit_faces(int axis, const std::array<std::size_t, 3>& lower_corner, std::uint32_t below, std::uint32_t above);
  void emit_face(int axis, const std::array<std::size_t, 3>& lower_corner, std::uint32_t label, bool is_below);
  void append_polygon(Shape& shape, int axis, const std::array<std::size_t, 3>& lower_corner);
  const Corner& corner(const std::array<std::size_t, 3>& place, std::uint32_t label) const;
  Index middle_of_edge(Shape& shape, const std::array<std::size_t, 3>& place, int axis, unsigned octant);
  Voxel_surface make_surface(Shape&& shape) const;

  Volume_grid m_grid;
  Voxel_surface_settings m_settings;
  std::size_t m_row;                        ///< voxels in a row of a padded slice
  std::vector<std::uint32_t> m_lower_slice; ///< with a border of background, as the next one
  std::vector<std::uint32_t> m_upper_slice;
  std::size_t m_number_of_slices = 0;        ///< that were taken
  Corner_plane m_lower_corners;              ///< below the lower slice
  Corner_plane m_upper_corners;              ///< between the slices
  std::map<Edge_copy, Index> m_open_middles; ///< of edges of which one of two faces is made
  std::vector<Shape> m_shapes;
  std::unordered_map<std::uint32_t, Index> m_shape_of_label;
  Index m_last_shape = no_index;
  std::vector<Index> m_polygon;
};

/// makes the surfaces of all labels of `volume`; see `Voxel_surface_builder`.
/// \throw Input_error if there are no voxels, labels that do not fit the size, too many labels or triangles, or axes
///        that do not span the space
std::vector<Voxel_surface> make_voxel_surfaces(const Volume& volume, const Voxel_surface_settings& settings = {});

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Volume/Voxel_surface_impl.h>
#endif

#endif // CSCD_VOLUME_VOXEL_SURFACE_H
