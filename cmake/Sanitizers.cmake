# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Option CSCD_SANITIZER: compiles everything with a sanitizer, and adds only the tests that name it.

set(CSCD_SANITIZER
    ""
    CACHE STRING "Sanitizer for the project's own programs: empty, address (with undefined behavior), or thread")
set_property(CACHE CSCD_SANITIZER PROPERTY STRINGS "" address thread)

if(CSCD_SANITIZER STREQUAL "address")
  # Divisions by zero and conversions that overflow are not part of `undefined`.
  set(cscd_sanitizers address,undefined,float-divide-by-zero,float-cast-overflow)
  add_compile_options(-fsanitize=${cscd_sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${cscd_sanitizers})
elseif(CSCD_SANITIZER STREQUAL "thread")
  # The macro lets CSCD show the sanitizer the order of TBB's work.
  add_compile_options(-fsanitize=thread)
  add_compile_definitions(CSCD_THREAD_SANITIZER)
  add_link_options(-fsanitize=thread)
elseif(CSCD_SANITIZER)
  message(FATAL_ERROR "CSCD_SANITIZER is \"${CSCD_SANITIZER}\": it has to be empty, address or thread")
endif()

# The tests link a build of the library of their own, with the sanitizer.
if(CSCD_SANITIZER AND TARGET cscd_compiled)
  foreach(part IN LISTS cscd_parts)
    set_target_properties(cscd_${part} PROPERTIES EXCLUDE_FROM_ALL ON)
  endforeach()
endif()
