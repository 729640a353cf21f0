#include "meet/core/device/answers/answers_for.hpp"

#include "meet/core/device/answers/any_pair.hpp"
#include "meet/core/device/answers/element_numbers.hpp"
#include "meet/core/device/answers/element_pairs.hpp"
#include "meet/core/device/answers/first_met.hpp"
#include "meet/core/device/answers/item_pairs.hpp"

namespace meetc::on_device {
namespace {

std::unique_ptr<query_answer> answer_about_elements(const device_options &options) {
  switch (options.want) {
  case answer_kind::pairs:
    return std::make_unique<element_pairs>(options.leave_there);
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

std::vector<std::unique_ptr<query_answer>> answers_for(const cuda::pair_launchers &by, const device_options &options) {
  std::vector<std::unique_ptr<query_answer>> out;
  const bool owned = !options.owner_a.empty() || !options.owner_b.empty();
  if (options.first_met)
    out.push_back(std::make_unique<first_met>(by, options.owner_b));
  if (owned && options.want != answer_kind::any && options.want != answer_kind::none)
    out.push_back(std::make_unique<item_pairs>(options.want, options.owner_a, options.owner_b));
  else if (auto answer = answer_about_elements(options))
    out.push_back(std::move(answer));
  return out;
}

} // namespace meetc::on_device
