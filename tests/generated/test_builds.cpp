// The exact rung's answers do not depend on compiler, optimisation, contraction or instruction set.
#include "tests/generated/catch.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

namespace {

std::string output_of(const std::string &program) {
  const auto close = [](FILE *f) { return pclose(f); };
  const std::unique_ptr<FILE, decltype(close)> pipe(popen(("'" + program + "'").c_str(), "r"), close);
  std::string out;
  std::array<char, 256> part{};
  while (pipe && std::fgets(part.data(), static_cast<int>(part.size()), pipe.get()))
    out += part.data();
  return out;
}

} // namespace

TEST_CASE("builds: one hash a predicate from every build of the case runner") {
  std::istringstream list(MEETC_RUNNERS);
  std::string first;
  int builds = 0;
  for (std::string program; std::getline(list, program, ':'); ++builds) {
    INFO(program);
    const std::string out = output_of(program);
    if (first.empty())
      first = out;
    CHECK(out == first);
  }
  CHECK(builds >= 5);
  // Ten predicates, each with hits and misses.
  std::istringstream lines(first);
  int predicates = 0;
  for (std::string line; std::getline(lines, line); ++predicates) {
    std::istringstream words(line);
    std::string name, hash, of;
    int hits = 0, cases = 0;
    words >> name >> hash >> hits >> of >> cases;
    INFO(line);
    CHECK(hits > cases / 50);
    CHECK(hits < cases - cases / 50);
  }
  CHECK(predicates == 10);
}
