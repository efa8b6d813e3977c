# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cpack -G DEB` in the build folder makes two packages: libcscd-dev, the library, and cscd, the program.

set(CPACK_COMPONENTS_ALL library)
if(CSCD_BUILD_COMPILED)
  list(APPEND CPACK_COMPONENTS_ALL compiled)
endif()
if(CSCD_BUILD_EXAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_COMPONENT_LIBRARY_GROUP development)
set(CPACK_COMPONENT_COMPILED_GROUP development)
set(CPACK_COMPONENT_PROGRAM_GROUP program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_PACKAGE_CONTACT "The CSCD developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcscd-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "curve skeletons of triangle meshes and point sets: C++ library
 Headers, in the style of CGAL, and a static library of what is no template.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libboost-dev (>= 1.74), libeigen3-dev (>= 3.3)")
if(CSCD_WITH_TBB)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libtbb-dev")
endif()
if(CSCD_WITH_ZLIB)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", zlib1g-dev")
endif()
if(CSCD_WITH_ZSTD)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libzstd-dev")
endif()
if(CSCD_WITH_TIFF)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libtiff-dev")
endif()

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME cscd)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "curve skeletons of triangle meshes and point sets: program
 Computes, measures, compares and converts skeletons; segments meshes by them.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS python3) # cscd-batch

include(CPack)
