// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A SeparatorFinder with no more than the concept asks for.

#ifndef CSCD_TEST_ARCHETYPES_SEPARATOR_FINDER_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_SEPARATOR_FINDER_ARCHETYPE_H

#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>

#include <limits>

namespace CSCD::test {

/// Finds sections across the x axis. Can be copied, and not assigned; there is none by default.
class Separator_finder_archetype
{
public:
  explicit Separator_finder_archetype(const Triangulated_surface& surface) : m_surface(surface) {}
  Separator_finder_archetype(const Separator_finder_archetype&) = default;
  Separator_finder_archetype& operator=(const Separator_finder_archetype&) = delete;
  ~Separator_finder_archetype() = default;

  void operator()(Index source, Index /* level_hint */, Search_result& result)
  {
    internal::Plane_section section(m_surface);
    result = Search_result();
    if (section.cut_at_vertex(source, Vector_3::UnitX(), std::numeric_limits<double>::max())) {
      result.outcome = Search_outcome::found;
      result.separator.source = source;
      result.separator.crossings = section.crossings();
      internal::set_measures(result.separator, section.points());
      result.loop_length = result.separator.length;
      result.is_section = true;
    }
  }

private:
  const Triangulated_surface& m_surface;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_SEPARATOR_FINDER_ARCHETYPE_H
