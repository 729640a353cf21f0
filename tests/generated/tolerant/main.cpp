// The long mode: tolerant_campaign [--cases N] [--seed N], for each predicate of the scenes. Exits with 1 if an answer was
// wrong by more than its rung promises.
#include "tests/generated/tolerant/campaign.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <string_view>

using namespace meetc;
using namespace meetc::tolerant_test;

int main(int argc, char **argv) {
  std::uint64_t cases = 1'000'000, seed = 1;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    std::uint64_t *const value = name == "--cases" ? &cases : name == "--seed" ? &seed : nullptr;
    const char *const end = i + 1 < argc ? argv[i + 1] + std::strlen(argv[i + 1]) : nullptr;
    if (!value || !end || std::from_chars(argv[i + 1], end, *value).ptr != end) {
      std::fputs("usage: tolerant_campaign [--cases N] [--seed N]\n", stderr);
      return 2;
    }
  }
  bool broken = false;
  fmt::print("{:<9} {:<18} {:<9} {:>10} {:>10} {:>10} {:>12} {:>12}\n", "scene", "predicate", "pairs are", "pairs",
             "hits", "differing", "farthest", "promised");
  for (const subject &s : subjects())
    for (const family f : families) {
      tally all;
      constexpr std::uint64_t batch = 100'000;
      for (std::uint64_t done = 0; done < cases / std::size(families); done += batch) {
        const tally t = compare(*s.tolerant, *s.exact,
                                make(*s.exact, f, std::min(batch, cases / std::size(families) - done), seed + done,
                                     s.tolerant->tolerance.reach));
        all.pairs += t.pairs, all.hits += t.hits, all.differing += t.differing;
        all.farthest = std::max(all.farthest, t.farthest);
      }
      broken |= all.farthest > s.tolerant->tolerance.moves;
      fmt::print("{:<9} {:<18} {:<9} {:>10} {:>10} {:>10} {:>12.4g} {:>12.4g}\n", s.scene, s.tolerant->name, name_of(f),
                 all.pairs, all.hits, all.differing, all.farthest, s.tolerant->tolerance.moves);
    }
  return broken ? 1 : 0;
}
