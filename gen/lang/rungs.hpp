// The rungs that a scene may ask for, in the compiler's only table of them.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace meetc::lang {

// Plain rungs take the sign of the value that their arithmetic computes. Exact and certified answers are never wrong.
// certified runs a filter cascade: the bounded arithmetics in this order, and then the exact rung. tolerant may be wrong
// within the scene's tolerance (gen/lower/tolerance.hpp).
enum class rung { fp32, fp64, fp64x2, exact, certified, tolerant };

struct rung_info {
  rung id;
  const char *name;
  bool is_plain;   // the sign of a computed value, whose error is not known
  bool is_bounded; // its arithmetic, with an error bound, is also in the filter cascade of `certified`
};
inline constexpr std::array<rung_info, 6> rungs{{
    {rung::fp32, "fp32", true, true},
    {rung::fp64, "fp64", true, true},
    {rung::fp64x2, "fp64x2", true, true},
    {rung::exact, "exact", false, false},
    {rung::certified, "certified", false, false},
    {rung::tolerant, "tolerant", false, false},
}};

constexpr const rung_info &info_of(rung r) {
  return rungs[static_cast<std::size_t>(r)];
}
constexpr bool is_plain(rung r) {
  return info_of(r).is_plain;
}
// The table is in the order of the values.
static_assert([] {
  for (std::size_t i = 0; i < rungs.size(); ++i)
    if (rungs[i].id != static_cast<rung>(i))
      return false;
  return true;
}());

inline std::vector<std::string> rung_names() {
  std::vector<std::string> out;
  for (const rung_info &r : rungs)
    out.emplace_back(r.name);
  return out;
}

} // namespace meetc::lang
