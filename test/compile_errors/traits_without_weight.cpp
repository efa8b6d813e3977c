// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A traits class without the function weight() is refused, and the sentence names what is missing.
// expected error: CSCD: SkeletonizationTraits requires t.weight(i) const, convertible to double

#include <CSCD/concepts.h>

#include <array>
#include <string>
#include <vector>

struct Traits
{
  using Point = std::array<double, 3>;
  using Input_descriptor = int;

  int number_of_sites() const;
  Eigen::Vector3d point(int i) const;
  Eigen::Vector3d normal(int i) const;
  std::vector<int> neighbors(int i) const;
  int number_of_triangles() const;
  std::array<int, 3> triangle(int f) const;
  std::vector<int> descriptors(int i) const;
  Point to_input_point(const Eigen::Vector3d& p) const;
  double to_input_length(double length) const;
  int genus() const;
  int number_of_components() const;
  int number_of_input_vertices() const;
  int number_of_isolated_vertices() const;
  int number_of_bridged_borders() const;
  int number_of_inserted_vertices() const;
  int number_of_degenerate_faces() const;
  std::vector<std::string> warnings() const;
  double seconds_to_compile() const;
};

int main()
{
  CSCD::check_skeletonization_traits<Traits>();
}
