// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Output of the commands that use the skeleton of a mesh.

#ifndef CSCD_PROGRAM_WRITE_WITH_REPORT_H
#define CSCD_PROGRAM_WRITE_WITH_REPORT_H

#include "dump_json.h"
#include "options.h"
#include "types.h"
#include <CSCD/IO/write_file.h>

#include <ostream>

namespace cscd {

/// Refuses files that are the input, and two results on standard output.
/// \throw Usage_error
void check_files(const Application_options& options);

/// Writes the result by `write(out)`, and the report if there is to be one.
/// \param document makes the report
template <class Write, class MakeDocument>
void write_with_report(const Application_options& options, const Write& write, const MakeDocument& document)
{
  CSCD::File_group files;
  write_to(files, options.output, write);
  if (!options.report.empty()) {
    write_to(files, options.report, [&](std::ostream& out) { out << dump_json(document()) << '\n'; });
  }
  files.publish();
}

} // namespace cscd

#endif // CSCD_PROGRAM_WRITE_WITH_REPORT_H
