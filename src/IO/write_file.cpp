// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The definitions of write_file.h.

#include <CSCD/IO/write_file.h>
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

namespace {

[[noreturn]] void throw_not_writable(const std::string& filename, const std::string& reason)
{
  throw File_error(filename + ": cannot be written (" + reason + "); check the folder, its permissions and the disk");
}

/// Opens `path`, lets `write` write to it and closes it.
void write_directly(const std::filesystem::path& path, const std::string& filename, const File_group::Write& write)
{
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "no such place");
  }
  write(out);
  out.close();
  if (!out) {
    throw_not_writable(filename, errno != 0 ? std::strerror(errno) : "the disk may be full");
  }
}

/// Where a file of this name is, or would be: links are followed.
std::filesystem::path place_of(const std::string& filename)
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

} // namespace

File_group::~File_group()
{
  for (const File& file : m_files) {
    std::error_code error;
    std::filesystem::remove(file.temporary, error);
  }
}

void File_group::write(const std::string& filename, const Write& write)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  if (fs::is_directory(status)) {
    throw_not_writable(filename, "it is a folder");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_directly(filename, filename, write);
    return;
  }
  const fs::path place = place_of(filename);
  // Next to the file, a name that no other process uses; not with that of the file, which may be as long as names can
  // be.
  const fs::path temporary = place.parent_path() / (".cscd_" + std::to_string(std::random_device()()) + ".part");
  m_files.push_back({filename, place, temporary});
  if (fs::exists(status)) {
    // Before the file holds anything, only those who may read the old one get to read it.
    write_directly(temporary, filename, [](std::ostream&) {});
    fs::permissions(temporary, status.permissions(), error);
  }
  write_directly(temporary, filename, write);
}

void File_group::publish()
{
  // Needs no memory, which might be lacking between two files.
  for (const File& file : m_files) {
    std::error_code error;
    std::filesystem::rename(file.temporary, file.place, error);
    if (error) {
      throw_not_writable(file.name, error.message());
    }
  }
  m_files.clear();
}

void write_file(const std::string& filename, const File_group::Write& write)
{
  File_group file;
  file.write(filename, write);
  file.publish();
}

} // namespace CSCD
