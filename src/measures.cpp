// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The measures of skeletons, compiled once.

#include <CSCD/Measure/compare_segmentations_impl.h>
#include <CSCD/Measure/compare_skeletons_impl.h>
#include <CSCD/Measure/evaluate_skeleton_impl.h>
