// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pipeline one stage after the other, with a visitor that shows progress and stops the work when it takes too long.
// Between the stages the separators can be read.
// Usage: step_by_step_example [mesh file [maximum number of seconds]]

#include <CSCD/Curve_skeletonization.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/Local_policies.h>
#include <CSCD/Skeletonization_visitor.h>
#include <CSCD/Traits/Triangle_mesh_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Traits = CSCD::Triangle_mesh_traits<Mesh>;

//! [A visitor]
/// Names the stages as they begin and end, and stops the work after some seconds.
class Time_limit_visitor : public CSCD::Default_skeletonization_visitor
{
public:
  explicit Time_limit_visitor(double max_seconds) : m_max_seconds(max_seconds) {}

  void on_stage_begin(CSCD::Skeletonization_stage stage) { std::cout << name(stage) << " ... " << std::flush; }
  void on_stage_end(CSCD::Skeletonization_stage) { std::cout << "done\n"; }
  void progress(double fraction)
  {
    if (fraction >= m_last_fraction + 0.25) {
      m_last_fraction = fraction;
      std::cout << int(100 * fraction) << " % ... " << std::flush;
    }
  }
  bool go_further()
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
    return elapsed.count() < m_max_seconds;
  }

private:
  double m_max_seconds;
  double m_last_fraction = 0;
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};
//! [A visitor]

using Skeletonization = CSCD::Curve_skeletonization<Traits, CSCD::Local_policies, Time_limit_visitor>;

/// Writes the packed separators as closed polylines, one a line.
void write_packed_separators(const Skeletonization& skeletonization, const char* filename)
{
  std::ofstream out(filename);
  for (auto position : skeletonization.packed_separators()) {
    const auto polyline = skeletonization.polyline(skeletonization.separators()[position]);
    out << polyline.size() + 1;
    for (const auto& point : polyline) {
      out << ' ' << point;
    }
    out << ' ' << polyline.front() << '\n';
  }
}

void print(const CSCD::Skeletonization_report& report)
{
  std::cout << "from " << report.number_of_sources << " sources, " << report.number_of_separators << " separators, "
            << report.number_of_packed_separators << " packed\n"
            << "skeleton of " << report.number_of_nodes << " nodes: " << report.number_of_tips << " tips, "
            << report.number_of_junctions << " junctions, " << report.betti_number << " cycles for genus "
            << report.genus.value_or(0) << '\n';
  for (const std::string& warning : report.warnings) {
    std::cout << "warning: " << warning << '\n';
  }
}

} // namespace

int main(int argc, char** argv)
try {
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  const double max_seconds = argc > 2 ? std::stod(argv[2]) : 60;

  Mesh mesh;
  CSCD::read_triangle_mesh(filename, mesh);
  //! [Step by step]
  const Traits traits(mesh);

  const CSCD::Local_policies policies{CSCD::Detail(0.6)};
  Skeletonization skeletonization(traits, policies, Time_limit_visitor(max_seconds));
  skeletonization.set_random_seed(7);
  skeletonization.find_separators();
  skeletonization.pack_separators();
  write_packed_separators(skeletonization, "separators.polylines.txt");

  Skeletonization::Skeleton skeleton;
  skeletonization.convert_to_skeleton(skeleton);
  //! [Step by step]
  print(skeletonization.report());
} catch (const std::exception& error) { // Cancelled_error is one of them
  std::cerr << error.what() << '\n';
  return 1;
}
