// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects loops of all kinds and chooses among them.

#include "Application/Loop_classes.h"
#include "Measure/skeleton_tools.h"
#include <CSCD/Application/find_surface_loops.h>
#include <CSCD/Local/Covering_search.h>
#include <CSCD/Local/Local_separator_finder.h>
#include <CSCD/Options.h>
#include <CSCD/Packing/Cut_graph.h>
#include <CSCD/Packing/Separator_packing.h>
#include <CSCD/Packing/cut_handles.h>
#include <CSCD/Published/Edge_flip_shortening.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Published/Surface_path.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Skeletonization_report.h>
#include <CSCD/Surface/Normalization.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/flat_arrays.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CSCD::internal {

namespace {

/// The lengths of the curves parallel to a closed curve that separates a surface.
class Parallel_curves
{
public:
  explicit Parallel_curves(const Triangulated_surface& surface)
      : m_surface(surface), m_front(surface.number_of_vertices()), m_height(surface.number_of_vertices()),
        m_is_listed(surface.number_of_faces()), m_is_passed(surface.number_of_faces())
  {
  }

  /// By how much the curve must get longer if it is to move away to either side, see `Surface_loop::depth`.
  /// O(k log k) for the k vertices within reach.
  double depth(const Surface_path& curve)
  {
    const double step = curve.length / boost::math::double_constants::pi / levels_per_diameter;
    measure_distances(curve, number_of_levels * step);
    return std::max(std::min(climb(curve.length, step), climb(curve.length, -step)) / curve.length - 1, 0.);
  }

private:
  /// Parallel curves are measured at so many distances in a diameter of the curve, `length / pi`, ...
  static constexpr int levels_per_diameter = 8;
  /// ... and so many on either side: up to three diameters, what a hand is longer than its wrist is wide.
  static constexpr int number_of_levels = 3 * levels_per_diameter;
  /// Of these, so many must be one curve, or have a piece as long: half a diameter. Loops that cut off several limbs at
  /// once, such as an arm together with the head, come apart before.
  static constexpr int min_levels = levels_per_diameter / 2;
  /// Relative to the length of the curve: a parallel curve shorter by more is beyond what makes the constriction. Less
  /// comes of measuring distances along triangles.
  static constexpr double tolerance = 0.02;

  /// The length of the longest parallel curve on one side, before they get shorter than the curve or come apart; 0 if
  /// they soon do.
  /// \param step from one parallel curve to the next, positive on the left
  double climb(double length, double step)
  {
    double longest = 0;
    for (int level = 1; level <= number_of_levels; ++level) {
      m_is_passed.clear();
      double piece = 0; // the longest one
      for (const Index face : m_faces) {
        piece = std::max(piece, piece_length(face, level * step));
      }
      if (piece < (1 - tolerance) * length) {
        return level > min_levels ? longest : 0;
      }
      longest = std::max(longest, piece);
    }
    return longest;
  }

  /// Distances from `curve` of all vertices up to `reach`, and of those beyond next to them.
  void measure_distances(const Surface_path& curve, double reach)
  {
    m_front.clear();
    m_reached.clear();
    push_off_vertices(m_surface, curve, m_crossings);
    for (std::size_t i = 0; i < m_crossings.size(); ++i) {
      const Vector3 point = crossing_point(m_surface, m_crossings[i]);
      const Vector3 before = crossing_point(m_surface, m_crossings[(i + m_crossings.size() - 1) % m_crossings.size()]);
      const Vector3 after = crossing_point(m_surface, m_crossings[(i + 1) % m_crossings.size()]);
      for (const bool is_left : {false, true}) {
        const Index h = m_crossings[i].halfedge;
        const Index vertex = is_left ? m_surface.target(h) : m_surface.origin(h);
        const Vector3& at = m_surface.point(vertex);
        reach_vertex(vertex, std::min(distance_to_segment(at, before, point), distance_to_segment(at, point, after)),
                     is_left);
      }
    }
    m_front.spread([&](Index vertex, float distance) {
      m_reached.push_back(vertex);
      if (distance <= reach) {
        for (const Index h : m_surface.outgoing(vertex)) {
          pass_face(vertex, h, distance);
        }
      }
    });
    m_faces.clear();
    m_is_listed.clear();
    const auto is_reached = [&](Index h) { return m_front.is_reached(m_surface.origin(h)); };
    for (const Index vertex : m_reached) {
      for (const Index h : m_surface.outgoing(vertex)) {
        const Index face = Triangulated_surface::face(h);
        const std::array<Index, 3> sides = Triangulated_surface::face_halfedges(face);
        if (!m_surface.is_hole_filling(face) && std::all_of(sides.begin(), sides.end(), is_reached) &&
            m_is_listed.mark(face)) {
          m_faces.push_back(face);
        }
      }
    }
  }

  void reach_vertex(Index vertex, double distance, bool is_left)
  {
    if ((!m_front.is_reached(vertex) || this->is_left(vertex) == is_left) && m_front.reach(vertex, float(distance))) {
      m_height[vertex] = is_left ? float(distance) : -float(distance);
    }
  }

  /// The front goes on from `vertex` over the face of `h`, along its sides and, straight, over the side that it has
  /// passed already.
  void pass_face(Index vertex, Index h, float distance)
  {
    const std::array<Index, 2> others{m_surface.target(h), m_surface.opposite_vertex(h)};
    for (std::size_t i = 0; i < 2; ++i) {
      const Index to = others[i];
      const Index beside = others[1 - i];
      double reached = distance + (m_surface.point(to) - m_surface.point(vertex)).norm();
      if (m_front.is_reached(beside) && is_left(beside) == is_left(vertex)) {
        reached = std::min(reached, straight_distance(vertex, beside, to));
      }
      reach_vertex(to, std::max(reached, double(distance)), is_left(vertex));
    }
  }

  /// The distance of `to` where distances grow evenly over the triangle of `a`, `b` and `to`, and the shortest path to
  /// it passes between `a` and `b`; otherwise the greatest number.
  double straight_distance(Index a, Index b, Index to) const
  {
    const Vector3 side = m_surface.point(b) - m_surface.point(a);
    const Vector3 way = m_surface.point(to) - m_surface.point(a);
    const double length = side.norm();
    const double along = way.dot(side) / length;
    const double across = std::sqrt(std::max(way.squaredNorm() - along * along, 0.));
    const double cosine = (double(m_front.distance(b)) - double(m_front.distance(a))) / length;
    if (!(std::abs(cosine) < 1)) {
      return std::numeric_limits<double>::max();
    }
    const double sine = std::sqrt(1 - cosine * cosine);
    const double foot = along - across * cosine / sine;
    return foot >= 0 && foot <= length ? m_front.distance(a) + cosine * along + sine * across
                                       : std::numeric_limits<double>::max();
  }

  bool is_left(Index vertex) const { return !std::signbit(m_height[vertex]); }

  /// The length of the connected piece of the curve at the signed distance `level` that passes through `face`; 0 if
  /// none does, or it was passed before.
  double piece_length(Index face, double level)
  {
    if (m_is_passed.is_marked(face)) {
      return 0;
    }
    const auto is_crossed = [&](Index h) {
      return (m_height[m_surface.origin(h)] < level) != (m_height[m_surface.target(h)] < level);
    };
    const auto point_on = [&](Index h) -> Vector3 {
      const double from = m_height[m_surface.origin(h)];
      const double to = m_height[m_surface.target(h)];
      const Vector3& point = m_surface.point(m_surface.origin(h));
      return point + (level - from) / (to - from) * (m_surface.point(m_surface.target(h)) - point);
    };
    const std::array<Index, 3> sides = Triangulated_surface::face_halfedges(face);
    const auto* const start = std::find_if(sides.begin(), sides.end(), is_crossed);
    if (start == sides.end()) {
      return 0;
    }
    double length = 0;
    for (Index entry : {*start, m_surface.twin(*start)}) { // in both directions
      while (m_is_listed.is_marked(Triangulated_surface::face(entry)) &&
             m_is_passed.mark(Triangulated_surface::face(entry))) {
        const Index next = Triangulated_surface::next(entry);
        const Index exit = is_crossed(next) ? next : Triangulated_surface::next(next);
        length += (point_on(exit) - point_on(entry)).norm();
        entry = m_surface.twin(exit);
      }
    }
    return length;
  }

  const Triangulated_surface& m_surface;
  Dijkstra_search m_front;
  std::vector<float> m_height; // of vertices that are reached: the distance from the curve, positive on the left
  std::vector<Edge_crossing> m_crossings;
  std::vector<Index> m_reached;
  std::vector<Index> m_faces;
  Epoch_marks m_is_listed; // of faces: whether among these
  Epoch_marks m_is_passed; // of these: whether the piece of the curve in it has been measured
};

/// Finds loops of all kinds on one surface.
class Surface_loop_search
{
public:
  explicit Surface_loop_search(const Triangulated_solid& solid)
      : m_solid(solid), m_surface(solid.triangulation()), m_classes(m_surface),
        m_shorten(Intrinsic_triangulation(m_surface, m_surface.first_hole_filling_face()),
                  m_surface.first_hole_filling_face()),
        m_is_consistent(m_classes.is_consistent())
  {
  }

  std::vector<Surface_loop<Vector3>> operator()(unsigned random_seed, double min_depth)
  {
    Options settings;
    settings.random_seed = random_seed;
    Skeletonization_report report;
    for (const Separator& separator : cover_by_separators(m_solid, settings, report, [](double) {})) {
      add_separator(separator);
    }
    if (m_classes.size() > 0) {
      add_basis_loops();
    }
    std::stable_sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.is_over_hole, a.measures.length) < std::tie(b.is_over_hole, b.measures.length);
    });
    std::vector<Surface_loop<Vector3>> result;
    for (const Loop_kind kind : {Loop_kind::handle, Loop_kind::tunnel}) {
      add_independent_loops(kind, result);
    }
    add_constrictions(min_depth, result);
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
      return std::tie(a.kind, a.length) < std::tie(b.kind, b.length);
    });
    return result;
  }

private:
  using Bits = Loop_classes::Bits;

  /// Bound for the vertices that are visited for loops from several roots: about a second.
  static constexpr std::size_t max_visits = 5000000;
  /// From a root that is chosen for one loop, so many of the shortest loops are taken: the others are far from it.
  static constexpr std::size_t max_loops_per_root = 12;
  /// Samples of the disc that a loop spans: the middle between each point of the loop and the center.
  static constexpr double min_inside_part = 0.5;

  struct Candidate
  {
    Surface_path path;
    std::vector<Vector3> points; // of the path
    Polygon_measures measures;
    Bits loop_class;
    bool is_over_hole = false; // along an edge that only bridges a border
  };

  /// \name Candidates
  /// @{

  /// Adds the loop along the vertices on one side of a separator.
  void add_separator(const Separator& separator)
  {
    for (const bool is_left : {false, true}) {
      Vertex_loop loop;
      for (const Edge_crossing& crossing : separator.crossings) {
        const Index h = crossing.halfedge;
        add_vertex(is_left ? m_surface.target(h) : m_surface.origin(h), loop);
      }
      while (loop.size() > 2 && loop.front() == loop.back()) {
        loop.pop_back();
      }
      if (add_candidate(halfedges_along(loop))) {
        return;
      }
    }
  }

  /// Appends `vertex` unless the loop is there; going straight back shortens the loop.
  static void add_vertex(Index vertex, Vertex_loop& loop)
  {
    if (loop.size() > 1 && loop[loop.size() - 2] == vertex) {
      loop.pop_back();
    } else if (loop.empty() || loop.back() != vertex) {
      loop.push_back(vertex);
    }
  }

  std::vector<Index> halfedges_along(const Vertex_loop& loop) const
  {
    std::vector<Index> result;
    result.reserve(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.push_back(m_surface.find_halfedge(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]));
    }
    return result;
  }

  bool is_over_hole(Index h) const
  {
    return m_surface.is_hole_filling(Triangulated_surface::face(h)) &&
           m_surface.is_hole_filling(Triangulated_surface::face(m_surface.twin(h)));
  }

  /// Shortens the loop along `halfedges` and adds it. \return whether it runs along different edges of the surface
  bool add_candidate(const std::vector<Index>& halfedges)
  {
    std::set<Index> edges;
    const auto is_new_edge = [&](Index h) { return h != no_index && edges.insert(m_surface.edge(h)).second; };
    if (halfedges.size() < 3 || !std::all_of(halfedges.begin(), halfedges.end(), is_new_edge)) {
      return false;
    }
    Candidate candidate;
    candidate.loop_class = m_classes(halfedges);
    candidate.is_over_hole = std::any_of(halfedges.begin(), halfedges.end(), [&](Index h) { return is_over_hole(h); });
    const Shortening_outcome outcome = m_shorten(halfedges, true, candidate.path);
    if (outcome == Shortening_outcome::collapsed && candidate.loop_class.any()) {
      // Around a handle that is tiny compared with it, the loop is kept as it was.
      for (const Index h : halfedges) {
        candidate.path.points.push_back({h, 0.});
      }
    }
    if (candidate.loop_class.any() || (outcome == Shortening_outcome::straight && !candidate.is_over_hole)) {
      crossing_points(m_surface, candidate.path.points, candidate.points);
      candidate.measures = measure_polygon(candidate.points);
      m_candidates.push_back(std::move(candidate));
    }
    return true;
  }

  /// Adds loops that are a basis of the homology of each component, from one root, and from roots on these.
  void add_basis_loops()
  {
    Handle_loops handle_loops(m_surface);
    std::size_t roots_left = max_visits / m_surface.number_of_vertices();
    for (const Handle_loops::Loop& rough_loop : handle_loops.of_all_pieces()) {
      add_candidate(halfedges_along(rough_loop));
      if (roots_left > 0) {
        --roots_left;
        const std::vector<Handle_loops::Loop> loops = handle_loops(rough_loop.begin); // the shortest first
        for (std::size_t i = 0; i < std::min(loops.size(), max_loops_per_root); ++i) {
          add_candidate(halfedges_along(loops[i]));
        }
      }
    }
  }

  static std::vector<Index> halfedges_along(const Handle_loops::Loop& loop)
  {
    std::vector<Index> result;
    for (const Edge_crossing& step : loop.crossings) {
      result.push_back(step.halfedge);
    }
    return result;
  }
  /// @}

  /// \name Handles and tunnels
  /// @{

  bool is_of_kind(const Candidate& candidate, Loop_kind kind) const
  {
    if (candidate.loop_class.none()) {
      return false;
    }
    if (!m_is_consistent) {
      return spans_body(candidate) == (kind == Loop_kind::handle);
    }
    const Bits tunnel_part = m_classes.tunnel_part(candidate.loop_class);
    return kind == Loop_kind::handle ? tunnel_part.none() : tunnel_part == candidate.loop_class;
  }

  /// Whether a disc that the loop spans is inside the body for the most part: a substitute where the surface intersects
  /// itself, and no loop need bound anything.
  bool spans_body(const Candidate& candidate) const
  {
    const std::vector<Vector3>& corners = candidate.points;
    const auto number_inside = std::count_if(corners.begin(), corners.end(), [&](const Vector3& point) {
      return m_solid.is_inside((point + candidate.measures.center) / 2);
    });
    return double(number_inside) >= min_inside_part * double(corners.size());
  }

  /// Adds the shortest candidates of a kind that are independent.
  void add_independent_loops(Loop_kind kind, std::vector<Surface_loop<Vector3>>& result) const
  {
    Independent_bits chosen;
    for (const Candidate& candidate : m_candidates) {
      if (2 * chosen.size() < m_classes.size() && is_of_kind(candidate, kind) && chosen.insert(candidate.loop_class)) {
        result.push_back({kind, candidate.measures.length, 0, candidate.points});
      }
    }
  }
  /// @}

  /// \name Constrictions
  /// @{

  /// Adds loops that separate and cross neither each other nor themselves, the shortest first.
  void add_constrictions(double min_depth, std::vector<Surface_loop<Vector3>>& result)
  {
    std::vector<const Candidate*> seen;
    Parallel_curves parallel_curves(m_surface);
    Separator_arrangement arrangement(m_surface);
    std::vector<Edge_crossing> crossings;
    for (const Candidate& candidate : m_candidates) {
      if (candidate.loop_class.any() || std::any_of(seen.begin(), seen.end(), [&](const Candidate* other) {
            return is_same_place(*other, candidate);
          })) {
        continue;
      }
      seen.push_back(&candidate);
      const double depth = parallel_curves.depth(candidate.path);
      if (depth >= min_depth && push_off_vertices(m_surface, candidate.path, crossings) &&
          arrangement.insert(Index(result.size()), crossings)) {
        result.push_back({Loop_kind::constriction, candidate.measures.length, depth, candidate.points});
      }
    }
  }

  /// Whether no point of either loop is further from the other one than the radius of the shorter one.
  static bool is_same_place(const Candidate& shorter, const Candidate& longer)
  {
    const double radius = shorter.measures.length / (2 * boost::math::double_constants::pi);
    return (shorter.measures.center - longer.measures.center).norm() <= radius &&
           is_near(shorter.points, longer.points, radius) && is_near(longer.points, shorter.points, radius);
  }

  /// Whether all points of a polygon are within `distance` of `other`.
  static bool is_near(const std::vector<Vector3>& polygon, const std::vector<Vector3>& other, double distance)
  {
    return std::all_of(polygon.begin(), polygon.end(), [&](const Vector3& point) {
      for (std::size_t i = 0; i < other.size(); ++i) {
        if (distance_to_segment(point, other[i], other[i + 1 < other.size() ? i + 1 : 0]) <= distance) {
          return true;
        }
      }
      return false;
    });
  }
  /// @}

  const Triangulated_solid& m_solid;
  const Triangulated_surface& m_surface;
  Loop_classes m_classes;
  Edge_flip_shortening m_shorten;
  bool m_is_consistent;
  std::vector<Candidate> m_candidates;
};

} // namespace

std::vector<Surface_loop<Vector3>> find_surface_loops(std::vector<Vector3> points,
                                                      std::vector<std::array<Index, 3>> faces, unsigned random_seed,
                                                      double min_depth)
{
  const Triangulated_solid solid(std::move(points), std::move(faces), Border_treatment::bridge);
  const Normalization& normalization = solid.normalization();
  std::vector<Surface_loop<Vector3>> loops = Surface_loop_search(solid)(random_seed, min_depth);
  for (Surface_loop<Vector3>& loop : loops) {
    loop.length *= normalization.unit;
    for (Vector3& point : loop.points) {
      point = normalization.to_input(point);
    }
  }
  return loops;
}

} // namespace CSCD::internal
