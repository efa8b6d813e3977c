// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distances by the heat method, several sources at a time.

#ifndef CSCD_PUBLISHED_HEAT_METHOD_H
#define CSCD_PUBLISHED_HEAT_METHOD_H

#include <CSCD/Published/Cotangent_elements.h>
#include <CSCD/Published/Intrinsic_triangulation.h>
#include <CSCD/Surface/Triangulated_surface.h>
#include <CSCD/Vector3.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// One number of each of so many problems that are solved together.
template <std::size_t lanes>
struct Lanes : Eigen::Array<double, int(lanes), 1>
{
  using Array = Eigen::Array<double, int(lanes), 1>;
  using Array::Array;
  using Array::operator=;

  double& operator[](std::size_t lane) { return this->coeffRef(Eigen::Index(lane)); }
  double operator[](std::size_t lane) const { return this->coeff(Eigen::Index(lane)); }
};

/// One row for each vertex; none is in two cache lines, which 8 lanes fill.
template <std::size_t lanes>
using Lane_rows = std::vector<Lanes<lanes>, boost::alignment::aligned_allocator<Lanes<lanes>, sizeof(Lanes<lanes>)>>;

/// The factors of symmetric positive definite matrices with a common pattern, for many right-hand sides.
///
/// Eigen factors (LDL^T with approximate minimum degree ordering). The triangular solves are not Eigen's. Eigen treats
/// several right-hand sides one after the other, and each waits for the factor to come from memory. Here the numbers of
/// several right-hand sides lie side by side, and one pass over the factor serves all.
/// All members are const and may be called by several threads at once.
class Interleaved_solver
{
public:
  /// Factors `matrices`. Only their lower triangles are read.
  /// \pre they are not empty, and have the same size and pattern
  /// \throw Input_error if one of them is not positive definite within rounding; the message is `message`
  Interleaved_solver(const std::vector<Eigen::SparseMatrix<double>>& matrices, const std::string& message)
  {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> factorization;
    factorization.analyzePattern(matrices.front());
    for (const Eigen::SparseMatrix<double>& matrix : matrices) {
      CGAL_precondition(matrix.nonZeros() == matrices.front().nonZeros());
      factorization.factorize(matrix);
      const auto& pivots = factorization.vectorD();
      if (factorization.info() != Eigen::Success || !pivots.allFinite() || !(pivots.minCoeff() > 0)) {
        throw Input_error(message);
      }
      const auto& lower = factorization.matrixL().nestedExpression();
      CGAL_assertion(lower.isCompressed());
      m_column_begin.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
      m_row.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
      m_factors.push_back({{lower.valuePtr(), lower.valuePtr() + m_row.size()}, pivots.cwiseInverse()});
    }
    m_place = factorization.permutationP().indices();
  }

  std::size_t size() const { return std::size_t(m_place.size()); }

  /// The place of `row` in the order of elimination, the order of right-hand sides and solutions.
  Index place(Index row) const { return Index(m_place[row]); }

  /// Replaces the right-hand sides `x`, in the order of elimination, by the solutions for the matrix of this number.
  /// Linear in the number of nonzeros of the factor; the solutions of a lane do not depend on the other lanes.
  /// \pre `x.size() == size()`
  /// \tparam Rows `Lane_rows` of any number of lanes
  template <class Rows>
  void solve(std::size_t matrix, Rows& x) const
  {
    CGAL_precondition(x.size() == size());
    const double* value = m_factors[matrix].values.data();
    for (std::size_t column = 0; column < size(); ++column) {
      const typename Rows::value_type from = x[column];
      // Right-hand sides with few entries reach few columns.
      if ((from != 0).any()) {
        for (std::size_t entry = m_column_begin[column]; entry < m_column_begin[column + 1]; ++entry) {
          x[m_row[entry]] -= value[entry] * from;
        }
      }
    }
    const Eigen::VectorXd& inverse_pivot = m_factors[matrix].inverse_pivots;
    for (std::size_t column = size(); column-- > 0;) {
      typename Rows::value_type sum = inverse_pivot[Eigen::Index(column)] * x[column];
      for (std::size_t entry = m_column_begin[column]; entry < m_column_begin[column + 1]; ++entry) {
        sum -= value[entry] * x[m_row[entry]];
      }
      x[column] = sum;
    }
  }

private:
  struct Factor
  {
    std::vector<double> values; // of the entries below the diagonal, column by column
    Eigen::VectorXd inverse_pivots;
  };

  Eigen::VectorXi m_place;
  std::vector<Index> m_column_begin; // in the entries, and their number at the end
  std::vector<Index> m_row;          // of every entry
  std::vector<Factor> m_factors;
};

/// A point of a surface that distance is measured from, relative to the vertices around it: so it is a source on every
/// triangulation of the surface with the same vertices.
struct Geodesic_source
{
  static Geodesic_source at_vertex(Index vertex) { return {{vertex, vertex, vertex}, {1, 0, 0}, {0, 0, 0}}; }

  /// The point in a face of `triangulation` with these barycentric coordinates with respect to the origins of the
  /// halfedges 3 `face`, 3 `face` + 1 and 3 `face` + 2.
  /// \pre the coordinates are not negative, and their sum is 1; the face carries area
  static Geodesic_source in_face(const Triangulated_surface& triangulation, Index face,
                                 const std::array<double, 3>& coordinates)
  {
    const std::array<double, 3> lengths{triangulation.length(3 * face), triangulation.length(3 * face + 1),
                                        triangulation.length(3 * face + 2)};
    const double unit = (lengths[0] + lengths[1] + lengths[2]) / 3;
    const Face_layout layout = lay_out_face(lengths, unit > 0 ? unit : 1.);
    const std::array<double, 3> x{0, layout.base, layout.apex_x};
    const std::array<double, 3> y{0, 0, layout.apex_y};
    const double source_x = coordinates[1] * layout.base + coordinates[2] * layout.apex_x;
    const double source_y = coordinates[2] * layout.apex_y;
    Geodesic_source result{};
    for (Index k = 0; k < 3; ++k) {
      const Index corner = triangulation.origin(3 * face + k);
      if (coordinates[k] == 1) {
        return at_vertex(corner);
      }
      result.vertices[k] = corner;
      result.weights[k] = coordinates[k];
      result.distances[k] = std::hypot(x[k] - source_x, y[k] - source_y);
    }
    return result;
  }

  std::array<Index, 3> vertices;   ///< around the point
  std::array<double, 3> weights;   ///< its barycentric coordinates
  std::array<double, 3> distances; ///< from it to the vertices, in the unit of the lengths
};

/// Geodesic distance from any number of sources, on a triangulation given by its edge lengths: the elements of a
/// surface and the factors of the heat method's two equations. A `Heat_workspace` computes distances.
///
/// On Delaunay triangulations a distance is exact to a few tenths of an edge where the surface is smooth, and rounded
/// off over two or three edges on ridges, where shortest paths from different sides meet. Other triangulations should
/// be made Delaunay first. Accuracy does not degrade with distance. It may be used by several threads at once, each
/// with its own workspace.
struct Heat_method
{
  /// The numbers of the matrices in `solver`.
  static constexpr std::size_t heat = 0;    ///< masses / time + stiffness: one implicit step of heat flow
  static constexpr std::size_t poisson = 1; ///< stiffness, pinned

  /// Factors the equations of `triangulation`, which is not referred to later; O(n^1.5), and usually nearly linear.
  /// \param time_step_factor the duration of the heat flow, in squared mean edge lengths of the component: more is
  ///        smoother and less exact
  /// \pre `time_step_factor` is positive
  /// \throw Input_error if the equations cannot be factored
  explicit Heat_method(const Intrinsic_triangulation& triangulation, double time_step_factor = 1)
      : elements(triangulation),
        solver({elements.matrix(1 / time_step_factor, false), elements.matrix(0, true)},
               "the Laplacian of the surface cannot be factored: its triangles are too uneven; remesh it, for instance "
               "by CGAL::Polygon_mesh_processing::isotropic_remeshing")
  {
    CGAL_precondition(time_step_factor > 0);
    faces.reserve(elements.faces.size());
    for (const Cotangent_elements::Face& face : elements.faces) {
      faces.push_back({{solver.place(face.vertices[0]), solver.place(face.vertices[1]), solver.place(face.vertices[2])},
                       face.layout});
    }
    const auto first_place = [](const Face& face) { return *std::min_element(face.places.begin(), face.places.end()); };
    std::stable_sort(faces.begin(), faces.end(),
                     [&](const Face& a, const Face& b) { return first_place(a) < first_place(b); });
  }

  /// A face of the elements, in the order of elimination.
  struct Face
  {
    std::array<Index, 3> places; ///< of its corners
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
  void operator()(const Heat_method& method, const std::array<const std::vector<Geodesic_source>*, lanes>& source_sets,
                  const std::array<std::vector<double>*, lanes>& distances)
  {
    m_method = &method;
    m_source_sets = source_sets;
    m_distances = distances;
    prepare();
    do {
      method.solver.solve(Heat_method::heat, m_heat);
    } while (pass_faces() && set_frontier_sources());
    method.solver.solve(Heat_method::poisson, m_divergence);
    write_distances();
  }

private:
  using Row = Lanes<lanes>;
  using Face = Heat_method::Face;
  using Lane_set = std::bitset<lanes>;

  /// The power of two below which heat is left to the next stage. Numbers still have full precision down to 2^-1022:
  /// only products with a number less than 2^-122 are lost here, and every sum loses these.
  static constexpr int frontier_exponent = -900;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The direction of the heat flow in a face, where `largest` is large enough.
  struct Flow
  {
    Row largest; ///< heat of a corner
    Row x, y;
  };

  static double frontier() { return std::ldexp(1., frontier_exponent); }
  const Cotangent_elements& elements() const { return m_method->elements; }
  Index place(Index vertex) const { return m_method->solver.place(vertex); }
  bool is_reached(Index component, std::size_t lane) const { return m_number_of_sources[component][lane] > 0; }

  /// The lanes where `predicate(lane)` holds.
  template <class Predicate>
  static Lane_set lanes_where(const Predicate& predicate)
  {
    Lane_set result;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      result[lane] = predicate(lane);
    }
    return result;
  }

  void prepare()
  {
    const std::size_t n = elements().number_of_vertices();
    m_heat.assign(n, Row::Zero());
    m_divergence.assign(n, Row::Zero());
    m_number_of_sources.assign(elements().number_of_components(), Row::Zero());
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        add_source(source, lane);
      }
    }
    m_known.resize(n);
    m_beyond.resize(n);
    for (Index v = 0; v < n; ++v) {
      const Index component = elements().component[v];
      m_beyond[place(v)] = lanes_where([&](std::size_t lane) { return is_reached(component, lane); });
    }
  }

  void add_source(const Geodesic_source& source, std::size_t lane)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      CGAL_precondition(source.vertices[k] < elements().number_of_vertices());
      m_heat[place(source.vertices[k])][lane] += source.weights[k];
    }
    m_number_of_sources[elements().component[source.vertices[0]]][lane] += 1;
  }

  /// The direction of the flow, which needs no square of a small number. The absolute value is taken, as in CGAL: where
  /// faces are far from Delaunay, heat is negative here and there, but falls with the distance all the same.
  Flow flow(const Face& face) const
  {
    // Keeps the zero vector where it is.
    constexpr double min_norm = std::numeric_limits<double>::min();
    const Row heat_0 = m_heat[face.places[0]].abs();
    const Row heat_1 = m_heat[face.places[1]].abs();
    const Row heat_2 = m_heat[face.places[2]].abs();
    Flow result;
    result.largest = heat_0.max(heat_1).max(heat_2);
    const Row scale = 1 / result.largest.max(frontier());
    const Row x = (heat_0 - heat_1) * scale * (1 / face.layout.base);
    const Row y = ((heat_0 - heat_2) * scale - face.layout.apex_x * x) * (1 / face.layout.apex_y);
    const Row inverse_norm = 1 / (x * x + y * y).sqrt().max(min_norm);
    result.x = x * inverse_norm;
    result.y = y * inverse_norm;
    return result;
  }

  /// Adds the divergence of the flow in the faces beyond the frontier, in the lanes where they have enough heat.
  /// \return whether there are faces that heat has yet to reach
  bool pass_faces()
  {
    bool are_faces_left = false;
    for (const Face& face : m_method->faces) {
      const auto [a, b, c] = face.places;
      const Lane_set beyond = m_beyond[a] & m_beyond[b] & m_beyond[c];
      if (beyond.none()) {
        continue;
      }
      Flow result = flow(face);
      if (!beyond.all() || (result.largest < frontier()).any()) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          if (!beyond[lane] || result.largest[lane] < frontier()) {
            result.x[lane] = 0;
            result.y[lane] = 0;
            are_faces_left = are_faces_left || beyond[lane];
          }
        }
      }
      const Face_layout& layout = face.layout;
      const Row flux_b = (layout.apex_y * result.x - layout.apex_x * result.y) * 0.5;
      const Row flux_c = layout.base * 0.5 * result.y;
      m_divergence[a] -= flux_b + flux_c;
      m_divergence[b] += flux_b;
      m_divergence[c] += flux_c;
    }
    return are_faces_left;
  }

  /// Advances the frontier, and replaces the heat by the sources of the next stage: what the matrix makes of the heat
  /// beyond the frontier, taken alone. On the vertices there it is minus what the matrix makes of the known heat.
  /// \return false if no source is left
  bool set_frontier_sources()
  {
    for (std::size_t i = 0; i < m_heat.size(); ++i) {
      const auto has_heat = [&](std::size_t lane) { return !(std::abs(m_heat[i][lane]) < frontier()); };
      m_known[i] = m_beyond[i] & lanes_where(has_heat);
      m_beyond[i] &= ~m_known[i];
    }
    m_sources.assign(m_heat.size(), Row::Zero());
    bool has_sources = false;
    for (const Face& face : m_method->faces) {
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
    const Lane_set across = m_known[from] & m_beyond[to];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (across[lane]) {
        m_sources[to][lane] -= std::ldexp(entry * m_heat[from][lane], -frontier_exponent);
        m_sources[from][lane] += std::ldexp(entry * m_heat[to][lane], -frontier_exponent);
      }
    }
    return across.any();
  }

  /// Shifts the potential, which the divergence has become, so that it is the distance, on average, at the vertices of
  /// the sources.
  void write_distances()
  {
    m_shifts.assign(elements().number_of_components(), Row::Zero());
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        add_shift(source, lane);
      }
      m_distances[lane]->resize(elements().number_of_vertices());
    }
    for (Index v = 0; v < elements().number_of_vertices(); ++v) {
      const Index component = elements().component[v];
      const Row distance = (m_divergence[place(v)] - m_shifts[component]) * elements().units[component];
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        (*m_distances[lane])[v] = is_reached(component, lane) ? distance[lane] : infinity;
      }
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (const Geodesic_source& source : *m_source_sets[lane]) {
        if (source.weights[0] == 1) { // a vertex
          (*m_distances[lane])[source.vertices[0]] = 0;
        }
      }
    }
  }

  void add_shift(const Geodesic_source& source, std::size_t lane)
  {
    const Index component = elements().component[source.vertices[0]];
    const double unit = elements().units[component];
    double excess = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double distance = unit > 0 ? source.distances[k] / unit : 0.;
      excess += source.weights[k] * (m_divergence[place(source.vertices[k])][lane] - distance);
    }
    m_shifts[component][lane] += excess / m_number_of_sources[component][lane];
  }

  const Heat_method* m_method = nullptr;
  std::array<const std::vector<Geodesic_source>*, lanes> m_source_sets{};
  std::array<std::vector<double>*, lanes> m_distances{};
  // Of every vertex, in the order of elimination:
  Lane_rows<lanes> m_heat;
  Lane_rows<lanes> m_divergence;
  Lane_rows<lanes> m_sources;
  std::vector<Lane_set> m_known;  // where this stage is the first with enough heat
  std::vector<Lane_set> m_beyond; // where all stages so far had too little heat, and some source will bring it
  // Of every component:
  Lane_rows<lanes> m_number_of_sources;
  Lane_rows<lanes> m_shifts;
};

/// Computes distances by the heat method. One object serves one thread: it is working memory, 270 bytes a vertex where
/// batches are solved, reused from call to call.
class Heat_workspace
{
public:
  /// As many sets of sources are solved for at once.
  static constexpr std::size_t batch_size = 8;

  /// Calls `use(i, distances)` for the sets of sources from 0 on: `distances` has for every vertex that from the
  /// nearest source of the set, in the unit of the lengths, until the next call. It is 0 at vertices that are sources,
  /// infinite on components without a source, single vertices among them. Close to several sources, or to one inside a
  /// face, values may be a little below 0. Near linear in the number of vertices.
  ///
  /// Sets are solved for eight at a time, in about a third of the time. The result is the same as one by one, bit for
  /// bit unless the compiler fuses multiplications and additions as it likes.
  template <class Use>
  void operator()(const Heat_method& method, const std::vector<std::vector<Geodesic_source>>& source_sets,
                  const Use& use)
  {
    // From this number of sets on, a batch takes less time than one by one.
    constexpr std::size_t min_batch = 3;
    for (std::size_t begin = 0; begin < source_sets.size(); begin += batch_size) {
      const std::size_t size = std::min(batch_size, source_sets.size() - begin);
      if (size >= min_batch) {
        std::array<const std::vector<Geodesic_source>*, batch_size> batch_sets{};
        std::array<std::vector<double>*, batch_size> batch_distances{};
        for (std::size_t lane = 0; lane < batch_size; ++lane) {
          // Lanes to spare repeat the last set.
          const std::size_t i = std::min(lane, size - 1);
          batch_sets[lane] = &source_sets[begin + i];
          batch_distances[lane] = &m_distances[i];
        }
        m_batch(method, batch_sets, batch_distances);
      }
      for (std::size_t i = 0; i < size; ++i) {
        if (size < min_batch) {
          m_single(method, {&source_sets[begin + i]}, {&m_distances[i]});
        }
        use(begin + i, std::as_const(m_distances[i]));
      }
    }
  }

private:
  Heat_batch<1> m_single;
  Heat_batch<batch_size> m_batch;
  std::array<std::vector<double>, batch_size> m_distances;
};

/// Estimates the distance of every vertex from the nearest one of `sources` by the heat method, for callers that ask
/// once; infinite on components without a source, single vertices among them. O(n^1.5), and usually nearly linear.
/// \param triangulation Delaunay
/// \throw Input_error if the equations cannot be factored
inline std::vector<double> distances_from_vertices(const Intrinsic_triangulation& triangulation,
                                                   const std::vector<Index>& sources)
{
  std::vector<Geodesic_source> geodesic_sources;
  std::transform(sources.begin(), sources.end(), std::back_inserter(geodesic_sources), Geodesic_source::at_vertex);
  std::vector<double> result;
  Heat_workspace()(Heat_method(triangulation), {geodesic_sources},
                   [&](std::size_t, const std::vector<double>& distances) { result = distances; });
  return result;
}

} // namespace CSCD::internal

#endif // CSCD_PUBLISHED_HEAT_METHOD_H
