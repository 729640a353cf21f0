// Catch2, version 2 or 3, under one name.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx; // which version 2 has among all names
#else
#include <catch2/catch.hpp>
#endif

#include <string>

namespace meetc::test {

// Version 3 gave the old name to a matcher of ranges.
inline auto contains(const std::string &part) {
#if __has_include(<catch2/catch_all.hpp>)
  return Catch::Matchers::ContainsSubstring(part);
#else
  return Catch::Matchers::Contains(part);
#endif
}

} // namespace meetc::test
