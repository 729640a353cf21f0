// core/answers/answers_for.hpp: the answers of a query, by what is asked for.
#ifndef MEETC_CORE_ANSWERS_ANSWERS_FOR_HPP
#define MEETC_CORE_ANSWERS_ANSWERS_FOR_HPP

#include "meet/core/answers/query_answer.hpp"

#include <memory>
#include <span>
#include <vector>

namespace meetc {

// None for a count of elements, which each query makes. Owners and first_met are as in collide_options.
std::vector<std::unique_ptr<query_answer>> answers_for(const predicate_info &predicate, answer_kind want,
                                                       bool first_met, std::span<const std::uint32_t> owner_a,
                                                       std::span<const std::uint32_t> owner_b);

} // namespace meetc

#endif
