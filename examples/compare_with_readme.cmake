# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails unless the file README holds the code of the file EXAMPLE, without its first comment, as a block of C++.

file(READ "${README}" readme)
file(READ "${EXAMPLE}" example)
string(FIND "${example}" "#include" begin)
string(SUBSTRING "${example}" ${begin} -1 code)
string(FIND "${readme}" "```cpp\n${code}```\n" position)
if(position EQUAL -1)
  message(FATAL_ERROR "${README} does not show the code of ${EXAMPLE}: copy what follows its first comment")
endif()
