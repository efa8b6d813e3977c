// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of the library's own named parameters, in the form of CGAL's list: type of the tag, its value, name.
// It is included several times, each time with another meaning of the macro, and so has no include guard.

// clang-format off
CSCD_add_named_parameter(number_of_threads_t, number_of_threads, number_of_threads)
CSCD_add_named_parameter(maximum_number_of_sources_t, maximum_number_of_sources, maximum_number_of_sources)
CSCD_add_named_parameter(detail_t, detail, detail)
CSCD_add_named_parameter(node_spacing_t, node_spacing, node_spacing)
CSCD_add_named_parameter(border_treatment_t, border_treatment, border_treatment)
CSCD_add_named_parameter(resolution_t, resolution, resolution)
CSCD_add_named_parameter(use_skeleton_radii_t, use_skeleton_radii, use_skeleton_radii)
CSCD_add_named_parameter(match_distance_t, match_distance, match_distance)
CSCD_add_named_parameter(time_step_factor_t, time_step_factor, time_step_factor)
CSCD_add_named_parameter(distance_map_t, distance_map, distance_map)
CSCD_add_named_parameter(laplacian_threshold_t, laplacian_threshold, laplacian_threshold)
CSCD_add_named_parameter(angle_threshold_t, angle_threshold, angle_threshold)
CSCD_add_named_parameter(minimum_branch_length_t, minimum_branch_length, minimum_branch_length)
CSCD_add_named_parameter(root_t, root, root)
CSCD_add_named_parameter(policies_t, policies, policies)
CSCD_add_named_parameter(minimum_component_size_t, minimum_component_size, minimum_component_size)
CSCD_add_named_parameter(minimum_significance_t, minimum_significance, minimum_significance)
CSCD_add_named_parameter(minimum_length_over_radius_t, minimum_length_over_radius, minimum_length_over_radius)
CSCD_add_named_parameter(join_components_t, join_components, join_components)
CSCD_add_named_parameter(spacing_t, spacing, spacing)
CSCD_add_named_parameter(spacing_over_radius_t, spacing_over_radius, spacing_over_radius)
