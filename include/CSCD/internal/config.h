// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the library is used header-only or by its compiled part.

#ifndef CSCD_INTERNAL_CONFIG_H
#define CSCD_INTERNAL_CONFIG_H

/// Precedes the definitions in files named `..._impl.h`, which are not templates. By default, the header that declares
/// them includes them. With the macro `CSCD_COMPILED`, which the target `CSCD::compiled` defines, it does not: each
/// file is compiled once, in `src/`.
#ifdef CSCD_COMPILED
#define CSCD_INLINE
#else
#define CSCD_INLINE inline
#endif

#endif // CSCD_INTERNAL_CONFIG_H
