// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page that shows a skeleton, compiled once.

#include <CSCD/IO/write_html_page_impl.h>
