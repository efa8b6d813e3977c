// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Weighs, prunes and packs separators (3.2.1 to 3.2.3, appendix C), and the regions that belong to them.

#ifndef CSCD_PUBLISHED_REGION_PACKING_H
#define CSCD_PUBLISHED_REGION_PACKING_H

#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Points/Point_complex.h>
#include <CSCD/Published/Field_search_settings.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Vector3.h>
#include <CSCD/input_concepts.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Weighs separators by the balance of the surface on their two sides and by their roundness (section 3.2.1), and
/// prunes those that cut no limb (section 3.2.2). One object serves one thread.
///
/// The published text says that local separators are weighed as Baerentzen and Rotenberg do, by the ratio of the sizes
/// of their two fronts: 1 on a tube, less at its ends and where a limb branches off. The areas of two bands are that
/// for a curve. Roundness is the square root of the isoperimetric quotient; open separators have none.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Balance_and_roundness
{
public:
  Balance_and_roundness(const Surface& surface, Weight_rule rule)
      : m_surface(surface), m_triangulation(surface.triangulation()), m_rule(rule),
        m_crossed(m_triangulation.number_of_halfedges()), m_front(m_triangulation.number_of_vertices())
  {
  }

  /// The weight of `separator`, above 0; except with `shortness` it is at most 1. It is 0 where the separator is
  /// pruned, which is counted in `report`.
  double operator()(const Separator& separator, Skeletonization_report& report)
  {
    const double squared_length = separator.length * separator.length;
    const double width = band_width * separator.length;
    const double min_area = min_area_ratio(separator) * squared_length;
    const Side left = measure(separator, true, width, min_area);
    const Side right = measure(separator, false, width, min_area);
    if (std::min(left.area, right.area) < min_area) {
      ++report.number_of_bumps; // one side is as small as that of a curve around a bump
      return 0;
    }
    curve_points(m_triangulation, separator, m_points);
    // Between the two sides of a sheet there is nothing to be spanned.
    if (!separator.is_open && span_inside_share(m_surface, m_points, separator.center) < min_inside_share) {
      ++report.number_of_tunnels; // the curve does not span the body
      return 0;
    }
    return weight_of_good(separator,
                          std::min(left.band_area, right.band_area) / std::max(left.band_area, right.band_area));
  }

private:
  using Triangulation = std::decay_t<decltype(std::declval<const Surface&>().triangulation())>;

  /// One side of a separator.
  struct Side
  {
    double band_area = 0; ///< of the surface within a distance of the separator
    double area = 0;      ///< of all the surface on this side, or something above a limit
  };

  /// Width of the bands, relative to the length of the separator.
  static constexpr double band_width = 1. / 8;
  /// Least share of the spanned surface that lies inside: bent limbs have 0.8 and more, tunnels about 0.
  static constexpr double min_inside_share = 0.7;

  static double min_area_ratio(const Separator& separator)
  {
    return separator.is_open ? open_area_factor * Detail().min_branch_area_ratio() : Detail::max_loop_area_ratio;
  }

  double weight_of_good(const Separator& separator, double balance) const
  {
    if (m_rule == Weight_rule::shortness) {
      return 1 / separator.length; // coordinates are those of a surface of unit area
    }
    return separator.is_open ? balance : balance * std::sqrt(std::min(1., separator.roundness()));
  }

  /// Measures one side of a separator. The work is that of the surface near it, up to `width` and `limit`.
  /// \param width the distance along edges that bounds the band \param limit where the area need not be counted further
  Side measure(const Separator& separator, bool is_left, double width, double limit)
  {
    m_crossed.clear();
    m_front.clear();
    for (const Edge_crossing& crossing : separator.crossings) {
      m_crossed.mark(edge_of(m_triangulation, crossing.halfedge));
    }
    for (const Edge_crossing& crossing : separator.crossings) {
      // The target of the halfedge lies on the left.
      const Index vertex =
          is_left ? m_triangulation.target(crossing.halfedge) : m_triangulation.origin(crossing.halfedge);
      const double part = is_left ? 1 - crossing.position : crossing.position;
      m_front.reach(vertex, float(part * m_triangulation.length(crossing.halfedge)));
    }
    Side side = spread(width, limit);
    if (separator.is_open) {
      side.area += (is_left ? 1 : -1) * missing_on_left(separator);
    }
    return side;
  }

  /// What the faces that `separator` cuts have on its left beyond what their vertices there stand for, a third each. In
  /// corners of sheets, this is most of the area.
  double missing_on_left(const Separator& separator) const
  {
    double result = 0;
    for (std::size_t i = 0; i < separator.crossings.size(); ++i) {
      const Edge_crossing& a = separator.crossings[i];
      const Edge_crossing& b = separator.crossings[i + 1 < separator.crossings.size() ? i + 1 : 0];
      const bool is_corner_left = m_triangulation.target(a.halfedge) == m_triangulation.target(b.halfedge);
      const auto end = [&](const Edge_crossing& crossing, bool is_corner) {
        return m_triangulation.points()[is_corner == is_corner_left ? m_triangulation.target(crossing.halfedge)
                                                                    : m_triangulation.origin(crossing.halfedge)];
      };
      const Vector3& corner = end(a, true);
      const double area = triangle_area(corner, end(a, false), end(b, false));
      const double part_at_corner = is_corner_left ? (1 - a.position) * (1 - b.position) : a.position * b.position;
      result += area * (is_corner_left ? part_at_corner - 1. / 3 : 1. / 3 - part_at_corner);
    }
    return result;
  }

  Side spread(double width, double limit)
  {
    Side side;
    m_front.spread([&](Index vertex, float distance) {
      const double area = double(m_triangulation.vertex_area(vertex));
      side.area += area;
      // The part of the vertex that is in the band, as if it was a square along it.
      const double extent = std::sqrt(area);
      const double from = std::max(double(distance) - extent / 2, 0.);
      const double to = std::min(double(distance) + extent / 2, width);
      side.band_area += std::max(to - from, 0.) * extent;
      if (from > width && side.area > limit) {
        return;
      }
      for (Index halfedge : m_triangulation.outgoing(vertex)) {
        if (!m_crossed.is_marked(edge_of(m_triangulation, halfedge))) {
          m_front.reach(m_triangulation.target(halfedge), distance + float(m_triangulation.length(halfedge)));
        }
      }
    });
    return side;
  }

  const Surface& m_surface;
  const Triangulation& m_triangulation;
  Weight_rule m_rule;
  Epoch_marks m_crossed;
  Dijkstra_search m_front;
  std::vector<Vector3> m_points;
};

/// The end of the crossed edge that `crossing` is closer to; in the middle, the same one in either direction.
template <class Surface>
Index nearest_vertex(const Surface& surface, const Edge_crossing& crossing)
{
  const Index edge = edge_of(surface, crossing.halfedge);
  const double position = edge == crossing.halfedge ? crossing.position : 1 - crossing.position;
  return position < 0.5 ? surface.origin(edge) : surface.target(edge);
}

/// Whether the segments from `a` to `b` and from `c` to `d` meet, which are given by barycentric coordinates: by
/// equations 7 and 8 of appendix C, and where the lines are parallel, if they are one and the segments have a point in
/// common.
inline bool do_segments_meet(const std::array<double, 2>& a, const std::array<double, 2>& b,
                             const std::array<double, 2>& c, const std::array<double, 2>& d)
{
  // Of areas in barycentric coordinates: rounding errors.
  constexpr double tolerance = 1e-12;
  const auto turn = [](const std::array<double, 2>& p, const std::array<double, 2>& q, const std::array<double, 2>& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  const double denominator = (a[0] - b[0]) * (d[1] - c[1]) - (d[0] - c[0]) * (a[1] - b[1]);
  if (std::abs(denominator) > tolerance) {
    const double first = (a[0] * (d[1] - c[1]) + c[0] * (a[1] - d[1]) + d[0] * (c[1] - a[1])) / denominator;
    const double second = (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1])) / denominator;
    return first >= 0 && first <= 1 && second >= 0 && second <= 1;
  }
  if (std::abs(turn(a, b, c)) > tolerance || std::abs(turn(c, d, a)) > tolerance) {
    return false;
  }
  const auto overlap = [&](std::size_t k) {
    return std::max(std::min(a[k], b[k]), std::min(c[k], d[k])) <= std::min(std::max(a[k], b[k]), std::max(c[k], d[k]));
  };
  return overlap(0) && overlap(1);
}

/// The pairs of separators that overlap: both pass closest to the same vertex, or overlap as `Overlap_rule` says.
///
/// The pairs that pass closest to the same vertex include all pairs that cross in a face (appendix C). For let a chord
/// cut the corner c off a face with the other corners x and y, and cross another chord: this one has one end on c's
/// side, say on the edge to x. If the first chord meets this edge nearer to c than to x, both pass closest to c; if it
/// meets it nearer to x, and so does the second one, both pass closest to x. If the second one alone is nearer to c,
/// the first one passes closest to c too, on the edge to y, or passes closest to both x and y; and the other end of the
/// second one, which is not on c's side, is nearest to one of these. Parallel lines, vertices and edges need no special
/// treatment. Separators that coincide, and so do not cross, overlap too. And each separator of a set without overlaps
/// has a closed ring of vertices of its own: its part of the surface is never empty and always connected.
/// \tparam Surface a model of `SurfaceTriangulation`, a `Point_complex` or a `Spatial_graph`
template <class Surface>
class Separator_overlaps
{
public:
  /// Lists the separators that pass each vertex and, where they overlap by crossing, each face; linear in the number of
  /// crossings.
  /// \param surface whose edges the separators cross; as `separators`, it is referred to
  /// \param rule with `crossing`, only separators that meet overlap: in a face, or at a vertex that both pass through
  /// \pre `rule` is not `crossing` on a surface without faces
  Separator_overlaps(const Surface& surface, const std::vector<Separator>& separators, Overlap_rule rule)
      : m_surface(surface), m_separators(separators), m_rule(rule), m_found(separators.size())
  {
    CGAL_precondition(has_faces || rule != Overlap_rule::crossing);
    m_at_vertex = Compressed_rows<Index, std::size_t>(surface.number_of_vertices(), [this](const auto& add) {
      for (Index i = 0; i < m_separators.size(); ++i) {
        for_each_vertex(i, [&](Index vertex) { add(vertex, i); });
      }
    });
    if constexpr (has_faces) {
      if (rule == Overlap_rule::crossing) {
        m_in_face = Compressed_rows<Pass, std::size_t>(surface.number_of_faces(), [this](const auto& add) {
          for (Index i = 0; i < m_separators.size(); ++i) {
            for (Index k = 0; k < m_separators[i].crossings.size(); ++k) {
              add(Surface::face(m_separators[i].crossings[k].halfedge), Pass{i, k});
            }
          }
        });
      }
    }
  }

  /// The separators that overlap `separator`, in ascending order, until the next call. Linear in the number of
  /// crossings that pass the same vertices or faces, so that pairs take no memory.
  const std::vector<Index>& others(Index separator)
  {
    m_others.clear();
    m_found.clear();
    m_found.mark(separator);
    for_each_vertex(separator, [this](Index vertex) {
      for (const Index other : m_at_vertex[vertex]) {
        add(other);
      }
    });
    if constexpr (has_faces) {
      for (Index k = 0; m_rule == Overlap_rule::crossing && k < m_separators[separator].crossings.size(); ++k) {
        const auto [begin, end] = chord({separator, k});
        for (const Pass& pass : m_in_face[Surface::face(m_separators[separator].crossings[k].halfedge)]) {
          const auto [other_begin, other_end] = chord(pass);
          if (!m_found.is_marked(pass.separator) && do_segments_meet(begin, end, other_begin, other_end)) {
            add(pass.separator);
          }
        }
      }
    }
    std::sort(m_others.begin(), m_others.end());
    return m_others;
  }

private:
  static constexpr bool has_faces = CSCD_IS_VALID(const Surface&, std::decay_t<decltype(t)>::face(Index()));

  /// The piece of a separator that ends at a crossing.
  struct Pass
  {
    Index separator;
    Index crossing;
  };

  void add(Index other)
  {
    if (m_found.mark(other)) {
      m_others.push_back(other);
    }
  }

  /// Calls `use(vertex)` for the vertices that `separator` passes closest to or, by the rule of crossings, that it
  /// passes through; once for consecutive crossings.
  template <class Use>
  void for_each_vertex(Index separator, const Use& use) const
  {
    Index last = no_index;
    for (const Edge_crossing& crossing : m_separators[separator].crossings) {
      const Index vertex = nearest_vertex(m_surface, crossing);
      if ((m_rule == Overlap_rule::nearest_vertex ||
           std::min(crossing.position, 1 - crossing.position) <= vertex_offset) &&
          vertex != last) {
        use(vertex);
        last = vertex;
      }
    }
  }

  /// Two barycentric coordinates of each end of a piece.
  std::array<std::array<double, 2>, 2> chord(const Pass& pass) const
  {
    const auto coordinates = [](Index side, double position) {
      std::array<double, 3> weights{};
      weights[side] = 1 - position;
      weights[(side + 1) % 3] = position;
      return std::array<double, 2>{weights[0], weights[1]};
    };
    const std::vector<Edge_crossing>& crossings = m_separators[pass.separator].crossings;
    const Edge_crossing& before = pass.crossing > 0 ? crossings[pass.crossing - 1] : crossings.back();
    const Edge_crossing& here = crossings[pass.crossing];
    return {coordinates(m_surface.twin(before.halfedge) % 3, 1 - before.position),
            coordinates(here.halfedge % 3, here.position)};
  }

  const Surface& m_surface;
  const std::vector<Separator>& m_separators;
  Overlap_rule m_rule;
  Compressed_rows<Index, std::size_t> m_at_vertex; ///< of every vertex, the separators that pass it
  Compressed_rows<Pass, std::size_t> m_in_face;    ///< of every face, by the rule of crossings
  Epoch_marks m_found;                             ///< of the separators
  std::vector<Index> m_others;                     ///< of the separator that was asked for
};

/// Packs separators that do not overlap, greedily (section 3.2.3): first those whose weight is large against the
/// weights of all that they would exclude, w / (1 + sum of the w of its overlaps), as Baerentzen and Rotenberg order
/// local separators.
/// \param weights for each separator, how good it is; those of weight 0 are not packed
/// \return the packed separators, the first packed first; equal ones in the order of their numbers
template <class Surface>
std::vector<Index> pack_by_overlap(Separator_overlaps<Surface> overlaps, const std::vector<double>& weights)
{
  const std::size_t size = weights.size();
  std::vector<double> order_weight(size, 0);
  std::vector<Index> order;
  for (Index i = 0; i < size; ++i) {
    if (!(weights[i] > 0)) {
      continue;
    }
    double excluded = 0;
    for (Index other : overlaps.others(i)) {
      excluded += weights[other];
    }
    order_weight[i] = weights[i] / (1 + excluded);
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return order_weight[a] > order_weight[b]; });
  std::vector<std::uint8_t> is_packed(size, 0);
  std::vector<Index> packed;
  for (Index i : order) {
    const std::vector<Index>& others = overlaps.others(i);
    if (std::none_of(others.begin(), others.end(), [&](Index other) { return is_packed[other] != 0; })) {
      is_packed[i] = 1;
      packed.push_back(i);
    }
  }
  return packed;
}

/// The connected parts of regions: edges within a region join their ends. Near linear.
/// \param region returns the region of a vertex
template <class Surface, class Region>
Disjoint_sets parts_of_regions(const Surface& surface, const Region& region)
{
  Disjoint_sets result(surface.number_of_vertices());
  for (Index h = 0; h < surface.number_of_halfedges(); ++h) {
    if (region(surface.origin(h)) == region(surface.target(h))) {
      result.join(surface.origin(h), surface.target(h));
    }
  }
  return result;
}

/// Assigns every vertex to the packed separator that is nearest along the edges (Alg. 2, line 12). Each separator
/// starts from the ring of vertices that it passes closest to; so its region is connected and never empty. A component
/// of the surface without any separator is a region of its own.
class Separator_regions
{
public:
  /// Computes the regions of the separators `packed` of the list `separators`; O(n log n).
  /// \param surface whose edges the separators cross
  /// \param rule with `nearest_vertex`, separators start from the vertices that they pass closest to; with `crossing`,
  ///        from both ends of each crossed edge, at their distances: a region can then have no vertex, or not be
  ///        connected
  /// \pre no two of the packed separators overlap by `rule`
  template <class Surface>
  Separator_regions(const Surface& surface, const std::vector<Separator>& separators, const std::vector<Index>& packed,
                    Overlap_rule rule = Overlap_rule::nearest_vertex)
      : m_front(surface.number_of_vertices()), m_size(Index(packed.size()))
  {
    const auto for_each_neighbor = [&surface](Index vertex, const auto& visit) {
      for (const Index halfedge : surface.outgoing(vertex)) {
        visit(surface.target(halfedge), float(surface.length(halfedge)));
      }
    };
    for (Index i = 0; i < packed.size(); ++i) {
      for (const Edge_crossing& crossing : separators[packed[i]].crossings) {
        if (rule == Overlap_rule::nearest_vertex) {
          m_front.reach(nearest_vertex(surface, crossing), 0, i);
        } else {
          const auto length = float(surface.length(crossing.halfedge));
          m_front.reach(surface.origin(crossing.halfedge), float(crossing.position) * length, i);
          m_front.reach(surface.target(crossing.halfedge), float(1 - crossing.position) * length, i);
        }
      }
    }
    m_front.spread(for_each_neighbor);
    for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
      if (m_front.label(vertex) == no_index) {
        m_front.reach(vertex, 0, m_size++);
        m_front.spread(for_each_neighbor);
      }
    }
  }

  /// The number of regions: first those of the packed separators, in their order, then those of components without any.
  Index size() const { return m_size; }
  /// The region of `vertex`.
  Index operator[](Index vertex) const { return m_front.label(vertex); }
  /// Whether a separator passes closest to `vertex`.
  bool is_on_separator(Index vertex) const { return m_front.distance(vertex) == 0; }

private:
  Multi_source_dijkstra_search m_front;
  Index m_size;
};

/// Packed separators, and the regions of the surface that are nearest to them or the surface cut along them.
class Region_packing
{
public:
  /// Packs the `separators` at the positions `packed`; no two of these overlap by `rule`.
  template <class Surface>
  Region_packing(const Surface& surface, const std::vector<Separator>& separators, std::vector<Index> packed,
                 Overlap_rule rule = Overlap_rule::nearest_vertex)
      : m_packed(std::move(packed)), m_regions(std::in_place, surface.triangulation(), separators, m_packed, rule)
  {
  }
  /// Packs the separators that `packing` has packed, with the surface that it has cut.
  explicit Region_packing(const Separator_packing& packing)
      : m_packed(packing.packed()), m_cut_graph(packing.cut_graph())
  {
  }

  /// The packed separators, as positions in the list of all separators, the first packed first.
  const std::vector<Index>& packed() const { return m_packed; }
  /// The surface cut along them, or none.
  const std::optional<Cut_graph>& cut_graph() const { return m_cut_graph; }
  /// \pre the surface is not cut
  const Separator_regions& regions() const { return *m_regions; }

  /// Weighs, prunes and packs `separators` by the rules of `settings`; counts in `report`.
  /// \return the packed ones, as positions, the first packed first
  /// \pre among points, separators are not tested for crossings
  /// \tparam Surface a model of `SkeletonizationSurface`
  template <class Surface>
  static std::vector<Index> pack(const Surface& surface, const std::vector<Separator>& separators,
                                 const Field_search_settings& settings, Skeletonization_report& report)
  {
    Balance_and_roundness<Surface> weigh(surface, settings.weight_rule);
    std::vector<double> weights;
    weights.reserve(separators.size());
    report.number_of_bumps = 0;
    report.number_of_tunnels = 0;
    for (const Separator& separator : separators) {
      weights.push_back(weigh(separator, report));
    }
    const auto& triangulation = surface.triangulation();
    if constexpr (!std::is_same_v<std::decay_t<decltype(triangulation)>, Point_complex>) {
      drop_self_crossings(triangulation, separators, weights);
    }
    std::vector<Index> packed =
        pack_by_overlap(Separator_overlaps(triangulation, separators, settings.overlap_rule), weights);
    if constexpr (!std::is_same_v<std::decay_t<decltype(triangulation)>, Point_complex>) {
      if (settings.overlap_rule == Overlap_rule::crossing) {
        return resolved(triangulation, separators, std::move(packed));
      }
    }
    return packed;
  }

private:
  /// Sets the weights of separators that cross themselves in a face to 0. Linear in the number of crossings.
  template <class Triangulation>
  static void drop_self_crossings(const Triangulation& surface, const std::vector<Separator>& separators,
                                  std::vector<double>& weights)
  {
    Separator_arrangement_on<Triangulation> arrangement(surface);
    for (Index i = 0; i < separators.size(); ++i) {
      arrangement.clear();
      if (!arrangement.insert(i, separators[i].crossings)) {
        weights[i] = 0;
      }
    }
  }

  /// The separators of `packed` that the vertices resolve; no two of `packed` cross. Where several run between the same
  /// vertices, the regions of the inner ones have no vertices or fall into pieces, which would make cycles: the inner
  /// ones are dropped. O(n log n) for n vertices, times the number of rounds until all regions are connected.
  template <class Triangulation>
  static std::vector<Index> resolved(const Triangulation& surface, const std::vector<Separator>& separators,
                                     std::vector<Index> packed)
  {
    std::vector<Index> kept;
    for (;;) {
      const Separator_regions regions(surface, separators, packed, Overlap_rule::crossing);
      Disjoint_sets parts = parts_of_regions(surface, [&regions](Index vertex) { return regions[vertex]; });
      std::vector<Index> number_of_parts(regions.size(), 0);
      for (Index vertex = 0; vertex < surface.number_of_vertices(); ++vertex) {
        number_of_parts[regions[vertex]] += parts.find(vertex) == vertex ? 1 : 0;
      }
      kept.clear();
      for (std::size_t i = 0; i < packed.size(); ++i) {
        if (number_of_parts[i] == 1) {
          kept.push_back(packed[i]);
        }
      }
      if (kept.size() == packed.size()) {
        return packed;
      }
      packed.swap(kept);
    }
  }

  std::vector<Index> m_packed;
  std::optional<Separator_regions> m_regions;
  std::optional<Cut_graph> m_cut_graph;
};

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_REGION_PACKING_H
