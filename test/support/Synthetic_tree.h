// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees that are known exactly: limbs with axes and radii, and scans of them.

#ifndef CSCD_TEST_SUPPORT_SYNTHETIC_TREE_H
#define CSCD_TEST_SUPPORT_SYNTHETIC_TREE_H

#include "Shape.h"
#include "sampling.h"
#include "shape_operations.h"
#include "swept_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CSCD::test {

/// A limb: its axis from base to tip, which begins on the axis of its parent, and the radii along it.
struct Tree_limb
{
  std::vector<Triple> axis;
  std::vector<double> radii;
  std::optional<std::size_t> parent; ///< none for a trunk
  std::size_t order = 0;             ///< 0 for a trunk, one more than its parent's for any other limb
};

inline double length(const Tree_limb& limb)
{
  double sum = 0;
  for (std::size_t i = 1; i < limb.axis.size(); ++i) {
    sum += norm(limb.axis[i] - limb.axis[i - 1]);
  }
  return sum;
}

/// The parameters of the growth of a tree. Lengths in meters.
struct Tree_settings
{
  unsigned seed = 1;
  double height = 10;
  double radius = 0.2; ///< of the trunk at its base
  std::size_t max_order = 2;
  std::size_t limbs_of_trunk = 9; ///< each limb has about two thirds as many for its length
};

/// Limbs, parents first. Limbs taper by the pipe model: the area of a section is proportional to the total length of
/// the limbs that it carries.
class Synthetic_tree
{
public:
  explicit Synthetic_tree(const Tree_settings& settings) : m_settings(settings), m_random(settings.seed)
  {
    grow({0, 0, 0}, {0, 0, 1}, settings.height, std::nullopt);
    for (std::size_t limb = 0; limb < m_limbs.size(); ++limb) {
      if (m_limbs[limb].order < settings.max_order) {
        branch_off(limb);
      }
    }
    set_radii();
  }
  /// Takes limbs as they are.
  explicit Synthetic_tree(std::vector<Tree_limb> limbs) : m_limbs(std::move(limbs)) {}

  const std::vector<Tree_limb>& limbs() const { return m_limbs; }

  double length() const
  {
    double sum = 0;
    for (const Tree_limb& limb : m_limbs) {
      sum += test::length(limb);
    }
    return sum;
  }

  /// `number` points on the bark, less where it is high up: at the height `h`, `falling` to the power of h in heights
  /// of the tree times as many as at the ground.
  std::vector<Triple> scanned(std::size_t number, double falling, unsigned seed) const
  {
    std::vector<Triple> result;
    std::vector<std::pair<std::size_t, std::size_t>> pieces; // limb, and number of the second end
    std::vector<double> sums;
    double sum = 0;
    double height = 0;
    for (std::size_t limb = 0; limb < m_limbs.size(); ++limb) {
      const Tree_limb& l = m_limbs[limb];
      for (std::size_t i = 1; i < l.axis.size(); ++i) {
        sum += (l.radii[i] + l.radii[i - 1]) * norm(l.axis[i] - l.axis[i - 1]);
        sums.push_back(sum);
        pieces.emplace_back(limb, i);
        height = std::max(height, l.axis[i][2]);
      }
    }
    std::mt19937_64 random(seed);
    while (result.size() < number) {
      const auto found = std::upper_bound(sums.begin(), sums.end() - 1, random_unit(random) * sum);
      const auto [limb, i] = pieces[std::size_t(found - sums.begin())];
      const Triple p = point_on_bark(m_limbs[limb], i, random_unit(random), 2 * pi * random_unit(random));
      if (random_unit(random) < std::pow(falling, p[2] / height) && !is_buried(p, limb)) {
        result.push_back(p);
      }
    }
    return result;
  }

private:
  static Triple any_normal(const Triple& direction)
  {
    return unit(cross(direction, std::abs(direction[2]) < 0.9 ? Triple{0, 0, 1} : Triple{1, 0, 0}));
  }

  static Triple point_on_bark(const Tree_limb& limb, std::size_t i, double t, double angle)
  {
    const Triple& a = limb.axis[i - 1];
    const Triple& b = limb.axis[i];
    const Triple along = unit(b - a);
    const Triple u = any_normal(along);
    const Triple v = cross(along, u);
    const double radius = (1 - t) * limb.radii[i - 1] + t * limb.radii[i];
    return (1 - t) * a + t * b + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }

  /// Whether a point of the bark of one limb lies in another limb that it touches: its parent or a child.
  bool is_buried(const Triple& p, std::size_t limb) const
  {
    for (std::size_t other = 0; other < m_limbs.size(); ++other) {
      if ((m_limbs[other].parent == limb || m_limbs[limb].parent == other) && is_inside(p, m_limbs[other])) {
        return true;
      }
    }
    return false;
  }

  static bool is_inside(const Triple& p, const Tree_limb& limb)
  {
    for (std::size_t i = 1; i < limb.axis.size(); ++i) {
      const Centreline_segment segment{limb.axis[i - 1], limb.axis[i], limb.radii[i - 1], limb.radii[i]};
      if (distance(segment, p) < 0.99 * radius_near(segment, p)) {
        return true;
      }
    }
    return false;
  }

  void grow(const Triple& base, Triple direction, double length, std::optional<std::size_t> parent)
  {
    constexpr std::size_t number_of_pieces = 30;
    Tree_limb limb;
    limb.parent = parent;
    limb.order = parent ? m_limbs[*parent].order + 1 : 0;
    const double crookedness = limb.order == 0 ? 0.02 : 0.06;
    limb.axis.push_back(base);
    for (std::size_t i = 0; i < number_of_pieces; ++i) {
      const Triple bend{random_signed_unit(m_random), random_signed_unit(m_random), random_signed_unit(m_random)};
      // Limbs rise towards their tips.
      direction = unit(direction + crookedness * bend + Triple{0, 0, limb.order == 0 ? 0.0 : 0.015});
      limb.axis.push_back(limb.axis.back() + (length / number_of_pieces) * direction);
    }
    m_limbs.push_back(std::move(limb));
  }

  void branch_off(std::size_t parent)
  {
    const std::size_t order = m_limbs[parent].order + 1;
    const double whole = test::length(m_limbs[parent]);
    const auto number =
        std::size_t(double(m_settings.limbs_of_trunk) * (order == 1 ? 1 : 0.4 + whole / m_settings.height));
    double azimuth = 2 * pi * random_unit(m_random);
    for (std::size_t k = 0; k < number; ++k) {
      const double place = 0.25 + 0.67 * (double(k) + 0.7 * random_unit(m_random)) / double(number);
      const std::vector<Triple>& axis = m_limbs[parent].axis;
      const auto at = std::size_t(place * double(axis.size() - 1));
      const Triple along = unit(axis[at + 1] - axis[at]);
      const Triple u = any_normal(along);
      azimuth += 2.4 + 0.5 * random_signed_unit(m_random); // the golden angle, about
      const double inclination = (55 + 12 * random_signed_unit(m_random)) / 180 * pi;
      const Triple across = std::cos(azimuth) * u + std::sin(azimuth) * cross(along, u);
      const double length = (0.55 + 0.15 * random_signed_unit(m_random)) * (1.15 - place) * whole;
      grow(axis[at], std::cos(inclination) * along + std::sin(inclination) * across, length, parent);
    }
  }

  void set_radii()
  {
    // Children come after their parents.
    std::vector<std::vector<double>> carried(m_limbs.size());
    for (std::size_t limb = m_limbs.size(); limb-- > 0;) {
      const std::vector<Triple>& axis = m_limbs[limb].axis;
      std::vector<double>& of_limb = carried[limb];
      of_limb.resize(axis.size(), 0.);
      for (std::size_t i = axis.size() - 1; i-- > 0;) {
        of_limb[i] += of_limb[i + 1] + norm(axis[i + 1] - axis[i]);
      }
      if (m_limbs[limb].parent) {
        const std::vector<Triple>& parent_axis = m_limbs[*m_limbs[limb].parent].axis;
        const auto at = std::find(parent_axis.begin(), parent_axis.end(), axis.front()) - parent_axis.begin();
        std::vector<double>& of_parent = carried[*m_limbs[limb].parent];
        of_parent.resize(parent_axis.size(), 0.);
        of_parent[std::size_t(at)] += of_limb.front();
      }
    }
    const double unit_of_area = m_settings.radius * m_settings.radius / carried.front().front();
    const double radius_of_tips = 0.02 * m_settings.radius;
    for (std::size_t limb = 0; limb < m_limbs.size(); ++limb) {
      for (double sum : carried[limb]) {
        m_limbs[limb].radii.push_back(std::max(radius_of_tips, std::sqrt(unit_of_area * sum)));
      }
    }
  }

  Tree_settings m_settings;
  std::mt19937_64 m_random;
  std::vector<Tree_limb> m_limbs;
};

/// The `points` that a scanner at `scanner` sees: in every cell of its field of view, as wide as the angle `cell`, the
/// points at most `depth` behind the nearest point.
inline std::vector<Triple> seen_from(const std::vector<Triple>& points, const Triple& scanner, double cell,
                                     double depth)
{
  const auto cell_of = [&](const Triple& p) {
    const Triple d = p - scanner;
    return std::make_pair(std::lround(std::atan2(d[1], d[0]) / cell),
                          std::lround(std::atan2(d[2], std::hypot(d[0], d[1])) / cell));
  };
  std::map<std::pair<long, long>, double> nearest;
  for (const Triple& p : points) {
    double& range = nearest.try_emplace(cell_of(p), std::numeric_limits<double>::max()).first->second;
    range = std::min(range, norm(p - scanner));
  }
  std::vector<Triple> result;
  for (const Triple& p : points) {
    if (norm(p - scanner) <= nearest[cell_of(p)] + depth) {
      result.push_back(p);
    }
  }
  return result;
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_SYNTHETIC_TREE_H
