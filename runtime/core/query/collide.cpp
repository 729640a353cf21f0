#include "meet/core/query/collide.hpp"

#include "meet/core/answers/answers_for.hpp"
#include "meet/core/cascade/cascade.hpp"
#include "meet/core/query/decide.hpp"
#include "meet/core/query/operand.hpp"
#include "meet/core/threads/threads.hpp"

#include <chrono>

namespace meetc {
namespace {

void require(bool holds, const char *what) {
  if (!holds)
    throw usage_error(what);
}

bool owners_fit(std::span<const std::uint32_t> owners, const prepared &p) {
  return owners.empty() || owners.size() == p.elements();
}

} // namespace

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
  require(same_kind(a.kind(), *predicate.a) && same_kind(b.kind(), *predicate.b),
          "the predicate is for other kinds of element");
  require(a.fits(b) && b.fits(a), "a set was prepared for collisions with another one");
  require(owners_fit(options.owner_a, a) && owners_fit(options.owner_b, b),
          "an owner map needs one item for each element");
  require_first_met(predicate, options.want, options.first_met, options.owner_a);
  cascade by(predicate, precision);
  require(by.count > 0, text(status::no_such_rung));
  const status s = by.check(a.set(), b.set());
  require(s == status::ok, text(s));
  require(options.box >= 0, "the scene's box is negative or not a number");
  by.enter_box(options.box, a.set(), b.set());
  query_operand of_a{a, nullptr}, of_b{b, nullptr};
  if (never_wrong(precision) && predicate.scales) // a plain rung answers for the numbers as they are, as on a device
    normalise(of_a, of_b);
  if (of_a.normal)
    by.side = 0; // the box is in the caller's units

  const int threads = thread_count(options.threads);
  const bool half = &a == &b && predicate.symmetric && never_wrong(precision) && !options.first_met;
  const tree_pairs source(a.set(), b.set(), what_rules_out(precision), half);
  const auto answers = answers_for(predicate, options.want, options.first_met, options.owner_a, options.owner_b);
  std::vector<query_answer *> takers;
  for (const auto &answer : answers) {
    answer->start({of_a.set(), of_b.set(), a.elements(), b.elements(), threads});
    takers.push_back(answer.get());
  }
  const auto report = [](void *context, double fraction) {
    (*static_cast<const std::function<void(double)> *>(context))(fraction);
  };
  const std::unique_ptr<std::byte[]> batches(new std::byte[batch_bytes(threads)]);
  const tally total =
      decide_all({of_a.set(), of_b.set(), of_a.stored(by.stored_a, *predicate.a),
                  of_b.stored(by.stored_b, *predicate.b), by, source, threads, options.progress ? +report : nullptr,
                  const_cast<std::function<void(double)> *>(&options.progress), takers, half},
                 {batches.get(), batch_bytes(threads)});
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
