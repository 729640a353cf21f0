// The lanes' limits, which only their headers know.
#include <meetc/simd/lanes.hpp>

#include "tests/extremes/families/families.hpp"

#include <meetc/simd/wide_decide.hpp>

#include <map>

namespace meetc::extremes_test {

std::span<const double> exact_limits(shape a, shape b) {
  static const auto all = [] {
    std::map<std::pair<shape, shape>, std::vector<double>> out;
    generated_test::for_each_predicate([&out](auto p) {
      out[{p.a, p.b}].push_back(meetc::exact_steps<typename decltype(p)::type>());
    });
    for (auto &[shapes, limits] : out) { // where no limit is known, that of other predicates is as good as any
      std::erase_if(limits, [](double limit) { return limit < 8; });
      if (limits.empty())
        limits = {114'501, 0x1p24};
    }
    return out;
  }();
  static const std::vector<double> of_signs = {0x1p17, 0x1p24}; // whose differences no lanes take
  const auto known = all.find({a, b});
  return known == all.end() ? of_signs : known->second;
}

} // namespace meetc::extremes_test
