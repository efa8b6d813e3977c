// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Named parameters: CGAL's and the library's own, chained in any order, as in
// `CSCD::parameters::random_seed(7).number_of_threads(2).vertex_point_map(map)`.

#ifndef CSCD_NAMED_PARAMETERS_H
#define CSCD_NAMED_PARAMETERS_H

#include <CSCD/Options.h>
#include <CSCD/Skeletonization_visitor.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <type_traits>

/// Expands `ADD(name)` for each of the library's own named parameters.
#define CSCD_FOR_EACH_NAMED_PARAMETER(ADD)                                                                             \
  ADD(number_of_threads)                                                                                               \
  ADD(maximum_number_of_sources)                                                                                       \
  ADD(detail)                                                                                                          \
  ADD(node_spacing)                                                                                                    \
  ADD(border_treatment)                                                                                                \
  ADD(resolution)                                                                                                      \
  ADD(use_skeleton_radii)                                                                                              \
  ADD(match_distance)                                                                                                  \
  ADD(time_step_factor)                                                                                                \
  ADD(distance_map)                                                                                                    \
  ADD(laplacian_threshold)                                                                                             \
  ADD(angle_threshold)                                                                                                 \
  ADD(minimum_branch_length)                                                                                           \
  ADD(root)                                                                                                            \
  ADD(policies)                                                                                                        \
  ADD(minimum_component_size)                                                                                          \
  ADD(minimum_significance)                                                                                            \
  ADD(minimum_length_over_radius)                                                                                      \
  ADD(join_components)                                                                                                 \
  ADD(spacing)                                                                                                         \
  ADD(spacing_over_radius)

// Later versions of CGAL have further kinds of entries in their list; here all of them are ordinary parameters.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)

namespace CSCD {

/// The tags of the library's own named parameters; CGAL's are in `CGAL::internal_np`.
namespace internal_np {

#ifndef DOXYGEN_RUNNING
#define CSCD_ADD_TAG(NAME) enum NAME##_t{NAME};
CSCD_FOR_EACH_NAMED_PARAMETER(CSCD_ADD_TAG)
#undef CSCD_ADD_TAG
#endif

} // namespace internal_np

/// A chain of named parameters: the parameter `Tag` with a value of type `T`, in front of the chain `Base`.
/// It is a `CGAL::Named_function_parameters`, which every function of CGAL takes, and can be prolonged by the
/// parameters of CGAL and of CSCD. Values are held as CGAL holds them: copied if they can be, else by reference.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  /// The name of this type in CGAL's macros.
  using self = Named_parameters;

  using CGAL::Named_function_parameters<T, Tag, Base>::Named_function_parameters;

#ifdef DOXYGEN_RUNNING
  /// prolongs the chain by one parameter. There is a function of this kind for each parameter, CGAL's included.
  template <class K>
  Named_parameters<K, parameter_tag, Named_parameters> parameter_name(const K& value) const;
#else
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <class K>                                                                                                   \
  Named_parameters<K, CGAL::internal_np::X, self> Z(const K& value) const                                              \
  {                                                                                                                    \
    return {value, *this};                                                                                             \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CSCD_ADD_MEMBER(NAME)                                                                                          \
  template <class K>                                                                                                   \
  Named_parameters<K, internal_np::NAME##_t, self> NAME(const K& value) const                                          \
  {                                                                                                                    \
    return {value, *this};                                                                                             \
  }
  CSCD_FOR_EACH_NAMED_PARAMETER(CSCD_ADD_MEMBER)
#undef CSCD_ADD_MEMBER
#endif
};

} // namespace CSCD

namespace CGAL {

template <class PolygonMesh, class NamedParametersGT, class NamedParametersVPM>
class GetGeomTraits;

/// CGAL instantiates this with a chain of named parameters where one of several overloads takes a mesh in its place.
/// Like the specialization that CGAL has for its own chains, it makes that overload drop out instead of failing to
/// compile.
template <class T, class Tag, class Base, class NamedParametersGT, class NamedParametersVPM>
class GetGeomTraits<CSCD::Named_parameters<T, Tag, Base>, NamedParametersGT, NamedParametersVPM>
{
public:
  using type = void;
};

} // namespace CGAL

namespace CSCD {

namespace internal {

/// Puts the parameters of the chain `front` in front of `chain`.
template <class T, class Tag, class Base, class Chain>
auto prepend_named_parameters(const CGAL::internal_np::Named_params_impl<T, Tag, Base>& front, const Chain& chain)
{
  static_assert(std::is_same_v<Tag, CGAL::internal_np::all_default_t> ||
                    CGAL::parameters::is_default_parameter<Chain, Tag>::value,
                "CSCD: the same named parameter is given by two of the combined chains");
  const T& value = front.v;
  if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>) {
    return Named_parameters<T, Tag, Chain>(value, chain);
  } else {
    const typename Base::base& rest = front;
    using Prolonged = decltype(prepend_named_parameters(rest, chain));
    return Named_parameters<T, Tag, Prolonged>(value, prepend_named_parameters(rest, chain));
  }
}

/// Refuses at compile time a parameter of the chain `*np` that is not among `UsedTags`; the compiler names it as `Tag`.
template <class... UsedTags, class T, class Tag, class Base>
constexpr void check_named_parameters(const CGAL::internal_np::Named_params_impl<T, Tag, Base>* /* np */)
{
  static_assert(std::is_same_v<Tag, CGAL::internal_np::all_default_t> || (std::is_same_v<Tag, UsedTags> || ...),
                "CSCD: this named parameter is not used by this function");
  if constexpr (!std::is_same_v<Base, CGAL::internal_np::No_property>) {
    check_named_parameters<UsedTags...>(static_cast<const typename Base::base*>(nullptr));
  }
}

/// Refuses at compile time the parameters of `NamedParameters` whose tags are not among `UsedTags`: the first line of
/// a function that takes named parameters.
template <class NamedParameters, class... UsedTags>
constexpr void check_named_parameters()
{
  check_named_parameters<UsedTags...>(static_cast<const typename NamedParameters::base*>(nullptr));
}

} // namespace internal

/// Functions of CGAL and CSCD that begin a chain of named parameters, and functions that read one.
namespace parameters {

using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;
using CGAL::parameters::is_default_parameter;

/// The chain of no parameter.
using Default_named_parameters = Named_parameters<bool, CGAL::internal_np::all_default_t>;

/// returns the chain of no parameter.
inline Default_named_parameters default_values()
{
  return {};
}

#ifdef DOXYGEN_RUNNING
/// begins a chain with one parameter. There is a function of this kind for each parameter, CGAL's included.
template <class K>
Named_parameters<K, parameter_tag> parameter_name(const K& value);
#else
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <class K>                                                                                                   \
  Named_parameters<K, CGAL::internal_np::X> Z(const K& value)                                                          \
  {                                                                                                                    \
    return {value};                                                                                                    \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CSCD_ADD_FUNCTION(NAME)                                                                                        \
  template <class K>                                                                                                   \
  Named_parameters<K, internal_np::NAME##_t> NAME(const K& value)                                                      \
  {                                                                                                                    \
    return {value};                                                                                                    \
  }
CSCD_FOR_EACH_NAMED_PARAMETER(CSCD_ADD_FUNCTION)
#undef CSCD_ADD_FUNCTION
#endif

/// joins chains of named parameters, those begun by `CGAL::parameters` included. The result can be prolonged.
/// A parameter may stand in one of the chains only: this is checked at compile time.
template <class NamedParameters>
auto combine(const NamedParameters& np)
{
  return internal::prepend_named_parameters(static_cast<const typename NamedParameters::base&>(np), default_values());
}

/// joins two chains or more.
template <class NamedParameters, class... MoreNamedParameters>
auto combine(const NamedParameters& np, const MoreNamedParameters&... more)
{
  return internal::prepend_named_parameters(static_cast<const typename NamedParameters::base&>(np), combine(more...));
}

} // namespace parameters

namespace internal {

/// The number of threads, 0 for as many as TBB allows: `number`, or 1 unless `ConcurrencyTag` asks for threads.
template <class ConcurrencyTag>
unsigned threads_of_tag(unsigned number)
{
  constexpr bool is_parallel = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "CSCD: CGAL::Parallel_tag needs oneTBB: link CSCD::parallel");
#endif
  return is_parallel ? number : 1;
}

/// The options that `ConcurrencyTag` and `np` give. Any integer type will do for a number.
template <class ConcurrencyTag, class NamedParameters>
Options to_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Options options;
  const auto choose = [&np](auto& option, auto name) {
    option = std::decay_t<decltype(option)>(choose_parameter(get_parameter(np, name), option));
  };
  choose(options.random_seed, CGAL::internal_np::random_seed);
  choose(options.maximum_number_of_sources, internal_np::maximum_number_of_sources);
  choose(options.detail, internal_np::detail);
  choose(options.node_spacing, internal_np::node_spacing);
  options.border_treatment =
      choose_parameter(get_parameter(np, internal_np::border_treatment), options.border_treatment);
  options.number_of_threads = 0;
  choose(options.number_of_threads, internal_np::number_of_threads);
  options.number_of_threads = threads_of_tag<ConcurrencyTag>(options.number_of_threads);
  return options;
}

/// Calls `function` with the visitor that `np` gives: a copy, or a reference where it was given as one.
template <class NamedParameters, class Function>
auto with_visitor(const NamedParameters& np, const Function& function)
{
  Default_skeletonization_visitor default_visitor;
  using Visitor = typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::visitor_t, NamedParameters,
                                                                     Default_skeletonization_visitor>::reference;
  Visitor visitor = parameters::choose_parameter(parameters::get_parameter_reference(np, CGAL::internal_np::visitor),
                                                 default_visitor);
  check_skeletonization_visitor<std::remove_reference_t<Visitor>>();
  return function(visitor);
}

/// Whether `np` gives policies, the algorithms of the stages.
template <class NamedParameters>
inline constexpr bool has_policies_v =
    !parameters::is_default_parameter<NamedParameters, internal_np::policies_t>::value;

} // namespace internal
} // namespace CSCD

#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility

#endif // CSCD_NAMED_PARAMETERS_H
