// fuzz_specs SEED COUNT [SECONDS] [FOLDER]: compiles COUNT mutants of the shipped specs, each within SECONDS (20) and 2 GB. A
// mutant that crashes, hangs, grows, or is refused without a place is copied to FOLDER (fuzz_specs.found). One line of result;
// exit code 1: something was found.
#include "tests/gen/fuzz/specs/campaign.hpp"

#include <cstdlib>
#include <fmt/format.h>

int main(int argc, char **argv) {
  std::vector<double> numbers;
  for (int i = 1; i < argc && i < 4; ++i) {
    char *end = argv[i];
    numbers.push_back(std::strtod(argv[i], &end));
    if (end == argv[i] || *end != 0 || !(numbers.back() >= 0))
      numbers.assign(9, 0);
  }
  if (argc > 5 || numbers.size() < 2 || numbers.size() > 3) {
    fmt::print(stderr, "usage: fuzz_specs SEED COUNT [SECONDS] [FOLDER]\n");
    return 2;
  }
  meetc::fuzz::spec_plan p;
  p.algebra_spec = MEETC_FUZZ_ALGEBRAS;
  p.seed = static_cast<std::uint64_t>(numbers[0]);
  p.count = static_cast<std::uint64_t>(numbers[1]);
  if (numbers.size() > 2)
    p.seconds = numbers[2];
  p.findings = argc > 4 ? argv[4] : "fuzz_specs.found";
  const meetc::fuzz::spec_tally t = meetc::fuzz::run_specs(p);
  for (const std::string &f : t.findings)
    fmt::print(stderr, "{}\n", f);
  fmt::print("fuzz_specs: seed {}, {} specs: {} compiled, {} refused, {} findings\n", p.seed, p.count, t.compiled,
             t.refused, t.findings.size());
  return t.findings.empty() ? 0 : 1;
}
