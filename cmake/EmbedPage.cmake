# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes one HTML file of a page in several files, and a C++ file of that. The building machine provides three.js.
#   cscd_three_js           the text of three.js and its OrbitControls, for a script element; empty if it was not found
#   cscd_bundle_page()      puts style sheets and scripts into a page
#   cscd_write_page_source() writes the viewer page as a file of C++

set(cscd_viewer_dir "${CMAKE_CURRENT_LIST_DIR}/../viewer")
cmake_path(NORMAL_PATH cscd_viewer_dir)

# cscd_read_text(<variable> <file>) reads a file, and configures again when that changes.
function(cscd_read_text variable file)
  file(READ "${file}" text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

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

# Minified files lack the notice that their license requires.
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

set(cscd_three_js "")
if(CSCD_THREE_JS_DIR)
  set(cscd_three_js "${cscd_three_js_notice}")
  foreach(script build/three.min.js examples/js/controls/OrbitControls.js)
    cscd_read_text(text "${CSCD_THREE_JS_DIR}/${script}")
    string(APPEND cscd_three_js "${text}\n")
  endforeach()
  string(STRIP "${cscd_three_js}" cscd_three_js)
  # Neither ends the element, nor begins a comment in it. These occur in strings and comments of JavaScript alone.
  string(REGEX REPLACE "</([Ss][Cc][Rr][Ii][Pp][Tt])" "<\\\\/\\1" cscd_three_js "${cscd_three_js}")
  string(REPLACE "<!--" "<\\!--" cscd_three_js "${cscd_three_js}")
else()
  message(STATUS "three.js not found (package libjs-three, or -DCSCD_FETCH_THREE_JS=ON): programs cannot write the viewer "
                 "page")
endif()

# cscd_append_file(<file>)
# appends a file to the global property cscd_text, behind the modules of JavaScript that it imports, without the words
# import and export. Modules of one page share their names.
function(cscd_append_file file)
  get_property(files GLOBAL PROPERTY cscd_text_files)
  if(file IN_LIST files)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY cscd_text_files "${file}")
  cscd_read_text(text "${file}")
  cmake_path(GET file PARENT_PATH folder)
  string(REGEX MATCHALL "\nimport [^;]* from '[^']*'" imports "${text}")
  foreach(import IN LISTS imports)
    string(REGEX REPLACE ".* from '(.*)'" "\\1" path "${import}")
    cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY "${folder}" NORMALIZE)
    cscd_append_file("${path}")
  endforeach()
  string(REGEX REPLACE "\nimport [^;]*;" "" text "${text}")
  string(REPLACE "\nexport " "\n" text "${text}")
  set_property(GLOBAL APPEND_STRING PROPERTY cscd_text "${text}")
endfunction()

# cscd_bundle_page(<variable> <page> <text of three.js>)
# sets the variable to the text of an HTML file with its style sheets and scripts in the places of their names.
function(cscd_bundle_page variable page three_js)
  cscd_read_text(html "${page}")
  cmake_path(GET page PARENT_PATH folder)
  string(REPLACE "<script src=\"three.js\"></script>" "<script>\n${three_js}\n</script>" html "${html}")
  string(REGEX MATCHALL "<(link rel=\"stylesheet\"|script[^>]*) (href|src)=\"[^\"]*\"(></script>| />)" tags "${html}")
  foreach(tag IN LISTS tags)
    string(REGEX REPLACE ".*=\"(.*)\".*" "\\1" file "${tag}")
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${folder}" NORMALIZE)
    set_property(GLOBAL PROPERTY cscd_text_files "")
    set_property(GLOBAL PROPERTY cscd_text "")
    cscd_append_file("${file}")
    get_property(text GLOBAL PROPERTY cscd_text)
    if(tag MATCHES "^<link")
      set(element "<style>\n${text}</style>")
    else()
      string(REGEX REPLACE " src=.*" ">" begin "${tag}")
      set(element "${begin}\n${text}</script>")
    endif()
    string(REPLACE "${tag}" "${element}" html "${html}")
  endforeach()
  set(${variable} "${html}" PARENT_SCOPE)
endfunction()

# cscd_write_page_source(<output> <text of three.js>)
# writes the functions has_three_js() and html_page_template() of the viewer as a file of C++. The text is in pieces, since
# compilers limit the length of string literals.
function(cscd_write_page_source output three_js)
  cscd_bundle_page(text "${cscd_viewer_dir}/index.html" "${three_js}")
  set(has_three_js true)
  if(three_js STREQUAL "")
    set(has_three_js false)
  endif()
  set(source "#include <string>\n\nnamespace {\n\nconst char* const pieces[] = {\n")
  string(LENGTH "${text}" length)
  set(length_of_piece 16000)
  foreach(begin RANGE 0 ${length} ${length_of_piece})
    string(SUBSTRING "${text}" ${begin} ${length_of_piece} piece)
    string(APPEND source "    R\"page(${piece})page\",\n")
  endforeach()
  string(
    APPEND source
    "};\n\n} // namespace\n\nnamespace CSCD {\n\nbool has_three_js()\n{\n  return ${has_three_js};\n}\n\n"
    "namespace internal {\n\nstd::string html_page_template()\n{\n  std::string text;\n"
    "  for (const char* piece : pieces) {\n    text += piece;\n  }\n  return text;\n}\n\n} // namespace internal\n\n"
    "} // namespace CSCD\n")
  file(CONFIGURE OUTPUT "${output}" CONTENT "@source@" @ONLY)
endfunction()
