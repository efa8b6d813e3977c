// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A minimal model of SkeletonizationTraits, without any type of a mesh.

#ifndef CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H

#include "Point_archetype.h"
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Vector3.h>

#include <array>
#include <cstddef>

namespace CSCD::test {

/// A type that can only be copied, and read by the test: not a number, not comparable, not default constructible.
class Input_descriptor_archetype
{
public:
  explicit Input_descriptor_archetype(Index number) : m_number(number) {}
  Index number() const { return m_number; }

private:
  Index m_number;
};

/// An input that is the surface itself, at twice its size; its vertices are the descriptors.
template <class SkeletonizationSurface>
class Skeletonization_traits_archetype
{
public:
  using Point = Point_archetype;
  using Input_descriptor = Input_descriptor_archetype;
  using Surface = SkeletonizationSurface;

  explicit Skeletonization_traits_archetype(const Surface& surface) : m_surface(surface) {}
  Skeletonization_traits_archetype(const Skeletonization_traits_archetype&) = delete;
  Skeletonization_traits_archetype& operator=(const Skeletonization_traits_archetype&) = delete;
  ~Skeletonization_traits_archetype() = default;

  const Surface& surface() const { return m_surface; }
  std::array<Input_descriptor, 1> descriptors(Index vertex) const { return {Input_descriptor(vertex)}; }
  Normalization normalization() const { return {Vector3::Zero(), 2}; }
  void describe_input(Skeletonization_report& report) const
  {
    report.number_of_input_vertices = std::size_t(m_surface.triangulation().number_of_vertices());
  }

private:
  const Surface& m_surface;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SKELETONIZATION_TRAITS_ARCHETYPE_H
