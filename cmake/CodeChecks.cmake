# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Targets that check the text of the code: format_check, format (rewrites), tidy.

set(cscd_code)
foreach(folder include src program viewer examples python test benchmark cmake)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*.h" "${PROJECT_SOURCE_DIR}/${folder}/*.cpp")
  list(APPEND cscd_code ${files})
endforeach()

find_program(CSCD_CLANG_FORMAT NAMES clang-format clang-format-14)
mark_as_advanced(CSCD_CLANG_FORMAT)
if(CSCD_CLANG_FORMAT)
  add_custom_target(format_check COMMAND "${CSCD_CLANG_FORMAT}" --dry-run -Werror ${cscd_code} VERBATIM)
  add_custom_target(format COMMAND "${CSCD_CLANG_FORMAT}" -i ${cscd_code} VERBATIM)
endif()

# clang-tidy reads one file, since most of its time goes to the headers of CGAL: all headers of the library, with the
# definitions that src/ compiles among them, the files of the modules, then a file that instantiates the pipeline for
# meshes and points and both methods. Definitions in files are analyzed along all paths, those in headers as far as
# these files call them.
find_program(CSCD_CLANG_TIDY NAMES clang-tidy clang-tidy-14)
mark_as_advanced(CSCD_CLANG_TIDY)
if(CSCD_CLANG_TIDY)
  file(GLOB_RECURSE cscd_tidy_headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/*.h")
  file(GLOB cscd_tidy_modules CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/*/*.cpp" "${PROJECT_SOURCE_DIR}/viewer/*.cpp")
  set(cscd_tidy_text ${cscd_tidy_headers} ${cscd_tidy_modules} "${PROJECT_SOURCE_DIR}/cmake/instantiate_adapters.cpp")
  list(TRANSFORM cscd_tidy_text REPLACE "(.+)" "#include \"\\1\" // NOLINT(bugprone-suspicious-include)\n")
  list(JOIN cscd_tidy_text "" cscd_tidy_text)
  set(cscd_tidy_file "${PROJECT_BINARY_DIR}/tidy.cpp")
  file(CONFIGURE OUTPUT "${cscd_tidy_file}" CONTENT "${cscd_tidy_text}" @ONLY)

  # Never built: it only puts the file's options into compile_commands.json.
  add_library(cscd_tidy OBJECT EXCLUDE_FROM_ALL "${cscd_tidy_file}")
  target_link_libraries(cscd_tidy PRIVATE CSCD::parallel)
  target_include_directories(cscd_tidy PRIVATE "${PROJECT_SOURCE_DIR}/src")
  set_target_properties(cscd_tidy PROPERTIES CXX_EXTENSIONS OFF EXPORT_COMPILE_COMMANDS ON)

  add_custom_target(
    tidy
    COMMAND "${CSCD_CLANG_TIDY}" --quiet "--config-file=${PROJECT_SOURCE_DIR}/.clang-tidy" -p "${PROJECT_BINARY_DIR}"
            "${cscd_tidy_file}"
    VERBATIM)
endif()
