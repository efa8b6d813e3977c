// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bound_memory.h"

#include "memory.h"
#include <CSCD/IO/internal/Polygon_soup.h>
#include <CSCD/IO/internal/has_unmatched_side.h>
#include <CSCD/IO/read_triangle_mesh.h>
#include <CSCD/IO/write_correspondence.h>
#include <CSCD/Surface/coarsen_triangles.h>
#include <CSCD/Vector_3.h>
#include <CSCD/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace cscd {

namespace {

using Soup = CSCD::internal::Polygon_soup;

/// \name Bytes, as measured on meshes of 0.7 to 20 million vertices and rounded up; see doc/performance.md
/// @{
constexpr std::size_t bytes_of_program = std::size_t(16) << 20U;
constexpr std::size_t bytes_a_vertex = 340;              // of surface, levels and search
constexpr std::size_t bytes_a_vertex_with_borders = 140; // more, where there are any: they are looked at and closed
constexpr std::size_t bytes_a_vertex_of_mesh = 150;      // more, where a mesh is made
constexpr std::size_t bytes_a_coarsened_vertex = 6;      // beside the triangles, while they are coarsened
constexpr std::size_t bytes_a_merged_vertex = 24;    // beside them, while points of equal coordinates are looked for
constexpr std::size_t bytes_a_vertex_of_block = 300; // of the blocks that are coarsened at a time
/// @}

/// On fewer vertices than this, thin limbs are lost.
constexpr std::size_t min_number_of_vertices = 10000;

std::size_t bytes_of(const Soup& soup)
{
  const std::size_t offsets = soup.first_corner.are_triangles() ? 0 : soup.first_corner.size();
  return sizeof(CSCD::Vector_3) * (soup.points.size() + soup.normals.size()) +
         sizeof(CSCD::Index) * soup.corners.size() + sizeof(std::size_t) * offsets;
}

[[noreturn]] void refuse(const Skeletonize_options& options, std::size_t number_of_vertices, std::size_t needed)
{
  throw CSCD::Input_error(name_of(options.input) + ": " + std::to_string(number_of_vertices) +
                          " vertices do not fit into --max-memory " + memory_size_text(options.max_memory) +
                          ", however coarse: it has to be " + memory_size_text(needed) + " at least");
}

/// The size of a file that is read into memory as it is, else 0.
std::size_t bytes_of_file(const std::string& name)
{
  std::error_code error;
  const auto size = name == standard_stream ? 0 : std::filesystem::file_size(name, error);
  return error ? 0 : std::size_t(size);
}

void add(const CSCD::Mesh_repair_report& earlier, CSCD::Mesh_repair_report& report)
{
  report.number_of_triangulated_polygons += earlier.number_of_triangulated_polygons;
  report.number_of_removed_faces += earlier.number_of_removed_faces;
  report.number_of_merged_points += earlier.number_of_merged_points;
}

} // namespace

std::optional<Coarse_triangles> bound_memory(Soup& soup, const Skeletonize_options& options, std::size_t file_bytes,
                                             std::size_t other_bytes, bool makes_mesh)
{
  const std::size_t n = soup.points.size();
  const std::size_t per_vertex = bytes_a_vertex + (makes_mesh ? bytes_a_vertex_of_mesh : 0) +
                                 (CSCD::internal::has_unmatched_side(soup) ? bytes_a_vertex_with_borders : 0);
  const std::size_t without_coarsening = bytes_of_program + other_bytes + per_vertex * n;
  if (without_coarsening <= options.max_memory) {
    return std::nullopt;
  }
  const std::size_t others = bytes_of_program + other_bytes + sizeof(CSCD::Index) * n;
  const std::size_t bytes_of_block = bytes_a_vertex_of_block * std::min(n, CSCD::default_coarsening_block);
  const std::size_t beside_blocks = bytes_of_program + other_bytes + bytes_of(soup) + bytes_a_coarsened_vertex * n;
  const std::size_t needed = std::max({others + per_vertex * min_number_of_vertices, beside_blocks + bytes_of_block,
                                       bytes_of_program + other_bytes + bytes_of(soup) + bytes_a_merged_vertex * n,
                                       bytes_of_program + file_bytes + bytes_of(soup)});
  if (needed > options.max_memory) {
    refuse(options, n, std::min(needed, without_coarsening));
  }
  const std::size_t max_number_of_vertices = (options.max_memory - others) / per_vertex;
  const std::size_t max_number_of_threads = (options.max_memory - beside_blocks) / bytes_of_block;
  const std::size_t number_of_threads =
      options.number_of_threads > 0 ? options.number_of_threads : std::max(1U, std::thread::hardware_concurrency());
  Coarse_triangles result;
  result.point_of_file = CSCD::internal::coarsen_soup(soup, max_number_of_vertices,
                                                      unsigned(std::min(number_of_threads, max_number_of_threads)),
                                                      result.earlier_repairs);
  if (soup.points.size() > max_number_of_vertices) {
    refuse(options, n, others + per_vertex * soup.points.size());
  }
  result.points = soup.points;
  result.bound = {options.max_memory, n, soup.points.size()};
  return result;
}

Input to_input(Soup&& soup, std::optional<Coarse_triangles>&& coarse, const Skeletonize_options& options,
               bool makes_mesh)
{
  constexpr bool keeps_file = false; // coarse triangles are not those of the file
  Input input =
      to_input(std::move(soup), options.input, options.is_quiet, keeps_file, makes_mesh, options.number_of_threads);
  if (coarse) {
    add(coarse->earlier_repairs, input.repairs);
  }
  input.coarse = std::move(coarse);
  return input;
}

Input read_within_memory(const Skeletonize_options& options, bool makes_mesh)
{
  const std::size_t file_bytes = bytes_of_file(options.input);
  const std::size_t bytes_to_read = bytes_of_program + file_bytes;
  if (bytes_to_read > options.max_memory) {
    throw CSCD::Input_error(name_of(options.input) + ": to read the file takes more than --max-memory " +
                            memory_size_text(options.max_memory) + ": it has to be " +
                            memory_size_text(2 * bytes_to_read) + " or so at least");
  }
  Soup soup = read_soup(options.input, options.format);
  if (soup.number_of_polygons() == 0) {
    throw Usage_error("--max-memory: is for meshes only, not for points; leave the option out");
  }
  const bool keeps_file = !(options.correspondence.empty() && options.labelled.empty());
  Soup as_read;
  if (keeps_file) {
    as_read = soup;
  }
  const std::size_t bytes_of_labels =
      keeps_file ? bytes_of(soup) + sizeof(CSCD::Vertex_label) * soup.points.size() : std::size_t(0);
  std::optional<Coarse_triangles> coarse = bound_memory(soup, options, file_bytes, bytes_of_labels, makes_mesh);
  Input input = to_input(std::move(soup), std::move(coarse), options, makes_mesh);
  input.as_read = std::move(as_read);
  return input;
}

std::string sentence(const Memory_bound& bound)
{
  return "coarsened from " + std::to_string(bound.number_of_file_vertices) + " to " +
         std::to_string(bound.number_of_vertices) + " vertices, to stay within " + memory_size_text(bound.max_memory) +
         " of memory";
}

} // namespace cscd
