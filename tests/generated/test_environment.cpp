// The exact rung does not depend on the translation unit from which it is called. Plain rungs are deterministic. (The control
// word, and operands that are not finite, are those of tests/extremes.)
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/operands.hpp"

#include "meet/core/cascade/cascade.hpp"

#include <cga/cga_runtime.hpp>
#include <cstring>

using namespace meetc::generated_test;

namespace {

const meetc::predicate_info *find(const char *name) {
  const meetc::catalogue &c = cga::catalogue();
  for (int i = 0; i < c.predicate_count; ++i)
    if (std::strcmp(c.predicates[i].name, name) == 0)
      return &c.predicates[i];
  return nullptr;
}
const char *name_of(shape s) {
  static constexpr const char *names[] = {"point", "sphere", "segment", "triangle", "box"};
  return names[static_cast<int>(s)];
}

template <class P> std::vector<pair_of_rows> some(P p, int of_each) {
  std::vector<pair_of_rows> out;
  std::uint64_t seed = 900;
  for (const family &f : families()) {
    random_numbers random(seed++);
    for (int i = 0; i < effort(of_each); ++i)
      out.push_back(f.make(p.a, p.b, random));
  }
  return out;
}

} // namespace

TEST_CASE("environment: the runtime's table answers as the headers do") {
  CHECK(cga::catalogue().predicate_count == 11);
  CHECK(std::string(cga::catalogue().space) == "cga");
  for_each_predicate([](auto p) {
    INFO(p.name);
    const meetc::predicate_info *info = find(p.name);
    REQUIRE(info != nullptr);
    CHECK(std::string(info->a->name) == name_of(p.a));
    CHECK(std::string(info->b->name) == name_of(p.b));
    REQUIRE(info->a->fields == floats_of(p.a));
    REQUIRE(info->b->fields == floats_of(p.b));
    CHECK(std::string(info->mode) == (!padded(p.a) && !padded(p.b) ? "" : p.surface ? "surface" : "solid"));
    // All rows of the cases, in pairs of different index.
    const auto cases = some(p, 200);
    row a, b;
    for (const pair_of_rows &c : cases) {
      a.insert(a.end(), c.a.begin(), c.a.end());
      b.insert(b.end(), c.b.begin(), c.b.end());
    }
    std::vector<meetc::index_pair> pairs;
    random_numbers random(4);
    for (std::uint32_t i = 0; i < cases.size(); ++i) {
      pairs.push_back({i, i});
      pairs.push_back({static_cast<std::uint32_t>(random.bits() % cases.size()), i});
    }
    std::vector<meetc::answer> first(pairs.size()), again(pairs.size());
    for (int r = 0; r < static_cast<int>(meetc::rung::tolerant); ++r) {
      const auto rung = static_cast<meetc::rung>(r);
      const meetc::cascade by(*info, rung);
      REQUIRE(by.count > 0);
      by.decide(a.data(), b.data(), pairs.data(), pairs.size(), first.data());
      by.decide(a.data(), b.data(), pairs.data(), pairs.size(), again.data());
      CHECK(first == again); // plain rungs, too, are deterministic
      bool same = true;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const row &x = cases[pairs[i].a].a, &y = cases[pairs[i].b].b;
        const bool want = rung == meetc::rung::fp32     ? p.template plain<float>(x, y)
                          : rung == meetc::rung::fp64   ? p.template plain<double>(x, y)
                          : rung == meetc::rung::fp64x2 ? p.template plain<meetc::double_double>(x, y)
                                                        : p.hit(x, y);
        same = same && first[i] == (want ? meetc::answer::yes : meetc::answer::no);
      }
      CHECK(same);
    }
    for (const meetc::decide_function certify : info->certify) {
      REQUIRE(certify != nullptr);
      certify(a.data(), b.data(), pairs.data(), pairs.size(), first.data());
      bool right = true;
      std::size_t sure = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (first[i] != meetc::answer::unsure) {
          ++sure;
          right = right && (first[i] == meetc::answer::yes) == p.hit(cases[pairs[i].a].a, cases[pairs[i].b].b);
        }
      CHECK(right);
      CHECK(sure > pairs.size() / 4);
    }
  });
}

// With integers of b bits no value exceeds 2^(degree b + growth). Where that fits the mantissa, plain is exact.
TEST_CASE("environment: plain rungs are right where their arithmetic is exact") {
  for_each_predicate([](auto p) {
    INFO(p.name);
    using P = typename decltype(p)::type;
    const auto bits_for = [](int mantissa) {
      int bits = 30;
      meetc::each_stage<P>(
          [&]<class Stage>(Stage) { bits = std::min(bits, (mantissa - Stage::growth) / Stage::degree); });
      return bits;
    };
    const auto check = [&](int bits, auto plain) {
      REQUIRE(bits >= 1);
      random_numbers random(55);
      bool same = true;
      int hits = 0;
      for (int i = 0; i < effort(20000); ++i) {
        const int most = (1 << random.integer(1, bits)) - 1;
        pair_of_rows c{row(static_cast<std::size_t>(floats_of(p.a))), row(static_cast<std::size_t>(floats_of(p.b)))};
        for (row *r : {&c.a, &c.b})
          for (float &f : *r)
            f = static_cast<float>(random.integer(0, most));
        const bool hit = p.hit(c.a, c.b);
        hits += hit;
        same = same && plain(c.a, c.b) == hit;
      }
      CHECK(same);
      CHECK(hits > 0);
    };
    check(bits_for(53), [&](const row &x, const row &y) { return p.template plain<double>(x, y); });
    check(bits_for(24), [&](const row &x, const row &y) { return p.template plain<float>(x, y); });
  });
}
