# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For builds for other systems: libraries that consist of headers are those of this machine, and nothing else is.

set(cscd_headers "${CMAKE_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${cscd_headers}")
foreach(library CGAL boost nlohmann CLI eigen3/Eigen)
  cmake_path(GET library FILENAME name)
  file(CREATE_LINK "/usr/include/${library}" "${cscd_headers}/${name}" SYMBOLIC)
endforeach()

foreach(library CGAL::CGAL Boost::boost Eigen3::Eigen nlohmann_json::nlohmann_json CLI11::CLI11)
  add_library(${library} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${library} INTERFACE "${cscd_headers}")
endforeach()
# As CGAL's package has it where GMP is disabled. Its exact predicates change the rounding mode.
target_compile_definitions(CGAL::CGAL INTERFACE CGAL_DISABLE_GMP=1)
target_compile_options(CGAL::CGAL INTERFACE -frounding-math)

macro(cscd_find_headers method package)
  if("${package}" MATCHES "^(CGAL|Boost|Eigen3|nlohmann_json|CLI11)$")
    set(${package}_FOUND TRUE)
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER cscd_find_headers SUPPORTED_METHODS FIND_PACKAGE)

foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
