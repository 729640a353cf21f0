#include "meet/core/answers/answers_for.hpp"

#include "meet/core/answers/any_pair.hpp"
#include "meet/core/answers/element_numbers.hpp"
#include "meet/core/answers/element_pairs.hpp"
#include "meet/core/answers/first_met.hpp"
#include "meet/core/answers/item_pairs.hpp"

namespace meetc {
namespace {

std::unique_ptr<query_answer> answer_about_elements(answer_kind want) {
  switch (want) {
  case answer_kind::pairs:
    return std::make_unique<element_pairs>();
  case answer_kind::counts:
    return std::make_unique<element_counts>();
  case answer_kind::flags:
    return std::make_unique<element_flags>();
  case answer_kind::any:
    return std::make_unique<any_pair>();
  case answer_kind::count:
  case answer_kind::none:
    break;
  }
  return nullptr;
}

} // namespace

std::vector<std::unique_ptr<query_answer>> answers_for(const predicate_info &predicate, answer_kind want,
                                                       bool wants_first_met, std::span<const std::uint32_t> owner_a,
                                                       std::span<const std::uint32_t> owner_b) {
  std::vector<std::unique_ptr<query_answer>> out;
  const bool owned = !owner_a.empty() || !owner_b.empty();
  if (owned && want != answer_kind::any && want != answer_kind::none)
    out.push_back(std::make_unique<item_pairs>(want, owner_a, owner_b));
  else if (auto answer = answer_about_elements(want))
    out.push_back(std::move(answer));
  if (wants_first_met)
    out.push_back(std::make_unique<first_met>(predicate.first_met, owner_b));
  return out;
}

} // namespace meetc
