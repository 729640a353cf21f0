// The long mode: extremes [--judge signs|geometry] [--cases N] [--seed N] [--threads T]. Exits with 1 if anything was
// wrong.
#include "tests/extremes/campaign.hpp"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <fmt/core.h>

using namespace meetc::extremes_test;

namespace {

constexpr const char *usage = "usage: extremes [--judge signs|geometry] [--cases N] [--seed N] [--threads T]\n";

bool number(const char *text, std::uint64_t &out) {
  const char *end = text + std::strlen(text);
  const auto [last, error] = std::from_chars(text, end, out);
  return error == std::errc() && last == end;
}

} // namespace

int main(int argc, char **argv) {
  std::uint64_t cases = 1'000'000, seed = 1, threads = 1;
  judge by = judge::signs;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i], given = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--judge" && (given == "signs" || given == "geometry")) {
      by = given == "signs" ? judge::signs : judge::geometry;
      continue;
    }
    std::uint64_t *const value = name == "--cases"     ? &cases
                                 : name == "--seed"    ? &seed
                                 : name == "--threads" ? &threads
                                                       : nullptr;
    if (!value || i + 1 == argc || !number(argv[i + 1], *value) || cases == 0 || threads == 0 || threads > 1024) {
      std::fputs(usage, stderr);
      return 2;
    }
  }
  std::vector<cell> cells = all_cells();
  run(cells, {cases, seed, static_cast<unsigned>(threads), by}, [&](std::uint64_t done, std::uint64_t wrong) {
    fmt::print(stderr, "{} of {} cases, {} wrong\n", done, cases, wrong);
  });
  fmt::print("{}", table(cells, by));
  return wrong_in(cells) ? 1 : 0;
}
