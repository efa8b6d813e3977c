// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A point with only the members that the library requires.

#ifndef CSCD_TEST_ARCHETYPES_POINT_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_POINT_ARCHETYPE_H

namespace CSCD::test {

/// Coordinates that can be read, and a constructor from three of them; the default constructor is for nodes of a graph.
class Point_archetype
{
public:
  Point_archetype() = default;
  Point_archetype(double x, double y, double z) : m_x(x), m_y(y), m_z(z) {}

  double x() const { return m_x; }
  double y() const { return m_y; }
  double z() const { return m_z; }

private:
  double m_x = 0;
  double m_y = 0;
  double m_z = 0;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_POINT_ARCHETYPE_H
