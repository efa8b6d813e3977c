// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole files into memory.

#ifndef CSCD_IO_INTERNAL_READ_CONTENT_H
#define CSCD_IO_INTERNAL_READ_CONTENT_H

#include <CSCD/exceptions.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <system_error>

namespace CSCD::internal {

/// All that is left in `in`.
/// \throw File_error if reading fails
inline std::string read_content(std::istream& in, const std::string& name)
{
  constexpr std::size_t block_size = std::size_t(1) << 20; // bytes; large enough that the calls do not count
  std::string content;
  while (in) {
    const std::size_t size = content.size();
    content.resize(size + block_size);
    in.read(content.data() + size, static_cast<std::streamsize>(block_size));
    content.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) {
    throw File_error(name + ": cannot be read to its end; check the disk or the connection");
  }
  return content;
}

/// The content of the file `filename`.
/// \throw File_error if it cannot be read
inline std::string read_content(const std::string& filename)
{
  std::error_code error;
  if (std::filesystem::is_directory(filename, error)) {
    throw File_error(filename + ": is a folder; name a file in it");
  }
  errno = 0;
  std::ifstream in(filename, std::ios::binary);
  if (!in) {
    throw File_error(filename + ": cannot be opened (" + (errno != 0 ? std::strerror(errno) : "unknown reason") +
                     "); check the name and the permissions");
  }
  const auto size = std::filesystem::file_size(filename, error);
  if (error) {
    return read_content(in, filename); // a pipe
  }
  std::string content(static_cast<std::size_t>(size), '\0');
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad()) {
    throw File_error(filename + ": cannot be read to its end; check the disk or the connection");
  }
  return content;
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_READ_CONTENT_H
