// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default algorithms of the pipeline's stages.

#ifndef CSCD_LOCAL_POLICIES_H
#define CSCD_LOCAL_POLICIES_H

#include <CSCD/Options.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/config.h>

#include <memory>
#include <vector>

namespace CSCD {

namespace internal {
class Separator_packing;
}

/// The local policies: a separator is sought on the surface around its source alone, sources cover the surface, and
/// the surface is cut along the packed separators. The default model of `SkeletonizationPolicies`, for
/// `Triangulated_solid`.
class Local_policies
{
public:
  /// The packed separators, and the surface cut along them.
  class Packing
  {
  public:
    /// The packed separators, as positions in the list of all separators, by increasing cost.
    const std::vector<Index>& packed() const;

  private:
    friend class Local_policies;
    std::shared_ptr<const internal::Separator_packing> m_packing;
  };

  /// \param detail how small a limb may be to get a branch
  /// \param node_spacing the length that edges may have where nodes are left out, in radii of the body, see `Options`
  explicit Local_policies(const Detail& detail = Detail(), double node_spacing = 0)
      : m_detail(detail), m_node_spacing(node_spacing)
  {
  }

  /// How small a limb may be to get a branch.
  const Detail& detail() const { return m_detail; }

  /// Seeks separators until they cover the surface, or the bound of `settings` on the number of sources is reached.
  /// It leaves out separators around a hollow.
  std::vector<Separator> find_separators(const Triangulated_solid& solid, const Options& settings,
                                         Skeletonization_report& report, const Progress& progress) const;

  /// Appends separators to `separators` around handles that no source has found.
  Packing pack_separators(const Triangulated_solid& solid, std::vector<Separator>& separators,
                          Skeletonization_report& report) const;

  /// Builds the skeleton of the cut graph.
  Embedded_skeleton build_skeleton(const Triangulated_solid& solid, const std::vector<Separator>& separators,
                                   const Packing& packing, Skeletonization_report& report) const;

private:
  Detail m_detail;
  double m_node_spacing;
};

} // namespace CSCD

#ifndef CSCD_COMPILED
#include <CSCD/Local_policies_impl.h>
#endif

#endif // CSCD_LOCAL_POLICIES_H
