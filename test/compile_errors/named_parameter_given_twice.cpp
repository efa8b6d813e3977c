// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains that both hold a parameter cannot be combined.
// expected error: CSCD: the same named parameter is given by two of the combined chains

#include <CSCD/Named_parameters.h>

int main()
{
  CSCD::parameters::combine(CGAL::parameters::random_seed(7), CSCD::parameters::number_of_threads(2).random_seed(8));
}
