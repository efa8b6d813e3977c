// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes to NRRD, and which node of a skeleton each voxel belongs to.

#ifndef CSCD_IO_WRITE_NRRD_H
#define CSCD_IO_WRITE_NRRD_H

#include <CSCD/IO/read_volume.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <cstdint>
#include <ostream>
#include <vector>

namespace CSCD {

/// writes `volume` as NRRD, raw, with labels of 64 bits. Linear.
/// \pre there is a label for each voxel
void write_nrrd(std::ostream& out, const Volume& volume);

/// writes as NRRD the node of each voxel of a volume: the node of the nearest vertex of the surface of its label. The
/// segment to this vertex is inside the body, so that a voxel never gets a node of a neighboring limb. The volume is
/// read and written slice by slice. Expectedly O(n log m) for n voxels in bodies and m vertices.
/// \param reader before its first slice
/// \param surfaces of the labels; voxels of labels without a surface get 0
/// \param node_of_vertex for each surface and each of its points, the number that its voxels get
/// \throw File_error if the volume cannot be read to its end
void write_node_volume(std::ostream& out, Volume_reader& reader, const std::vector<Voxel_surface>& surfaces,
                       const std::vector<std::vector<std::uint32_t>>& node_of_vertex);

} // namespace CSCD

#endif // CSCD_IO_WRITE_NRRD_H
