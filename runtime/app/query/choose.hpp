// app/query/choose.hpp: chooses the predicate for two kinds of element.
#ifndef MEETC_APP_QUERY_CHOOSE_HPP
#define MEETC_APP_QUERY_CHOOSE_HPP

#include "meet/core/query/fitting.hpp"
#include "meet/core/query/self_pairs.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace meetc::app {

// The value of --mode, by default "solid". Throws failure for another word.
std::string mode_named(const std::optional<std::string> &mode);

// The predicate of that name; without a name the first that fits and answers for `mode`, by default "solid". Throws
// failure that lists those that fit.
choice choose(const catalogue &all, const kind_info &a, const kind_info &b, const std::optional<std::string> &name,
              const std::optional<std::string> &mode);

// Those that find where a mesh of triangles crosses itself.
self_predicates of_one_mesh(const catalogue &all, const catalogue &neighbours);

// The name of a rung, such as "exact".
const char *name_of(rung precision);

// Throws failure if this build does not have the precision.
rung precision_named(std::string_view name);

// The same kernels, compiled for several instruction sets. best(): for the best one that this processor runs. of(): for
// the given one; null if this build lacks it or this processor does not run it.
struct kernel_library {
  const catalogue &(*best)();
  const catalogue *(*of)(instruction_set);
};

// The kernels for the value of --instruction-set, "auto" or a set's name. Throws failure with the sets that run here.
const catalogue &kernels_named(const kernel_library &all, std::string_view name);

} // namespace meetc::app

#endif
