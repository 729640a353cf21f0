#include "meet/bench/harness/method.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/cascade/cascade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace meetc::bench {

difference difference_of(std::vector<index_pair> found, const std::vector<index_pair> &truth) {
  const auto before = [](const index_pair &x, const index_pair &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  std::sort(found.begin(), found.end(), before);
  difference d{found.size()};
  auto f = found.begin();
  for (auto t = truth.begin(); t != truth.end() || f != found.end();) {
    if (t == truth.end() || (f != found.end() && before(*f, *t)))
      ++d.extra, ++f;
    else if (f == found.end() || before(*t, *f))
      ++d.missed, ++t;
    else
      ++f, ++t;
  }
  return d;
}

difference difference_of(std::span<const answer> given, std::span<const answer> truth) {
  difference d;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool yes = given[i] == answer::yes, touch = truth[i] == answer::yes;
    d.found += yes, d.extra += yes && !touch, d.missed += touch && !yes;
  }
  return d;
}

difference difference_of(std::uint64_t found, std::uint64_t truth) {
  return {found, found > truth ? found - truth : 0, truth > found ? truth - found : 0};
}

pair_decider decider_of(const predicate_info &p, rung precision) {
  const cascade by(p, precision);
  if (by.count == 0)
    return {};
  return [by](row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
    by.decide(a, b, pairs, n, out);
  };
}

void require_truth(const std::string &scene, const std::string &method, const difference &found) {
  if (found.wrong() > 0)
    throw app::failure(fmt::format("{}: {} found {} hits, of which {} are false, and missed {}", scene, method,
                                   app::grouped(found.found), app::grouped(found.extra), app::grouped(found.missed)),
                       app::check_failed);
}

measured_methods measure(const std::string &scene, clock &by, const std::vector<method> &all, const turns &how) {
  works steps;
  for (const method &m : all) {
    if (m.promises_truth && !m.answer)
      throw std::logic_error(m.name + " promises the truth and gives no answer");
    steps.insert(steps.end(), m.steps.begin(), m.steps.end());
  }
  const times timed = take_turns(by, steps, how);
  measured_methods out{{}, timed.repetitions};
  auto next = timed.seconds.begin();
  for (const method &m : all) {
    const auto end = next + static_cast<std::ptrdiff_t>(m.steps.size());
    out.of.push_back({{next, end}, m.answer ? m.answer() : difference{}});
    next = end;
    if (m.promises_truth)
      require_truth(scene, m.name, out.of.back().found);
  }
  return out;
}

} // namespace meetc::bench
