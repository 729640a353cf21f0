#include "meet/core/query/collide.hpp"

#include "meet/core/answers/answers_for.hpp"
#include "meet/core/query/touching_query.hpp"

#include <chrono>

namespace meetc {

void require_first_met(const predicate_info &predicate, answer_kind want, bool asked,
                       std::span<const std::uint32_t> owner_a) {
  require(!asked || predicate.first_met, "the predicate knows no order in which its hits are met");
  require(asked || want != answer_kind::none, "nothing is asked for");
  require(!asked || want != answer_kind::any, "a search for any pair does not find those that are met first");
  require(!asked || owner_a.empty(), "what is met first is asked of elements, not of the items that own them");
}

namespace {

result find_touching(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                     const collide_options &options) {
  const auto start = std::chrono::steady_clock::now();
  const touching_query query(a, b, predicate, precision, options);
  const auto answers = answers_for(predicate, options.want, options.first_met, options.owner_a, options.owner_b);
  std::vector<query_answer *> takers;
  for (const auto &answer : answers) {
    query.start(*answer, query.a());
    takers.push_back(answer.get());
  }
  const tally total = query.run(query.walked_a(), query.a(), query.stored_a(), query.half(), takers, options.progress);
  result r;
  r.candidates = total.candidates;
  r.count = options.want == answer_kind::none ? 0 : total.hits;
  r.rungs = total.rungs;
  for (const auto &answer : answers)
    answer->finish(r);
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace

result collide(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
               const collide_options &options) {
  return under_standard_word([&] { return find_touching(a, b, predicate, precision, options); });
}

} // namespace meetc
