// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of what became of each input of a batch.

#ifndef CSCD_PROGRAM_BATCH_MANIFEST_H
#define CSCD_PROGRAM_BATCH_MANIFEST_H

#include <string>
#include <unordered_set>
#include <vector>

namespace cscd {

/// \name What became of an input, as the manifest has it
/// @{
inline constexpr const char* done_status = "done";       ///< its files are there
inline constexpr const char* failed_status = "failed";   ///< it was refused; the message says why
inline constexpr const char* timeout_status = "timeout"; ///< it took too long
inline constexpr const char* memory_status = "memory";   ///< it needed more memory than it was given
inline constexpr const char* crashed_status = "crashed"; ///< its process broke down or was killed
/// @}

/// A row of the manifest. Counts are text, empty where they are not known.
struct Batch_row
{
  std::string input;
  std::string status;
  std::vector<std::string> counts; ///< in the order of `batch_counts`
  double seconds = 0;              ///< wall-clock time
  double megabytes = 0;            ///< largest resident size
  std::string message;             ///< warnings, or why there is no skeleton
};

/// The members of the report of `cscd skeletonize` that are columns of the manifest.
inline constexpr const char* batch_counts[] = {
    "number_of_sites", "number_of_nodes", "number_of_edges",    "number_of_skeleton_components",
    "betti_number",    "number_of_tips",  "number_of_junctions"};

/// A manifest in CSV that grows by one row at a time and is complete whenever the process ends, however it ends. While
/// it is open, no other process can open it.
class Batch_manifest
{
public:
  /// Opens the file, or creates it. If there is one, the rows of inputs that were done or refused are kept; others, and
  /// half a row at the end, are removed, as are those of the same input but for the first.
  /// \param resumes whether there may be one
  /// \throw Usage_error if there is one and it must not be; CSCD::File_error if it cannot be read or written, or
  ///        another process has it open
  Batch_manifest(const std::string& filename, bool resumes);
  Batch_manifest(const Batch_manifest&) = delete;
  Batch_manifest& operator=(const Batch_manifest&) = delete;
  ~Batch_manifest();

  /// Whether there is a row of this input.
  bool has(const std::string& input) const { return m_inputs.count(input) > 0; }

  /// \throw CSCD::File_error if it cannot be written
  void append(const Batch_row& row);

private:
  void keep_finished_rows();
  void write(const std::string& text);

  std::string m_filename;
  int m_file = -1;
  std::unordered_set<std::string> m_inputs;
};

} // namespace cscd

#endif // CSCD_PROGRAM_BATCH_MANIFEST_H
