# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The compiled parts of the library: the core and the published method, which can also be used header-only, and the
# modules, which cannot.

# Each part after the parts that it links.
set(cscd_parts core published measure tree application io)

set(cscd_core_sources mesh_pipeline.cpp points.cpp)
set(cscd_published_sources published_method.cpp)
set(cscd_published_links core)
set(cscd_measure_sources
    Measure/Rooted_forest.cpp
    Measure/Skeleton_branches.cpp
    Measure/compare_skeletons.cpp
    Measure/evaluate_skeleton.cpp
    Measure/simplify_skeleton.cpp)
set(cscd_measure_links core)
set(cscd_tree_sources Tree/Tree_skeletonization.cpp)
set(cscd_tree_links measure)
set(cscd_application_sources Application/find_surface_loops.cpp Application/make_rig.cpp Application/segment_mesh.cpp)
set(cscd_application_links measure)
set(cscd_io_sources
    IO/files.cpp
    IO/parse_gltf.cpp
    IO/parse_meshes.cpp
    IO/parse_points_and_skeletons.cpp
    IO/parse_vtk.cpp
    IO/repair_mesh.cpp
    IO/volumes.cpp
    IO/write_rig.cpp
    IO/write_skeleton.cpp)
set(cscd_io_links tree application)

# cscd_add_parts(<prefix> [STATIC])
# adds the libraries <prefix>_core, <prefix>_measure and so on, and <prefix>_compiled, which links all of them. The files
# of a part are compiled as one, since most of the time goes to the headers that they share: in a part no name may be
# defined twice.
function(cscd_add_parts prefix)
  foreach(part IN LISTS cscd_parts)
    set(target ${prefix}_${part})
    set(sources ${cscd_${part}_sources})
    list(TRANSFORM sources PREPEND "${PROJECT_SOURCE_DIR}/src/")
    set(links ${cscd_${part}_links})
    list(TRANSFORM links PREPEND ${prefix}_)
    add_library(${target} ${ARGN} ${sources})
    target_link_libraries(${target} PUBLIC CSCD::parallel ${links})
    target_compile_definitions(${target} PUBLIC CSCD_COMPILED)
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src")
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endforeach()
  if(TARGET ${prefix}_io)
    target_link_libraries(${prefix}_io PRIVATE $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
    cscd_add_formats(${prefix}_io)
  endif()
  list(TRANSFORM cscd_parts PREPEND ${prefix}_ OUTPUT_VARIABLE parts)
  add_library(${prefix}_compiled INTERFACE)
  target_link_libraries(${prefix}_compiled INTERFACE ${parts})
endfunction()
