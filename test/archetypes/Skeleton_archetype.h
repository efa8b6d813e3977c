// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A minimal model of CurveSkeletonGraph: its descriptors are not numbers, and it has no index map.

#ifndef CSCD_TEST_ARCHETYPES_SKELETON_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SKELETON_ARCHETYPE_H

#include <boost/graph/adjacency_list.hpp>

#include <vector>

namespace CSCD::test {

/// A node with a position and sites only.
template <class Point, class InputDescriptor>
struct Skeleton_vertex_archetype
{
  Point point;
  std::vector<InputDescriptor> vertices;
};

template <class Point, class InputDescriptor>
using Skeleton_archetype = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS,
                                                 Skeleton_vertex_archetype<Point, InputDescriptor>>;

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SKELETON_ARCHETYPE_H
