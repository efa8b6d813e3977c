// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and writes image volumes slice by slice: the definitions of read_volume.h and write_nrrd.h.

#include "IO/decompress.h"
#include "IO/formats.h"
#include "IO/scanners.h"
#include "IO/volume_headers.h"
#include <CSCD/IO/Shape_file.h>
#include <CSCD/IO/internal/Skeleton_content.h>
#include <CSCD/IO/read_volume.h>
#include <CSCD/IO/write_nrrd.h>
#include <CSCD/Points/Neighbor_table.h>
#include <CSCD/Vector3.h>
#include <CSCD/Volume/Voxel_surface.h>
#include <CSCD/exceptions.h>

#include <CGAL/assertions.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/endian/conversion.hpp>

#ifdef CSCD_WITH_TIFF
#include <tiffio.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <istream>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CSCD {
namespace internal {

/// The size of the voxels of a volume, in bytes.
/// \throw Content_error if it is 0, or more than a quarter of the greatest number: sums with others do not overflow
std::size_t size_of_voxels(const Volume_header& header)
{
  constexpr std::size_t max_size = std::numeric_limits<std::size_t>::max() / 4;
  std::size_t size = header.type.size;
  for (const std::size_t extent : header.grid.size) {
    if (extent == 0) {
      fail("a size in the header is 0", "correct it");
    }
    if (extent > max_size / size) {
      fail("the sizes in the header are too large for any memory", "correct them");
    }
    size *= extent;
  }
  return size;
}

/// The label that a voxel's value is, if any; 0 if it is not a number.
template <class Number>
std::optional<Voxel_label> to_label(Number value)
{
  constexpr double end_of_labels = 0x1p64;
  if constexpr (std::is_floating_point_v<Number>) {
    value = std::isnan(value) ? 0 : value;
    if (value != std::floor(value) || double(value) >= end_of_labels) {
      return std::nullopt;
    }
  }
  return std::is_unsigned_v<Number> || value >= Number(0) ? std::optional<Voxel_label>(value) : std::nullopt;
}

/// The label of a voxel of this value; 0 if it is not selected.
template <class Number>
Voxel_label select_voxel(const Voxel_selection& selection, Number value)
{
  if (selection.threshold) {
    return double(value) >= *selection.threshold ? 1 : 0;
  }
  const std::optional<Voxel_label> label = to_label(value);
  if (selection.label) {
    return label == selection.label ? *label : 0;
  }
  if (!selection.separates_labels) {
    return label != Voxel_label(0) ? 1 : 0;
  }
  if (!label) {
    fail("a voxel has the value " + std::to_string(value) + ", which is not an integer from 0 on",
         "choose a threshold");
  }
  return *label;
}

/// A volume that is open, and how its voxels are read.
struct Volume_file
{
  std::string filename;
  Volume_header header;
  std::ifstream file;                      ///< the one with the data, unless libtiff reads it
  std::unique_ptr<std::streambuf> decoder; ///< of the data; null if they stand in the file as they are
  std::istream data{nullptr};              ///< the bytes of the voxels
  std::vector<char> bytes{};               ///< of a slice
};

/// Opens data that are raw bytes, compressed or not. \throw Content_error if they cannot have the size in the header
void open_bytes(Volume_file& volume)
{
  const Volume_header& header = volume.header;
  volume.file.open(header.data_filename, std::ios::binary);
  std::error_code error;
  const std::size_t file_size = std::size_t(std::filesystem::file_size(header.data_filename, error));
  if (!volume.file || error) {
    fail("the data file " + header.data_filename + " cannot be opened", "put it there or correct its name");
  }
  const std::size_t size = size_of_voxels(header);
  std::size_t begin = header.data_begin;
  if (header.is_data_at_end) {
    begin = file_size >= size ? file_size - size : file_size;
  }
  const std::size_t available = begin < file_size ? file_size - begin : 0;
  const std::size_t needed = header.is_compressed ? size / max_deflate_ratio : size;
  if (needed > available || available == 0) {
    fail("the header promises " + std::to_string(size) + " bytes of voxels, the data have " +
             std::to_string(available) + (header.is_compressed ? " compressed ones" : ""),
         "the file seems truncated, fetch or write it again");
  }
  volume.file.seekg(std::streamoff(begin));
  if (header.is_compressed) {
    volume.decoder = std::make_unique<Inflating_buffer>(volume.file);
  }
}

#ifdef CSCD_WITH_TIFF
/// The voxels of a TIFF whose pages are slices, in strips of rows.
class Tiff_buffer : public std::streambuf
{
public:
  /// Opens the file and describes it in `header`, which must outlive this object.
  Tiff_buffer(const std::string& filename, Volume_header& header) : m_header(header)
  {
    TIFFSetErrorHandler(nullptr); // failures are exceptions here
    TIFFSetWarningHandler(nullptr);
    m_tiff.reset(TIFFOpen(filename.c_str(), "rm"));
    if (!m_tiff) {
      fail("cannot be opened as TIFF", "check the name, the permissions and what the file is");
    }
    const Page first = read_page();
    header.type = first.type;
    header.order = Byte_order::native;
    header.grid.size = {first.width, first.height, 1};
    while (TIFFReadDirectory(m_tiff.get()) != 0) {
      ++header.grid.size[2];
    }
    if (TIFFSetDirectory(m_tiff.get(), 0) == 0) {
      fail_at_page();
    }
    size_of_voxels(header); // which checks it
    // Nothing compresses to less than a four thousandth, except pages that understate their size.
    constexpr std::size_t max_ratio = 4096;
    std::error_code error;
    const std::size_t file_size = std::size_t(std::filesystem::file_size(filename, error));
    if (error || header.grid.slice_size() / max_ratio > file_size) {
      fail("the pages are larger than the file can hold", "fetch or write the file again");
    }
  }

protected:
  /// Reads a row, the first one of the next page after the last one of a page.
  int_type underflow() override
  {
    if (m_y == m_header.grid.size[1]) {
      ++m_page;
      m_y = 0;
      if (m_page == m_header.grid.size[2]) {
        return traits_type::eof();
      }
      if (TIFFReadDirectory(m_tiff.get()) == 0) {
        fail_at_page();
      }
    }
    if (m_y == 0) {
      begin_page();
    }
    if (TIFFReadScanline(m_tiff.get(), m_row.data(), std::uint32_t(m_y++), 0) != 1) {
      fail_at_page();
    }
    setg(m_row.data(), m_row.data(), m_row.data() + m_header.grid.size[0] * m_header.type.size);
    return traits_type::to_int_type(*gptr());
  }

private:
  struct Page
  {
    std::size_t width;
    std::size_t height;
    Number_type type;
  };
  struct Closer
  {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };

  [[noreturn]] void fail_at_page() const
  {
    fail("page " + std::to_string(m_page) + " is damaged or cannot be decoded",
         "write the file again, without compression");
  }

  void begin_page()
  {
    const Page page = read_page();
    if (page.width != m_header.grid.size[0] || page.height != m_header.grid.size[1] ||
        page.type.kind != m_header.type.kind || page.type.size != m_header.type.size) {
      fail("page " + std::to_string(m_page) + " has another size or type than the first", "write all slices alike");
    }
    m_row.resize(std::size_t(TIFFScanlineSize(m_tiff.get())));
    if (m_row.size() < page.width * page.type.size) {
      fail_at_page();
    }
  }

  template <class Value>
  Value field(std::uint32_t tag) const
  {
    Value value{};
    return TIFFGetFieldDefaulted(m_tiff.get(), tag, &value) == 1 ? value : Value{};
  }

  /// The description of libtiff's current page.
  Page read_page() const
  {
    const auto bits = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    const auto format = field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
    const Number_type type{format == SAMPLEFORMAT_IEEEFP ? 'f'
                           : format == SAMPLEFORMAT_INT  ? 'i'
                                                         : 'u',
                           std::size_t(bits / 8)};
    if (TIFFIsTiled(m_tiff.get()) != 0 || field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL) != 1 || bits % 8 != 0 ||
        !type.is_valid()) {
      fail("is tiled, in color, or of numbers that are not 8 to 64 bits long",
           "write slices of one number a pixel, in strips");
    }
    return {field<std::uint32_t>(TIFFTAG_IMAGEWIDTH), field<std::uint32_t>(TIFFTAG_IMAGELENGTH), type};
  }

  std::unique_ptr<TIFF, Closer> m_tiff;
  const Volume_header& m_header;
  std::size_t m_page = 0; ///< that is read
  std::size_t m_y = 0;    ///< of the next row in it
  std::vector<char> m_row;
};
#endif

/// Opens a TIFF.
void open_tiff([[maybe_unused]] Volume_file& volume)
{
#ifdef CSCD_WITH_TIFF
  volume.decoder = std::make_unique<Tiff_buffer>(volume.filename, volume.header);
#else
  fail("is a TIFF, and this was built without libtiff",
       "install libtiff-dev and build again, or write the volume as .nrrd, .nii or .mha");
#endif
}

using Read_header = Volume_header(const std::string& filename);

/// The functions that read headers of files with these endings; null for TIFF.
constexpr std::array<std::pair<const char*, Read_header*>, 8> volume_formats{{{".nrrd", read_nrrd_header},
                                                                              {".nhdr", read_nrrd_header},
                                                                              {".nii", read_nifti_header},
                                                                              {".nii.gz", read_nifti_header},
                                                                              {".mha", read_meta_image_header},
                                                                              {".mhd", read_meta_image_header},
                                                                              {".tif", nullptr},
                                                                              {".tiff", nullptr}}};

/// The row of the format of a file; the end of the table if its ending names none.
const auto* find_volume_format(const std::string& filename)
{
  return std::find_if(volume_formats.begin(), volume_formats.end(), [&](const auto& format) {
    return boost::algorithm::iends_with(filename, format.first, std::locale::classic());
  });
}

std::unique_ptr<Volume_file> open_volume(const std::string& filename)
{
  const auto* const format = find_volume_format(filename);
  if (format == volume_formats.end()) {
    fail("the ending names no known format of volumes", "use one of .nrrd .nhdr .nii .nii.gz .mha .mhd .tif .tiff");
  }
  open_file(filename); // libtiff would not report a folder or a wrong name as the cause
  auto volume = std::make_unique<Volume_file>();
  volume->filename = filename;
  if (format->second == nullptr) {
    open_tiff(*volume);
  } else {
    volume->header = format->second(filename);
    open_bytes(*volume);
  }
  volume->data.rdbuf(volume->decoder ? volume->decoder.get() : volume->file.rdbuf());
  volume->data.exceptions(volume->decoder ? std::ios::badbit : std::ios::goodbit); // passes on those of the decoder
  volume->data.ignore(std::streamsize(volume->header.skipped_bytes));
  volume->bytes.resize(volume->header.grid.slice_size() * volume->header.type.size);
  return volume;
}

/// Reads the next slice of a volume.
void read_slice(Volume_file& volume, const Voxel_selection& selection, std::vector<Voxel_label>& labels)
{
  const Volume_header& header = volume.header;
  if (!volume.data.read(volume.bytes.data(), std::streamsize(volume.bytes.size()))) {
    if (header.is_compressed) {
      fail("compressed data end too early", "fetch or write the file again");
    }
    fail("cannot be read to the end of its data", "check the disk or the connection");
  }
  labels.resize(header.grid.slice_size());
  const Number_view view{volume.bytes.data(), header.type, header.order, header.type.size, labels.size()};
  const bool is_scaled = header.slope != 1 || header.intercept != 0;
  view.for_each([&](std::size_t i, auto value) {
    labels[i] = is_scaled ? select_voxel(selection, header.slope * double(value) + header.intercept)
                          : select_voxel(selection, value);
  });
}

} // namespace internal

bool is_volume_filename(const std::string& filename)
{
  return internal::find_volume_format(filename) != internal::volume_formats.end();
}

Volume_reader::Volume_reader(const std::string& filename, const Voxel_selection& selection)
    : m_file(internal::naming(filename, [&] { return internal::open_volume(filename); })), m_selection(selection)
{
  const Volume_grid& its_grid = grid();
  const double volume = std::abs(its_grid.signed_voxel_volume());
  const double product = its_grid.axes[0].norm() * its_grid.axes[1].norm() * its_grid.axes[2].norm();
  constexpr double min_angle = 1e-6; // of a voxel's volume to that of a box with the same sides
  if (!(volume > min_angle * product) || !std::isfinite(product) || !its_grid.origin.allFinite()) {
    throw File_error(filename + ": the axes in the header do not span the space, or are not finite; correct spacing, "
                                "directions and origin");
  }
}
Volume_reader::Volume_reader(Volume_reader&& other) noexcept = default;
Volume_reader::~Volume_reader() = default;

const Volume_grid& Volume_reader::grid() const
{
  return m_file->header.grid;
}

void Volume_reader::read_slice(std::vector<Voxel_label>& labels)
{
  internal::naming(m_file->filename, [&] { internal::read_slice(*m_file, m_selection, labels); });
}

Volume read_volume(const std::string& filename, const Voxel_selection& selection)
{
  Volume_reader reader(filename, selection);
  Volume result{reader.grid(), {}};
  std::vector<Voxel_label> slice;
  for (std::size_t z = 0; z < result.grid.size[2]; ++z) {
    reader.read_slice(slice);
    result.labels.insert(result.labels.end(), slice.begin(), slice.end());
  }
  return result;
}

namespace {

/// The labels that occur in each slice and not in a later one, in ascending order.
std::vector<std::vector<Voxel_label>> labels_of_last_slices(const std::string& filename,
                                                            const Voxel_selection& selection)
{
  Volume_reader reader(filename, selection);
  std::unordered_map<Voxel_label, std::size_t> last_slice;
  std::vector<Voxel_label> slice;
  for (std::size_t z = 0; z < reader.grid().size[2]; ++z) {
    reader.read_slice(slice);
    slice.erase(std::unique(slice.begin(), slice.end()), slice.end());
    for (const Voxel_label label : slice) {
      if (label != 0) {
        last_slice[label] = z;
      }
    }
    internal::naming(filename, [&] { Voxel_surface_builder::check_number_of_labels(last_slice.size()); });
  }
  std::vector<std::vector<Voxel_label>> result(reader.grid().size[2]);
  for (const auto& [label, z] : last_slice) {
    result[z].push_back(label);
  }
  for (std::vector<Voxel_label>& labels : result) {
    std::sort(labels.begin(), labels.end());
  }
  return result;
}

} // namespace

void for_each_voxel_surface(const std::string& filename, const Voxel_selection& selection,
                            const Voxel_surface_settings& settings, const std::function<void(Voxel_surface&&)>& take)
{
  std::vector<std::vector<Voxel_label>> labels_that_end;
  if (selection.separates_labels) {
    labels_that_end = labels_of_last_slices(filename, selection);
  }
  Volume_reader reader(filename, selection);
  Voxel_surface_builder builder =
      internal::naming(filename, [&] { return Voxel_surface_builder(reader.grid(), settings); });
  std::vector<Voxel_label> slice;
  for (std::size_t z = 0; z < reader.grid().size[2]; ++z) {
    reader.read_slice(slice);
    internal::naming(filename, [&] { builder.push_slice(slice.data()); });
    if (z > 0 && !labels_that_end.empty()) {
      for (const Voxel_label label : labels_that_end[z - 1]) {
        take(builder.take_surface(label));
      }
    }
  }
  builder.close();
  for (const Voxel_label label : builder.labels()) {
    take(builder.take_surface(label));
  }
}

std::vector<Voxel_surface> read_voxel_surfaces(const std::string& filename, const Voxel_selection& selection,
                                               const Voxel_surface_settings& settings)
{
  std::vector<Voxel_surface> result;
  for_each_voxel_surface(filename, selection, settings,
                         [&](Voxel_surface&& surface) { result.push_back(std::move(surface)); });
  std::sort(result.begin(), result.end(),
            [](const Voxel_surface& a, const Voxel_surface& b) { return a.label < b.label; });
  return result;
}

namespace {

/// Writes the header of NRRD for numbers of this `type` that follow raw.
void write_nrrd_header(std::ostream& out, const Volume_grid& grid, const char* type)
{
  const internal::Exact_format format(out);
  const auto vector = [&out](const Vector3& v) -> std::ostream& {
    return out << '(' << v.x() << ',' << v.y() << ',' << v.z() << ')';
  };
  out << "NRRD0004\ntype: " << type << "\ndimension: 3\nspace dimension: 3\nsizes: " << grid.size[0] << ' '
      << grid.size[1] << ' ' << grid.size[2] << "\nspace directions: ";
  vector(grid.axes[0]) << ' ';
  vector(grid.axes[1]) << ' ';
  vector(grid.axes[2]) << "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: ";
  vector(grid.origin) << "\n\n";
}

template <class Number>
void write_nrrd_numbers(std::ostream& out, std::vector<Number> numbers)
{
  for (Number& number : numbers) {
    boost::endian::native_to_little_inplace(number);
  }
  out.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(numbers.size() * sizeof(Number)));
}

} // namespace

void write_nrrd(std::ostream& out, const Volume& volume)
{
  CGAL_precondition(volume.labels.size() == volume.grid.number_of_voxels());
  write_nrrd_header(out, volume.grid, "uint64");
  write_nrrd_numbers(out, volume.labels);
}

void write_node_volume(std::ostream& out, Volume_reader& reader, const std::vector<Voxel_surface>& surfaces,
                       const std::vector<std::vector<std::uint32_t>>& node_of_vertex)
{
  CGAL_precondition(surfaces.size() == node_of_vertex.size());
  std::map<Voxel_label, std::size_t> surface_of_label;
  std::deque<internal::Point_tree> vertices; // of each surface; trees cannot be moved
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surface_of_label.emplace(surfaces[i].label, i);
    vertices.emplace_back(surfaces[i].triangles.points);
  }
  const Volume_grid& grid = reader.grid();
  write_nrrd_header(out, grid, "uint32");
  std::vector<Voxel_label> labels;
  std::vector<std::uint32_t> nodes(grid.slice_size());
  for (std::size_t z = 0; z < grid.size[2]; ++z) {
    reader.read_slice(labels);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto found = labels[i] == 0 ? surface_of_label.end() : surface_of_label.find(labels[i]);
      const bool has_node = found != surface_of_label.end();
      const std::size_t y = i / grid.size[0];
      const Vector3 point = grid.point({double(i % grid.size[0]), double(y), double(z)});
      nodes[i] = has_node ? node_of_vertex[found->second][vertices[found->second].nearest(point)] : 0;
    }
    write_nrrd_numbers(out, nodes);
  }
}

} // namespace CSCD
