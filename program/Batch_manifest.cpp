// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The manifest of a batch as CSV.

#include "Batch_manifest.h"

#include "commands.h"
#include <CSCD/exceptions.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>
#include <sys/file.h>
#include <sys/types.h>
#include <unistd.h>
#include <vector>

namespace cscd {

namespace {

constexpr std::size_t number_of_columns = 2 + std::size(batch_counts) + 3;

/// A field as RFC 4180 has it.
std::string quoted(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string result = "\"";
  for (const char c : text) {
    result += c == '"' ? "\"\"" : std::string(1, c);
  }
  return result + '"';
}

std::string header()
{
  std::string result = "input,status,";
  for (const char* count : batch_counts) {
    result += std::string(count) + ",";
  }
  return result + "seconds,megabytes,message\n";
}

std::string to_line(const Batch_row& row)
{
  constexpr int digits = 3; // of seconds and megabytes
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << quoted(row.input) << ',' << row.status << ',';
  for (std::size_t i = 0; i < std::size(batch_counts); ++i) {
    out << (i < row.counts.size() ? row.counts[i] : "") << ',';
  }
  out << std::fixed << std::setprecision(digits) << row.seconds << ',' << row.megabytes << ',' << quoted(row.message)
      << '\n';
  return out.str();
}

/// Reads the fields of the row that begins at `position`, and moves this behind it. \return none if the row has no end
std::vector<std::string> read_row(const std::string& text, std::size_t& position)
{
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  while (position < text.size()) {
    const char c = text[position++];
    if (c == '"') {
      const bool is_escaped = is_quoted && position < text.size() && text[position] == '"';
      if (is_escaped) {
        fields.back() += c;
        ++position;
      } else {
        is_quoted = !is_quoted;
      }
    } else if (!is_quoted && c == ',') {
      fields.emplace_back();
    } else if (!is_quoted && c == '\n') {
      return fields;
    } else {
      fields.back() += c;
    }
  }
  return {};
}

[[noreturn]] void fail(const std::string& filename, const std::string& what)
{
  throw CSCD::File_error(filename + ": cannot be " + what + " (" + std::strerror(errno) +
                         "); check the folder, its permissions and the disk");
}

/// The whole content of an open file.
std::string content_of(int file, const std::string& filename)
{
  constexpr std::size_t block = 1 << 16; // bytes
  std::string result;
  std::array<char, block> buffer{};
  for (;;) {
    const ssize_t size = read(file, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) {
      continue;
    }
    if (size < 0) {
      fail(filename, "read");
    }
    if (size == 0) {
      return result;
    }
    result.append(buffer.data(), std::size_t(size));
  }
}

} // namespace

Batch_manifest::Batch_manifest(const std::string& filename, bool resumes) : m_filename(filename)
{
  constexpr mode_t permissions = 0666; // less what the user's mask takes
  const int mode = O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | (resumes ? 0 : O_EXCL);
  m_file = open(filename.c_str(), mode, permissions);
  if (m_file < 0 && errno == EEXIST) {
    throw Usage_error(filename + ": is there already; add --resume to go on with it, or name another folder");
  }
  if (m_file < 0) {
    fail(filename, "written");
  }
  try {
    if (flock(m_file, LOCK_EX | LOCK_NB) != 0) {
      throw CSCD::File_error(filename + ": another cscd batch is writing it; wait for its end, or name another folder");
    }
    keep_finished_rows();
  } catch (...) {
    close(m_file);
    throw;
  }
}

Batch_manifest::~Batch_manifest()
{
  close(m_file);
}

void Batch_manifest::append(const Batch_row& row)
{
  write(to_line(row));
  m_inputs.insert(row.input);
}

void Batch_manifest::keep_finished_rows()
{
  const std::string old = content_of(m_file, m_filename);
  std::string kept = header();
  if (old.compare(0, kept.size(), kept, 0, old.size()) != 0) {
    throw Usage_error(m_filename + ": is no manifest of this version; name another folder");
  }
  std::size_t position = std::min(kept.size(), old.size());
  while (position < old.size()) {
    const std::size_t begin = position;
    const std::vector<std::string> fields = read_row(old, position);
    const bool is_finished =
        fields.size() == number_of_columns && (fields[1] == done_status || fields[1] == failed_status);
    if (is_finished && m_inputs.insert(fields[0]).second) {
      kept.append(old, begin, position - begin);
    }
  }
  if (kept == old) {
    return;
  }
  // Rows that are lost if the process ends here are made again the next time.
  std::size_t same = 0;
  while (same < std::min(kept.size(), old.size()) && kept[same] == old[same]) {
    ++same;
  }
  if (ftruncate(m_file, off_t(same)) != 0) {
    fail(m_filename, "written");
  }
  write(kept.substr(same));
}

void Batch_manifest::write(const std::string& text)
{
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t size = ::write(m_file, text.data() + written, text.size() - written);
    if (size < 0 && errno != EINTR) {
      fail(m_filename, "written");
    }
    written += size > 0 ? std::size_t(size) : 0;
  }
}

} // namespace cscd
