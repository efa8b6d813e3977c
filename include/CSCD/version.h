// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The version of the library.

#ifndef CSCD_VERSION_H
#define CSCD_VERSION_H

#define CSCD_VERSION_MAJOR 0
#define CSCD_VERSION_MINOR 4
#define CSCD_VERSION_PATCH 0
#define CSCD_VERSION "0.4.0"

#endif // CSCD_VERSION_H
