// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of PLY files.

#ifndef CSCD_IO_INTERNAL_PLY_HEADER_H
#define CSCD_IO_INTERNAL_PLY_HEADER_H

#include <CSCD/IO/internal/Text_scanner.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CSCD::internal {

/// The types of numbers in PLY.
enum class Ply_type
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// A property of the items of an element: a number, or a list of numbers.
struct Ply_property
{
  std::string name;
  Ply_type type{};
  bool is_list = false;
  Ply_type size_type{}; ///< of a list
};

/// An element: items of the same properties.
struct Ply_element
{
  std::string name;
  std::size_t number_of_items = 0;
  std::vector<Ply_property> properties;
};

/// What the header of a PLY file tells.
struct Ply_header
{
  enum class Encoding
  {
    ascii,
    binary_little_endian,
    binary_big_endian
  };
  Encoding encoding = Encoding::ascii;
  std::vector<Ply_element> elements;
};

/// The type of the name `name`.
/// \throw File_error if there is none
inline Ply_type ply_type(std::string_view name, const Text_scanner& scanner)
{
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i][0] || name == names[i][1]) {
      return static_cast<Ply_type>(i);
    }
  }
  scanner.fail("the header names an unknown type", "write the file again");
}

/// Reads the next word of a header.
/// \throw File_error if the line ends before
inline std::string_view next_ply_word(Text_scanner& scanner)
{
  if (!scanner.skip_blanks_in_line()) {
    scanner.fail("the header has an incomplete line", "write the file again");
  }
  return scanner.word();
}

inline Ply_header::Encoding next_ply_encoding(Text_scanner& scanner)
{
  const std::string_view name = next_ply_word(scanner);
  if (name == "ascii") {
    return Ply_header::Encoding::ascii;
  }
  if (name == "binary_little_endian") {
    return Ply_header::Encoding::binary_little_endian;
  }
  if (name == "binary_big_endian") {
    return Ply_header::Encoding::binary_big_endian;
  }
  scanner.fail("the header names an unknown encoding", "write the file again");
}

inline Ply_property next_ply_property(Text_scanner& scanner)
{
  Ply_property property;
  std::string_view word = next_ply_word(scanner);
  if (word == "list") {
    property.is_list = true;
    property.size_type = ply_type(next_ply_word(scanner), scanner);
    word = next_ply_word(scanner);
  }
  property.type = ply_type(word, scanner);
  property.name = next_ply_word(scanner);
  return property;
}

/// Reads a header, up to and with its last line.
/// \throw File_error if it is malformed
inline Ply_header read_ply_header(Text_scanner& scanner)
{
  if (scanner.word() != "ply") {
    scanner.fail("this is no PLY file: it does not begin with ply", "check the ending of the file name");
  }
  Ply_header header;
  while (scanner.skip_blanks()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "format") {
      header.encoding = next_ply_encoding(scanner);
    } else if (keyword == "element") {
      const std::string name(next_ply_word(scanner));
      scanner.skip_blanks_in_line();
      header.elements.push_back({name, scanner.count("the number of items of an element"), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) {
        scanner.fail("a property stands before any element", "write the file again");
      }
      header.elements.back().properties.push_back(next_ply_property(scanner));
    }
    scanner.skip_line(); // comments and whatever else the header holds
    if (keyword == "end_header") {
      return header;
    }
  }
  scanner.fail_at_end("the end of its header");
}

} // namespace CSCD::internal

#endif // CSCD_IO_INTERNAL_PLY_HEADER_H
