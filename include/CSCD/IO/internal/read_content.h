// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of files.

#ifndef CSCD_IO_INTERNAL_READ_CONTENT_H
#define CSCD_IO_INTERNAL_READ_CONTENT_H

#include <istream>
#include <string>

namespace CSCD::internal {

/// All that is left in `in`, decompressed if `format` ends as the name of a compressed file.
/// \param name for messages
/// \throw File_error if reading fails, or if it cannot be decompressed
std::string read_content(std::istream& in, const std::string& name, const std::string& format = "");

/// The content of the file `filename`, decompressed if it ends as the name of a compressed file.
/// \throw File_error if it cannot be read
std::string read_content(const std::string& filename);

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_READ_CONTENT_H
