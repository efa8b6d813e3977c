# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cpack -G DEB` in the build folder makes the packages libcscd-dev, the library, cscd, the program, and python3-cscd,
# where the Python module is built: with -DCSCD_PYTHON_DESTINATION=lib/python3/dist-packages.

set(CPACK_COMPONENTS_ALL library)
if(CSCD_BUILD_COMPILED)
  list(APPEND CPACK_COMPONENTS_ALL compiled)
endif()
if(CSCD_BUILD_EXAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
if(CSCD_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python python_documents)
endif()
set(CPACK_COMPONENT_LIBRARY_GROUP development)
set(CPACK_COMPONENT_COMPILED_GROUP development)
set(CPACK_COMPONENT_PROGRAM_GROUP program)
set(CPACK_COMPONENT_PYTHON_GROUP python)
set(CPACK_COMPONENT_PYTHON_DOCUMENTS_GROUP python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

# Debian requires an address.
set(CPACK_PACKAGE_CONTACT "The CSCD developers <developers@cscd.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcscd-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "curve skeletons of triangle meshes and point sets: C++ library
 Headers, in the style of CGAL, and static libraries of the parts that are not
 templates.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libboost-dev (>= 1.74), libeigen3-dev (>= 3.3)")
if(CSCD_WITH_TBB)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libtbb-dev")
endif()
if(CSCD_WITH_ZLIB)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", zlib1g-dev")
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

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-cscd)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "curve skeletons of triangle meshes and point sets: Python module
 Takes and gives arrays of NumPy.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The module is compiled for one version of Python.
execute_process(COMMAND /usr/bin/python3 -c "import sys; a, b, *_ = sys.version_info; print(f'python3 (>= {a}.{b}), \
python3 (<< {a}.{b + 1}), python3-numpy')" OUTPUT_VARIABLE CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
                OUTPUT_STRIP_TRAILING_WHITESPACE)

# Debian requires of each package a copyright file and a changelog.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(changelog "${PROJECT_BINARY_DIR}/debian/changelog")
file(CONFIGURE OUTPUT "${changelog}" CONTENT "cscd (${PROJECT_VERSION}) unstable; urgency=medium

  * Release ${PROJECT_VERSION}: see CHANGELOG.md in the source.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip --best --no-name --force --keep "${changelog}")
set(components library program python_documents) # wheels have the component python alone
set(packages libcscd-dev cscd python3-cscd)
foreach(component package IN ZIP_LISTS components packages)
  install(FILES "${PROJECT_SOURCE_DIR}/packaging/copyright" "${changelog}.gz"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component})
endforeach()

include(CPack)
