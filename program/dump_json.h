// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of JSON documents.

#ifndef CSCD_PROGRAM_DUMP_JSON_H
#define CSCD_PROGRAM_DUMP_JSON_H

#include <nlohmann/json.hpp>

#include <string>

namespace cscd {

/// Text of any encoding can stand in a file name; JSON holds UTF-8 only.
inline std::string dump_json(const nlohmann::ordered_json& json)
{
  constexpr int indentation = 2;
  return json.dump(indentation, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace cscd

#endif // CSCD_PROGRAM_DUMP_JSON_H
