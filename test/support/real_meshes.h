// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Real meshes that come with CGAL (Debian package libcgal-demo), with their topology.

#ifndef CSCD_TEST_SUPPORT_REAL_MESHES_H
#define CSCD_TEST_SUPPORT_REAL_MESHES_H

#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD::test {

/// A mesh file and the known properties of the mesh.
struct Real_mesh
{
  const char* name; ///< of the file, without its ending `.off`
  std::size_t number_of_components;
  std::size_t genus; ///< summed over the components, every border closed by a disc
  std::size_t number_of_border_cycles;

  std::string path() const { return std::string(CSCD_CGAL_DATA_DIR) + "/" + name + ".off"; }
  bool exists() const { return std::ifstream(path()).good(); }
};

inline void PrintTo(const Real_mesh& mesh, std::ostream* out)
{
  *out << mesh.name;
}

/// Closed meshes: animals, people, bones, knots, machine parts; from 24 to 44,460 vertices.
inline std::vector<Real_mesh> closed_real_meshes()
{
  return {{"3torus", 1, 3, 0},       {"anchor_dense", 1, 4, 0},
          {"armadillo", 1, 0, 0},    {"bear", 1, 0, 0},
          {"bones", 26, 0, 0},       {"bull", 1, 0, 0},
          {"bunny00", 1, 0, 0},      {"cactus", 1, 0, 0},
          {"camel", 1, 0, 0},        {"cheese", 1, 133, 0},
          {"couplingdown", 1, 9, 0}, {"cow", 1, 0, 0},
          {"cross", 1, 0, 0},        {"dino", 1, 0, 0},
          {"diplodocus", 1, 0, 0},   {"dragknob", 1, 0, 0},
          {"eight", 1, 2, 0},        {"elephant", 1, 3, 0},
          {"elk", 1, 1, 0},          {"ellipsoid", 1, 0, 0},
          {"fandisk", 1, 0, 0},      {"femur", 1, 2, 0},
          {"hand", 1, 0, 0},         {"handle", 1, 0, 0},
          {"helmet", 1, 3, 0},       {"homer", 1, 0, 0},
          {"joint", 1, 2, 0},        {"knot1", 1, 1, 0},
          {"knot2", 2, 2, 0},        {"man", 1, 0, 0},
          {"mpi_triang", 1, 1, 0},   {"pinion_small", 1, 1, 0},
          {"pipe", 1, 1, 0},         {"refined_elephant", 1, 3, 0},
          {"retinal", 1, 0, 0},      {"rotor_small", 1, 1, 0},
          {"spool", 1, 0, 0},        {"triceratops", 1, 0, 0},
          {"tripod", 1, 0, 0},       {"turbine", 1, 11, 0}};
}

/// Meshes with borders: pierced bodies, patches, shells, and a scene of many pieces.
inline std::vector<Real_mesh> open_real_meshes()
{
  return {{"ChineseDragon-10kv", 1, 0, 2},
          {"b9_mesh", 47, 4, 76},
          {"blade", 1, 0, 2},
          {"blobby_3cc", 3, 0, 4},
          {"double-torus-3-holes", 1, 2, 3},
          {"elephant-with-holes", 1, 3, 106},
          {"head", 1, 0, 3},
          {"horizons", 2, 0, 2},
          {"lion-head", 1, 0, 1},
          {"mask_cone", 2, 0, 2},
          {"mushroom", 1, 0, 1},
          {"patch-13", 1, 0, 1},
          {"pig", 1, 0, 7},
          {"plane", 1, 0, 1},
          {"triangle", 1, 0, 1},
          {"three_peaks", 1, 0, 1}};
}

} // namespace CSCD::test

#endif // CSCD_TEST_SUPPORT_REAL_MESHES_H
