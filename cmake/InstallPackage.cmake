# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the headers, the compiled parts and the program if they are built, and the files of find_package(CSCD).

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(cscd_package_dir "${CMAKE_INSTALL_DATADIR}/cmake/CSCD")

install(
  DIRECTORY "${PROJECT_SOURCE_DIR}/include/CSCD"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT library
  FILES_MATCHING
  PATTERN "*.h")
install(TARGETS CSCD cscd_parallel EXPORT CSCDTargets COMPONENT library)
install(
  EXPORT CSCDTargets
  NAMESPACE CSCD::
  DESTINATION "${cscd_package_dir}"
  COMPONENT library)

# The compiled parts of the package have a targets file of their own, so that the headers can be installed without them.
if(CSCD_BUILD_COMPILED)
  list(TRANSFORM cscd_parts PREPEND cscd_ OUTPUT_VARIABLE cscd_part_targets)
  set_target_properties(
    ${cscd_part_targets} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION
                                                               ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(
    TARGETS ${cscd_part_targets} cscd_compiled
    EXPORT CSCDCompiledTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT compiled
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT compiled
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT compiled)
  install(
    EXPORT CSCDCompiledTargets
    NAMESPACE CSCD::
    DESTINATION "${cscd_package_dir}"
    COMPONENT compiled)
endif()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/CSCDConfig.cmake.in" "${PROJECT_BINARY_DIR}/CSCDConfig.cmake"
                              INSTALL_DESTINATION "${cscd_package_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/CSCDConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/CSCDConfig.cmake" "${PROJECT_BINARY_DIR}/CSCDConfigVersion.cmake"
        DESTINATION "${cscd_package_dir}" COMPONENT library)
