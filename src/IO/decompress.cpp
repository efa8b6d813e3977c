// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of decompress.h.

#include "IO/decompress.h"

#include "IO/formats.h"

#ifdef CSCD_WITH_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CSCD::internal {

namespace {

constexpr const char* remedy_of_damage = "fetch or write the file again";

[[noreturn, maybe_unused]] void fail_to_decompress(const std::string& filename)
{
  fail_in_file(filename, "compressed data are damaged", remedy_of_damage);
}

} // namespace

#ifdef CSCD_WITH_ZLIB

struct Inflating_stream::State
{
  State(std::istream& its_in, const std::string& its_filename) : in(its_in), filename(its_filename)
  {
    constexpr int recognizes_header = 32;
    if (inflateInit2(&stream, MAX_WBITS + recognizes_header) != Z_OK) {
      fail_to_decompress(filename);
    }
  }
  State(State&&) = delete;
  ~State() { inflateEnd(&stream); }

  /// Decompresses the next bytes, `size` of them at most. \return their number, 0 at the end of the data
  std::size_t read_some(char* bytes, std::size_t size)
  {
    stream.next_out = reinterpret_cast<Bytef*>(bytes);
    stream.avail_out = uInt(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
    const uInt room = stream.avail_out;
    while (stream.avail_out > 0 && (stream.avail_in > 0 || refill())) {
      const int status = ::inflate(&stream, Z_NO_FLUSH);
      is_between_streams = status == Z_STREAM_END;
      if (is_between_streams) {
        inflateReset(&stream); // gzip allows several streams in one file
      } else if (status != Z_OK) {
        fail_to_decompress(filename);
      }
    }
    return room - stream.avail_out;
  }

  /// \return false at the end of the data
  bool refill()
  {
    in.read(buffer.data(), std::streamsize(buffer.size()));
    stream.next_in = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_in = uInt(in.gcount());
    if (stream.avail_in == 0 && !is_between_streams) {
      fail_at_end();
    }
    return stream.avail_in > 0;
  }

  [[noreturn]] void fail_at_end() const { fail_in_file(filename, "compressed data end too early", remedy_of_damage); }

  std::istream& in;
  std::string filename;
  std::vector<char> buffer = std::vector<char>(read_block_size);
  z_stream stream{};
  bool is_between_streams = true;
};

#else

/// There is none.
struct Inflating_stream::State
{
  State(std::istream&, const std::string& filename)
  {
    fail_in_file(filename, "is compressed, and this was built without zlib",
                 "install zlib1g-dev and build again, or write the file without compression");
  }
  std::size_t read_some(char*, std::size_t) { return 0; }
  void fail_at_end() const {}
};

#endif

Inflating_stream::Inflating_stream(std::istream& in, const std::string& filename)
    : m_state(std::make_unique<State>(in, filename))
{
}

Inflating_stream::~Inflating_stream() = default;

void Inflating_stream::read(char* bytes, std::size_t size)
{
  while (size > 0) {
    const std::size_t number = m_state->read_some(bytes, size);
    if (number == 0) {
      m_state->fail_at_end();
    }
    bytes += number;
    size -= number;
  }
}

std::string Inflating_stream::read_all(std::size_t max_size)
{
  std::string result;
  for (std::size_t added = read_block_size; added > 0;) {
    const std::size_t size = result.size();
    result.resize(size + std::min(read_block_size, max_size - size));
    added = m_state->read_some(result.data() + size, result.size() - size);
    result.resize(size + added);
  }
  return result;
}

void Inflating_stream::skip(std::size_t size)
{
  std::array<char, 4096> skipped{};
  for (; size > 0; size -= std::min(size, skipped.size())) {
    read(skipped.data(), std::min(size, skipped.size()));
  }
}

} // namespace CSCD::internal
