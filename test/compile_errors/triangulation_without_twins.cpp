// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The published method refuses a surface whose triangulation has no twins, and the sentence names what is missing.
// expected error: CSCD: SurfaceTriangulation requires t.origin(h), t.target(h) and t.twin(h)

#include <CSCD/concepts.h>

#include <array>
#include <optional>
#include <vector>

struct Triangulation : CSCD::Triangle_halfedges
{
  CSCD::Index number_of_vertices() const;
  CSCD::Index number_of_halfedges() const;
  CSCD::Index number_of_faces() const;
  CSCD::Index origin(CSCD::Index h) const;
  CSCD::Index target(CSCD::Index h) const;
  std::array<CSCD::Index, 6> outgoing(CSCD::Index v) const;
  const std::vector<CSCD::Vector_3>& points() const;
  double length(CSCD::Index h) const;
  double vertex_area(CSCD::Index v) const;
};

struct Surface
{
  const Triangulation& triangulation() const;
  bool is_inside(const CSCD::Vector_3& p) const;
  std::optional<CSCD::Vector_3> middle_behind(const CSCD::Vector_3& p) const;
  void crossings(const CSCD::Vector_3& p, const CSCD::Vector_3& q, std::vector<double>& distances) const;
};

int main()
{
  CSCD::check_skeletonization_surface<Surface>();
}
