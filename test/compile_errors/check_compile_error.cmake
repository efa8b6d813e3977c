# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -DSOURCE=<file> -P check_compile_error.cmake -- <compiler> <option>...
# compiles SOURCE and fails unless the compiler refuses it with the sentence after `expected error: ` in SOURCE;
# a SOURCE without such a line has to compile.

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

file(STRINGS "${SOURCE}" expected_error REGEX "expected error: ")
string(REGEX REPLACE ".*expected error: " "" expected_error "${expected_error}")

execute_process(COMMAND ${command} "${SOURCE}" RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(expected_error STREQUAL "")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "should compile, but:\n${output}")
  endif()
else()
  if(result EQUAL 0)
    message(FATAL_ERROR "compiles, but should be refused with: ${expected_error}")
  endif()
  string(FIND "${output}" "${expected_error}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "refused, but not with: ${expected_error}\n${output}")
  endif()
endif()
