# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the headers and what find_package(CSCD) reads.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(cscd_package_dir "${CMAKE_INSTALL_DATADIR}/cmake/CSCD")

# The program cscd, if built, is installed with the default component.
install(
  DIRECTORY "${PROJECT_SOURCE_DIR}/include/CSCD"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT library
  FILES_MATCHING
  PATTERN "*.h")
install(TARGETS CSCD EXPORT CSCDTargets COMPONENT library)
install(
  EXPORT CSCDTargets
  NAMESPACE CSCD::
  DESTINATION "${cscd_package_dir}"
  COMPONENT library)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/CSCDConfig.cmake.in" "${PROJECT_BINARY_DIR}/CSCDConfig.cmake"
                              INSTALL_DESTINATION "${cscd_package_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/CSCDConfigVersion.cmake" COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES "${PROJECT_BINARY_DIR}/CSCDConfig.cmake" "${PROJECT_BINARY_DIR}/CSCDConfigVersion.cmake"
        DESTINATION "${cscd_package_dir}" COMPONENT library)
