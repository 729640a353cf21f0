// The long mode: extremes [--judge signs|geometry|sets] [--family NAME] [--cases N] [--seed N] [--threads T]. `sets` asks
// the library about whole sets (sets.hpp). Exits with 1 if anything was wrong.
#include "tests/extremes/campaign.hpp"
#include "tests/extremes/judges/sets.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fmt/core.h>

using namespace meetc::extremes_test;

namespace {

constexpr const char *usage =
    "usage: extremes [--judge signs|geometry|sets] [--family NAME] [--cases N] [--seed N] [--threads T]\n";

bool number(const char *text, std::uint64_t &out) {
  const char *end = text + std::strlen(text);
  const auto [last, error] = std::from_chars(text, end, out);
  return error == std::errc() && last == end;
}

int through_library(const set_plan &what) {
  const auto say = [](const set_counts &n) {
    return fmt::format("{} pairs of elements in {} queries, {} touch; {} queries wrong\n", n.cases, n.queries, n.hits,
                       n.wrong);
  };
  const set_counts n = run_sets(what, [&](const set_counts &s) { fmt::print(stderr, "{}", say(s)); });
  fmt::print("{}{}{}", say(n), n.first_wrong, n.first_wrong.empty() ? "" : "\n");
  return n.wrong ? 1 : 0;
}

} // namespace

int main(int argc, char **argv) {
  std::uint64_t cases = 1'000'000, seed = 1, threads = 1;
  judge by = judge::signs;
  bool sets = false;
  std::string_view only; // this family; empty: all
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i], given = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--judge" && (given == "signs" || given == "geometry" || given == "sets")) {
      sets = given == "sets";
      by = given == "geometry" ? judge::geometry : judge::signs;
      continue;
    }
    if (name == "--family" &&
        std::any_of(families().begin(), families().end(), [&](const family &f) { return f.name == given; })) {
      only = given;
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
  if (sets)
    return through_library({cases, seed, static_cast<unsigned>(threads), only});
  std::vector<cell> cells = all_cells();
  std::erase_if(cells, [&](const cell &c) { return !only.empty() && c.from->name != only; });
  run(cells, {cases, seed, static_cast<unsigned>(threads), by}, [&](std::uint64_t done, std::uint64_t wrong) {
    fmt::print(stderr, "{} of {} cases, {} wrong\n", done, cases, wrong);
  });
  fmt::print("{}", table(cells, by));
  return wrong_in(cells) ? 1 : 0;
}
