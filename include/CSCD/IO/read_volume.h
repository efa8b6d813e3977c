// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Image volumes from files, slice by slice.

#ifndef CSCD_IO_READ_VOLUME_H
#define CSCD_IO_READ_VOLUME_H

#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/internal/config.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CSCD {

/// Which voxels of a file are of a body.
struct Voxel_selection
{
  /// Voxels of at least this value are a body of label 1.
  std::optional<double> threshold;
  /// Voxels of this label, which is not 0, are a body of this label.
  std::optional<Voxel_label> label;
  /// Whether the voxels of each label but 0 are a body of their own; else, without label and threshold, all that are
  /// not 0 are one body of label 1.
  bool separates_labels = false;
};

namespace internal {
struct Volume_file;
}

/// Reads the slices of a volume one after the other, so that there is never more than one in memory:
/// - NRRD, raw or gzip, with its data attached or not (`.nrrd`, `.nhdr`)
/// - NIfTI-1 in one file, also compressed (`.nii`, `.nii.gz`)
/// - MetaImage, also compressed, with its data attached or not (`.mha`, `.mhd`)
/// - TIFF with a slice a page (`.tif`, `.tiff`), if built with libtiff
///
/// Raw data are read by a `.nhdr` or `.mhd` that describes them. Compressed data need zlib. Coordinates are those of
/// the file: its origin is the center of the first voxel, and nothing is converted from one system of axes to another.
class Volume_reader
{
public:
  /// Reads the header and checks it against the size of the data.
  /// \throw File_error if the file cannot be read, its header is malformed, has sizes that its data cannot have, or
  ///        axes that are not finite or do not span the space, or the build lacks a library for its format
  Volume_reader(const std::string& filename, const Voxel_selection& selection);
  /// Takes over the file of `other`.
  Volume_reader(Volume_reader&& other) noexcept;
  ~Volume_reader();

  /// Where the voxels are.
  const Volume_grid& grid() const;
  /// Reads the next slice.
  /// \param labels is replaced by the labels of the selected voxels, and 0 for all others
  /// \throw File_error if the data end too early, are damaged, or hold a number that is not a label; a value that is
  ///        not a number belongs to the background
  /// \pre there is a next slice
  void read_slice(std::vector<Voxel_label>& labels);

private:
  std::unique_ptr<internal::Volume_file> m_file;
  Voxel_selection m_selection;
};

/// Whether `filename` has an ending of volumes.
bool is_volume_filename(const std::string& filename);

/// reads a volume into memory. \see Volume_reader
Volume read_volume(const std::string& filename, const Voxel_selection& selection = {});

/// reads the surfaces of the bodies in a volume, in ascending order of their labels. Only two slices and the surfaces
/// are in memory. \see Volume_reader, Voxel_surface_builder \throw File_error, Input_error whose messages name the file
std::vector<Voxel_surface> read_voxel_surfaces(const std::string& filename, const Voxel_selection& selection = {},
                                               const Voxel_surface_settings& settings = {});

/// reads the surfaces of the bodies in a volume, and passes each to `take` after its last slice, so that the surfaces
/// of a large volume need not be in memory at once. The bodies come in the order of their last slices, and of their
/// labels within one. A volume with several labels is read twice, and checked before the first call of `take`.
/// \throw File_error, Input_error as `read_voxel_surfaces()`; every exception of `take`
void for_each_voxel_surface(const std::string& filename, const Voxel_selection& selection,
                            const Voxel_surface_settings& settings, const std::function<void(Voxel_surface&&)>& take);

} // namespace CSCD

#endif // CSCD_IO_READ_VOLUME_H
