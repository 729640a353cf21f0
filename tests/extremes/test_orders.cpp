// The same points in another order give the same answer, and a sign as the parity of the order says.
#include "tests/catch.hpp"
#include "tests/extremes/campaign.hpp"
#include "tests/generated/judge/effort.hpp"

#include <algorithm>
#include <numeric>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

std::vector<std::vector<std::size_t>> orders_of(std::size_t n) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::vector<std::size_t>> out;
  do
    out.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return out;
}

int parity(const std::vector<std::size_t> &order) {
  int sign = 1;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j)
      sign = order[i] > order[j] ? -sign : sign;
  return sign;
}

// Reorders the points; what follows them (a radius) stays.
row ordered(const row &r, const std::vector<std::size_t> &order) {
  row out = r;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out[3 * i + k] = r[3 * order[i] + k];
  return out;
}

} // namespace

TEST_CASE("orders: a decision does not depend on the order of corners and operands") {
  for (const subject &s : subjects()) {
    if (s.sign)
      continue;
    int orders = 0;
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      INFO(s.name << " on " << f.name);
      random_numbers random(60);
      bool same = true;
      for (int i = 0; i < effort(20) && same; ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const int want = s.truth(p.a.data(), p.b.data());
        orders = 0;
        const auto check = [&](const row &a, const row &b) {
          const outcome o = check_case(s, {a, b}, random);
          same = same && o.wrong == 0 && o.hit == (want != 0);
          ++orders;
        };
        for (const auto &a : orders_of(corners(s.a)))
          for (const auto &b : orders_of(corners(s.b))) {
            check(ordered(p.a, a), ordered(p.b, b));
            if (s.a == s.b)
              check(ordered(p.b, b), ordered(p.a, a));
          }
      }
      CHECK(same);
    }
    CHECK((std::string(s.name) != "triangle_triangle" || orders == 72));
  }
}

TEST_CASE("orders: an orientation has the parity of its 24 orders") {
  for (const char *name : {"side_triangle_point", "twist_segment_segment"}) {
    const subject &s = subject_named(name);
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      INFO(s.name << " on " << f.name);
      random_numbers random(61);
      bool same = true;
      for (int i = 0; i < effort(100) && same; ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const int want = s.truth(p.a.data(), p.b.data());
        row all = p.a;
        all.insert(all.end(), p.b.begin(), p.b.end());
        for (const auto &order : orders_of(4)) {
          const row r = ordered(all, order);
          const auto cut = r.begin() + static_cast<std::ptrdiff_t>(p.a.size());
          const pair_of_rows q{row(r.begin(), cut), row(cut, r.end())};
          same = same && check_case(s, q, random).wrong == 0 && s.hit(q.a.data(), q.b.data()) == parity(order) * want;
        }
      }
      CHECK(same);
    }
  }
}
