// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A function refuses a named parameter of the library that it does not use, last in the chain.
// expected error: CSCD: this named parameter is not used by this function

#include <CSCD/Named_parameters.h>

template <class NamedParameters>
void function(const NamedParameters& /* np */)
{
  CSCD::internal::check_named_parameters<NamedParameters, CGAL::internal_np::random_seed_t,
                                         CSCD::internal_np::number_of_threads_t>();
}

int main()
{
  function(CSCD::parameters::maximum_number_of_sources(2).random_seed(7));
}
