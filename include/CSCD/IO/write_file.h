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
#include <vector>

namespace CSCD {

namespace internal {

[[noreturn]] inline void throw_not_writable(const std::string& filename, const std::string& reason)
{
  throw File_error(filename + ": cannot be written (" + reason + "); check the folder, its permissions and the disk");
}

/// Opens `path`, lets `write` write to it and closes it.
template <class Write>
void write_directly(const std::string& path, const std::string& filename, const Write& write)
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

/// Where a file of this name is, or would be: links are followed.
inline std::filesystem::path place_of(const std::string& filename)
{
  namespace fs = std::filesystem;
  constexpr int max_number_of_links = 40; // as on Linux
  std::error_code error;
  fs::path place = filename;
  for (int i = 0; i < max_number_of_links && fs::is_symlink(fs::symlink_status(place, error)); ++i) {
    place = place.parent_path() / fs::read_symlink(place, error);
  }
  return place;
}

/// A name beside `path` that no other process uses. It does not contain the name, which may be as long as names can be.
inline std::string temporary_name(const std::filesystem::path& path)
{
  std::random_device device;
  return (path.parent_path() / (".cscd_" + std::to_string(device()) + ".part")).string();
}

} // namespace internal

/// Files that appear together: each is written beside its place, and takes it when all are complete. When anything
/// fails, there is no new file, and old ones are as they were.
class File_group
{
public:
  File_group() = default;
  File_group(File_group&&) = delete;
  /// Removes what has been written and not published.
  ~File_group()
  {
    for (const File& file : m_files) {
      std::error_code error;
      std::filesystem::remove(file.temporary, error);
    }
  }

  /// Writes what `write` puts into a stream beside the place of `filename`; what is not a regular file, such as a pipe,
  /// is written to directly. A file that is replaced keeps its permissions, and a link to it stays a link.
  /// \param write called once with a `std::ostream&`
  /// \throw File_error if the file cannot be written; whatever `write` throws
  template <class Write>
  void write(const std::string& filename, Write write)
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
    const fs::path place = internal::place_of(filename);
    m_files.push_back({filename, place, internal::temporary_name(place)});
    const std::string& temporary = m_files.back().temporary;
    if (fs::exists(status)) {
      // Before the file holds anything, only those who may read the old one get to read it.
      internal::write_directly(temporary, filename, [](std::ostream&) {});
      fs::permissions(temporary, status.permissions(), error);
    }
    internal::write_directly(temporary, filename, write);
  }

  /// Lets all files that have been written take their places.
  /// \throw File_error if one of them cannot, as in a folder that forbids it; those before it are published
  void publish()
  {
    for (const File& file : m_files) {
      std::error_code error;
      std::filesystem::rename(file.temporary, file.place, error);
      if (error) {
        internal::throw_not_writable(file.name, error.message());
      }
    }
    m_files.clear();
  }

private:
  struct File
  {
    std::string name;
    std::filesystem::path place;
    std::string temporary;
  };

  std::vector<File> m_files;
};

/// creates the file `filename`, or replaces it, with what `write` puts into a stream: a `File_group` of one file.
/// \param write called once with a `std::ostream&`
/// \throw File_error if the file cannot be written; whatever `write` throws
template <class Write>
void write_file(const std::string& filename, Write write)
{
  File_group file;
  file.write(filename, write);
  file.publish();
}

} // namespace CSCD

#endif // CSCD_IO_WRITE_FILE_H
