// Many pairs of rows for the functions of a runtime's table.
#ifndef MEETC_TESTS_GENERATED_MANY_ROWS_HPP
#define MEETC_TESTS_GENERATED_MANY_ROWS_HPP

#include "tests/catch.hpp"
#include "tests/generated/judge/operands.hpp"

#include <cstring>
#include <meetc/table/table.hpp>
#include <stdexcept>

namespace meetc::generated_test {

inline const predicate_info &named(const catalogue &all, const char *name) {
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::strcmp(all.predicates[i].name, name) == 0)
      return all.predicates[i];
  throw std::logic_error("no such predicate");
}

// Rows of every family, with pairs of equal and of different indices.
struct many_rows {
  row a, b;
  std::vector<index_pair> pairs;

  many_rows() = default;
  template <class P> many_rows(const P &p, std::uint32_t each) {
    random_numbers random(11);
    std::uint32_t n = 0;
    for (const family &f : families())
      for (std::uint32_t i = 0; i < each; ++i, ++n) {
        const pair_of_rows c = f.make(p.a, p.b, random);
        a.insert(a.end(), c.a.begin(), c.a.end());
        b.insert(b.end(), c.b.begin(), c.b.end());
        pairs.push_back({n, n});
        pairs.push_back({static_cast<std::uint32_t>(random.bits() % (n + 1)), n});
      }
  }
};

inline std::vector<float> stored(const stored_values &v, const row &rows, int fields) {
  std::vector<float> out(rows.size() / static_cast<std::size_t>(fields) * static_cast<std::size_t>(v.floats));
  if (v.floats > 0)
    REQUIRE(v.compute(rows.data(), rows.size() / static_cast<std::size_t>(fields), out.data()));
  return out;
}
inline const float *or_null(const std::vector<float> &v) {
  return v.empty() ? nullptr : v.data();
}

} // namespace meetc::generated_test

#endif
