// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the headers of volumes whose data are raw bytes, compressed or not: NRRD, MetaImage, NIfTI-1.

#ifndef CSCD_IO_VOLUME_HEADERS_H
#define CSCD_IO_VOLUME_HEADERS_H

#include "IO/decompress.h"
#include "IO/formats.h"
#include "IO/scanners.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <locale>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CSCD::internal {

/// The content of the header of a volume.
struct Volume_header
{
  Volume_grid grid;
  Number_type type;
  Byte_order order = Byte_order::little;
  double slope = 1; ///< factor of values, before `intercept` is added
  double intercept = 0;
  bool is_compressed = false;
  std::string data_filename;     ///< of the file with the data
  std::size_t data_begin = 0;    ///< the first byte of the data in it, compressed or not
  bool is_data_at_end = false;   ///< whether the data are the last bytes of the file instead
  std::size_t skipped_bytes = 0; ///< at the beginning of the data, when they are decompressed
};

/// A header of lines, each a name and a value.
class Line_header
{
public:
  /// \param size of the header, in bytes, is at most this
  static constexpr std::size_t max_size = std::size_t(1) << 20U;

  Line_header(const std::string& filename, char separator) : m_separator(separator)
  {
    std::ifstream in = open_file(filename);
    m_text.resize(max_size);
    in.read(m_text.data(), std::streamsize(max_size));
    m_text.resize(std::size_t(in.gcount()));
  }

  /// The next line without its end, if there is one.
  std::optional<std::string> next_line()
  {
    const std::size_t end = m_text.find('\n', m_at);
    if (m_at >= m_text.size() || (end == std::string::npos && m_text.size() == max_size)) {
      return std::nullopt;
    }
    std::string line = m_text.substr(m_at, end - m_at);
    m_at = end == std::string::npos ? m_text.size() : end + 1;
    boost::algorithm::trim_right(line, std::locale::classic());
    return line;
  }

  /// The first byte behind the lines that were read.
  std::size_t position() const { return m_at; }

  /// Keeps the value of a line. Names do not depend on case and blanks. \return the name
  std::string add(const std::string& line)
  {
    const std::size_t separator = line.find(m_separator);
    if (separator == std::string::npos) {
      internal::fail("the header has a line that is not a field", "correct it: " + line.substr(0, 40));
    }
    const std::string name = boost::algorithm::erase_all_copy(lower_case(line.substr(0, separator)), " ");
    m_values[name] = boost::algorithm::trim_copy(line.substr(separator + 1), std::locale::classic());
    return name;
  }

  /// The value of the first of `names` that is there, or an empty one.
  std::string value(std::initializer_list<const char*> names) const
  {
    for (const char* name : names) {
      if (const auto found = m_values.find(name); found != m_values.end()) {
        return found->second;
      }
    }
    return "";
  }

  /// Reads vectors from the value of the first of `names` that is there: finite numbers separated by blanks, commas and
  /// parentheses.
  /// \param title of the field in messages
  /// \return whether one is there
  /// \throw Content_error if there are not exactly the numbers of as many vectors
  bool read(std::initializer_list<const char*> names, const char* title, std::initializer_list<Vector3*> vectors) const
  {
    const std::string text = value(names);
    if (text.empty()) {
      return false;
    }
    const std::vector<double> all = numbers(text, title, 3 * vectors.size());
    auto number = all.begin();
    for (Vector3* const vector : vectors) {
      std::copy_n(number, 3, vector->begin());
      number += 3;
    }
    return true;
  }

  /// Integers from 0 on, at most three. \throw Content_error if there are not exactly as many as `size`
  std::array<std::size_t, 3> counts(const std::string& text, const std::string& title, std::size_t size = 3) const
  {
    constexpr double max_count = 1e15; // integers up to this are exact, and no file has as many bytes
    const std::vector<double> all = numbers(text, title, size);
    std::array<std::size_t, 3> result{};
    std::transform(all.begin(), all.end(), result.begin(), [&](double number) {
      if (!(number >= 0) || number > max_count || number != std::floor(number)) {
        fail(title, size);
      }
      return std::size_t(number);
    });
    return result;
  }

  /// A single number, or the default where the field is missing.
  std::size_t count(const std::string& name, std::size_t its_default) const
  {
    const std::string text = value({name.c_str()});
    return text.empty() ? its_default : counts(text, name, 1).front();
  }

private:
  /// \throw Content_error if there are not exactly `size` numbers in `text`, all finite
  static std::vector<double> numbers(std::string text, const std::string& title, std::size_t size)
  {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    Text_scanner scanner(text);
    std::vector<double> result;
    bool are_finite = true;
    while (are_finite && result.size() < size && scanner.skip_blanks() && scanner.is_at_number()) {
      result.push_back(scanner.number());
      are_finite = std::isfinite(result.back());
    }
    if (result.size() != size || !are_finite || scanner.skip_blanks()) {
      fail(title, size);
    }
    return result;
  }

  [[noreturn]] static void fail(const std::string& name, std::size_t count)
  {
    internal::fail("the field '" + name + "' of the header is not " + std::to_string(count) +
                       (count == 1 ? " finite number" : " finite numbers"),
                   "correct it or write the file again");
  }

  char m_separator;
  std::string m_text;
  std::size_t m_at = 0;
  std::map<std::string, std::string> m_values;
};

/// Finds the data that a header names, which begin behind so many bytes as the field `skip` says, or end the file.
/// \param name of the file with the data, relative to that of the header; empty if they are behind the header
/// \param number_of_lines before these bytes
inline void find_data(const std::string& filename, const std::string& name, const Line_header& lines, const char* skip,
                      std::size_t number_of_lines, Volume_header& header)
{
  if (name.find('%') != std::string::npos || boost::algorithm::starts_with(name, "LIST")) {
    fail("the data are in several files, which is not read", "write them into one");
  }
  header.data_filename =
      name.empty() ? filename : (std::filesystem::path(filename).parent_path() / name).string(); // absolute ones stay
  header.data_begin = name.empty() ? lines.position() : 0;
  if (number_of_lines > 0) {
    std::ifstream in(header.data_filename, std::ios::binary);
    in.seekg(std::streamoff(header.data_begin));
    for (char c = 0; number_of_lines > 0 && in.get(c);) {
      ++header.data_begin;
      number_of_lines -= c == '\n' ? 1 : 0;
    }
  }
  header.is_data_at_end = lines.value({skip}) == "-1";
  header.skipped_bytes = header.is_data_at_end ? 0 : lines.count(skip, 0);
}

inline void scale_axes(Volume_grid& grid, const Vector3& spacing)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.axes[axis] *= spacing[axis];
  }
}

inline Volume_header read_nrrd_header(const std::string& filename)
{
  Line_header lines(filename, ':');
  const std::optional<std::string> magic = lines.next_line();
  if (!magic || !boost::algorithm::starts_with(*magic, "NRRD000")) {
    fail("does not begin with NRRD and its version", "check what the file is");
  }
  while (const std::optional<std::string> line = lines.next_line()) {
    if (line->empty()) {
      break;
    }
    const std::size_t separator = line->find(':');
    const bool is_key = separator != std::string::npos && separator + 1 < line->size() && (*line)[separator + 1] == '=';
    if (line->front() != '#' && !is_key) {
      lines.add(*line);
    }
  }
  Volume_header header;
  if (lines.count("dimension", 0) != 3) {
    fail("'dimension' in the header is not 3", "write a volume of one value a voxel");
  }
  header.grid.size = lines.counts(lines.value({"sizes"}), "sizes");
  const std::string type = lines.value({"type"});
  header.type = number_type(type);
  if (!header.type.is_valid()) {
    fail("'" + type.substr(0, 40) + "' is not a type of numbers that volumes have",
         "write the volume with one from int8 to uint64, float or double");
  }
  header.order = lines.value({"endian"}) == "big" ? Byte_order::big : Byte_order::little;
  const std::string encoding = lower_case(lines.value({"encoding"}));
  header.is_compressed = encoding == "gzip" || encoding == "gz";
  if (!header.is_compressed && encoding != "raw") {
    fail("'encoding: " + encoding.substr(0, 40) + "' is not read", "write it with the encoding raw or gzip");
  }
  auto& [x, y, z] = header.grid.axes; // directions in space or spacings
  const bool has_directions = lines.read({"spacedirections"}, "space directions", {&x, &y, &z});
  Vector3 spacings(1, 1, 1);
  if (!has_directions && lines.read({"spacings"}, "spacings", {&spacings})) {
    scale_axes(header.grid, spacings);
  }
  lines.read({has_directions ? "spaceorigin" : "axismins"}, "space origin", {&header.grid.origin});
  find_data(filename, lines.value({"datafile"}), lines, "byteskip", lines.count("lineskip", 0), header);
  if (!header.is_compressed) {
    header.data_begin += std::exchange(header.skipped_bytes, 0);
  }
  return header;
}

inline Volume_header read_meta_image_header(const std::string& filename)
{
  Line_header lines(filename, '=');
  bool has_data = false;
  while (const std::optional<std::string> line = has_data ? std::nullopt : lines.next_line()) {
    has_data = !line->empty() && lines.add(*line) == "elementdatafile";
  }
  const auto is_true = [&lines](std::initializer_list<const char*> names) {
    return boost::algorithm::istarts_with(lines.value(names), "t", std::locale::classic());
  };
  if (!has_data) {
    fail("the header has no ElementDataFile", "check what the file is");
  }
  if (lines.count("ndims", 0) != 3 || lines.count("elementnumberofchannels", 1) != 1) {
    fail("is not of three dimensions with one number a voxel", "write such a volume");
  }
  Volume_header header;
  header.grid.size = lines.counts(lines.value({"dimsize"}), "DimSize");
  const std::string type = lines.value({"elementtype"});
  constexpr std::size_t size_of_long = 4; // in files, whatever it is in memory
  header.type = number_type(type, size_of_long);
  if (!header.type.is_valid()) {
    fail("'" + type.substr(0, 40) + "' is not an ElementType of one number a voxel",
         "write the volume with one from MET_CHAR to MET_DOUBLE");
  }
  header.order = is_true({"elementbyteordermsb", "binarydatabyteordermsb"}) ? Byte_order::big : Byte_order::little;
  header.is_compressed = is_true({"compresseddata"});
  auto& [x, y, z] = header.grid.axes;
  lines.read({"transformmatrix", "rotation", "orientation"}, "TransformMatrix", {&x, &y, &z});
  Vector3 spacing(1, 1, 1);
  lines.read({"elementspacing", "elementsize"}, "ElementSpacing", {&spacing});
  scale_axes(header.grid, spacing);
  lines.read({"offset", "origin", "position"}, "Offset", {&header.grid.origin});
  const std::string data = lines.value({"elementdatafile"});
  const bool is_local = boost::algorithm::iequals(data, "LOCAL", std::locale::classic());
  find_data(filename, is_local ? "" : data, lines, "headersize", 0, header);
  header.data_begin += std::exchange(header.skipped_bytes, 0);
  return header;
}

/// Reads the axes by the matrix, else by the quaternion, else by spacings: the order that NIfTI recommends.
/// \param integer, real read numbers of the header at their places
template <class Integer, class Real>
inline void read_nifti_axes(const Integer& integer, const Real& real, Volume_grid& grid)
{
  if (integer(254) > 0) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        grid.axes[axis][row] = real(280 + 16 * row + 4 * axis);
      }
      grid.origin[row] = real(280 + 16 * row + 12);
    }
    return;
  }
  if (integer(252) > 0) {
    const double b = real(256);
    const double c = real(260);
    const double d = real(264);
    const double a = std::sqrt(std::max(0., 1 - b * b - c * c - d * d));
    grid.axes[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
    grid.axes[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
    grid.axes[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c};
    grid.axes[2] *= real(76) < 0 ? -1 : 1;
    grid.origin = {real(268), real(272), real(276)};
  }
  scale_axes(grid, {real(80), real(84), real(88)});
}

inline constexpr std::size_t nifti_header_size = 348; // bytes

/// \param bytes the header of NIfTI-1, whose numbers stand in fixed places
inline Volume_header parse_nifti_header(const std::string& bytes)
{
  Volume_header result;
  const auto has_size = [&] {
    return stored_number<std::int32_t>(bytes.data(), result.order) == std::int32_t(nifti_header_size);
  };
  const auto integer = [&](std::size_t place) {
    return int(stored_number<std::int16_t>(bytes.data() + place, result.order));
  };
  const auto real = [&](std::size_t place) { return double(stored_number<float>(bytes.data() + place, result.order)); };
  result.order = has_size() ? Byte_order::little : Byte_order::big;
  if (!has_size() || bytes.substr(344, 3) != "n+1") {
    fail("has no header of NIfTI-1 with its data in the same file", "check what the file is, or write it as NIfTI-1");
  }
  const int dimension = integer(40);
  for (std::size_t axis = 0; axis < 7; ++axis) {
    const int extent = int(axis) < dimension ? integer(42 + 2 * axis) : 1;
    if (dimension < 1 || extent < 1 || (axis >= 3 && extent > 1)) {
      fail("'dim' in the header tells no volume of one value a voxel", "write it as one of three dimensions");
    }
    if (axis < 3) {
      result.grid.size[axis] = std::size_t(extent);
    }
  }
  static const std::map<int, Number_type> types{{2, {'u', 1}},    {4, {'i', 2}},   {8, {'i', 4}},   {16, {'f', 4}},
                                                {64, {'f', 8}},   {256, {'i', 1}}, {512, {'u', 2}}, {768, {'u', 4}},
                                                {1024, {'i', 8}}, {1280, {'u', 8}}};
  const auto type = types.find(integer(70));
  if (type == types.end()) {
    fail("'datatype' " + std::to_string(integer(70)) + " is not of one number a voxel",
         "write the volume with integers, float or double");
  }
  result.type = type->second;
  if (std::isfinite(real(112)) && std::isfinite(real(116)) && real(112) != 0) {
    result.slope = real(112);
    result.intercept = real(116);
  }
  const double begin = real(108);
  constexpr double max_begin = 1e9; // bytes of extensions
  if (!(begin >= double(nifti_header_size)) || begin > max_begin) {
    fail("'vox_offset' in the header is inside the header or too large", "correct it");
  }
  result.data_begin = std::size_t(begin);
  read_nifti_axes(integer, real, result.grid);
  return result;
}

inline Volume_header read_nifti_header(const std::string& filename)
{
  std::ifstream in = open_file(filename);
  const bool is_compressed = in.peek() == 0x1f; // the first byte of gzip
  std::string bytes(nifti_header_size, '\0');
  const auto size = std::streamsize(bytes.size());
  if ((is_compressed ? Inflating_buffer(in).sgetn(bytes.data(), size) : in.rdbuf()->sgetn(bytes.data(), size)) < size) {
    fail("is shorter than a header of NIfTI-1", "check what the file is");
  }
  Volume_header header = parse_nifti_header(bytes);
  header.data_filename = filename;
  header.is_compressed = is_compressed;
  if (is_compressed) {
    header.skipped_bytes = std::exchange(header.data_begin, 0);
  }
  return header;
}

} // namespace CSCD::internal

#endif // CSCD_IO_VOLUME_HEADERS_H
