# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D SOURCE=<file> -P check_compile_errors.cmake -- <compiler> <option>...
# compiles SOURCE, and fails unless the compiler prints, as failed assertions of the library, exactly the sentences that
# follow `expected error: ` in SOURCE, each as often as it stands there.

set(command)
set(is_command FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(is_command)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(is_command TRUE)
  endif()
endforeach()
set(failed "static assertion failed( due to requirement [^\n]*)?: ") # GCC and Clang

execute_process(COMMAND ${command} "${SOURCE}" OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX MATCHALL "${failed}CSCD: [^\n]*" printed "${output}")
list(TRANSFORM printed REPLACE "${failed}" "")
file(STRINGS "${SOURCE}" expected REGEX "expected error: ")
list(TRANSFORM expected REPLACE ".*expected error: " "")
list(SORT printed)
list(SORT expected)
if(NOT printed STREQUAL expected)
  list(JOIN printed "\n  " printed)
  list(JOIN expected "\n  " expected)
  message(FATAL_ERROR "refused with\n  ${printed}\nbut expected\n  ${expected}\n${output}")
endif()
