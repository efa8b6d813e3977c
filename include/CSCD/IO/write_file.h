// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing a file so that no half of it remains.

#ifndef CSCD_IO_WRITE_FILE_H
#define CSCD_IO_WRITE_FILE_H

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace CSCD {

/// Files that appear together: each is written next to its place, and moved there when all are complete. If a file
/// cannot be written, none is created or changed; if one cannot be moved, files that were moved before it stay.
class File_group
{
public:
  /// Writes the content of a file.
  using Write = std::function<void(std::ostream&)>;

  File_group() = default;
  File_group(File_group&&) = delete;
  /// Removes the files that have been written and not published.
  ~File_group();

  /// Writes the output of `write` into a stream next to the place of `filename`. A file that is not regular, such as a
  /// pipe, is written directly. A replaced file keeps its permissions, and a link to it stays a link.
  /// \param write called once
  /// \throw File_error if the file cannot be written; every exception of `write`
  void write(const std::string& filename, const Write& write);

  /// Lets all files that have been written take their places.
  /// \throw File_error if one of them cannot, as in a folder that forbids it; those before it are published
  void publish();

private:
  struct File
  {
    std::string name;
    std::filesystem::path place;
    std::filesystem::path temporary;
  };

  std::vector<File> m_files;
};

/// creates the file `filename`, or replaces it, with the output of `write`: a `File_group` of one file.
/// \param write called once
/// \throw File_error if the file cannot be written; every exception of `write`
void write_file(const std::string& filename, const File_group::Write& write);

} // namespace CSCD

#endif // CSCD_IO_WRITE_FILE_H
