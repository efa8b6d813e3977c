# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The compilation of the project's own programs. It does not affect users of CSCD::CSCD.

# Warnings are errors in our own code; the headers of CGAL, Boost and Eigen count as system headers.
add_library(cscd_warnings INTERFACE)
target_compile_options(
  cscd_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Werror)

set(CSCD_PROGRAM_FLAGS
    ""
    CACHE STRING "Options of the compiler for examples and benchmarks alone: -O0 where their speed does not matter")
mark_as_advanced(CSCD_PROGRAM_FLAGS)

# cscd_add_program(<name> <source>... [LIBRARIES <library>...] [FOLDER <folder under bin>])
# adds an executable that uses CSCD::compiled and goes to the folder bin of the build.
function(cscd_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 program "" "FOLDER" "LIBRARIES")
  add_executable(${name} ${program_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE CSCD::compiled cscd_warnings ${program_LIBRARIES})
  set_target_properties(
    ${name} PROPERTIES CXX_EXTENSIONS OFF RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin/${program_FOLDER}")
endfunction()

# cscd_add_unit(<output> SOURCES <source>... [OPTIONS <definition>...])
# lets the build write the file <output>, which compiles all sources as one: see write_unit.cmake.
function(cscd_add_unit output)
  cmake_parse_arguments(PARSE_ARGV 1 unit "" "" "SOURCES;OPTIONS")
  set(sources)
  foreach(source IN LISTS unit_SOURCES)
    cmake_path(ABSOLUTE_PATH source)
    list(APPEND sources "${source}")
  endforeach()
  list(TRANSFORM unit_OPTIONS PREPEND -D)
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_unit.cmake")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DSOURCES=${sources}" ${unit_OPTIONS} -P "${script}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${output}"
    DEPENDS ${sources} "${script}"
    VERBATIM)
endfunction()
