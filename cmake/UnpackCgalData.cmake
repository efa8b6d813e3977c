# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Unpacks the real meshes and points of Debian's package libcgal-demo into the build folder.
# Sets CSCD_CGAL_DATA_DIR to the folder of meshes and CSCD_CGAL_POINTS_DIR to that of points. The folders do not exist
# without the package.

set(CSCD_CGAL_DATA_ARCHIVE
    "/usr/share/doc/libcgal-dev/data.tar.gz"
    CACHE FILEPATH "CGAL's example data, as packed by Debian's libcgal-demo")
mark_as_advanced(CSCD_CGAL_DATA_ARCHIVE)

set(CSCD_CGAL_DATA_DIR "${PROJECT_BINARY_DIR}/cgal_data/data/meshes")
set(CSCD_CGAL_POINTS_DIR "${PROJECT_BINARY_DIR}/cgal_data/data/points_3")
if(EXISTS "${CSCD_CGAL_DATA_ARCHIVE}" AND NOT (EXISTS "${CSCD_CGAL_DATA_DIR}" AND EXISTS "${CSCD_CGAL_POINTS_DIR}"))
  # Renamed at the end, so that an interrupted extraction is not treated as complete.
  file(REMOVE_RECURSE "${PROJECT_BINARY_DIR}/cgal_data" "${PROJECT_BINARY_DIR}/cgal_data_partial")
  file(ARCHIVE_EXTRACT INPUT "${CSCD_CGAL_DATA_ARCHIVE}" DESTINATION "${PROJECT_BINARY_DIR}/cgal_data_partial"
       PATTERNS "data/meshes/*" "data/points_3/*")
  file(RENAME "${PROJECT_BINARY_DIR}/cgal_data_partial" "${PROJECT_BINARY_DIR}/cgal_data")
endif()
if(NOT EXISTS "${CSCD_CGAL_DATA_DIR}")
  message(STATUS "CGAL's example data not found (package libcgal-demo): tests on real meshes will be skipped")
endif()
