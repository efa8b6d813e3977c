// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that gzip or zstd has compressed.

#ifndef CSCD_IO_INTERNAL_INFLATING_STREAM_H
#define CSCD_IO_INTERNAL_INFLATING_STREAM_H

#include <CSCD/IO/Mesh_format.h>
#include <CSCD/IO/internal/decode_bytes.h>

#ifdef CSCD_WITH_ZLIB
#include <zlib.h>
#endif
#ifdef CSCD_WITH_ZSTD
#include <zstd.h>
#endif

#include <algorithm>
#include <cstddef>
#include <istream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CSCD::internal {

#ifdef CSCD_WITH_ZLIB
/// Decompresses what zlib or gzip has compressed, piece by piece.
class Inflating_stream
{
public:
  /// \param in must outlive this object
  /// \param filename for messages
  Inflating_stream(std::istream& in, const std::string& filename) : m_in(in), m_filename(filename)
  {
    constexpr int recognizes_header = 32;
    if (inflateInit2(&m_stream, MAX_WBITS + recognizes_header) != Z_OK) {
      fail_to_decompress(filename);
    }
  }
  Inflating_stream(Inflating_stream&&) = delete;
  ~Inflating_stream() { inflateEnd(&m_stream); }

  /// \throw File_error if there are not `size` bytes left, or they are damaged
  void read(char* bytes, std::size_t size)
  {
    while (size > 0) {
      const std::size_t part = std::min(size, std::size_t(std::numeric_limits<uInt>::max()));
      if (read_some(bytes, part) < part) {
        fail_at_end_of_compressed(m_filename);
      }
      bytes += part;
      size -= part;
    }
  }

  /// All that is left.
  /// \throw File_error if it is damaged, or ends within a stream
  std::string read_all()
  {
    constexpr std::size_t block_size = std::size_t(1) << 20U; // bytes; large enough that the calls do not count
    std::string result;
    std::size_t added = block_size;
    while (added == block_size) {
      const std::size_t size = result.size();
      result.resize(size + block_size);
      added = read_some(result.data() + size, block_size);
      result.resize(size + added);
    }
    return result;
  }

private:
  /// Reads `size` bytes, or fewer at the end of the data. \return how many
  std::size_t read_some(char* bytes, std::size_t size)
  {
    m_stream.next_out = reinterpret_cast<Bytef*>(bytes);
    m_stream.avail_out = uInt(size);
    while (m_stream.avail_out > 0 && inflate_some()) {
    }
    return size - m_stream.avail_out;
  }

  /// \return false at the end of the data
  bool inflate_some()
  {
    if (m_stream.avail_in == 0) {
      m_in.read(m_buffer.data(), std::streamsize(m_buffer.size()));
      m_stream.next_in = reinterpret_cast<Bytef*>(m_buffer.data());
      m_stream.avail_in = uInt(m_in.gcount());
      if (m_stream.avail_in == 0) {
        if (!m_is_between_streams) {
          fail_at_end_of_compressed(m_filename);
        }
        return false;
      }
    }
    const int status = ::inflate(&m_stream, Z_NO_FLUSH);
    m_is_between_streams = status == Z_STREAM_END;
    if (m_is_between_streams) {
      inflateReset(&m_stream); // gzip allows several streams in one file
    } else if (status != Z_OK) {
      fail_to_decompress(m_filename);
    }
    return true;
  }

  static constexpr std::size_t buffer_size = std::size_t(1) << 16U; // bytes

  std::istream& m_in;
  std::string m_filename;
  std::vector<char> m_buffer = std::vector<char>(buffer_size);
  z_stream m_stream{};
  bool m_is_between_streams = true;
};
#endif

/// All that is left in `in`, decompressed.
/// \throw File_error if it is damaged, or if this is built without zlib
inline std::string read_gzipped([[maybe_unused]] std::istream& in, const std::string& filename)
{
#ifdef CSCD_WITH_ZLIB
  return Inflating_stream(in, filename).read_all();
#else
  fail_without_zlib(filename);
#endif
}

/// The same of what zstd has compressed.
/// \throw File_error if it is damaged, or if this is built without zstd
inline std::string read_zstd([[maybe_unused]] std::istream& in, const std::string& filename)
{
#ifdef CSCD_WITH_ZSTD
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(), &ZSTD_freeDStream);
  std::vector<char> read(ZSTD_DStreamInSize());
  std::vector<char> decompressed(ZSTD_DStreamOutSize());
  std::string result;
  std::size_t missing = 1; // of a frame; 0 between frames, of which a file may have several
  while (in.read(read.data(), std::streamsize(read.size())), in.gcount() > 0) {
    // The last byte of a frame is not taken before all of it is written.
    for (ZSTD_inBuffer input{read.data(), std::size_t(in.gcount()), 0}; input.pos < input.size;) {
      ZSTD_outBuffer output{decompressed.data(), decompressed.size(), 0};
      missing = ZSTD_decompressStream(stream.get(), &output, &input);
      if (ZSTD_isError(missing) != 0) {
        fail_to_decompress(filename);
      }
      result.append(decompressed.data(), output.pos);
    }
  }
  if (missing != 0) {
    fail_at_end_of_compressed(filename);
  }
  return result;
#else
  fail_without_library(filename, "zstd", "libzstd-dev");
#endif
}

/// All that is left in `in`, decompressed.
/// \throw File_error if it is damaged, or if this is built without what decompresses it
inline std::string read_compressed(std::istream& in, Compression compression, const std::string& filename)
{
  return compression == Compression::gzip ? read_gzipped(in, filename) : read_zstd(in, filename);
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_INFLATING_STREAM_H
