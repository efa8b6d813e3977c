// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of the separators that overlap are packed, by their costs, without bumps, and the surface nearest to each.

#ifndef CSCD_PACKING_SEPARATOR_PACKING_H
#define CSCD_PACKING_SEPARATOR_PACKING_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace CSCD::internal {

/// The cost of `separator`, a length: of two separators that overlap, the one of lower cost is packed. Prefers short,
/// planar separators.
inline double separator_cost(const Separator& separator)
{
  // A deviation from a plane by a quarter of the length counts as twice the length.
  constexpr double planarity_factor = 4;
  return separator.length * (1 + planarity_factor * separator.planarity);
}

/// Finds the branches of a cut graph that stand on no limb, and the ends of branches that lead into a corner of the
/// body.
///
/// A corner of a box or a plank is not a limb, although loops surround it. Its separators cut off less, relative to
/// their squared length, than those of a limb, and they turn aside from the branch.
class Spurious_branches
{
public:
  /// Seeks them in `cut_graph`, the surface cut along the separators `packed` of the list `separators`; linear.
  /// \param min_area_ratio a branch stands on a limb if one of its separators cuts off at least this area, relative to
  ///        its squared length
  Spurious_branches(const Cut_graph& cut_graph, const std::vector<Separator>& separators,
                    const std::vector<Index>& packed, double min_area_ratio)
      : m_cut_graph(cut_graph), m_separators(separators), m_packed(packed), m_min_area_ratio(min_area_ratio)
  {
    for (Index tip = 0; tip < cut_graph.pieces().size(); ++tip) {
      if (cut_graph.pieces()[tip].separators.size() == 1) {
        const Index junction = walk_branch(tip);
        if (junction != no_index && (!is_limb(1) || is_corner() || is_flange(junction))) {
          ban(m_branch.size());
        } else {
          ban(number_of_steps_into_corner());
        }
      }
    }
  }

  /// The separators of the bumps, as positions in the list of all separators.
  const std::vector<Index>& separators() const { return m_bumps; }

private:
  /// The area that a separator around a corner may cut off, relative to the least of a limb. A corner of a plank cuts
  /// off up to 0.137 of the squared length, which is 1.37 times the least by default.
  static constexpr double corner_factor = 1.4;
  /// The cosine of the angle between the normals of a separator into a corner and of the last one before is at most
  /// this. Of 0.90 to 0.97, bars and prisms were the straighter the larger it was.
  static constexpr double max_corner_cosine = 0.97;
  /// A separator across a bar that reaches from the corner beyond the opposite edge cuts off up to this factor, ...
  static constexpr double oblique_factor = 1.7;
  /// ... and the cosine of the angle to the next one is at most this.
  static constexpr double max_oblique_cosine = 0.9;
  /// Across a ball behind a neck, circles in any direction are separators: they are at least this round, ...
  static constexpr double min_roundness_of_ball = 0.97;
  /// ... and cut off up to this factor. With 2.4, more dumbbells bend; with 20, the same ones as with this.
  static constexpr double ball_factor = 4;
  /// Some separator of a branch into the corner of a plank, or across a flange, is at most this round, less than a
  /// square, and separators around low limbs are rounder.
  static constexpr double max_roundness_of_plank = 0.77;
  /// Some separator of a branch into the corner of a bar, or across a flange as thick as its radius, is at most this
  /// round, and toes are rounder, ...
  static constexpr double max_roundness_of_bar = 0.8;
  /// ... and cuts off up to 1.225 times the least area of a limb, by default; around low limbs, 1.31 times.
  static constexpr double bar_corner_factor = 1.25;
  /// Across a flange next to a thin shaft, a separator cuts off up to this factor. Of 1.6 to 2.5, the same skeletons of
  /// 300 shafts, and a half disc has 1.96.
  static constexpr double flange_factor = 1.6;
  /// It is longer than the separators of the shaft by at least this factor; 1.2 gives the same skeletons ...
  static constexpr double flange_length = 1.5;
  /// ... and less round, as a rectangle is. Separators around the body of a cup are rounder, and longer than those of
  /// its handle.
  static constexpr double max_roundness_of_flange = 0.9;

  /// A packed separator of a branch and the area between it and the tip.
  struct Step
  {
    Index separator;
    double area_beyond;
  };

  /// Walks the branch that starts at the tip `piece`. \return the junction where it ends, or `no_index`
  Index walk_branch(Index piece)
  {
    m_branch.clear();
    double area = 0;
    Index separator = m_cut_graph.pieces()[piece].separators.front();
    while (true) {
      area += m_cut_graph.pieces()[piece].area;
      m_branch.push_back({separator, area});
      piece = m_cut_graph.sides(separator).other(piece);
      const std::vector<Index>& around = m_cut_graph.pieces()[piece].separators;
      if (around.size() != 2) {
        return around.size() > 2 ? piece : Index(no_index);
      }
      separator = around[0] == separator ? around[1] : around[0];
    }
  }

  /// Bans the first steps of the branch.
  void ban(std::size_t number_of_steps)
  {
    for (std::size_t i = 0; i < number_of_steps; ++i) {
      m_bumps.push_back(m_packed[m_branch[i].separator]);
    }
  }

  bool is_limb(double factor) const { return number_of_weak_steps(factor) < m_branch.size(); }

  /// Whether the branch is as weak and as flat as branches into the corners of a plank or a table, and as those across
  /// the flange of a shaft, which sticks out all around.
  bool is_corner() const
  {
    double roundness = 1;
    for (const Step& step : m_branch) {
      roundness = std::min(roundness, separator(step).roundness());
    }
    return (roundness < max_roundness_of_plank && !is_limb(corner_factor)) ||
           (roundness < max_roundness_of_bar && !is_limb(bar_corner_factor));
  }

  /// Whether the branch is weak and much thicker than all that passes through its `junction`, as across a flange.
  bool is_flange(Index junction) const
  {
    const Separator& last = separator(m_branch.back());
    if (is_limb(flange_factor) || last.roundness() > max_roundness_of_flange) {
      return false;
    }
    double longest = 0;
    for (const Index around : m_cut_graph.pieces()[junction].separators) {
      const Index beyond = m_cut_graph.sides(around).other(junction);
      if (around != m_branch.back().separator && m_cut_graph.pieces()[beyond].separators.size() > 1) { // not to a tip
        longest = std::max(longest, m_separators[m_packed[around]].length);
      }
    }
    return longest > 0 && last.length > flange_length * longest;
  }

  /// The number of steps before the first one that cuts off `factor` times the least area of a limb.
  std::size_t number_of_weak_steps(double factor) const
  {
    const auto is_strong = [&](const Step& step) { return cuts_off(step, factor); };
    return std::size_t(std::find_if(m_branch.begin(), m_branch.end(), is_strong) - m_branch.begin());
  }

  /// The number of steps at the end of a limb that lead into a corner: steps on no limb by themselves, and steps before
  /// the first strong one if one of them turns aside from that.
  std::size_t number_of_steps_into_corner() const
  {
    if (separator(m_branch.front()).is_open) {
      return number_of_weak_steps(1);
    }
    std::size_t first_strong = number_of_weak_steps(corner_factor);
    while (first_strong + 1 < m_branch.size() && !cuts_off(m_branch[first_strong], factor_if_oblique(first_strong)) &&
           cosine(first_strong, first_strong + 1) < max_oblique_cosine) {
      ++first_strong;
    }
    if (first_strong < m_branch.size()) {
      for (std::size_t i = 0; i < first_strong; ++i) {
        if (cosine(i, first_strong) < max_corner_cosine) {
          return first_strong;
        }
      }
    }
    const std::size_t first_of_limb = number_of_weak_steps(1);
    return first_of_limb < m_branch.size() ? first_of_limb : 0;
  }

  /// The largest factor at which step `i` is oblique if it turns aside.
  double factor_if_oblique(std::size_t i) const
  {
    return separator(m_branch[i]).roundness() > min_roundness_of_ball ? ball_factor : oblique_factor;
  }

  /// The cosine of the angle between the planes of two steps.
  double cosine(std::size_t a, std::size_t b) const
  {
    return std::abs(separator(m_branch[a]).normal.dot(separator(m_branch[b]).normal));
  }

  bool cuts_off(const Step& step, double factor) const
  {
    const double length = separator(step).length;
    const double open_factor = separator(step).is_open ? open_area_factor : 1;
    return step.area_beyond >= open_factor * factor * m_min_area_ratio * length * length;
  }

  const Separator& separator(const Step& step) const { return m_separators[m_packed[step.separator]]; }

  const Cut_graph& m_cut_graph;
  const std::vector<Separator>& m_separators;
  const std::vector<Index>& m_packed;
  double m_min_area_ratio;
  std::vector<Step> m_branch;
  std::vector<Index> m_bumps;
};

/// Greedy weighted set packing of separators (section 3.2.3): the cheaper one of two that overlap is kept.
class Disjoint_separators
{
public:
  /// Prepares to pack `separators`; both the surface and the separators are referred to.
  Disjoint_separators(const Triangulated_surface& surface, const std::vector<Separator>& separators)
      : m_separators(separators), m_arrangement(surface), m_order(all_indices(separators.size()))
  {
    // Costs are compared in single precision, so that rounding does not order equal ones.
    std::stable_sort(m_order.begin(), m_order.end(), [&](Index a, Index b) {
      return float(separator_cost(separators[a])) < float(separator_cost(separators[b]));
    });
  }

  /// Packs anew, from the separators that satisfy `is_allowed(separator)`.
  template <class Predicate>
  void pack(const Predicate& is_allowed)
  {
    m_packed.clear();
    m_packed_along.clear();
    m_arrangement.clear();
    for (Index separator : m_order) {
      if (is_allowed(separator) && is_spaced(separator)) {
        insert(separator);
      }
    }
  }

  /// Packs `separator` too if it crosses neither a packed one nor itself. \return whether it was packed
  bool insert(Index separator)
  {
    const bool is_inserted = m_arrangement.insert(separator, m_separators[separator].crossings);
    if (is_inserted) {
      m_packed.push_back(separator);
      m_packed_along.emplace(place_along(m_separators[separator].center), separator);
    }
    return is_inserted;
  }

  /// The packed separators, as positions in the list of all separators, in the order of packing.
  const std::vector<Index>& packed() const { return m_packed; }
  const Separator_arrangement& arrangement() const { return m_arrangement; }
  /// Makes room between crossings at the same position.
  void spread_crossings() { m_arrangement.spread_points(); }

private:
  /// The centers of packed separators keep this distance, relative to the radius of the shorter one.
  static constexpr double min_spacing = 0.3;

  /// The coordinate along an axis of unit length that is oblique to most models, so that few centers have the same.
  static double place_along(const Vector3& point) { return point.dot(Vector3(0.42, 0.56, 0.71)); }

  /// Whether `candidate` keeps its distance from all that are packed; these are compared with it if they are as near
  /// along the axis.
  bool is_spaced(Index candidate) const
  {
    const Separator& a = m_separators[candidate];
    const auto is_far = [&](const auto& packed) {
      const Separator& b = m_separators[packed.second];
      const double distance = min_spacing * std::min(a.radius(), b.radius());
      return (a.center - b.center).squaredNorm() >= distance * distance;
    };
    const double place = place_along(a.center);
    const double reach = min_spacing * a.radius();
    return std::all_of(m_packed_along.lower_bound(place - reach), m_packed_along.upper_bound(place + reach), is_far);
  }

  const std::vector<Separator>& m_separators;
  Separator_arrangement m_arrangement;
  std::vector<Index> m_order;
  std::vector<Index> m_packed;
  std::multimap<double, Index> m_packed_along; ///< the packed separators by the places of their centers
};

/// Greedy weighted set packing of separators (section 3.2.3), followed by pruning: the separators of a branch that no
/// limb stands on are banned, and the remaining ones are packed again.
class Separator_packing : public Disjoint_separators
{
public:
  /// Packs `separators`: the cheaper one of two that overlap is kept.
  /// \param min_branch_area_ratio see `Spurious_branches`
  Separator_packing(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                    double min_branch_area_ratio = Detail().min_branch_area_ratio())
      : Disjoint_separators(surface, separators), m_surface(surface)
  {
    std::vector<char> is_allowed(separators.size(), 1);
    for (int round = 1;; ++round) {
      pack([&](Index separator) { return is_allowed[separator] != 0; });
      cut_again();
      const Spurious_branches bumps(cut_graph(), separators, packed(), min_branch_area_ratio);
      if (bumps.separators().empty()) {
        break;
      }
      if (round >= max_packings) {
        is_allowed.assign(separators.size(), 0);
        for (Index separator : packed()) {
          is_allowed[separator] = 1;
        }
      }
      for (Index separator : bumps.separators()) {
        is_allowed[separator] = 0;
      }
    }
  }

  /// Packs the `separators` at the positions `packed` except those that cross an earlier one.
  Separator_packing(const Triangulated_surface& surface, const std::vector<Separator>& separators,
                    const std::vector<Index>& packed)
      : Disjoint_separators(surface, separators), m_surface(surface)
  {
    for (Index separator : packed) {
      insert(separator);
    }
    cut_again();
  }

  /// The surface cut along the packed separators, as they were when it was cut last.
  const Cut_graph& cut_graph() const { return *m_cut_graph; }

  /// Cuts the surface along all packed separators, including the ones inserted last.
  void cut_again() { m_cut_graph.emplace(m_surface, arrangement()); }

private:
  /// Separators that replace pruned ones may have to be pruned again. After this many packings, nothing takes their
  /// place any more, so that pruning comes to an end.
  static constexpr int max_packings = 2;

  const Triangulated_surface& m_surface;
  std::optional<Cut_graph> m_cut_graph;
};

/// Assigns every vertex to the separator that is nearest along the edges (Dijkstra from all separators at once). Runs
/// on a level where separators are several vertices apart.
class Surface_regions
{
public:
  /// Computes the regions of the separators `packed` of the list `separators`; O(n log n).
  Surface_regions(const Surface_levels& levels, const std::vector<Separator>& separators,
                  const std::vector<Index>& packed)
      : m_level(levels[levels.finest_with_at_most(rough_size)]), m_front(m_level.surface.number_of_vertices())
  {
    const Triangulated_surface& finest = levels.finest().surface;
    const Vertex_fan_table& corners = m_level.corners();
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        for (const Index end : {finest.origin(crossing.halfedge), finest.target(crossing.halfedge)}) {
          const Index vertex = m_level.from_finest(end);
          const Vector3 way = m_level.surface.point(vertex) - crossing_point(finest, crossing);
          if (m_front.reach(vertex, float(way.norm()), i)) {
            corners.prefetch(vertex);
          }
        }
      }
    }
    m_front.spread([&corners](Index vertex, const auto& visit) {
      for (const Corner& corner : corners.neighbors(vertex)) {
        if (visit(corner.neighbor, corner.length)) {
          corners.prefetch(corner.neighbor);
        }
      }
    });
  }

  /// The position of the packed separator nearest to a vertex of the finest level; `no_index` where a component has
  /// none.
  Index separator(Index vertex) const { return m_front.label(m_level.from_finest(vertex)); }
  /// The distance from it, infinite without one.
  float distance(Index vertex) const { return m_front.distance(m_level.from_finest(vertex)); }

private:
  /// Vertices of a level that is precise enough to find the nearest separator.
  static constexpr Index rough_size = 16000;

  const Surface_level& m_level;
  Multi_source_dijkstra_search m_front;
};

} // namespace CSCD::internal

#endif // CSCD_PACKING_SEPARATOR_PACKING_H
