// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A minimal model of SkeletonizationPolicies: one separator, and one node.

#ifndef CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
#define CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H

#include <CSCD/Options.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>

#include <utility>
#include <vector>

namespace CSCD::test {

/// Can be copied, and not assigned; there are none by default.
template <class Surface>
class Policies_archetype
{
public:
  /// Can be moved only.
  class Packing
  {
  public:
    Packing(const Packing&) = delete;
    Packing& operator=(const Packing&) = delete;
    Packing(Packing&&) = default;
    Packing& operator=(Packing&&) = default;
    ~Packing() = default;

    const std::vector<Index>& packed() const { return m_packed; }

  private:
    friend class Policies_archetype;
    explicit Packing(std::vector<Index> packed) : m_packed(std::move(packed)) {}

    std::vector<Index> m_packed;
  };

  explicit Policies_archetype(Index source) : m_source(source) {}
  Policies_archetype(const Policies_archetype&) = default;
  Policies_archetype& operator=(const Policies_archetype&) = delete;
  ~Policies_archetype() = default;

  /// The separator around one vertex.
  std::vector<Separator> find_separators(const Surface& surface, const Options&, Skeletonization_report& report,
                                         const Progress& progress) const
  {
    report.number_of_sources = 1;
    progress(0.5);
    Separator separator;
    separator.source = m_source;
    for (const Index h : surface.triangulation().outgoing(m_source)) {
      separator.crossings.push_back({h, 0.5});
    }
    return {separator};
  }

  Packing pack_separators(const Surface&, std::vector<Separator>& separators, Skeletonization_report&) const
  {
    return Packing(std::vector<Index>(separators.size(), 0));
  }

  Embedded_skeleton build_skeleton(const Surface& surface, const std::vector<Separator>&, const Packing& packing,
                                   Skeletonization_report&) const
  {
    Embedded_skeleton result;
    const Index node = result.graph.add_node(Vector3(1, 2, 3), double(packing.packed().size()));
    result.radius = {double(packing.packed().size())};
    result.node_of_vertex.assign(surface.triangulation().number_of_vertices(), node);
    return result;
  }

private:
  Index m_source;
};

} // namespace CSCD::test

#endif // CSCD_TEST_ARCHETYPES_POLICIES_ARCHETYPE_H
