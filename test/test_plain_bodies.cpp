// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeletons of bars, prisms and frustums are their axes: users try these first.

#include <CSCD/Options.h>
#include <CSCD/Skeleton.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/skeletonize.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using CSCD::Index;
using CSCD::Vector3;
using Section = std::vector<std::array<double, 2>>;

constexpr double pi = 3.14159265358979323846;
constexpr double height = 6;

/// A body around the axis from (0, 0, 0) to (0, 0, height).
struct Plain_body
{
  std::string name;
  Section section; ///< a convex polygon around the origin, counterclockwise
  double top = 1;  ///< the scale of the upper end relative to the lower one
};

double area(const Section& section)
{
  double result = 0;
  for (std::size_t i = 0; i < section.size(); ++i) {
    const auto& [x, y] = section[i];
    const auto& [next_x, next_y] = section[(i + 1) % section.size()];
    result += (x * next_y - next_x * y) / 2;
  }
  return result;
}

Section rectangle(double a, double b)
{
  return {{-a / 2, -b / 2}, {a / 2, -b / 2}, {a / 2, b / 2}, {-a / 2, b / 2}};
}

Section regular_polygon(std::size_t n)
{
  Section result;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n);
    result.push_back({std::cos(angle), std::sin(angle)});
  }
  return result;
}

/// `section` with `parts` edges in place of each one.
Section divided(const Section& section, std::size_t parts)
{
  Section result;
  for (std::size_t i = 0; i < section.size(); ++i) {
    const auto& [x, y] = section[i];
    const auto& [next_x, next_y] = section[(i + 1) % section.size()];
    for (std::size_t part = 0; part < parts; ++part) {
      const double along = double(part) / double(parts);
      result.push_back({(1 - along) * x + along * next_x, (1 - along) * y + along * next_y});
    }
  }
  return result;
}

/// A turn, so that no face is parallel to an axis.
Vector3 turned(const Vector3& p)
{
  const Vector3 q(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y(), p.z());
  return {q.x(), 0.28 * q.y() - 0.96 * q.z(), 0.96 * q.y() + 0.28 * q.z()};
}

struct Soup
{
  std::vector<Vector3> points;
  std::vector<std::array<Index, 3>> faces;
};

/// The surface of `body`, turned, its walls made of `rows` rows of triangles.
Soup triangulated(const Plain_body& body, std::size_t parts, std::size_t rows)
{
  const Section section = divided(body.section, parts);
  const auto n = Index(section.size());
  Soup result;
  for (std::size_t row = 0; row <= rows; ++row) {
    const double along = double(row) / double(rows);
    const double scale = 1 + along * (body.top - 1);
    for (const auto& [x, y] : section) {
      result.points.push_back(turned({scale * x, scale * y, along * height}));
    }
  }
  for (Index first = 0; first < rows * n; first += n) {
    for (Index i = 0; i < n; ++i) {
      const Index next = (i + 1) % n;
      result.faces.push_back({first + i, first + next, first + n + next});
      result.faces.push_back({first + i, first + n + next, first + n + i});
    }
  }
  const auto bottom = Index(result.points.size());
  result.points.push_back(turned({0, 0, 0}));
  result.points.push_back(turned({0, 0, height}));
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    result.faces.push_back({bottom, next, i});
    result.faces.push_back({bottom + 1, Index(rows) * n + i, Index(rows) * n + next});
  }
  return result;
}

/// Expects two tips, all nodes near the axis, and tips near its ends.
void expect_axis(const CSCD::Skeleton& skeleton, double radius)
{
  std::vector<int> degree(skeleton.points.size());
  for (const auto& [a, b] : skeleton.edges) {
    ++degree[a];
    ++degree[b];
  }
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1), 2);
  const Vector3 axis = turned({0, 0, 1});
  double lowest = height;
  double highest = 0;
  for (const Vector3& point : skeleton.points) {
    const double along = point.dot(axis);
    EXPECT_LT((point - along * axis).norm(), 0.1 * radius);
    lowest = std::min(lowest, along);
    highest = std::max(highest, along);
  }
  EXPECT_LT(lowest, radius);
  EXPECT_GT(highest, height - radius);
}

class Plain_bodies : public testing::TestWithParam<Plain_body>
{
};

TEST_P(Plain_bodies, have_their_axis_as_skeleton)
{
  const double radius = std::sqrt(area(GetParam().section) / pi);
  for (const auto& [parts, rows] : {std::pair<std::size_t, std::size_t>(1, 1), {6, 24}}) {
    const Soup soup = triangulated(GetParam(), parts, rows);
    for (const unsigned seed : {0U, 1U, 2U}) {
      SCOPED_TRACE(GetParam().name + ", rows " + std::to_string(rows) + ", seed " + std::to_string(seed));
      CSCD::Options options;
      options.random_seed = seed;
      CSCD::Skeleton skeleton;
      CSCD::skeletonize(soup.points, soup.faces, options, skeleton);
      expect_axis(skeleton, radius);
    }
  }
}

TEST_P(Plain_bodies, of_few_vertices_have_few_nodes)
{
  const Soup soup = triangulated(GetParam(), 1, 1);
  CSCD::Skeleton skeleton;
  CSCD::skeletonize(soup.points, soup.faces, CSCD::Options(), skeleton);
  EXPECT_LE(skeleton.points.size(), 14U);
}

TEST_P(Plain_bodies, keep_their_axis_at_any_spacing_of_nodes)
{
  const double radius = std::sqrt(area(GetParam().section) / pi);
  const Soup soup = triangulated(GetParam(), 6, 24);
  std::size_t number_of_nodes = soup.points.size();
  for (const double spacing : {0., 1.5, 3.}) {
    CSCD::Options options;
    options.node_spacing = spacing;
    CSCD::Skeleton skeleton;
    const CSCD::Skeletonization_report report = CSCD::skeletonize(soup.points, soup.faces, options, skeleton);
    expect_axis(skeleton, radius);
    EXPECT_EQ(report.number_of_edges_outside, 0U);
    EXPECT_LT(skeleton.points.size(), number_of_nodes);
    number_of_nodes = skeleton.points.size();
    std::size_t number_of_vertices = 0;
    for (const auto& vertices : skeleton.vertices) {
      number_of_vertices += vertices.size();
    }
    EXPECT_EQ(number_of_vertices, soup.points.size());
  }
}

// An ellipsoid of diameters 1, 0.12 and 6 along the axis of the other bodies, its vertices scattered.
TEST(Plain_bodies, of_thin_sections_and_uneven_triangles_have_a_straight_skeleton)
{
  constexpr std::size_t rows = 24;
  Soup soup = triangulated({"blade", regular_polygon(24)}, 1, rows - 1);
  const std::size_t per_row = (soup.points.size() - 2) / rows;
  for (const unsigned seed : {0U, 1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> shift(-0.4, 0.4);
    for (std::size_t i = 0; i + 2 < soup.points.size(); ++i) {
      const double along = 2 * (double(i / per_row) + 0.5 + shift(generator)) / rows - 1;
      const double angle = 2 * pi * (double(i % per_row) + 0.4 + shift(generator)) / double(per_row);
      const double radius = std::sqrt(1 - along * along) / 2;
      soup.points[i] = turned({radius * std::cos(angle), 0.12 * radius * std::sin(angle), height * (1 + along) / 2});
    }
    CSCD::Skeleton skeleton;
    CSCD::skeletonize(soup.points, soup.faces, CSCD::Options(), skeleton);
    // Distances from the axis are those of the scattered surface, too; waves make the branch longer.
    const Vector3 axis = turned({0, 0, 1});
    double length = 0;
    double height_passed = 0;
    for (const auto& [a, b] : skeleton.edges) {
      const Vector3 way = skeleton.points[b] - skeleton.points[a];
      if (std::abs(skeleton.points[a].dot(axis) - height / 2) < 0.35 * height) {
        length += way.norm();
        height_passed += std::abs(way.dot(axis));
      }
    }
    EXPECT_LT(length, 1.0004 * height_passed);
  }
}

/// Two balls of radius 1 on the z axis, around the origin and `distance` away, which a neck of `radius` joins.
Soup dumbbell(double radius, double distance)
{
  constexpr std::size_t corners = 48;
  std::vector<std::array<double, 2>> half; // from the first pole to the middle: place along the axis, radius
  for (double angle = pi - 0.05; angle > std::asin(radius); angle -= 0.05) {
    half.push_back({std::cos(angle), std::sin(angle)});
  }
  for (double along = std::sqrt(1 - radius * radius); along < distance / 2 - 0.01; along += 0.05) {
    half.push_back({along, radius});
  }
  const std::size_t rows = 2 * half.size() + 1;
  Soup soup = triangulated({"dumbbell", regular_polygon(corners)}, 1, rows - 1);
  for (std::size_t i = 0; i < rows * corners; ++i) {
    const std::size_t row = std::min(i / corners, rows - 1 - i / corners); // from the nearer pole
    const auto [along, r] = row < half.size() ? half[row] : std::array<double, 2>{distance / 2, radius};
    const double angle = 2 * pi * double(i % corners) / double(corners);
    soup.points[i] = {r * std::cos(angle), r * std::sin(angle), row == i / corners ? along : distance - along};
  }
  soup.points[rows * corners] = {0, 0, -1};
  soup.points[rows * corners + 1] = {0, 0, distance + 1};
  return soup;
}

TEST(Plain_bodies, of_two_balls_at_a_thin_neck_have_skeletons_in_both)
{
  constexpr int number_of_poses = 6;
  // Of a neck whose faces are longer than it is thick, no separator may be found that tells its direction.
  for (const auto& [radius, length, max_offset] : {std::array<double, 3>{0.01, 0., 0.1},
                                                   {0.01, 0.5, 0.1},
                                                   {0.03, 0.5, 0.4},
                                                   {0.03, 2., 0.1},
                                                   {0.1, 0.5, 0.1},
                                                   {0.3, 1., 0.1}}) {
    const double distance = 2 * std::sqrt(1 - radius * radius) + length;
    Soup soup = dumbbell(radius, distance);
    Vector3 axis(0, 0, 1);
    double sum_of_offsets = 0;
    for (int pose = 0; pose < number_of_poses; ++pose) {
      SCOPED_TRACE(std::to_string(radius) + ", length " + std::to_string(length) + ", pose " + std::to_string(pose));
      CSCD::Skeleton skeleton;
      const CSCD::Skeletonization_report report = CSCD::skeletonize(soup.points, soup.faces, CSCD::Options(), skeleton);
      EXPECT_EQ(report.number_of_edges_outside, 0U);
      std::array<double, 2> distance_from_center{2, 2};
      double offset = 0;
      for (const Vector3& point : skeleton.points) {
        offset = std::max(offset, (point - point.dot(axis) * axis).norm());
        distance_from_center[0] = std::min(distance_from_center[0], point.norm());
        distance_from_center[1] = std::min(distance_from_center[1], (point - distance * axis).norm());
      }
      EXPECT_LT(std::max(distance_from_center[0], distance_from_center[1]), 0.6);
      sum_of_offsets += offset;
      std::transform(soup.points.begin(), soup.points.end(), soup.points.begin(), turned);
      axis = turned(axis);
    }
    EXPECT_LT(sum_of_offsets / number_of_poses, max_offset);
  }
}

/// The name of `body`, of letters and digits alone.
std::string test_name(const Plain_body& body)
{
  std::string name = body.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Plain_bodies,
    testing::Values(Plain_body{"square bar", rectangle(1, 1)}, Plain_body{"thick square bar", rectangle(2, 2)},
                    Plain_body{"bar 1 x 0.7", rectangle(1, 0.7)}, Plain_body{"bar 2 x 0.86", rectangle(2, 0.86)},
                    Plain_body{"bar 1 x 0.5", rectangle(1, 0.5)}, Plain_body{"plank", rectangle(2, 0.5)},
                    Plain_body{"triangular prism", regular_polygon(3)},
                    Plain_body{"pentagonal prism", regular_polygon(5)},
                    Plain_body{"hexagonal prism", regular_polygon(6)},
                    Plain_body{"octagonal prism", regular_polygon(8)}, Plain_body{"cylinder", regular_polygon(32)},
                    Plain_body{"pyramidal frustum", regular_polygon(4), 0.6},
                    Plain_body{"hexagonal frustum", regular_polygon(6), 0.5},
                    Plain_body{"conical frustum", regular_polygon(32), 0.6}),
    [](const auto& tested) { return test_name(tested.param); });

} // namespace
