#include "live_calls.hpp"

#include "sets.hpp"

#include "meet/core/query/ask.hpp"
#include "meet/core/query/chunks.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/moving_set.hpp"
#include "meet/core/threads/execution.hpp"

#include <limits>
#include <optional>

namespace words_test {

using namespace meetc;

void add(caller &to, const result &r) {
  to.add_all(r.pairs), to.add(r.count), to.add_all(r.flags.a), to.add_all(r.flags.b), to.add_all(r.counts.a);
  to.add_all(r.counts.b), to.add_all(r.first_met), to.add(r.candidates), to.add_all(r.rungs.unsure, bounded_rungs);
  to.add(r.rungs.left_box_a), to.add(r.rungs.left_box_b);
}
void add(caller &to, const prepared &p) {
  const element_set &s = p.set();
  to.add(p.elements()), to.add(s.elements), to.add(s.reach), to.add(s.longest), to.add(s.grid), to.add(s.around);
  to.add_all(s.rows, s.elements * static_cast<std::size_t>(s.kind->fields));
  to.add_all(s.order, s.elements);
}

void call_ask(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const rung precision : {rung::fp32, rung::exact, rung::certified}) {
      how asked;
      asked.predicate = p.by.name, asked.precision = precision;
      asked.with.threads = 2;
      result r;
      under([&] { r = ask(cga::catalogue(), p.set_a, p.set_b, asked); });
      add(under, r);
      std::optional<choice> by;
      under([&] { by = chosen(cga::catalogue(), *p.by.a, *p.by.b, asked); });
      under.add(by ? by->predicate : nullptr);
    }
  const kind_info *kind = nullptr;
  under([&] { kind = &find_kind(cga::catalogue(), "triangle"); });
  under.add(kind);
  under([&] { kind = &find_kind(cga::catalogue(), "none"); });
}

void call_collide_in_chunks(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const rung precision : {rung::fp32, rung::exact, rung::certified}) {
      std::vector<index_pair> all;
      result r;
      under([&] {
        r = collide_in_chunks(p.set_a, p.set_b, p.by, precision, 3, [&](std::span<const index_pair> pairs) {
          all.insert(all.end(), pairs.begin(), pairs.end());
        });
      });
      under.add_all(all), add(under, r);
    }
}

void call_moving_set(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const pose &at : {pose(), some_pose(), some_pose(0x1p-149)}) {
      const view v = view_of(p.a, *p.by.a);
      std::optional<moving_set> moving;
      under([&] { moving.emplace(v, *p.by.a, at, 2); });
      if (!moving)
        continue;
      add(under, moving->now());
      under([&] { moving->update(v, at, 2); });
      add(under, moving->now());
      double loose = 0;
      under([&] {
        moving->reorder(v, at, 2);
        loose = moving->looseness();
      });
      add(under, moving->now());
      under.add(loose);
    }
}

void call_cancelled(caller &under) {
  std::string said;
  under([&] { said = cancelled().what(); });
  under.answer += said;
}

void call_execution(caller &under) {
  std::stop_source source;
  int threads = 0;
  bool went_on = false, stopped = false;
  under([&] {
    const execution on = execution_on(3, source.get_token());
    on.go_on();
    threads = on.threads + execution(2).threads + thread_count(max_threads + 1);
    went_on = true;
  });
  source.request_stop();
  under([&] {
    try {
      execution(1, source.get_token()).go_on();
    } catch (const cancelled &) {
      stopped = true;
    }
  });
  under.add(threads), under.add(went_on), under.add(stopped);
}

void call_refuse(caller &under) {
  rows bad = one_pair().a;
  bad[4] = std::numeric_limits<float>::infinity();
  under([&] { refuse(view_of(bad, *touching().a), 7, *touching().a, pose()); });
}

} // namespace words_test
