// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point sets that come with CGAL: scans, scenes, noise, curves and a few points. Whether they are treated as
// surfaces, their topology, and the time.

#include "support/convert_shape.h"
#include "support/point_skeletons.h"
#include "support/sampling.h"
#include "support/shapes.h"
#include "support/skip_or_fail.h"
#include <CSCD/IO/read_points.h>
#include <CSCD/exceptions.h>
#include <CSCD/extract_curve_skeleton_from_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Point_set = CGAL::Point_set_3<Point>;

/// What users may expect of a point set.
enum class Outcome
{
  surface,  ///< a skeleton without doubt
  doubtful, ///< the points hardly sample a surface: refused, or a skeleton with a warning that says so
  refused,
  any ///< scenes and patches: the skeleton is of no use, with or without a warning
};

struct Real_points
{
  const char* name; ///< of the file
  Outcome outcome;
  std::size_t number_of_components = 0; ///< of a surface
  std::size_t number_of_cycles = 0;     ///< of a surface

  std::string path() const { return std::string(CSCD_CGAL_DATA_DIR) + "/../points_3/" + name; }
};

void PrintTo(const Real_points& points, std::ostream* out)
{
  *out << points.name;
}

std::vector<Real_points> all_real_points()
{
  using O = Outcome;
  return {{"b9_training.ply", O::any},
          {"ball.ply", O::surface, 1, 0},
          {"before_upsample.xyz", O::surface, 1, 0},
          {"blobby.xyz", O::doubtful},
          {"building.ply", O::doubtful},
          {"circles.ply", O::refused},
          {"colors.ply", O::refused},
          {"cube.pwn", O::surface, 1, 0},
          {"cube.xyz", O::surface, 1, 0},
          {"example.ply", O::refused},
          {"fin90_with_PCA_normals.xyz", O::surface, 1, 0},
          {"half.xyz", O::surface, 1, 0},
          {"hippo1.ply", O::any},
          {"hippo2.ply", O::any},
          {"kitten.off", O::surface, 1, 1},
          {"kitten.xyz", O::surface, 1, 1},
          {"oneH.xyz", O::doubtful},
          {"oneK.xyz", O::doubtful},
          {"oni.ply", O::surface, 1, 0},
          {"oni.pwn", O::surface, 1, 0},
          {"point_set_2.xyz", O::refused},
          {"point_set_3.xyz", O::surface, 1, 0},
          {"points.xyz", O::surface, 1, 0},
          {"poste_france.xyz", O::any},
          {"radar.xyz", O::any},
          {"sphere926.pwn", O::surface, 1, 0},
          {"sphere_1k.xyz", O::surface, 1, 0},
          {"sphere_20k.xyz", O::surface, 1, 0},
          {"sphere_20k_normal.xyz", O::surface, 1, 0},
          {"spheres.ply", O::surface, 9, 0},
          {"triangles.xyz", O::doubtful}};
}

/// A result for a point set, and the time it took.
struct Result
{
  bool is_refused = false;
  CSCD::Skeletonization_report report;
  double seconds = 0; ///< of all threads

  bool warns(const char* text) const
  {
    const auto& warnings = report.warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
  }
  bool is_doubtful() const { return warns("hardly sample the surface"); }
};

Result skeletonize(const Point_set& points)
{
  CSCD::Skeleton_graph<Point, Point_set::Index> skeleton;
  Result result;
  const std::clock_t start = std::clock();
  try {
    result.report = CSCD::extract_curve_skeleton(points, skeleton);
  } catch (const CSCD::Input_error&) {
    result.is_refused = true;
  }
  result.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
}

/// The seconds for each point of a torus, which has a surface.
double usual_seconds_for_each_point()
{
  constexpr std::size_t number = 5000;
  Point_set points;
  for (const Point& p : CSCD::test::to_points<Point>(sampled(CSCD::test::torus(3, 1, 24), number, 1))) {
    points.insert(p);
  }
  return skeletonize(points).seconds / double(number);
}

class Skeletonized_real_points : public testing::TestWithParam<Real_points>
{
};

TEST_P(Skeletonized_real_points, are_what_users_expect_in_reasonable_time)
{
  if (!std::ifstream(GetParam().path()).good()) {
    CSCD_TEST_SKIP_OR_FAIL(GetParam().path() << " is missing: it comes with the Debian package libcgal-demo");
  }
  std::vector<Point> points;
  std::vector<Vector> normals;
  CSCD::read_points(GetParam().path(), points, normals);
  Point_set point_set;
  if (!normals.empty()) {
    point_set.add_normal_map();
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto place = point_set.insert(points[i]);
    if (!normals.empty()) {
      point_set.normal(*place) = normals[i];
    }
  }
  const Result result = skeletonize(point_set);
  switch (GetParam().outcome) {
  case Outcome::surface:
    EXPECT_FALSE(result.is_refused);
    EXPECT_FALSE(result.is_doubtful());
    EXPECT_EQ(result.report.number_of_skeleton_components, GetParam().number_of_components);
    EXPECT_EQ(result.report.betti_number, GetParam().number_of_cycles);
    break;
  case Outcome::doubtful:
    EXPECT_TRUE(result.is_refused || result.is_doubtful());
    EXPECT_TRUE(result.warns("so many handles were cut") || GetParam().name != std::string("blobby.xyz"));
    break;
  case Outcome::refused:
    EXPECT_TRUE(result.is_refused);
    break;
  case Outcome::any:
    break;
  }
  // Noise of many spacings, with tens of handles to be cut, takes ten times as long as a torus.
  constexpr double max_slowness = 40;
  constexpr std::size_t few_points = 1000; // no faster than so many
  static const double usual = usual_seconds_for_each_point();
  EXPECT_LT(result.seconds, max_slowness * usual * double(std::max(points.size(), few_points)));
}

std::string name_of(const testing::TestParamInfo<Real_points>& info)
{
  std::string name = "_" + std::string(info.param.name);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cgal, Skeletonized_real_points, testing::ValuesIn(all_real_points()), name_of);

} // namespace
