# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D OUTPUT=<file> -D "SOURCES=<source>;..." [-D ENTRY=<function>] -P write_unit.cmake
# writes the file OUTPUT, which compiles the sources as one, since most of the time goes to the headers that they share.
# All headers come first, then each source in a namespace that is named after it: so sources may define the same names.
# With ENTRY, each source defines this extern "C" function, which is named after the source instead.

set(includes)
set(body)
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
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)

file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${includes}\n\n${body}" @ONLY)
