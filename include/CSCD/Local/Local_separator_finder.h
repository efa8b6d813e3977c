// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the local separator of a source, touching only the surface around it.

#ifndef CSCD_LOCAL_LOCAL_SEPARATOR_FINDER_H
#define CSCD_LOCAL_LOCAL_SEPARATOR_FINDER_H

#include <CSCD/Local/Geodesic_polar_coordinates.h>
#include <CSCD/Separator/Plane_section.h>
#include <CSCD/Separator/Separator.h>
#include <CSCD/Separator/Straightening.h>
#include <CSCD/Separator/limb_tests.h>
#include <CSCD/Surface/Surface_levels.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Vector3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD {

/// Finds separators: a front in polar coordinates, stopped early, on the level of detail that suits the limb; meetings
/// while it grows; shortening by the section plane through the source, by straightening where that fails.
///
/// One object serves one thread. It keeps all working memory, of the size of the surface, and uses it again for each
/// source; the work for a source is a few hundred visited vertices on a surface of any size.
class Local_separator_finder
{
public:
  /// Prepares the working memory; `solid` is referred to and must outlive this object.
  /// \param min_area_ratio loops that cut off a smaller area, relative to their squared length, encircle a bump
  Local_separator_finder(const Triangulated_solid& solid, double min_area_ratio)
      : m_solid(solid), m_levels(solid.levels()), m_min_area_ratio(min_area_ratio), m_workspaces(m_levels.size()),
        m_projection(m_levels), m_section(m_levels.finest().surface)
  {
  }

  /// Seeks the separator of `source`, a vertex of the finest level, and starts on the level `level_hint`.
  void operator()(Index source, Index level_hint, Search_result& result)
  {
    result.separator.crossings.clear();
    result.is_section = false;
    result.outcome = trace_on_best_level(source, level_hint, result.level);
    if (result.outcome == Search_outcome::no_cut && cut_across_longest_edge(source, result)) {
      return;
    }
    if (result.outcome != Search_outcome::found) {
      return;
    }
    measure_vertex_loop(result);
    Workspace& workspace = workspace_of(result.level);
    const double min_area_ratio = (side_of_sheet(source) != 0 ? internal::open_area_factor : 1) * m_min_area_ratio;
    if (workspace.bump_test.area_ratio(m_loop, bump_limit * min_area_ratio) < min_area_ratio) {
      result.outcome = Search_outcome::bump;
      return;
    }
    shorten(source, result);
  }

private:
  /// A loop of fewer edges than this is too coarse to decide on: the next finer level is tried. Of 12 to 16, found on
  /// 190 odd-numbered Princeton meshes: skeletons are as good as with 16, and with 12 nodes are less central.
  static constexpr std::size_t min_loop_size = 15;
  /// A loop of fewer edges encloses nothing.
  static constexpr std::size_t min_simple_loop_size = 3;
  /// Visits on a level before the next coarser one is tried: for a loop of `min_loop_size` edges, a front visits about
  /// the square of that number; found by experiment on 27 meshes.
  static constexpr std::size_t max_visits = std::size_t(1.6 * min_loop_size * min_loop_size);
  /// Visits where no coarser level is left to try: on the coarsest one, which has fewer vertices unless the limbs are
  /// many, and below a level without a loop. Few fronts that grow larger find a loop, and then one around a whole body.
  static constexpr std::size_t max_visits_at_last = 2000;
  /// Where the measurement of the area on the smaller side may stop, relative to the least area.
  static constexpr double bump_limit = 1.01;
  /// A section is accepted if its length is within these bounds, relative to the loop's ...
  static constexpr double min_section_length = 0.5;
  static constexpr double max_section_length = 1.35;
  /// ... and if its center has moved by less than this, relative to the loop's length.
  static constexpr double max_center_shift = 0.12;
  /// The same on a sheet, where that is half of the width: sections that are turned perpendicular to the borders are
  /// turned about the source, which may be near one of them.
  static constexpr double max_shift_on_sheet = 0.25;
  /// A straightened loop is accepted if the mean cosine of the angle between its normal and the normals of the faces
  /// that it crosses is at most this: at a step of a shaft, loops lie flat on the face of the step. With 0.5, limbs of
  /// animals end earlier.
  static constexpr double max_mean_cosine = 0.6;
  /// How often the plane is turned perpendicular to the limb's axis and the section taken again.
  static constexpr int number_of_axis_steps = 2;

  /// A section across a limb of long faces crosses at least this many edges: a pin of four sides is crossed by eight.
  /// With six, clouds whose edges are as long as their limbs are thick get false branches.
  static constexpr std::size_t min_crossings_of_long_faces = 8;
  /// It is at least this round: two sides of a sheet are not.
  static constexpr double min_roundness_of_long_faces = 0.2;
  /// Its center lies below the source, up to an angle of this cosine.
  static constexpr double min_center_cosine = 0.5;

  struct Workspace
  {
    explicit Workspace(const Surface_level& level)
        : front(level.corners(), level.surface.number_of_vertices()), bump_test(level.surface)
    {
    }
    internal::Geodesic_polar_coordinates front;
    internal::Enclosed_area_test bump_test;
  };

  int side_of_sheet(Index vertex) const { return m_solid.side_of_sheet(vertex); }

  /// Returns a test whether a vertex of `level` is on the other side of the sheet than `source`; none where `source` is
  /// not on a sheet. The sides are too near to each other for directions between them to mean anything.
  std::function<bool(Index)> across_sheet(const Surface_level& level, Index source) const
  {
    const int side = side_of_sheet(source);
    if (side == 0) {
      return nullptr;
    }
    return [this, &level, side](Index vertex) { return side_of_sheet(level.to_finest(vertex)) != side; };
  }

  Workspace& workspace_of(Index level)
  {
    if (!m_workspaces[level]) {
      m_workspaces[level] = std::make_unique<Workspace>(m_levels[level]);
    }
    return *m_workspaces[level];
  }

  /// Grows fronts on neighboring levels until one finds a loop of a suitable number of edges; leaves the loop in
  /// `m_loop` and its level in `level`.
  Search_outcome trace_on_best_level(Index source, Index level_hint, Index& level)
  {
    const Index first = level = std::min(level_hint, m_levels.top());
    while (trace(source, level, level == m_levels.top() ? max_visits_at_last : max_visits)) {
      if (level == m_levels.top()) {
        return Search_outcome::no_cut;
      }
      ++level;
    }
    const auto is_too_coarse = [&] {
      return m_loop.empty() ? workspace_of(level).front.number_of_visits() <= 2 * max_visits
                            : m_loop.size() < min_loop_size;
    };
    while (level > 0 && level <= first && is_too_coarse()) {
      // A loop on the coarser level bounds the front.
      const std::size_t cap = m_loop.empty() ? max_visits_at_last : std::numeric_limits<std::size_t>::max();
      if (trace(source, --level, cap)) {
        return Search_outcome::no_cut;
      }
    }
    return m_loop.empty()                          ? Search_outcome::no_cut
           : m_loop.size() >= min_simple_loop_size ? Search_outcome::found
                                                   : Search_outcome::degenerate;
  }

  /// Grows a front on `level` and traces the loop of the nearest meeting, if there is one. \return whether the front
  /// was capped
  bool trace(Index source, Index level, std::size_t visits)
  {
    const Surface_level& surface_level = m_levels[level];
    internal::Geodesic_polar_coordinates& front = workspace_of(level).front;
    const Index level_source = surface_level.from_finest(source);
    internal::Nearest_meeting meeting(surface_level.surface, front, level_source,
                                      across_sheet(surface_level, surface_level.to_finest(level_source)));
    const bool is_capped = front.grow(level_source, visits, meeting);
    m_loop.clear();
    if (meeting.has_found()) {
      internal::trace_loop(front, meeting.first(), meeting.second(), m_loop);
    }
    return is_capped;
  }

  /// Finds the section across the longest edge at `source` if it is at most twice as long: a limb whose faces are
  /// longer than it is thick, such as a wire of a few rows of faces. A front passes them before it has gone around the
  /// limb.
  bool cut_across_longest_edge(Index source, Search_result& result)
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    Vector3 longest = Vector3::Zero();
    for (const Index h : surface.outgoing(source)) {
      const Vector3 edge = surface.point(surface.target(h)) - surface.point(source);
      longest = float(edge.squaredNorm()) > float(longest.squaredNorm()) ? edge : longest; // of equal ones, the first
    }
    const double length = longest.norm();
    if (!(length > 0) || !m_section.cut_at_vertex(source, longest / length, 2 * length) ||
        m_section.crossings().size() < min_crossings_of_long_faces) {
      return false;
    }
    Separator& separator = result.separator;
    internal::set_measures(separator, m_section.points());
    const Vector3 chord = separator.center - surface.point(source);
    if (separator.roundness() < min_roundness_of_long_faces ||
        -chord.dot(surface.vertex_normal(source)) < min_center_cosine * chord.norm()) {
      return false;
    }
    separator.source = source;
    separator.crossings = m_section.crossings();
    result.outcome = Search_outcome::found;
    result.level = 0;
    result.is_section = true;
    return true;
  }

  void measure_vertex_loop(Search_result& result)
  {
    const Triangulated_surface& surface = m_levels[result.level].surface;
    m_points.clear();
    for (Index vertex : m_loop) {
      m_points.push_back(surface.point(vertex));
    }
    internal::set_measures(result.separator, m_points);
  }

  void shorten(Index source, Search_result& result)
  {
    // The loop starts at the coarse source, which stands for several fine vertices.
    const Surface_level& level = m_levels[result.level];
    result.separator.source = level.to_finest(level.from_finest(source));
    result.is_section = shorten_by_section(result.separator);
    if (!result.is_section && !shorten_by_straightening(level, result.separator)) {
      result.outcome = Search_outcome::degenerate;
    }
  }

  /// Replaces the vertex loop, whose measures `separator` has, by the shortest of a few plane sections around it.
  bool shorten_by_section(Separator& separator)
  {
    const double loop_length = separator.length;
    const Vector3 loop_center = separator.center;
    const bool is_on_sheet = side_of_sheet(separator.source) != 0;
    const Vector3 loop_normal = separator.normal;
    const double max_shift = is_on_sheet ? max_shift_on_sheet : max_center_shift;
    Vector3 axis = loop_normal;
    double best_length = std::numeric_limits<double>::max();
    for (int step = 0; step <= number_of_axis_steps; ++step) {
      if (axis.dot(loop_normal) < 0) {
        axis = -axis;
      }
      if (!m_section.cut_at_vertex(separator.source, axis, max_section_length * loop_length)) {
        if (step == 0) {
          break;
        }
        // Half way back to where a section was found.
        axis = (axis + loop_normal).normalized();
        continue;
      }
      const internal::Polygon_measures measures = internal::measure_polygon(m_section.points());
      if (measures.length >= max_section_length * loop_length || measures.length <= min_section_length * loop_length ||
          (measures.center - loop_center).norm() >= max_shift * loop_length) {
        break;
      }
      if (measures.length < best_length) {
        best_length = measures.length;
        separator.crossings = m_section.crossings();
        internal::set_measures(separator, measures);
      }
      if (step < number_of_axis_steps) {
        axis = is_on_sheet ? border_axis() : m_section.symmetry_axis();
      }
    }
    return best_length < std::numeric_limits<double>::max();
  }

  /// The mean direction of the borders of a sheet where the section crosses them: perpendicular to it, an open curve
  /// meets both at about a right angle. The normals of a flat sheet do not determine an axis.
  Vector3 border_axis() const
  {
    const Triangulated_surface& surface = m_levels.finest().surface;
    const std::vector<Edge_crossing>& crossings = m_section.crossings();
    const auto is_on_rim = [&](std::size_t i) {
      const Index h = crossings[i % crossings.size()].halfedge;
      return side_of_sheet(surface.origin(h)) != side_of_sheet(surface.target(h));
    };
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      if (!is_on_rim(i) && (is_on_rim(i + 1) || is_on_rim(i + crossings.size() - 1))) {
        const Index h = crossings[i].halfedge; // an edge of the border, from above the plane to below
        sum += (surface.point(surface.origin(h)) - surface.point(surface.target(h))).normalized();
      }
    }
    return sum.norm() > 0 ? Vector3(sum.normalized()) : m_section.symmetry_axis();
  }

  bool shorten_by_straightening(const Surface_level& level, Separator& separator)
  {
    if (!level.finest_vertex.empty()) {
      if (!m_projection(level, m_loop, m_fine_loop)) {
        return false;
      }
      std::swap(m_loop, m_fine_loop);
    }
    const Triangulated_surface& finest = m_levels.finest().surface;
    if (!internal::push_off(finest, m_loop, separator.crossings)) {
      return false;
    }
    internal::straighten(finest, separator.crossings);
    internal::crossing_points(finest, separator.crossings, m_points);
    internal::set_measures(separator, m_points);
    return separator.crossings.size() >= min_simple_loop_size &&
           (side_of_sheet(separator.source) != 0 || mean_cosine_to_faces(separator) <= max_mean_cosine);
  }

  /// The mean, along the curve `m_points`, of the cosine of the angle between the normals of `separator` and of the
  /// faces that it crosses.
  double mean_cosine_to_faces(const Separator& separator) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const Index face = Triangulated_surface::face(separator.crossings[i].halfedge);
      const double length = (m_points[i] - m_points[i > 0 ? i - 1 : m_points.size() - 1]).norm();
      sum += length * std::abs(separator.normal.dot(m_levels.finest().surface.face_normal(face)));
    }
    return sum / separator.length;
  }

  const Triangulated_solid& m_solid;
  const Surface_levels& m_levels;
  double m_min_area_ratio;
  std::vector<std::unique_ptr<Workspace>> m_workspaces;
  internal::Loop_projection m_projection;
  internal::Plane_section m_section;
  Vertex_loop m_loop;
  Vertex_loop m_fine_loop;
  std::vector<Vector3> m_points;
};

} // namespace CSCD

#endif // CSCD_LOCAL_LOCAL_SEPARATOR_FINDER_H
