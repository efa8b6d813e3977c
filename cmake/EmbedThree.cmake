# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the text of three.js, as found on the machine that builds, available to programs that write the viewer page.
# Defines the library cscd_three_js with the header three_js_source.h, which declares
#   std::string CSCD::three_js_source();
# the text of three.js and its OrbitControls, or an empty text where three.js was not found.

# The page is written for release 111 of three.js, which is that of Debian's libjs-three. The layout is the package's.
find_path(
  CSCD_THREE_JS_DIR
  NAMES build/three.min.js
  PATHS /usr/share/javascript/three
  DOC "Folder of three.js that has build/three.min.js and examples/js/controls/OrbitControls.js"
  NO_DEFAULT_PATH)
mark_as_advanced(CSCD_THREE_JS_DIR)

option(CSCD_FETCH_THREE_JS "Fetch three.js by npm where it is not found" OFF)
mark_as_advanced(CSCD_FETCH_THREE_JS)
if(CSCD_FETCH_THREE_JS AND NOT CSCD_THREE_JS_DIR)
  find_program(CSCD_NPM npm REQUIRED)
  mark_as_advanced(CSCD_NPM)
  set(cscd_npm_folder "${PROJECT_BINARY_DIR}/npm")
  execute_process(COMMAND "${CSCD_NPM}" install --no-audit --no-fund --prefix "${cscd_npm_folder}" three@0.111.0
                  COMMAND_ERROR_IS_FATAL ANY TIMEOUT 120 OUTPUT_QUIET)
  set_property(CACHE CSCD_THREE_JS_DIR PROPERTY VALUE "${cscd_npm_folder}/node_modules/three")
endif()

# Minified files come without the notice that their licence asks for.
set(cscd_three_js_notice
    [[
/*!
three.js and its OrbitControls. Copyright (c) 2010-2019 three.js authors. The MIT License:
Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:
The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.
THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
]])

# Appends <text> to the file of C++ <output> as an element of an array of strings.
function(cscd_append_literal output text)
  file(APPEND "${output}" "    R\"three_js(${text})three_js\",\n")
endfunction()

# Appends the file <input> to <output> in pieces that every compiler takes for a string literal.
function(cscd_append_file output input)
  set(length_of_piece 16000)
  file(READ "${input}" text)
  string(LENGTH "${text}" length)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} ${length_of_piece} piece)
    cscd_append_literal("${output}" "${piece}")
    math(EXPR begin "${begin} + ${length_of_piece}")
  endwhile()
  cscd_append_literal("${output}" "\n")
endfunction()

function(cscd_write_three_js_source output)
  set(partial "${output}.part")
  file(WRITE "${partial}" "#include \"three_js_source.h\"\n\nnamespace {\n\nconst char* const pieces[] = {\n")
  if(CSCD_THREE_JS_DIR)
    cscd_append_literal("${partial}" "${cscd_three_js_notice}")
    foreach(script build/three.min.js examples/js/controls/OrbitControls.js)
      cscd_append_file("${partial}" "${CSCD_THREE_JS_DIR}/${script}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CSCD_THREE_JS_DIR}/${script}")
    endforeach()
  endif()
  file(
    APPEND "${partial}"
    "    \"\"};\n\n} // namespace\n\nstd::string CSCD::three_js_source()\n{\n  std::string text;\n"
    "  for (const char* piece : pieces) {\n    text += piece;\n  }\n  return text;\n}\n")
  file(COPY_FILE "${partial}" "${output}" ONLY_IF_DIFFERENT)
  file(REMOVE "${partial}")
endfunction()

set(cscd_three_js_folder "${PROJECT_BINARY_DIR}/three_js")
file(
  CONFIGURE OUTPUT "${cscd_three_js_folder}/three_js_source.h"
  CONTENT "#ifndef CSCD_THREE_JS_SOURCE_H
#define CSCD_THREE_JS_SOURCE_H

#include <string>

namespace CSCD {

/// The text of three.js and its OrbitControls; empty if they were not found when this was built.
std::string three_js_source();

} // namespace CSCD

#endif // CSCD_THREE_JS_SOURCE_H
"
  @ONLY)
cscd_write_three_js_source("${cscd_three_js_folder}/three_js_source.cpp")
if(NOT CSCD_THREE_JS_DIR)
  message(STATUS "three.js not found (package libjs-three, or -DCSCD_FETCH_THREE_JS=ON): programs cannot write the viewer "
                 "page")
endif()

add_library(cscd_three_js STATIC "${cscd_three_js_folder}/three_js_source.cpp")
target_include_directories(cscd_three_js PUBLIC "${cscd_three_js_folder}")
target_compile_features(cscd_three_js PUBLIC cxx_std_17)
set_target_properties(cscd_three_js PROPERTIES CXX_EXTENSIONS OFF)
