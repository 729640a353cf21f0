// Lanes, for every instruction set that this processor runs: certified and exact answers are the same on each, plain ones
// too, and lanes find what the function for one pair finds.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/many_rows.hpp"

#include "meet/core/cascade/cascade.hpp"

#include <cga/cga.hpp>
#include <cga/cga_runtime.hpp>
#include <cga/header_only.hpp>

using namespace meetc::generated_test;
using meetc::answer;
using meetc::rung;

namespace {

std::vector<const meetc::catalogue *> catalogues() {
  std::vector<const meetc::catalogue *> out;
  for (int i = 0; i < meetc::instruction_set_count; ++i)
    if (const meetc::catalogue *c = cga::catalogue_for(static_cast<meetc::instruction_set>(i))) {
      CHECK(static_cast<int>(c->compiled_for) == i);
      out.push_back(c);
    }
  return out;
}

template <class Decide>
std::vector<answer> answers(const many_rows &r, const Decide &f, const float *stored_a, const float *stored_b,
                            std::size_t n) {
  std::vector<answer> out(n, answer::unsure);
  f(meetc::row_array{r.a.data(), stored_a}, meetc::row_array{r.b.data(), stored_b}, r.pairs.data(), n, out.data());
  return out;
}

} // namespace

TEST_CASE("lanes: the best instruction set that runs here is chosen") {
  const auto all = catalogues();
  REQUIRE_FALSE(all.empty());
  CHECK(all.front()->compiled_for == meetc::instruction_set::baseline);
  CHECK(&cga::catalogue() == all.back());
}

TEST_CASE("lanes: certified, exact and plain answers are the same on every instruction set") {
  const auto all = catalogues();
  for_each_predicate([&](auto p) {
    const many_rows r(p, static_cast<std::uint32_t>(effort(300)));
    const std::size_t n = r.pairs.size();
    const meetc::predicate_info &first = named(*all.front(), p.name);
    const auto decide = [](const meetc::predicate_info &info, rung by) { return info.decide[static_cast<int>(by)]; };
    const std::vector<answer> truth = answers(r, decide(first, rung::exact), nullptr, nullptr, n);
    const std::vector<answer> plain = answers(r, decide(first, rung::fp32), nullptr, nullptr, n);
    CHECK(std::count(truth.begin(), truth.end(), answer::yes) > 20);
    for (const meetc::catalogue *c : all) {
      INFO(p.name << ", " << name_of(c->compiled_for));
      const meetc::predicate_info &info = named(*c, p.name);
      CHECK(answers(r, decide(info, rung::exact), nullptr, nullptr, n) == truth);
      for (const rung by : {rung::fp64, rung::fp64x2})
        CHECK(answers(r, decide(info, by), nullptr, nullptr, n) == answers(r, decide(first, by), nullptr, nullptr, n));
      const std::vector<float> of_a = stored(info.stored_a, r.a, info.a->fields),
                               of_b = stored(info.stored_b, r.b, info.b->fields),
                               plain_of_a = stored(info.plain_stored_a, r.a, info.a->fields),
                               plain_of_b = stored(info.plain_stored_b, r.b, info.b->fields);
      const std::vector<answer> filtered = answers(r, info.certify[0], nullptr, nullptr, n),
                                in_fp64 = answers(r, info.certify[1], nullptr, nullptr, n);
      const meetc::cascade certified(info, rung::certified);
      bool proved = true;
      for (std::size_t i = 0; i < n; ++i)
        for (const answer x : {filtered[i], in_fp64[i]})
          proved = proved && (x == answer::unsure || x == truth[i]);
      CHECK(proved);
      for (const bool with_a : {false, true})
        for (const bool with_b : {false, true}) {
          const float *a = with_a ? or_null(of_a) : nullptr, *b = with_b ? or_null(of_b) : nullptr;
          CHECK(answers(
                    r, [&](auto... to) { certified.decide(to...); }, a, b, n) == truth);
          CHECK(answers(r, info.certify[0], a, b, n) == filtered);
          CHECK(answers(r, decide(info, rung::fp32), with_a ? or_null(plain_of_a) : nullptr,
                        with_b ? or_null(plain_of_b) : nullptr, n) == plain);
        }
    }
  });
}

TEST_CASE("lanes: a pair's answer depends on no other, and is no more than the function for one pair finds") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    const many_rows r(p, static_cast<std::uint32_t>(effort(300)));
    for (const meetc::catalogue *c : catalogues())
      for (const int rung : {0, 1}) {
        INFO(p.name << ", " << name_of(c->compiled_for) << ", rung " << rung);
        const meetc::decide_function certify = named(*c, p.name).certify[rung];
        const std::vector<answer> all = answers(r, certify, nullptr, nullptr, r.pairs.size());
        bool same = true, no_more = true;
        std::size_t more = 0; // pairs that the function decides, and lanes do not
        for (std::size_t i = 0; i < all.size(); ++i) {
          answer alone = answer::unsure;
          certify(r.a.data(), r.b.data(), &r.pairs[i], 1, &alone);
          same = same && alone == all[i];
          if (rung > 0 || c->compiled_for != meetc::instruction_set::baseline)
            continue;
          const answer one = meetc::certify<P, meetc::in_fp32>(r.a.data() + std::size_t{r.pairs[i].a} * P::inputs_a,
                                                               r.b.data() + std::size_t{r.pairs[i].b} * P::inputs_b);
          no_more = no_more && (all[i] == answer::unsure || all[i] == one);
          more += all[i] == answer::unsure && one != answer::unsure;
        }
        CHECK(same);
        CHECK(no_more);
        CHECK(2 * more <= all.size()); // rare cases, which the function decides in fp32
        // Lists of every length about that of the lanes; memory beyond them is not touched.
        for (std::size_t n = 0; n < 70; ++n) {
          std::vector<answer> some(n + 1, answer::unsure);
          some[n] = static_cast<answer>(77);
          certify(r.a.data(), r.b.data(), r.pairs.data(), n, some.data());
          CHECK(std::equal(some.begin(), some.end() - 1, all.begin()));
          CHECK(static_cast<int>(some[n]) == 77);
        }
      }
  });
}
