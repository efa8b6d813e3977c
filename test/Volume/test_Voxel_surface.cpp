// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces of voxels are closed manifolds with the topology of the voxels. The tests count it by cells.

#include <CSCD/Surface/Surface_components.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace {

using CSCD::Volume, CSCD::Voxel_connectivity, CSCD::Voxel_surface;

CSCD::Voxel_surface_settings voxel_settings(Voxel_connectivity connectivity, bool fills_cavities = false)
{
  CSCD::Voxel_surface_settings result;
  result.connectivity = connectivity;
  result.fills_cavities = fills_cavities;
  return result;
}

/// A volume whose voxels have the labels `label(x, y, z)`.
template <class Label>
Volume make_volume(const std::array<std::size_t, 3>& size, const Label& label)
{
  Volume volume;
  volume.grid.size = size;
  for (std::size_t z = 0; z < size[2]; ++z) {
    for (std::size_t y = 0; y < size[1]; ++y) {
      for (std::size_t x = 0; x < size[0]; ++x) {
        volume.labels.push_back(CSCD::Voxel_label(label(int(x), int(y), int(z))));
      }
    }
  }
  return volume;
}

/// The Euler number of the voxels of a label: of the union of the closed voxels if they are joined through corners, of
/// its interior otherwise. A cell has even coordinates 2 i along the axes where its extent is zero.
int euler_number_of_voxels(const Volume& volume, CSCD::Voxel_label label, Voxel_connectivity connectivity)
{
  const std::array<int, 3> size{int(volume.grid.size[0]), int(volume.grid.size[1]), int(volume.grid.size[2])};
  const auto has_label = [&](const std::array<int, 3>& voxel) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (voxel[axis] < 0 || voxel[axis] >= size[axis]) {
        return false;
      }
    }
    return volume.labels[std::size_t(voxel[0] + size[0] * (voxel[1] + size[1] * voxel[2]))] == label;
  };
  int result = 0;
  for (int cell = 0; cell < (2 * size[0] + 1) * (2 * size[1] + 1) * (2 * size[2] + 1); ++cell) {
    const std::array<int, 3> place{cell % (2 * size[0] + 1), cell / (2 * size[0] + 1) % (2 * size[1] + 1),
                                   cell / (2 * size[0] + 1) / (2 * size[1] + 1)};
    int number = 0;
    int number_with_label = 0;
    for (int side = 0; side < 8; ++side) {
      std::array<int, 3> voxel{};
      bool is_new = true;
      for (int axis = 0; axis < 3; ++axis) {
        const int offset = side >> axis & 1;
        voxel[std::size_t(axis)] = (place[std::size_t(axis)] + 1) / 2 - 1 + offset;
        if (place[std::size_t(axis)] % 2 == 1) { // the cell is between the ends of one voxel along this axis
          voxel[std::size_t(axis)] = place[std::size_t(axis)] / 2;
          is_new = is_new && offset == 0;
        }
      }
      number += is_new ? 1 : 0;
      number_with_label += is_new && has_label(voxel) ? 1 : 0;
    }
    const bool is_in =
        connectivity == Voxel_connectivity::twenty_six ? number_with_label > 0 : number_with_label == number;
    const int dimension = place[0] % 2 + place[1] % 2 + place[2] % 2;
    const int codimension = connectivity == Voxel_connectivity::twenty_six ? dimension : 3 - dimension;
    result += is_in ? (codimension % 2 == 0 ? 1 : -1) : 0;
  }
  return result;
}

bool is_closed_manifold(const Voxel_surface& surface)
{
  const CSCD::Halfedge_pairing pairing(surface.triangles.faces, surface.triangles.points.size());
  return pairing.conflict() == CSCD::no_index && !pairing.has_border() && pairing.pinched_vertex() == CSCD::no_index;
}

int euler_number_of_surface(const Voxel_surface& surface)
{
  return int(surface.triangles.points.size()) - int(surface.triangles.faces.size() / 2);
}

double volume_inside(const Voxel_surface& surface)
{
  const CSCD::internal::Surface_components components(surface.triangles);
  return std::accumulate(components.measures.begin(), components.measures.end(), 0.,
                         [](double sum, const auto& measure) { return sum + measure.volume; });
}

double area_of(const Voxel_surface& surface)
{
  double result = 0;
  for (const auto& [a, b, c] : surface.triangles.faces) {
    const std::vector<CSCD::Vector3>& points = surface.triangles.points;
    result += (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
  }
  return result;
}

TEST(Voxel_surface, has_the_topology_of_random_voxels)
{
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const auto density = random() % 10;
    const Volume volume = make_volume({1 + random() % 6, 1 + random() % 6, 1 + random() % 6},
                                      [&](int, int, int) { return random() % 10 < density ? 1 + random() % 2 : 0; });
    for (const Voxel_connectivity connectivity : {Voxel_connectivity::six, Voxel_connectivity::twenty_six}) {
      for (const Voxel_surface& surface : make_voxel_surfaces(volume, voxel_settings(connectivity))) {
        ASSERT_TRUE(is_closed_manifold(surface)) << round;
        ASSERT_EQ(euler_number_of_surface(surface), 2 * euler_number_of_voxels(volume, surface.label, connectivity))
            << round;
        ASSERT_EQ(surface.number_of_voxels,
                  std::size_t(std::count(volume.labels.begin(), volume.labels.end(), surface.label)));
      }
    }
  }
}

TEST(Voxel_surface, has_few_vertices_where_it_is_thick)
{
  const auto is_in_ball = [](int x, int y, int z) {
    return (x - 21) * (x - 21) + (y - 21) * (y - 21) + (z - 21) * (z - 21) < 21 * 21;
  };
  // A ball and many handles of one voxel.
  std::mt19937 random(1);
  const Volume volume = make_volume({50, 44, 44}, [&](int x, int y, int z) {
    return is_in_ball(x, y, z) || (x > 43 && x < 46 && random() % 4 == 0);
  });
  for (const Voxel_connectivity connectivity : {Voxel_connectivity::six, Voxel_connectivity::twenty_six}) {
    const Voxel_surface surface = make_voxel_surfaces(volume, voxel_settings(connectivity)).front();
    EXPECT_TRUE(is_closed_manifold(surface));
    EXPECT_EQ(euler_number_of_surface(surface), 2 * euler_number_of_voxels(volume, 1, connectivity));
    const auto is_of_ball = [](const CSCD::Vector3& point) { return point.x() < 35; };
    EXPECT_LT(std::count_if(surface.triangles.points.begin(), surface.triangles.points.end(), is_of_ball),
              3500); // of 9000 corners of voxels
  }
  constexpr double volume_of_ball = 4. / 3 * M_PI * 21 * 21 * 21;
  EXPECT_NEAR(volume_inside(make_voxel_surfaces(make_volume({44, 44, 44}, is_in_ball)).front()), volume_of_ball,
              0.02 * volume_of_ball);
}

TEST(Voxel_surface, joins_voxels_through_edges_and_corners_or_not)
{
  // Along a diagonal of the first slice, then to a corner above.
  const Volume volume = make_volume({4, 4, 3}, [](int x, int y, int z) { return x == y && z == (x == 2 ? 1 : 0); });
  const Voxel_surface joined = make_voxel_surfaces(volume, voxel_settings(Voxel_connectivity::twenty_six)).front();
  const Voxel_surface apart = make_voxel_surfaces(volume, voxel_settings(Voxel_connectivity::six)).front();
  EXPECT_EQ(CSCD::internal::Surface_components(joined.triangles).number(), 1U);
  EXPECT_EQ(CSCD::internal::Surface_components(apart.triangles).number(), 4U);
}

TEST(Voxel_surface, fills_cavities_or_keeps_them)
{
  const auto is_border = [](int i) { return i == 0 || i == 4; };
  const Volume volume =
      make_volume({5, 5, 5}, [&](int x, int y, int z) { return is_border(x) || is_border(y) || is_border(z); });
  const Voxel_surface kept = make_voxel_surfaces(volume, voxel_settings(Voxel_connectivity::six)).front();
  const Voxel_surface filled = make_voxel_surfaces(volume, voxel_settings(Voxel_connectivity::six, true)).front();
  EXPECT_EQ(kept.number_of_cavities, 1U);
  EXPECT_EQ(euler_number_of_surface(kept), 4);
  EXPECT_EQ(filled.number_of_cavities, 1U);
  EXPECT_EQ(euler_number_of_surface(filled), 2);
  EXPECT_TRUE(is_closed_manifold(filled));
  EXPECT_GT(volume_inside(filled), volume_inside(kept));
}

TEST(Voxel_surface, is_in_space_and_oriented_outwards)
{
  Volume volume = make_volume({20, 20, 20}, [](int, int, int) { return 3; });
  volume.grid.origin = {100, 0, -5};
  for (const double sign : {1., -1.}) {
    volume.grid.axes = {CSCD::Vector3(0, 0.5, 0), CSCD::Vector3(sign * 2, 0, 0), CSCD::Vector3(0, 0.1, 3)};
    const Voxel_surface surface = make_voxel_surfaces(volume).front();
    EXPECT_EQ(surface.label, 3U);
    EXPECT_TRUE(is_closed_manifold(surface));
    EXPECT_GT(volume_inside(surface), 0.97 * 8000 * 3); // edges and corners are rounded
    EXPECT_LT(volume_inside(surface), 1.01 * 8000 * 3);
    const auto [lowest, highest] =
        std::minmax_element(surface.triangles.points.begin(), surface.triangles.points.end(),
                            [](const CSCD::Vector3& a, const CSCD::Vector3& b) { return a.z() < b.z(); });
    EXPECT_NEAR(lowest->z(), -5 - 3 * 0.5, 3 * 0.45); // half a voxel below the first center, less what smoothing may do
    EXPECT_NEAR((lowest->z() + highest->z()) / 2, -5 + 3 * 9.5, 3 * 0.05);
  }
}

TEST(Voxel_surface, has_no_terraces)
{
  constexpr int radius = 20;
  const auto is_in_ball = [](int x, int y, int z) {
    const int dx = x - radius;
    const int dy = y - radius;
    const int dz = z - radius;
    return dx * dx + dy * dy + dz * dz < radius * radius;
  };
  const Volume volume = make_volume({2 * radius + 1, 2 * radius + 1, 2 * radius + 1}, is_in_ball);
  // Faces of voxels have 1.5 times the area of the ball.
  EXPECT_NEAR(area_of(make_voxel_surfaces(volume).front()), 4 * M_PI * radius * radius,
              0.05 * 4 * M_PI * radius * radius);
}

TEST(Voxel_surface, keeps_a_voxel_from_vanishing)
{
  const Voxel_surface surface = make_voxel_surfaces(make_volume({1, 1, 1}, [](int, int, int) { return 1; })).front();
  EXPECT_EQ(surface.triangles.points.size(), 8U);
  // Each corner stays in its octant, .05 away from the others.
  for (const CSCD::Vector3& point : surface.triangles.points) {
    EXPECT_GE(point.cwiseAbs().minCoeff(), 0.05 - 1e-9);
  }
  EXPECT_GE(volume_inside(surface), 0.1 * 0.1 * 0.1 - 1e-9);
}

TEST(Voxel_surface, refuses_what_is_no_volume)
{
  Volume volume = make_volume({2, 2, 2}, [](int, int, int) { return 1; });
  volume.labels.pop_back();
  EXPECT_THROW(make_voxel_surfaces(volume), CSCD::Input_error);
  volume.labels.push_back(1);
  volume.grid.axes[2] = volume.grid.axes[1];
  EXPECT_THROW(make_voxel_surfaces(volume), CSCD::Input_error);
  EXPECT_THROW(make_voxel_surfaces(Volume()), CSCD::Input_error);
  const Volume noise = make_volume({41, 41, 41}, [](int x, int y, int z) { return 1 + x + 41 * (y + 41 * z); });
  EXPECT_THROW(make_voxel_surfaces(noise), CSCD::Input_error);
}

} // namespace
