// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder for the files of a test.

#ifndef CSCD_TEST_SUPPORT_TEMPORARY_FOLDER_H
#define CSCD_TEST_SUPPORT_TEMPORARY_FOLDER_H

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>

namespace test_support {

/// An empty folder that is removed with all its content in the end.
class Temporary_folder
{
public:
  Temporary_folder()
      : m_path(std::filesystem::temp_directory_path() / ("cscd_test_" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(m_path);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder()
  {
    std::error_code error;
    std::filesystem::permissions(m_path, std::filesystem::perms::owner_all, error);
    std::filesystem::remove_all(m_path, error);
  }

  const std::filesystem::path& path() const { return m_path; }
  std::string file(const std::string& name) const { return (m_path / name).string(); }

  /// Writes a file. \return its name with the folder
  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

  std::ptrdiff_t number_of_files() const
  {
    return std::distance(std::filesystem::directory_iterator(m_path), std::filesystem::directory_iterator());
  }

private:
  std::filesystem::path m_path;
};

/// The content of a file; empty if it does not exist.
inline std::string read_file(const std::string& filename)
{
  std::ifstream in(filename, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

} // namespace test_support

#endif // CSCD_TEST_SUPPORT_TEMPORARY_FOLDER_H
