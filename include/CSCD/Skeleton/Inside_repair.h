// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Brings what lies outside back into the body.

#ifndef CSCD_SKELETON_INSIDE_REPAIR_H
#define CSCD_SKELETON_INSIDE_REPAIR_H

#include <CSCD/Skeleton/Sheet_placement.h>
#include <CSCD/Skeleton/Skeleton_builder.h>
#include <CSCD/Surface/Solid_queries.h>
#include <CSCD/Surface/Triangulated_solid.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/Box_tree.h>
#include <CSCD/internal/Dijkstra_search.h>
#include <CSCD/internal/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// Finds ways inside a body around what is outside: along its surface, and as far below it as there is room.
class Way_inside
{
public:
  /// \param solid is referred to
  explicit Way_inside(const Triangulated_solid& solid)
      : m_solid(solid), m_surface(solid.query_surface()), m_search(m_surface.number_of_faces()),
        m_entered(m_surface.number_of_faces(), no_index),
        m_work_left(free_work + max_work * m_surface.number_of_faces())
  {
  }

  /// Points inside such that each sees the next, the first one `from` and the last one `to`; none, where no way was
  /// found, as where components of different orientation overlap, or the ways before took too much work. \pre both are
  /// inside
  std::vector<Vector_3> find(const Vector_3& from, const Vector_3& to)
  {
    if (m_work_left == 0 || !trace_surface(from, to)) {
      return {};
    }
    std::vector<Vector_3> way;
    m_max_depth = (to - from).norm();
    const bool is_found = follow_surface(from, to, way);
    return is_found ? way : std::vector<Vector_3>();
  }

private:
  /// How many faces may be passed and lines be traced for all ways, relative to the number of faces.
  static constexpr std::size_t max_work = 8;
  /// So much more takes some tenths of a second.
  static constexpr std::size_t free_work = 1 << 17;
  /// A way of more nodes is no good skeleton.
  static constexpr std::size_t max_number_of_nodes = 64;
  /// Halvings of the depth below the surface, where the way is not free.
  static constexpr int max_halvings = 12;

  /// A point of the surface, from where one goes inwards.
  struct Start
  {
    Vector_3 point;
    Vector_3 inward; ///< of unit length
  };

  void count_work() { m_work_left -= m_work_left > 0 ? 1 : 0; }

  /// Writes the way on the surface from where the segment leaves the body first to where it enters it last to
  /// `m_starts`. \return false if there is none
  bool trace_surface(const Vector_3& from, const Vector_3& to)
  {
    m_starts.clear();
    m_solid.crossings(from, to, m_crossings);
    if (m_crossings.size() < 2) {
      return false;
    }
    const Vector_3 direction = (to - from).normalized();
    const Surface_point leaving = m_solid.closest_point(from + m_crossings.front() * direction);
    const Surface_point entering = m_solid.closest_point(from + m_crossings.back() * direction);
    if (!search_faces(entering.face, leaving.face)) {
      return false;
    }
    m_starts.push_back({leaving.point, inward_of(leaving.face)});
    for (Index face = leaving.face; face != entering.face;) {
      m_starts.push_back({center_of(face), inward_of(face)});
      const Index h = m_entered[face]; // of the next face
      const Index next = Triangulated_surface::face(h);
      m_starts.push_back({(m_surface.point(m_surface.origin(h)) + m_surface.point(m_surface.target(h))) / 2,
                          (inward_of(face) + inward_of(next)).normalized()});
      face = next;
    }
    m_starts.push_back({center_of(entering.face), inward_of(entering.face)});
    m_starts.push_back({entering.point, inward_of(entering.face)});
    return true;
  }

  /// Searches for the shortest way over centers of faces, backwards, so that `m_entered` has for each face on it the
  /// halfedge of the next one. \return whether there is one
  bool search_faces(Index first, Index last)
  {
    bool is_found = false;
    m_search.clear();
    m_search.reach(first, 0);
    m_search.spread([&](Index face, float distance) {
      count_work();
      is_found = face == last;
      if (is_found || m_work_left == 0) {
        m_search.clear();
        return;
      }
      const Vector_3 center = center_of(face);
      for (const Index h : Triangulated_surface::face_halfedges(face)) {
        const Index neighbor = Triangulated_surface::face(m_surface.twin(h));
        if (m_search.reach(neighbor, distance + float((center_of(neighbor) - center).norm()))) {
          m_entered[neighbor] = h;
        }
      }
    });
    return is_found;
  }

  bool follow_surface(const Vector_3& from, const Vector_3& to, std::vector<Vector_3>& way)
  {
    std::size_t next = 0; // behind the last start that was passed
    Vector_3 here = from;
    while (!sees(here, to)) {
      if (way.size() > max_number_of_nodes || m_work_left == 0 || next == m_starts.size()) {
        return false;
      }
      const std::optional<std::size_t> seen = farthest_seen(here, next);
      if (seen) {
        way.push_back(*below(m_starts[*seen], 0));
        next = *seen + 1;
      } else if (!step_below_surface(here, next, way)) {
        return false;
      } else {
        ++next;
      }
      here = way.back();
    }
    return true;
  }

  /// Of some starts from `next` on, far ones first, the one whose middle of the body can be seen.
  std::optional<std::size_t> farthest_seen(const Vector_3& here, std::size_t next)
  {
    for (std::size_t step = m_starts.size() - next; step > 0; step /= 2) {
      const std::optional<Vector_3> middle = below(m_starts[next + step - 1], 0);
      if (middle && m_solid.is_inside(*middle) && sees(here, *middle)) {
        return next + step - 1;
      }
    }
    return std::nullopt;
  }

  /// Goes to the start `next` so near to the surface that the way is free, from near the one before.
  bool step_below_surface(const Vector_3& here, std::size_t next, std::vector<Vector_3>& way)
  {
    for (int halvings = 1; halvings <= max_halvings; ++halvings) {
      const std::optional<Vector_3> to = below(m_starts[next], halvings);
      const std::optional<Vector_3> from = next > 0 ? below(m_starts[next - 1], halvings) : std::nullopt;
      if (to && sees(here, *to)) {
        way.push_back(*to);
        return true;
      }
      if (to && from && sees(here, *from) && sees(*from, *to)) {
        way.push_back(*from);
        way.push_back(*to);
        return true;
      }
    }
    return false;
  }

  /// The middle of the body below `start`, or a point as far away as the ends of the way are from each other, where the
  /// body is thicker; or as many times nearer.
  std::optional<Vector_3> below(const Start& start, int halvings)
  {
    constexpr double relative_offset = 1e-9; // of the ray from the surface, in the unit of its area
    count_work();
    if (!(start.inward.squaredNorm() > 0)) {
      return std::nullopt; // at a face without area, or where two lie upon each other
    }
    const std::optional<Surface_hit> hit =
        m_solid.first_hit(start.point + relative_offset * start.inward, start.inward);
    if (!hit) {
      return std::nullopt;
    }
    const double depth = std::min(hit->distance / 2, m_max_depth);
    return Vector_3(start.point + std::ldexp(depth, -halvings) * start.inward);
  }

  bool sees(const Vector_3& from, const Vector_3& to)
  {
    count_work();
    m_solid.crossings(from, to, m_crossings);
    return m_crossings.empty();
  }

  Vector_3 center_of(Index face) const
  {
    return (m_surface.point(m_surface.origin(3 * face)) + m_surface.point(m_surface.target(3 * face)) +
            m_surface.point(m_surface.opposite_vertex(3 * face))) /
           3;
  }

  Vector_3 inward_of(Index face) const { return (-m_surface.face_vector(face)).normalized(); }

  const Triangulated_solid& m_solid;
  const Triangulated_surface& m_surface;
  Dijkstra_search m_search;        ///< over faces
  std::vector<Index> m_entered;    ///< for every face, the halfedge of the next one on the way
  std::vector<Start> m_starts;     ///< along the way on the surface
  std::vector<double> m_crossings; ///< working memory
  double m_max_depth = 0;          ///< of points of the way below the surface
  std::size_t m_work_left;
};

/// Moves nodes that lie outside of the body to its middle, and bends edges that leave it by further nodes.
/// \tparam Surface a model of `SkeletonizationSurface`
template <class Surface>
class Inside_repair
{
public:
  /// \param number_of_threads 0 for as many as TBB allows; the result is the same for any number
  Inside_repair(const Surface& surface, Skeleton_builder& builder, unsigned number_of_threads = 1)
      : m_surface(surface), m_builder(builder), m_number_of_threads(number_of_threads),
        m_diagonal(diagonal(surface.triangulation().points())), m_offset(relative_offset * m_diagonal),
        m_is_outside(builder.size(), 0)
  {
    for_each_chunk(builder.size(), [this](Index node) {
      const Skeleton_builder::Node& its = m_builder[node];
      const bool has_place = !its.is_removed && !its.is_opening;
      m_is_outside[node] = has_place && (is_flat(node) || !m_surface.is_inside(its.position)) ? 1 : 0;
    });
  }

  /// Brings nodes back in, and ends branches before tips that cannot be brought back.
  void draw_back_tips()
  {
    repair_nodes();
    for (Index node = 0; node < m_builder.size(); ++node) {
      for (Index tip = node; m_is_outside[tip] != 0 && m_builder.degree(tip) == 1;) {
        const Index next = m_builder[tip].neighbors[0];
        if (!m_builder.is_regular(next)) {
          break;
        }
        m_builder.contract(tip, next);
        m_is_outside[tip] = 0;
        tip = next;
      }
    }
  }

  /// Repairs what can be repaired, in a few rounds.
  void operator()()
  {
    repair_nodes();
    std::vector<Edge> edges;
    m_builder.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
    for (int round = 0; round < max_rounds && !edges.empty(); ++round) {
      edges = repair_edges(edges);
    }
    lead_around(edges);
  }

  std::size_t number_of_nodes_outside() const
  {
    return std::size_t(std::count(m_is_outside.begin(), m_is_outside.end(), char(1)));
  }

  std::size_t number_of_edges_outside()
  {
    std::vector<Edge> edges;
    m_builder.for_each_edge([&](Index a, Index b) { edges.emplace_back(a, b); });
    return number_outside(edges);
  }

private:
  using Edge = std::pair<Index, Index>;

  /// Edges that are still outside after this many rounds are led along the surface.
  static constexpr int max_rounds = 4;
  /// How far below the surface an edge is bent, relative to its length: more would be a sharp turn, as where limbs side
  /// by side grow from a thick body.
  static constexpr double max_relative_depth = 0.5;
  /// Shorter stretches outside are taken for rounding; relative to the diagonal of the bounding box.
  static constexpr double relative_offset = 1e-7;

  static double diagonal(const std::vector<Vector_3>& points)
  {
    Bounding_box box;
    for (const Vector_3& point : points) {
      box.extend(point);
    }
    return box.diagonal();
  }

  void repair_nodes()
  {
    for (Index node = 0; node < m_builder.size(); ++node) {
      if (m_is_outside[node] == 0) {
        continue;
      }
      if (const std::optional<Vector_3> place = place_inside(node)) {
        m_builder[node].position = *place;
        m_is_outside[node] = 0;
      }
    }
  }

  /// The middle of the body nearby; for a junction, such as where a handle joins the wall of a cup, behind the surface
  /// that is nearest to the middle of its neighbors.
  std::optional<Vector_3> place_inside(Index node)
  {
    if (m_builder.is_junction(node)) {
      Vector_3 sum = Vector_3::Zero();
      for (Index neighbor : m_builder[node].neighbors) {
        sum += m_builder[neighbor].position;
      }
      const Vector_3 middle = sum / double(m_builder.degree(node));
      return m_surface.is_inside(middle) ? middle : middle_behind(middle, node);
    }
    return middle_behind(m_builder[node].position, node);
  }

  /// Whether `node` is all that a component without thickness has, such as a single triangle: it has no inside, and
  /// rays would tell of another component, in which or beside which it lies.
  bool is_flat(Index node) const { return m_builder.degree(node) == 0 && m_builder[node].radius <= m_offset; }

  /// The middle of the body behind `point`, which is at `node` or on an edge there.
  std::optional<Vector_3> middle_behind(const Vector_3& point, Index node) const
  {
    if (m_builder[node].is_on_sheet) {
      return middle_of_sheet(m_surface, point, m_builder[node].radius);
    }
    return is_flat(node) ? std::nullopt : m_surface.middle_behind(point);
  }

  /// The middle of the first stretch of the edge that is outside. At an opening there is no surface that says.
  std::optional<Vector_3> first_stretch_outside(Index a, Index b) const
  {
    if (m_builder[a].is_opening || m_builder[b].is_opening) {
      return std::nullopt;
    }
    const Vector_3& from = m_builder[a].position;
    const Vector_3& to = m_builder[b].position;
    std::vector<double> crossings;
    m_surface.crossings(from, to, crossings);
    const double length = (to - from).norm();
    crossings.push_back(length);
    bool is_outside = m_is_outside[a] != 0;
    double last = 0;
    for (double crossing : crossings) {
      if (is_outside && crossing - last > m_offset) {
        return Vector_3(from + (last + crossing) / (2 * length) * (to - from));
      }
      is_outside = !is_outside;
      last = crossing;
    }
    return std::nullopt;
  }

  /// The first stretches outside of all `edges`.
  std::vector<std::optional<Vector_3>> stretches_outside(const std::vector<Edge>& edges) const
  {
    std::vector<std::optional<Vector_3>> result(edges.size());
    for_each_chunk(Index(edges.size()),
                   [&](Index i) { result[i] = first_stretch_outside(edges[i].first, edges[i].second); });
    return result;
  }

  std::size_t number_outside(const std::vector<Edge>& edges) const
  {
    const std::vector<std::optional<Vector_3>> stretches = stretches_outside(edges);
    return edges.size() - std::size_t(std::count(stretches.begin(), stretches.end(), std::nullopt));
  }

  /// The point on the way from `outside` to `inside` that is `max_depth` below the surface, if `inside` is farther.
  Vector_3 at_most_below_surface(const Vector_3& outside, const Vector_3& inside, double max_depth) const
  {
    std::vector<double> crossings;
    m_surface.crossings(outside, inside, crossings);
    const double length = (inside - outside).norm();
    const double allowed = (crossings.empty() ? 0 : crossings.back()) + max_depth;
    return allowed < length ? Vector_3(outside + allowed / length * (inside - outside)) : inside;
  }

  /// Splits those of `edges` that leave the body, by nodes behind the nearest surface. \return the parts, which may
  /// leave it again
  std::vector<Edge> repair_edges(const std::vector<Edge>& edges)
  {
    std::vector<Edge> parts;
    // Dividing one edge does not move the ends of another.
    const std::vector<std::optional<Vector_3>> stretches = stretches_outside(edges);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto& [a, b] = edges[i];
      const std::optional<Vector_3>& outside = stretches[i];
      if (!outside) {
        continue;
      }
      if (const std::optional<Vector_3> middle = middle_behind(*outside, a)) {
        const double max_depth = max_relative_depth * m_builder.edge_length(a, b);
        const Index node = split_edge(a, b, at_most_below_surface(*outside, *middle, max_depth));
        parts.emplace_back(a, node);
        parts.emplace_back(node, b);
      } else {
        parts.emplace_back(a, b);
      }
    }
    return parts;
  }

  Index split_edge(Index a, Index b, const Vector_3& position)
  {
    m_is_outside.push_back(0);
    return m_builder.split_edge(a, b, position, (m_builder[a].radius + m_builder[b].radius) / 2);
  }

  /// Leads those of `edges` that leave the body along its surface.
  void lead_around(const std::vector<Edge>& edges)
  {
    if constexpr (std::is_same_v<Surface, Triangulated_solid>) {
      Way_inside way(m_surface);
      for (const auto& [a, b] : edges) {
        if (m_is_outside[a] != 0 || m_is_outside[b] != 0 || !first_stretch_outside(a, b)) {
          continue;
        }
        Index last = a;
        for (const Vector_3& point : way.find(m_builder[a].position, m_builder[b].position)) {
          last = split_edge(last, b, point);
        }
      }
    }
  }

  /// Calls `function(i)` for `i` from 0 to `size` - 1 in several threads, for some numbers at once.
  template <class Function>
  void for_each_chunk(Index size, const Function& function) const
  {
    constexpr Index chunk_size = 32; // queries take some microseconds each
    for_each_part(size / chunk_size + 1, m_number_of_threads, [&](Index chunk) {
      for (Index i = chunk * chunk_size; i < std::min(size, (chunk + 1) * chunk_size); ++i) {
        function(i);
      }
    });
  }

  const Surface& m_surface;
  Skeleton_builder& m_builder;
  unsigned m_number_of_threads;
  double m_diagonal;
  double m_offset;
  std::vector<char> m_is_outside; ///< for every node
};

} // namespace CSCD::internal

#endif // CSCD_SKELETON_INSIDE_REPAIR_H
