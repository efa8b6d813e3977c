# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Links from Markdown to the examples lead to their folder on a host of Git: makes them lead to pages of the manual.
s,\[([^]]*)\]\((\.\./)?examples/([a-z_]+\.cpp)\),\\ref \3 "\1",g
s,\[([^]]*)\]\((doc/)?manual/user_manual\.dox\),\\ref user_manual "\1",g
s,\((\.\./)?examples/\),(examples.html),g
# Links to headers have no page of their own by that path: the name is left.
s,\[(`[^]]*`)\]\(\.\./include/[^)]*\),\1,g
# Likewise of pages next to the code of other tools, whose pictures are found by name.
s,\[([^]]*)\]\(\.\./integrations/[^)]*\.md\),\1,g
s,\]\(\.\./integrations/blender/,](,g
