// round_solver Z3 FOLDER: has z3 answer every claim of the proof, whole statements and planted wrong
// decisions. The exit code is 0 if each claim is "unsat" and each wrong decision makes some query "sat"; 77 if there
// is no z3; and otherwise 1, also if a query is not answered.
#include "tests/decisions/round/solver.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <map>

using namespace meetc::decisions_round;

namespace {

constexpr int limit = 10; // seconds for each query

struct asked {
  std::string z3, folder;
  std::map<std::string, std::string> known; // by script, since the two triangle predicates share most scripts
  std::string slowest;
  double longest = 0;

  std::string operator()(const query &q) {
    const std::string body = q.script.substr(q.script.find('\n'));
    if (const auto it = known.find(body); it != known.end())
      return it->second;
    const auto start = std::chrono::steady_clock::now();
    const std::string said = answer(q, z3, folder, limit);
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (took > longest)
      longest = took, slowest = q.name;
    return known[body] = said;
  }
};

std::vector<query> queries_of(const emitted &e, const decision &d) {
  std::vector<query> out = whole_queries(e, d);
  for (const claim &c : claims_of(e, d))
    out.push_back(query_of(c));
  return out;
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: round_solver Z3 FOLDER\n");
    return 2;
  }
  if (!std::filesystem::exists(argv[1])) {
    fmt::print("SKIPPED: z3 was not found (Debian: apt install z3); the certificates were checked without it\n");
    return 77;
  }
  std::filesystem::create_directories(argv[2]);
  asked ask{argv[1], argv[2], {}, "", 0};
  bool well = true;
  const auto expect_unsat = [&](const query &q) {
    if (const std::string said = ask(q); said != "unsat") {
      fmt::print("not proved: {}: {}\n", q.name, said);
      well = false;
    }
  };
  expect_unsat(way_out());
  std::size_t whole = 0;
  for (const emitted &e : emitted_predicates()) {
    const decision d = e.value ? decision{} : stated(e);
    whole += whole_queries(e, d).size();
    for (const query &q : queries_of(e, d))
      expect_unsat(q);
  }
  fmt::print("{}: {} different queries, of which {} are whole statements; the slowest took {:.2f} s: {}\n",
             well ? "all unsat" : "NOT PROVED", ask.known.size(), whole, ask.longest, ask.slowest);
  std::size_t seen = 0;
  const std::vector<mutant> wrong = mutants();
  for (const mutant &m : wrong) {
    std::string first;
    for (const query &q : queries_of(emitted_predicate(m.of), m.wrong))
      if (first.empty() && ask(q) == "sat")
        first = q.name;
    fmt::print("{}: {}: {}\n", m.of, m.what, first.empty() ? "NOT SEEN" : "sat: " + first);
    seen += first.empty() ? 0 : 1;
  }
  fmt::print("{} of {} wrong decisions make a query sat\n", seen, wrong.size());
  return well && seen == wrong.size() ? 0 : 1;
}
