// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether expressions are valid for a type: what concept checks are made of.

#ifndef CSCD_INTERNAL_DETECTION_H
#define CSCD_INTERNAL_DETECTION_H

#include <type_traits>

namespace CSCD::internal {

template <class... T, class Function>
constexpr bool is_valid(const Function& /* expression */)
{
  return std::is_invocable_v<const Function&, T...>;
}

template <class Result, class... T, class Function>
constexpr bool gives(const Function& /* expression */)
{
  return std::is_invocable_r_v<Result, const Function&, T...>;
}

} // namespace CSCD::internal

/// Whether an expression in `t`, an object of type `T`, is valid. The expression is not evaluated.
#define CSCD_IS_VALID(T, ...)                                                                                          \
  ::CSCD::internal::is_valid<T>([]([[maybe_unused]] auto&& t) -> decltype(__VA_ARGS__) { return __VA_ARGS__; })
/// Whether it is valid and convertible to `Result`.
#define CSCD_GIVES(Result, T, ...)                                                                                     \
  ::CSCD::internal::gives<Result, T>([]([[maybe_unused]] auto&& t) -> decltype(__VA_ARGS__) { return __VA_ARGS__; })

#endif // CSCD_INTERNAL_DETECTION_H
