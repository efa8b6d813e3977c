// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CSCD_PUBLISHED_HEAT_METHOD_IMPL_H
#define CSCD_PUBLISHED_HEAT_METHOD_IMPL_H

#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Heat_method.h>
#include <CSCD/Published/Interleaved_solver.h>
#include <CSCD/Vector_3.h>
#include <CSCD/internal/config.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The elements of a surface and the factors of the heat method's two equations.
struct Heat_operators
{
  /// The numbers of the matrices in `solver`.
  static constexpr std::size_t heat = 0;    ///< masses / time + stiffness: one implicit step of heat flow
  static constexpr std::size_t poisson = 1; ///< stiffness, pinned

  /// \param step_factor the duration of the heat flow, in squared mean edge lengths
  Heat_operators(Cotangent_elements&& given_elements, double step_factor)
      : elements(std::move(given_elements)),
        solver({elements.matrix(1 / step_factor, false), elements.matrix(0, true)},
               "the Laplacian of the surface cannot be factored: its triangles are too uneven; remesh it, for instance "
               "by CGAL::Polygon_mesh_processing::isotropic_remeshing")
  {
    faces.reserve(elements.faces().size());
    for (const Cotangent_elements::Face& face : elements.faces()) {
      faces.push_back({{solver.place(face.vertices[0]), solver.place(face.vertices[1]), solver.place(face.vertices[2])},
                       face.face,
                       elements.component(face.vertices[0]),
                       face.layout});
    }
    const auto first_place = [](const Face& face) { return *std::min_element(face.places.begin(), face.places.end()); };
    std::sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) {
      return std::make_pair(first_place(a), a.face) < std::make_pair(first_place(b), b.face);
    });
  }

  /// A face of the elements, in the order of elimination.
  struct Face
  {
    std::array<Index, 3> places; ///< of its corners
    Index face;                  ///< its number in the triangulation
    Index component;
    Face_layout layout;
  };

  Cotangent_elements elements;
  Interleaved_solver solver;
  std::vector<Face> faces; ///< near numbers are near in the order of elimination
};

/// Heat flows from sources for a short time; its directions are made unit vectors, and the function whose gradient they
/// are, as nearly as can be, is the distance (K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat", 2013,
/// algorithm 1).
///
/// Heat falls by a factor of 2.6 or so with each edge: some 740 edges from the source it is less than any number. So
/// where it becomes tiny the flow is continued in stages. The heat beyond a frontier, taken alone, fulfils the same
/// equation with sources along the frontier, known from the stage before; they are magnified by a power of two, which
/// does not change the directions. Nothing is approximated: the heat is what a larger range of exponents would give.
///
/// A lane holds one set of sources. An object is working memory, and is reused.
template <std::size_t lanes>
class Heat_batch
{
public:
  /// Computes the distances from `lanes` sets of sources; linear in the number of nonzeros of the factors, times the
  /// number of stages. The result of a lane does not depend on the other lanes.
  /// \param distances of lanes with the same vector, the last one counts
  void operator()(const Heat_operators& operators,
                  const std::array<const std::vector<Geodesic_source>*, lanes>& source_sets,
                  const std::array<std::vector<double>*, lanes>& distances)
  {
    m_operators = &operators;
    m_source_sets = source_sets;
    m_distances = distances;
    prepare();
    diffuse();
    operators.solver.solve(Heat_operators::poisson, m_divergence);
    write_distances();
  }

private:
  using Row = Simd_pack<lanes>;
  using Face = Heat_operators::Face;

  /// The power of two below which heat is left to the next stage. Numbers still have full precision down to 2^-1022:
  /// what is lost here, products with a number less than 2^-122, is lost in every sum.
  static constexpr int frontier_exponent = -900;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Where a vertex is in a stage.
  enum Zone : std::uint8_t
  {
    done,  ///< known from an earlier stage, or never reached
    known, ///< known from this stage
    beyond ///< too little heat for this stage
  };

  /// A face whose heat is too little in a lane.
  struct Left_face
  {
    const Face* face;
    std::size_t lane;
  };

  /// The direction of the heat flow in a face, where `largest` is large enough.
  template <class Array>
  struct Flow
  {
    Array largest; ///< heat of a corner
    Array x, y;
  };

  static double frontier() { return std::ldexp(1., frontier_exponent); }
  const Cotangent_elements& elements() const { return m_operators->elements; }
  Index place(Index vertex) const { return m_operators->solver.place(vertex); }
  bool is_reached(Index component, std::size_t lane) const { return m_number_of_sources[component][lane] > 0; }

  void prepare()
  {
    const std::size_t n = elements().number_of_vertices();
    m_heat.assign(n, Row{});
    m_divergence.assign(n, Row{});
    m_number_of_sources.assign(elements().number_of_components(), Row{});
    m_left_faces.clear();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        add_source(source, lane);
      }
    }
  }

  void add_source(const Geodesic_source& source, std::size_t lane)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      CGAL_precondition(source.vertices[k] < elements().number_of_vertices());
      m_heat[place(source.vertices[k])][lane] += source.weights[k];
    }
    m_number_of_sources[elements().component(source.vertices[0])][lane] += 1;
  }

  /// Computes the heat stage by stage, and from it the divergence of its directions.
  void diffuse()
  {
    m_operators->solver.solve(Heat_operators::heat, m_heat);
    pass_all_faces();
    if (m_left_faces.empty()) {
      return;
    }
    enter_zones();
    while (!m_left_faces.empty() && set_frontier_sources()) {
      m_operators->solver.solve(Heat_operators::heat, m_heat);
      pass_left_faces();
      advance_zones();
    }
  }

  /// The direction of the flow, which needs no square of a small number. The absolute value is taken, as in CGAL: where
  /// faces are far from Delaunay, heat is negative here and there, but falls with the distance all the same.
  template <class Array>
  static Flow<Array> flow(const Face_layout& layout, const Array& signed_heat_0, const Array& signed_heat_1,
                          const Array& signed_heat_2)
  {
    // Keeps the zero vector where it is.
    constexpr double min_norm = std::numeric_limits<double>::min();
    const Array heat_0 = signed_heat_0.abs();
    const Array heat_1 = signed_heat_1.abs();
    const Array heat_2 = signed_heat_2.abs();
    Flow<Array> result;
    result.largest = heat_0.max(heat_1).max(heat_2);
    const Array scale = 1 / result.largest.max(frontier());
    const Array x = (heat_0 - heat_1) * scale * (1 / layout.base);
    const Array y = ((heat_0 - heat_2) * scale - layout.apex_x * x) * (1 / layout.apex_y);
    const Array inverse_norm = 1 / (x * x + y * y).sqrt().max(min_norm);
    result.x = x * inverse_norm;
    result.y = y * inverse_norm;
    return result;
  }

  void pass_all_faces()
  {
    for (const Face& face : m_operators->faces) {
      Flow<typename Row::Array> result = flow<typename Row::Array>(
          face.layout, m_heat[face.places[0]].array(), m_heat[face.places[1]].array(), m_heat[face.places[2]].array());
      if ((result.largest < frontier()).any()) {
        leave_lanes(face, result);
      }
      const Face_layout& layout = face.layout;
      const typename Row::Array flux_1 = (layout.apex_y * result.x - layout.apex_x * result.y) * 0.5;
      const typename Row::Array flux_2 = layout.base * 0.5 * result.y;
      m_divergence[face.places[0]].array() -= flux_1 + flux_2;
      m_divergence[face.places[1]].array() += flux_1;
      m_divergence[face.places[2]].array() += flux_2;
    }
  }

  /// Takes a face out of those lanes in which its heat is too little.
  void leave_lanes(const Face& face, Flow<typename Row::Array>& result)
  {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (result.largest[int(lane)] < frontier()) {
        result.x[int(lane)] = 0;
        result.y[int(lane)] = 0;
        if (is_reached(face.component, lane)) {
          m_left_faces.push_back({&face, lane});
        }
      }
    }
  }

  void pass_left_faces()
  {
    using Array = Simd_pack<1>::Array;
    const auto pass = [this](const Left_face& left) {
      const Face& face = *left.face;
      const auto heat = [&](std::size_t k) { return Array(m_heat[face.places[k]][left.lane]); };
      const Flow<Array> result = flow<Array>(face.layout, heat(0), heat(1), heat(2));
      if (result.largest[0] < frontier()) {
        return false;
      }
      const double flux_1 = (face.layout.apex_y * result.x[0] - face.layout.apex_x * result.y[0]) * 0.5;
      const double flux_2 = face.layout.base * 0.5 * result.y[0];
      m_divergence[face.places[0]][left.lane] -= flux_1 + flux_2;
      m_divergence[face.places[1]][left.lane] += flux_1;
      m_divergence[face.places[2]][left.lane] += flux_2;
      return true;
    };
    m_left_faces.erase(std::remove_if(m_left_faces.begin(), m_left_faces.end(), pass), m_left_faces.end());
  }

  void enter_zones()
  {
    m_zones.assign(m_heat.size(), {});
    for (Index v = 0; v < elements().number_of_vertices(); ++v) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        m_zones[place(v)][lane] = is_reached(elements().component(v), lane) ? beyond : done;
      }
    }
    advance_zones();
  }

  /// Makes `known` what has enough heat now, and `done` what was known.
  void advance_zones()
  {
    for (std::size_t i = 0; i < m_heat.size(); ++i) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        Zone& zone = m_zones[i][lane];
        if (zone != beyond) {
          zone = done;
        } else if (std::abs(m_heat[i][lane]) >= frontier()) {
          zone = known;
        }
      }
    }
  }

  /// Replaces the heat by the sources of the next stage: what the matrix makes of the heat beyond the frontier, taken
  /// alone. On the vertices there it is minus what the matrix makes of the known heat.
  /// \return false if no source is left
  bool set_frontier_sources()
  {
    m_sources.assign(m_heat.size(), Row{});
    bool has_sources = false;
    for (const Face& face : m_operators->faces) {
      const std::array<double, 3> couplings = face.layout.couplings();
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = face.places[(k + 1) % 3];
        const Index b = face.places[(k + 2) % 3];
        has_sources |= couple(a, b, couplings[k]);
        has_sources |= couple(b, a, couplings[k]);
      }
    }
    m_heat.swap(m_sources);
    return has_sources;
  }

  /// Adds the sources that an entry of the matrix makes where the heat is known at `from` and not at `to`.
  bool couple(Index from, Index to, double entry)
  {
    bool has_sources = false;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (m_zones[from][lane] == known && m_zones[to][lane] == beyond) {
        m_sources[to][lane] -= std::ldexp(entry * m_heat[from][lane], -frontier_exponent);
        m_sources[from][lane] += std::ldexp(entry * m_heat[to][lane], -frontier_exponent);
        has_sources = true;
      }
    }
    return has_sources;
  }

  /// Shifts the potential, which the divergence has become, so that it is the distance, on average, at the vertices of
  /// the sources.
  void write_distances()
  {
    // A component that is not reached is shifted to infinity.
    m_shifts.assign(elements().number_of_components(), Row{});
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (Index i = 0; i < elements().number_of_components(); ++i) {
        m_shifts[i][lane] = is_reached(i, lane) ? 0 : -infinity;
      }
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        add_shift(source, lane);
      }
      m_distances[lane]->resize(elements().number_of_vertices());
    }
    for (Index v = 0; v < elements().number_of_vertices(); ++v) {
      const Index component = elements().component(v);
      const typename Row::Array distance =
          (m_divergence[place(v)].array() - m_shifts[component].array()) * elements().unit(component);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        (*m_distances[lane])[v] = distance[int(lane)];
      }
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        if (source.is_vertex()) {
          (*m_distances[lane])[source.vertices[0]] = 0;
        }
      }
    }
  }

  void add_shift(const Geodesic_source& source, std::size_t lane)
  {
    const Index component = elements().component(source.vertices[0]);
    const double unit = elements().unit(component);
    double excess = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double distance = unit > 0 ? source.distances[k] / unit : 0.;
      excess += source.weights[k] * (m_divergence[place(source.vertices[k])][lane] - distance);
    }
    m_shifts[component][lane] += excess / m_number_of_sources[component][lane];
  }

  const Heat_operators* m_operators = nullptr;
  std::array<const std::vector<Geodesic_source>*, lanes> m_source_sets{};
  std::array<std::vector<double>*, lanes> m_distances{};
  // Of every vertex, in the order of elimination:
  std::vector<Row> m_heat;
  std::vector<Row> m_divergence;
  std::vector<Row> m_sources;
  std::vector<std::array<Zone, lanes>> m_zones;
  std::vector<Row> m_number_of_sources; // of every component
  std::vector<Row> m_shifts;            // of every component
  std::vector<Left_face> m_left_faces;
};

struct Heat_method::Workspace::Batches
{
  Heat_batch<1> single;
  Heat_batch<batch_size> batch;
};

CSCD_INLINE Heat_method::Workspace::Workspace() : m_batches(std::make_unique<Batches>())
{
}
CSCD_INLINE Heat_method::Workspace::~Workspace() = default;
CSCD_INLINE Heat_method::Workspace::Workspace(Workspace&&) noexcept = default;
CSCD_INLINE Heat_method::Workspace& Heat_method::Workspace::operator=(Workspace&&) noexcept = default;

CSCD_INLINE Heat_method::Heat_method(Cotangent_elements&& elements, double time_step_factor)
    : m_operators(std::make_shared<const Heat_operators>(std::move(elements), time_step_factor))
{
  CGAL_precondition(time_step_factor > 0);
}

CSCD_INLINE const Cotangent_elements& Heat_method::elements() const
{
  return m_operators->elements;
}

CSCD_INLINE void Heat_method::operator()(const std::vector<Geodesic_source>& sources, std::vector<double>& distances,
                                         Workspace& workspace) const
{
  workspace.m_batches->single(*m_operators, {&sources}, {&distances});
}

CSCD_INLINE void Heat_method::operator()(const std::vector<std::vector<Geodesic_source>>& source_sets,
                                         std::vector<std::vector<double>>& distances, Workspace& workspace) const
{
  // From this number of sets on, a batch takes less time than one by one.
  constexpr std::size_t min_batch = 3;
  distances.resize(source_sets.size());
  for (std::size_t begin = 0; begin < source_sets.size(); begin += batch_size) {
    const std::size_t size = std::min(batch_size, source_sets.size() - begin);
    if (size < min_batch) {
      for (std::size_t i = begin; i < begin + size; ++i) {
        (*this)(source_sets[i], distances[i], workspace);
      }
      continue;
    }
    std::array<const std::vector<Geodesic_source>*, batch_size> batch_sets{};
    std::array<std::vector<double>*, batch_size> batch_distances{};
    for (std::size_t lane = 0; lane < batch_size; ++lane) {
      // Lanes to spare repeat the last set.
      const std::size_t i = begin + std::min(lane, size - 1);
      batch_sets[lane] = &source_sets[i];
      batch_distances[lane] = &distances[i];
    }
    workspace.m_batches->batch(*m_operators, batch_sets, batch_distances);
  }
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_HEAT_METHOD_IMPL_H
