// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The skeletons of scans of trees, compiled once.

#include <CSCD/Tree/Tree_skeletonization_impl.h>
