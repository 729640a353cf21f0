// Certified answers do not depend on the compiler, optimisation, contraction or instruction set. Rungs with a bound may
// be unsure more or less often, and are never wrong.
#include "tests/catch.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

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

// One line of a runner's output, of which some numbers must be the same in every build.
struct result {
  std::string same;
  int hits = 0, cases = 0, wrong = -1;
  std::array<int, 5> unsure{};
};
std::vector<result> results_in(const std::string &output) {
  std::vector<result> out;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, hash, of;
    result r;
    words >> name >> hash >> r.hits >> of >> r.cases >> of >> r.wrong >> of;
    for (int &n : r.unsure)
      words >> n;
    r.same = words ? line.substr(0, line.find(" wrong")) : "unreadable: " + line;
    out.push_back(r);
  }
  return out;
}

} // namespace

TEST_CASE("builds: one hash a predicate from every build of the case runner, and no rung wrong in any") {
  const char *const runners = std::getenv("MEETC_RUNNERS");
  REQUIRE(runners);
  std::istringstream list(runners);
  std::vector<result> first;
  int builds = 0;
  for (std::string program; std::getline(list, program, ':'); ++builds) {
    INFO(program);
    const std::vector<result> results = results_in(output_of(program));
    if (first.empty())
      first = results;
    REQUIRE(results.size() == 11); // predicates
    for (std::size_t i = 0; i < results.size(); ++i) {
      const result &r = results[i];
      INFO(r.same);
      CHECK(r.same == first[i].same);
      CHECK(r.wrong == 0);
      CHECK(r.hits > r.cases / 50);
      CHECK(r.hits < r.cases - r.cases / 50);
      for (const int unsure : r.unsure) {                      // every rung is challenged, and decides some pairs
        CHECK((unsure > 0 || r.same.starts_with("box_box "))); // whose signs no rounding changes
        CHECK(unsure < r.cases);
      }
    }
  }
  CHECK(builds >= 4);
}
