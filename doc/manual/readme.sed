# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes links from README.md to the examples, which lead to their folder on a host of Git, lead to pages of the manual.
s,\[([^]]*)\]\(examples/([a-z_]+\.cpp)\),\\ref \2 "\1",g
s,\(examples/\),(examples.html),g
