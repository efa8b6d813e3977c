# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian packages of the build BUILD_DIR and unpacks them to the folder ROOT. Fails if a package is missing,
# needs a package that is not installed here (this build needed no more), or if the unpacked program does not run.

file(REMOVE_RECURSE "${ROOT}" "${ROOT}_packages")
execute_process(COMMAND "${CPACK}" -G DEB -B "${ROOT}_packages" --config "${BUILD_DIR}/CPackConfig.cmake"
                COMMAND_ERROR_IS_FATAL ANY)
foreach(package libcscd-dev cscd)
  file(GLOB file "${ROOT}_packages/${package}_*.deb")
  execute_process(COMMAND dpkg-deb --field "${file}" Depends OUTPUT_VARIABLE dependencies COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[a-z][a-z0-9.+-]+( \\([^)]*\\))?" dependencies "${dependencies}")
  list(TRANSFORM dependencies REPLACE " .*" "")
  if(NOT dependencies)
    message(FATAL_ERROR "${package}: depends on nothing")
  endif()
  execute_process(COMMAND dpkg-query --status ${dependencies} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND dpkg-deb --extract "${file}" "${ROOT}" COMMAND_ERROR_IS_FATAL ANY)
  if(NOT EXISTS "${ROOT}/usr/share/doc/${package}/copyright")
    message(FATAL_ERROR "${package}: no copyright file")
  endif()
endforeach()
execute_process(COMMAND "${ROOT}/usr/bin/cscd" --version COMMAND_ERROR_IS_FATAL ANY)
