// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing a file so that no half of it remains.

#ifndef CSCD_IO_WRITE_FILE_H
#define CSCD_IO_WRITE_FILE_H

#include <CSCD/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

namespace CSCD {

namespace internal {

[[noreturn]] inline void throw_not_writable(const std::string& filename, const std::string& reason)
{
  throw File_error(filename + ": cannot be written (" + reason + "); check the folder, its permissions and the disk");
}

/// Opens `path`, lets `write` write to it and closes it.
template <class Write>
void write_directly(const std::string& path, const std::string& filename, Write& write)
{
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "no such place");
  }
  write(static_cast<std::ostream&>(out));
  out.close();
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "the disk may be full");
  }
}

/// A name beside `path` that no other process uses.
inline std::string temporary_name(const std::filesystem::path& path)
{
  std::random_device device;
  return path.string() + "." + std::to_string(device()) + ".part";
}

} // namespace internal

/// creates the file `filename`, or replaces it, with what `write` puts into a stream.
/// The content goes to a temporary file beside it first, which takes its place only when it is complete: when anything
/// fails, there is no new file, and an old one is as it was. What is not a regular file, such as a pipe, is written to
/// directly.
/// \param write called once with a `std::ostream&`
/// \throw File_error if the file cannot be written; whatever `write` throws
template <class Write>
void write_file(const std::string& filename, Write write)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  if (fs::is_directory(status)) {
    internal::throw_not_writable(filename, "it is a folder");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    internal::write_directly(filename, filename, write);
    return;
  }
  fs::path place = fs::exists(status) ? fs::canonical(filename, error) : fs::path(filename);
  if (error) {
    place = filename;
  }
  const std::string temporary = internal::temporary_name(place);
  try {
    internal::write_directly(temporary, filename, write);
    fs::rename(temporary, place, error);
    if (error) {
      internal::throw_not_writable(filename, error.message());
    }
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_FILE_H
