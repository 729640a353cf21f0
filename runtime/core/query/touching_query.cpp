#include "meet/core/query/touching_query.hpp"

namespace meetc {
namespace {

bool owners_fit(std::span<const std::uint32_t> owners, const prepared &p) {
  return owners.empty() || owners.size() == p.elements();
}

} // namespace

touching_query::touching_query(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                               const collide_options &options)
    : elements_a_(a.elements()), elements_b_(b.elements()),
      by_(predicate, precision), of_a_{a, nullptr}, of_b_{b, nullptr}, on_(execution_on(options.threads, options.stop)),
      what_(what_rules_out(precision)) {
  require(same_kind(a.kind(), *predicate.a) && same_kind(b.kind(), *predicate.b),
          "the predicate is for other kinds of element");
  require(a.fits(b) && b.fits(a), "a set was prepared for collisions with another one");
  require(owners_fit(options.owner_a, a) && owners_fit(options.owner_b, b),
          "an owner map needs one item for each element");
  require_first_met(predicate, options.want, options.first_met, options.owner_a);
  require(by_.count > 0, text(status::no_such_rung));
  const status s = by_.check(a.set(), b.set());
  require(s == status::ok, text(s));
  require(options.box >= 0, "the scene's box is negative or not a number");
  by_.enter_box(options.box, a.set(), b.set());
  if (never_wrong(precision) && predicate.scales) // a plain rung answers for the numbers as they are, as on a device
    normalise(of_a_, of_b_, options.stop);
  if (of_a_.normal)
    by_.side = 0; // the box is in the caller's units
  half_ = &a == &b && predicate.symmetric && never_wrong(precision) && !options.first_met;
}

void touching_query::start(query_answer &answer, const element_set &a) const {
  answer.start({a, of_b_.set(), elements_a_, elements_b_, on_});
}

tally touching_query::run(const element_set &walked, const element_set &a, const stored_operand &stored_a, bool half,
                          std::span<query_answer *const> takers, const std::function<void(double)> &progress) const {
  const tree_pairs source(walked, of_b_.given.set(), what_, half);
  const auto report = [](void *context, double fraction) {
    (*static_cast<const std::function<void(double)> *>(context))(fraction);
  };
  const std::unique_ptr<std::byte[]> batches(new std::byte[batch_bytes(on_.threads)]);
  return decide_all({a, of_b_.set(), stored_a, of_b_.stored(by_.stored_b, *by_.predicate->b), by_, source, on_,
                     progress ? +report : nullptr, const_cast<std::function<void(double)> *>(&progress), takers, half},
                    {batches.get(), batch_bytes(on_.threads)});
}

} // namespace meetc
