// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A minimal model of SkeletonizationVisitor; it cannot be copied.

#ifndef CSCD_TEST_ARCHETYPES_VISITOR_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_VISITOR_ARCHETYPE_H

#include <CSCD/Skeletonization_visitor.h>

#include <cstddef>

namespace CSCD::test {

class Visitor_archetype
{
public:
  /// A type that converts to bool.
  class Answer
  {
  public:
    operator bool() const { return true; }
  };

  Visitor_archetype() = default;
  Visitor_archetype(const Visitor_archetype&) = delete;
  Visitor_archetype& operator=(const Visitor_archetype&) = delete;
  ~Visitor_archetype() = default;

  void on_stage_begin(Skeletonization_stage /* stage */) { ++m_number_of_calls; }
  void on_stage_end(Skeletonization_stage /* stage */) { ++m_number_of_calls; }
  void progress(double /* fraction */) { ++m_number_of_calls; }
  Answer go_further()
  {
    ++m_number_of_calls;
    return {};
  }

  std::size_t number_of_calls() const { return m_number_of_calls; }

private:
  std::size_t m_number_of_calls = 0;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_VISITOR_ARCHETYPE_H
