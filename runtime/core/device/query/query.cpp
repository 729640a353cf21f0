#include "meet/core/device/query/query.hpp"

#include "meet/core/cascade/cascade.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/query/parts.hpp"
#include "meet/core/device/walk/first_walk.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/views/usage_error.hpp"

#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>

namespace meetc {
namespace {

void require(bool holds, const char *what) {
  if (!holds)
    throw usage_error(what);
}

// The rung that decides where tolerant is asked for: certified, if a set leaves the box that tolerant presumes.
rung tolerant_or_certified(const device_rows &a, const device_rows &b, const predicate_info &p, rung_report &report) {
  const tolerance_info &t = p.tolerance;
  require(t.fits(a.grid()) && t.fits(b.grid()), text(status::not_on_grid));
  const auto leaves = [&t](const device_rows &s) {
    const auto [reach, longest] = s.reaches();
    return !t.holds(reach, longest);
  };
  report.left_box_a = leaves(a), report.left_box_b = leaves(b);
  if (!report.left_box_a && !report.left_box_b)
    return rung::tolerant;
  require(cascade(p, rung::certified).count > 0, text(status::left_box));
  return rung::certified;
}

} // namespace

const cuda::predicate_launchers &launchers_of(const cuda::catalogue &all, const predicate_info &p) {
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::strcmp(all.predicates[i].name, p.name) == 0)
      return all.predicates[i];
  throw device_error(std::string("no CUDA kernels were generated for ") + p.name);
}

void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options) {
  const auto same = [](const kind_info &x, const kind_info &y) {
    return x.fields == y.fields && std::strcmp(x.name, y.name) == 0;
  };
  require(same(a.kind(), *predicate.a) && same(b.kind(), *predicate.b), "the predicate is for other kinds of element");
  require(a.on() == on && b.on() == on, "a set is on another device");
  require(cascade(predicate, precision).count > 0, text(status::no_such_rung));
  require_first_met(predicate, options.want, options.first_met, options.owner_a);
  require(!options.first_met || launchers_of(on.kernels(), predicate).pairs.first_met,
          "no CUDA kernel was generated for the order of hits");
  const auto fit = [](std::span<const std::uint32_t> owners, const device_set &of) {
    return owners.empty() || owners.size() == of.elements();
  };
  require(fit(options.owner_a, a) && fit(options.owner_b, b), "an owner map needs one item for each element");
  require(options.list_capacity >= least_capacity, "a list holds at least 2^11 pairs");
}

device_result query(const device &on, device_rows &a, device_rows &b, const predicate_info &predicate, rung precision,
                    const device_options &options, device_answers answers, bool clock_runs) {
  const auto start = std::chrono::steady_clock::now();
  device_result r;
  if (precision == rung::tolerant)
    precision = tolerant_or_certified(a, b, predicate, r.rungs);
  const cuda::predicate_launchers &by = launchers_of(on.kernels(), predicate);
  const device_buffers &buffers = on.buffers();
  if (!clock_runs)
    buffers.start_clock();
  for (const auto &answer : answers)
    answer->start({on, a, b});
  // Half of the pairs of a set with itself are looked at where the other half has the same answers.
  const bool half = &a == &b && predicate.symmetric && never_wrong(precision) && !options.first_met;
  if (a.elements() > 0 && b.elements() > 0)
    decide_all({on, a, b, by, precision, half, answers, options.list_capacity, options.progress, options.stop,
                clock_runs, nullptr,
                options.want == answer_kind::none && options.first_alone.value_or(first_alone_pays(a))},
               r);
  else
    buffers.mark_clock();
  if (options.want == answer_kind::none)
    r.count = 0;
  for (const auto &answer : answers)
    answer->finish();
  for (const auto &answer : answers)
    answer->download(r);
  r.device_seconds = buffers.clocked();
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace meetc
