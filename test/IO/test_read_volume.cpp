// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes from all formats, and files that are refused.

#include "mesh_files.h"
#include "support/Temporary_folder.h"
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/exceptions.h>

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test_support;
using CSCD::Vector3, CSCD::Volume;

const std::vector<std::uint16_t> voxel_values{0, 1, 2, 3, 4, 500, 0, 0, 7, 8, 0, 65535}; // 3 x 2 x 2
const CSCD::Voxel_selection each_label{std::nullopt, std::nullopt, true};

std::string voxel_bytes(bool is_little_endian = true)
{
  return bytes_of<std::uint16_t>(voxel_values, is_little_endian);
}

/// As gzip, without compression.
std::string gzip(const std::string& bytes)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  const auto size = std::uint16_t(bytes.size());
  return std::string("\x1f\x8b\x08\0\0\0\0\0\0\xff\x01", 11) + number_bytes(size) + number_bytes(std::uint16_t(~size)) +
         bytes + number_bytes(std::uint32_t(crc.checksum())) + number_bytes(std::uint32_t(size));
}

const std::string nrrd_fields = "type: unsigned short\ndimension: 3\nsizes: 3 2 2\nendian: little\n"
                                "space: left-posterior-superior\nspace origin: (10,20,30)\n"
                                "space directions: (2,0,0) (0,0,0.5) (0,-1,0)\nkey:=value\n# remark\n";
const std::string meta_fields = "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementType = MET_USHORT\n"
                                "ElementSpacing = 2 0.5 1\nOffset = 10 20 30\n"
                                "TransformMatrix = 1 0 0 0 0 1 0 -1 0\n";

std::string nifti(float slope = 1, std::int16_t dimension = 3, float begin = 352, bool is_little_endian = true)
{
  std::string header(352, '\0');
  const auto put = [&](std::size_t place, const std::string& bytes) { header.replace(place, bytes.size(), bytes); };
  put(0, number_bytes(std::int32_t(348), is_little_endian));
  const std::int16_t extents[] = {dimension, 3, 2, 2, 1, 1, 1, 1};
  put(40, bytes_of<std::int16_t>(extents, is_little_endian));
  put(70, number_bytes(std::int16_t(512), is_little_endian));
  put(108, number_bytes(begin, is_little_endian));
  put(112, number_bytes(slope, is_little_endian));
  put(254, number_bytes(std::int16_t(1), is_little_endian));
  const float rows[] = {2, 0, 0, 10, 0, 0, -1, 20, 0, 0.5F, 0, 30};
  put(280, bytes_of<float>(rows, is_little_endian));
  put(344, "n+1");
  return header;
}

void expect_sample(const std::string& filename)
{
  SCOPED_TRACE(filename);
  const Volume volume = CSCD::read_volume(filename, each_label);
  EXPECT_EQ(volume.grid.size, (std::array<std::size_t, 3>{3, 2, 2}));
  EXPECT_EQ(volume.grid.origin, Vector3(10, 20, 30));
  EXPECT_EQ(volume.grid.axes[0], Vector3(2, 0, 0));
  EXPECT_EQ(volume.grid.axes[1], Vector3(0, 0, 0.5));
  EXPECT_EQ(volume.grid.axes[2], Vector3(0, -1, 0));
  EXPECT_EQ(volume.labels, std::vector<CSCD::Voxel_label>(voxel_values.begin(), voxel_values.end()));
}

TEST(read_volume, reads_the_same_from_all_formats)
{
  const Temporary_folder folder;
  folder.write("v.raw", "12345" + voxel_bytes(false));
  folder.write("v.raw.gz", gzip("12345" + voxel_bytes()));
  expect_sample(folder.write("v.nrrd", "NRRD0004\n" + nrrd_fields + "encoding: raw\n\n" + voxel_bytes()));
  expect_sample(folder.write("z.nrrd", "NRRD0004\r\n" + nrrd_fields + "encoding: gzip\r\n\r\n" + gzip(voxel_bytes())));
  expect_sample(
      folder.write("z.nhdr", "NRRD0004\n" + nrrd_fields + "encoding: gz\ndata file: v.raw.gz\nbyte skip: 5\n"));
  expect_sample(folder.write("v.mha", meta_fields + "ElementDataFile = LOCAL\n" + voxel_bytes()));
  expect_sample(
      folder.write("z.mha", meta_fields + "CompressedData = True\nElementDataFile = LOCAL\n" + gzip(voxel_bytes())));
  expect_sample(folder.write("v.mhd", meta_fields + "BinaryDataByteOrderMSB = True\nHeaderSize = -1\n"
                                                    "ElementDataFile = v.raw\n"));
  expect_sample(folder.write("v.nii", nifti() + voxel_bytes()));
  expect_sample(folder.write("b.nii", nifti(1, 3, 352, false) + voxel_bytes(false)));
  expect_sample(folder.write("v.nii.gz", gzip(nifti() + voxel_bytes())));
}

TEST(read_volume, reads_what_is_selected)
{
  const Temporary_folder folder;
  const std::string file = folder.write("v.nii", nifti(2) + voxel_bytes()); // values are doubled
  using Labels = std::vector<CSCD::Voxel_label>;
  EXPECT_EQ(CSCD::read_volume(file).labels, (Labels{0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 1}));
  EXPECT_EQ(CSCD::read_volume(file, {14., std::nullopt, false}).labels, (Labels{0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 1}));
  EXPECT_EQ(CSCD::read_volume(file, {std::nullopt, 6U, false}).labels, (Labels{0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(read_volume, tells_labels_of_64_bits_apart)
{
  const Temporary_folder folder;
  const std::vector<std::uint64_t> values{720575940621039145, 720575940621039146, ~std::uint64_t(0), 0};
  const std::string header = "NRRD0004\ntype: TYPE\ndimension: 3\nsizes: 4 1 1\nendian: little\nencoding: raw\n\n";
  const auto file = [&](const std::string& type) {
    std::string text = header;
    text.replace(text.find("TYPE"), 4, type);
    return folder.write(type + ".nrrd", text + bytes_of<std::uint64_t>(values, true));
  };
  EXPECT_EQ(CSCD::read_volume(file("uint64"), each_label).labels, values);
  EXPECT_EQ(CSCD::read_volume(file("uint64"), {std::nullopt, values[1], false}).labels,
            (std::vector<CSCD::Voxel_label>{0, values[1], 0, 0}));
  // The third is -1: not a label, but part of the body that everything else than 0 forms.
  EXPECT_THROW(CSCD::read_volume(file("int64"), each_label), CSCD::File_error);
  EXPECT_EQ(CSCD::read_volume(file("int64")).labels, (std::vector<CSCD::Voxel_label>{1, 1, 1, 0}));
}

TEST(read_volume, gives_the_same_surfaces_slice_by_slice)
{
  const Temporary_folder folder;
  Volume volume;
  volume.grid = {{9, 8, 7}, {1, 2, 3}, {Vector3(0.5, 0, 0), Vector3(0, 0.1, 2), Vector3(0, 1, 0)}};
  for (std::size_t i = 0; i < volume.grid.number_of_voxels(); ++i) {
    volume.labels.push_back(std::uint32_t(i * i % 97 % 4));
  }
  std::ostringstream out;
  CSCD::write_nrrd(out, volume);
  const std::string file = folder.write("v.nrrd", out.str());
  const Volume read = CSCD::read_volume(file, each_label);
  EXPECT_EQ(read.labels, volume.labels);
  EXPECT_EQ(read.grid.axes, volume.grid.axes);
  const std::vector<CSCD::Voxel_surface> streamed = CSCD::read_voxel_surfaces(file, each_label);
  const std::vector<CSCD::Voxel_surface> in_memory = make_voxel_surfaces(volume);
  ASSERT_EQ(streamed.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(streamed[i].label, in_memory[i].label);
    EXPECT_EQ(streamed[i].triangles.points, in_memory[i].triangles.points);
    EXPECT_EQ(streamed[i].triangles.faces, in_memory[i].triangles.faces);
  }
}

TEST(read_volume, refuses_gray_values_as_labels_before_a_surface_is_made)
{
  const Temporary_folder folder;
  Volume volume;
  volume.grid.size = {41, 41, 41};
  volume.grid.origin = Vector3(0, 0, 0);
  for (std::size_t i = 0; i < volume.grid.number_of_voxels(); ++i) {
    volume.labels.push_back(std::uint32_t(i)); // more than 65,536
  }
  std::ostringstream out;
  CSCD::write_nrrd(out, volume);
  const std::string file = folder.write("v.nrrd", out.str());
  std::size_t number_of_surfaces = 0;
  try {
    CSCD::for_each_voxel_surface(file, each_label, {}, [&](CSCD::Voxel_surface&&) { ++number_of_surfaces; });
    FAIL() << "not refused";
  } catch (const CSCD::Input_error& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
  EXPECT_EQ(number_of_surfaces, 0U);
}

TEST(read_volume, refuses_headers_that_lie)
{
  const Temporary_folder folder;
  const std::string data = voxel_bytes();
  const auto nrrd = [&](const std::string& from, const std::string& to) {
    std::string fields = nrrd_fields + "encoding: raw\n\n";
    fields.replace(fields.find(from), from.size(), to);
    return "NRRD0004\n" + fields + data;
  };
  const auto meta = [&](const std::string& from, const std::string& to) {
    std::string fields = meta_fields + "ElementDataFile = LOCAL\n";
    fields.replace(fields.find(from), from.size(), to);
    return fields + data;
  };
  std::vector<std::pair<std::string, std::string>> files{
      {"empty.nrrd", ""},
      {"magic.nrrd", "NRRX0004\n\n"},
      {"overflow.nrrd", nrrd("3 2 2", "4294967296 4294967296 4294967296")},
      {"beyond_integers.nrrd", nrrd("3 2 2", "1e300 2 2")},
      {"negative.nrrd", nrrd("3 2 2", "-3 -2 2")},
      {"fraction.nrrd", nrrd("3 2 2", "3.5 2 2")},
      {"zero.nrrd", nrrd("3 2 2", "3 0 2")},
      {"more_than_there_is.nrrd", nrrd("3 2 2", "3 2 3")},
      {"few_sizes.nrrd", nrrd("3 2 2", "3 2")},
      {"four.nrrd", nrrd("dimension: 3", "dimension: 4")},
      {"nan.nrrd", nrrd("(2,0,0)", "(nan,0,0)")},
      {"infinite_origin.nrrd", nrrd("(10,20,30)", "(inf,20,30)")},
      {"singular.nrrd", nrrd("(0,-1,0)", "(2,0,1e-9)")},
      {"no_length.nrrd", nrrd("(0,-1,0)", "(0,0,0)")},
      {"block.nrrd", nrrd("unsigned short", "block")},
      {"ascii.nrrd", nrrd("encoding: raw", "encoding: ascii")},
      {"not_gzip.nrrd", nrrd("encoding: raw", "encoding: gzip")},
      {"cut_gzip.nrrd", "NRRD0004\n" + nrrd_fields + "encoding: gzip\n\n" + gzip(data).substr(0, 25)},
      {"bomb.nrrd", "NRRD0004\n" + nrrd_fields.substr(0, nrrd_fields.find("sizes")) +
                        "sizes: 60000 60000 60000\nencoding: gzip\n\n" + gzip(data)},
      {"skip.nrrd", nrrd("encoding: raw", "byte skip: 1\nencoding: raw")},
      {"skip_lines.nrrd", nrrd("encoding: raw", "line skip: 999999999\nencoding: raw")},
      {"missing.nhdr", "NRRD0004\n" + nrrd_fields + "encoding: raw\ndata file: nowhere.raw\n"},
      {"several.nhdr", "NRRD0004\n" + nrrd_fields + "encoding: raw\ndata file: v%03d.raw 1 2 1\n"},
      {"no_data.mha", meta_fields},
      {"channels.mha", meta("NDims", "ElementNumberOfChannels = 3\nNDims")},
      {"sizes.mha", meta("3 2 2", "3 2 200")},
      {"spacing.mha", meta("2 0.5 1", "2 0.5 inf")},
      {"matrix.mha", meta("1 0 0 0 0 1 0 -1 0", "1 0 0 0 0 1")},
      {"type.mha", meta("MET_USHORT", "MET_OTHER")},
      {"line.mha", meta("NDims = 3", "NDims = 3\nno field")},
      {"short.nii", nifti().substr(0, 100)},
      {"dimensions.nii", nifti(1, -3) + data},
      {"no_data.nii", nifti()},
      {"offset.nii", nifti(1, 3, 3e9F) + data},
      {"offset_inside.nii", nifti(1, 3, 10) + data},
      {"cut.nii.gz", gzip(nifti() + data).substr(0, 370)},
      {"fractions.nii", nifti(0.25F) + data},
      {"no.tif", "II*\0garbage"},
      {"ending.vol", data}};
  for (const auto& [name, content] : files) {
    const std::string file = folder.write(name, content);
    try {
      CSCD::read_volume(file, each_label);
      ADD_FAILURE() << name << " was read";
    } catch (const CSCD::File_error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(name), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
  EXPECT_THROW(CSCD::read_volume(folder.file("nowhere.nrrd")), CSCD::File_error);
  EXPECT_THROW(CSCD::read_volume(folder.path().string()), CSCD::File_error);
}

} // namespace
