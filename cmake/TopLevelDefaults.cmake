# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Settings that apply only when CSCD is the main project: build type, memory of GCC, compiler cache.

get_property(cscd_is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT cscd_is_multi_config AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

# CGAL warns of every build type but Release; the tests choose theirs on purpose.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# GCC looks for memory that it can free once it holds this many kB. Its default, 128 MB, costs 3 to 10 % of the time of
# the large files, and saves 0.3 of 1.8 GB.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=1572864)
endif()

find_program(CSCD_CCACHE ccache)
mark_as_advanced(CSCD_CCACHE)
if(CSCD_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  # Without this sloppiness, ccache does not cache files that use a precompiled header. Without CCACHE_DEPEND, it
  # preprocesses each file that it does not know, which takes a second or two.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
                                  "${CSCD_CCACHE}")
endif()
