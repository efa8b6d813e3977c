# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D OUTPUT=<file> -D "SOURCES=<source>;..." [-D MAIN=ON] [-D ENTRY=<function>] -P write_unit.cmake
# writes the file OUTPUT, which compiles the sources as one, since most of the time goes to the headers that they share.
# All headers come first, then each source in a namespace that is named after it: so sources may define the same names.
# With MAIN, the sources are programs: OUTPUT is a program whose first argument names the one that is run. With ENTRY,
# each source defines this extern "C" function, which is named after the source instead.

set(includes)
set(body)
set(calls)
foreach(source IN LISTS SOURCES)
  cmake_path(GET source STEM name)
  cmake_path(GET source PARENT_PATH folder)
  file(STRINGS "${source}" lines REGEX "^#include ")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"(.*)\"$" "${folder}/\\1" path "${line}")
    if(EXISTS "${path}")
      set(line "#include \"${path}\"")
    endif()
    list(APPEND includes "${line}")
  endforeach()
  if(ENTRY)
    string(APPEND body "#define ${ENTRY} ${ENTRY}_${name}\n")
  endif()
  string(APPEND body "namespace ${name} {\n#include \"${source}\"\n}\n")
  if(ENTRY)
    string(APPEND body "#undef ${ENTRY}\n")
  endif()
  string(APPEND calls "  if (name == \"${name}\") {\n    return call(&${name}::main, argc - 1, argv + 1);\n  }\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)

if(MAIN)
  string(PREPEND includes "#include <string>\n")
  string(
    APPEND
    body
    "namespace {\n"
    "[[maybe_unused]] int call(int (*program)(), int, char**) { return program(); }\n"
    "[[maybe_unused]] int call(int (*program)(int, char**), int argc, char** argv) { return program(argc, argv); }\n"
    "}\n"
    "int main(int argc, char** argv)\n{\n  const std::string name(argc > 1 ? argv[1] : \"\");\n${calls}  return 2;\n}\n")
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${includes}\n\n${body}" @ONLY)
