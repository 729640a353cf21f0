#include "entries.hpp"
#include "formula_calls.hpp"
#include "live_calls.hpp"
#include "sets.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/normalised.hpp"
#include "meet/core/sets/topology.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace words_test {
namespace {

using namespace meetc;

constexpr float inf = std::numeric_limits<float>::infinity();

constexpr rung some_rungs[] = {rung::fp32, rung::exact, rung::certified};
constexpr answer_kind all_answers[] = {answer_kind::pairs, answer_kind::count, answer_kind::counts, answer_kind::flags,
                                       answer_kind::any};
const std::vector<index_pair> some_pairs = {{0, 1}, {2, 0}, {2, 2}};

// ---- queries ----

void call_collide(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const rung precision : some_rungs)
      for (const answer_kind want : all_answers)
        for (const float box : {0.0F, 0x1p127F}) {
          collide_options o;
          o.want = want, o.threads = 2, o.box = box;
          o.first_met = p.by.first_met && want == answer_kind::pairs;
          result r;
          under([&] { r = collide(p.set_a, p.set_b, p.by, precision, o); });
          if (want != answer_kind::any) // whose counts of candidates depend on threads
            add(under, r);
          else
            under.add(r.count);
        }
  collide_options wrong;
  wrong.box = -1;
  under([&] { collide(one_pair().set_a, one_pair().set_b, touching(), rung::certified, wrong); });
}
void call_pairs(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const rung precision : some_rungs)
      for (const pose &at : {pose(), some_pose()}) {
        const view a = view_of(p.a, *p.by.a), b = view_of(p.b, *p.by.b);
        std::vector<std::byte> work(workspace(p.by, a.elements, b.elements, 2));
        std::vector<index_pair> out(a.elements * b.elements);
        std::vector<std::uint64_t> counts(a.elements);
        std::uint64_t count = 0;
        status s = status::ok;
        pairs_options o;
        o.threads = 2;
        o.progress = [](void *, double) noexcept {};
        const pairs_out to{out.data(), out.size(), &count, nullptr, nullptr, nullptr, counts.data()};
        under([&] { s = pairs(p.by, precision, a, pose(), b, at, to, {work.data(), work.size()}, o); });
        under.add(s), under.add(count), under.add_all(out.data(), count), under.add_all(counts);
      }
}
void call_workspace(caller &under) {
  std::size_t bytes = 0;
  under([&] { bytes = workspace(touching(), 100, 200, 2); });
  under.add(bytes);
}
void call_require_first_met(caller &under) {
  under([] { require_first_met(touching(), answer_kind::pairs, true, {}); });
}
void call_answer_from_list(caller &under) {
  for (const answer_kind want : all_answers) {
    result r;
    r.pairs = some_pairs;
    under([&] { answer_from_list(want, 3, 3, r); });
    add(under, r);
  }
}
void call_counts_of(caller &under) {
  per_element<std::uint64_t> out;
  under([&] { out = counts_of(some_pairs, 3, 3); });
  under.add_all(out.a), under.add_all(out.b);
}
void call_flags_of(caller &under) {
  per_element<std::uint8_t> out;
  under([&] { out = flags_of(some_pairs, 3, 3); });
  under.add_all(out.a), under.add_all(out.b);
}
void call_name_items(caller &under) {
  std::vector<std::uint32_t> elements = {0, no_element, 2};
  const std::vector<std::uint32_t> owners = {5, 5, 9};
  under([&] { name_items(owners, elements); });
  under.add_all(elements);
}
void call_items(caller &under) {
  const std::vector<std::uint32_t> owners = {5, 5, 9};
  std::size_t n = 0;
  under([&] { n = items(owners, 3); });
  under.add(n);
}
void call_find_predicate(caller &under) {
  const predicate_info *found = nullptr;
  under([&] { found = &find_predicate(cga::catalogue(), "ball_ball"); });
  under.answer += found->name;
  under([&] { find_predicate(cga::catalogue(), "nothing"); });
}

// ---- sets ----

void call_prepare(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const pose &at : {pose(), some_pose(), some_pose(0x1p-149)})
      for (const prepared *counterpart : {static_cast<const prepared *>(nullptr), &p.set_b}) {
        std::optional<prepared> made;
        under([&] { made.emplace(prepare(view_of(p.a, *p.by.a), *p.by.a, at, 2, counterpart)); });
        if (made)
          add(under, *made);
      }
  rows bad = one_pair().a;
  bad[20] = inf;
  under([&] { prepare(view_of(bad, *touching().a), *touching().a); });
}
void call_members_of_prepared(caller &under) {
  const prepared &p = one_pair().set_a;
  float lo[3], hi[3];
  std::size_t elements = 0;
  bool fits = false, whole = false;
  const kind_info *kind = nullptr;
  const element_set *set = nullptr;
  stored_rows *stored = nullptr;
  under([&] {
    p.bounds(lo, hi);
    elements = p.elements(), fits = p.fits(one_pair().set_b), whole = p.whole();
    kind = &p.kind(), set = &p.set(), stored = p.stored(touching().stored_a, *touching().a);
  });
  under.add_all(lo, 3), under.add_all(hi, 3), under.add(elements), under.add(fits), under.add(whole);
  under.add(kind), under.add(set), under.add(stored);
}
void call_topology(caller &under) {
  const prepared p = prepare(view_of(one_pair().a, *touching().a), *touching().a);
  const set_topology *found = nullptr;
  under([&] { found = &p.topology(); });
  for (const set_topology::corner &c : found->parts)
    under.add(c.slot), under.add(c.point);
  under.add(found->open.value_or(0));
}
void call_prepared(caller &under) { // made from another
  prepared p = prepare(view_of(one_pair().a, *touching().a), *touching().a);
  std::optional<prepared> moved;
  under([&] { moved.emplace(std::move(p)); });
  add(under, *moved);
}
void call_normalised(caller &under) {
  for (const int power : {96, 16, -16, -96}) {
    std::shared_ptr<const normalised_set> set;
    const prepared fresh = prepare(view_of(one_pair().a, *touching().a), *touching().a);
    under([&] { set = fresh.normalised(power); });
    under.add(set != nullptr);
    if (set)
      under.add_all(set->set.rows, set->set.elements * 9);
  }
}
void call_input_error(caller &under) {
  fault f;
  f.kind = fault_kind::value, f.value = 0x1p-149F;
  std::string said;
  under([&] { said = input_error(f, *touching().a, "before: ").what(); });
  under.answer += said;
}
void call_check(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const pose &at : {pose(), some_pose(), some_pose(0x1p127)})
      for (const float bad : {0.0F, inf, -0x1p-149F}) {
        rows r = p.a;
        r[r.size() / 2 | 3] = bad;
        fault f;
        under([&] { f = check(view_of(r, *p.by.a), *p.by.a, at); });
        under.add(f.kind), under.add(f.element), under.add(f.field), under.add(f.value), under.add(f.grid);
      }
}
void call_describe(caller &under) {
  for (const fault_kind kind : {fault_kind::value, fault_kind::moved, fault_kind::rounded})
    for (const float value : {1e-40F, 0.1F, 3.4e38F, 16777217.7F}) {
      fault f;
      f.kind = kind, f.value = value, f.grid = 0x1p-140;
      std::string said;
      under([&] { said = describe(f, *touching().a); });
      under.answer += said;
    }
}

// ---- poses ----

// For each of these numbers.
constexpr double some_numbers[] = {0,       0x1p-1074, -0x1p-1074, 1e-310,  0x1p-149, 0x1.8p-149, 1e-40,
                                   0x1p-20, 0.1,       1 / 3.0,    0x1p127, 1e300,    HUGE_VAL,   -1};
template <class F> void for_some_numbers(caller &under, const F &f) {
  for (const double x : some_numbers) {
    decltype(f(x)) out{};
    under([&] { out = f(x); });
    under.add(out);
  }
}
void call_identity(caller &under) {
  for_some_numbers(under, [](const double &x) {
    pose at;
    at.m[7] = x;
    return at.identity();
  });
}
void call_is_grid(caller &under) {
  for_some_numbers(under, [](const double &x) { return is_grid(x); });
}
void call_moved_by_grid(caller &under) {
  for_some_numbers(under, [](const double &x) { return moved_by_grid(touching(), x); });
}
void call_grid_within(caller &under) {
  for_some_numbers(under, [](const double &x) { return grid_within(touching(), x); });
}
void call_can_move(caller &under) {
  bool can = false;
  under([&] { can = can_move(*touching().a); });
  under.add(can);
}
void call_lies_along_axes(caller &under) {
  bool lies = false;
  under([&] { lies = lies_along_axes(*touching().a); });
  under.add(lies);
}
void call_keeps_axes(caller &under) {
  for_some_numbers(under, [](const double &x) {
    const double off[12] = {1, 0, x, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    return keeps_axes(off);
  });
  for_some_numbers(under, [](const double &x) {
    const double on[12] = {x, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    return keeps_axes(on);
  });
}
void call_proved_apart(caller &under) {
  static constexpr float lo[3] = {0x1p-149F, -1, 0}, hi[3] = {1, 1, 1};
  for (const float at : {0.0F, 0x1p-149F, -0x1p-130F, -1e-3F, -0x1.8p-20F}) {
    const float from[3] = {-2, -2, -2}, to[3] = {at, 2, 2};
    for_some_numbers(under, [&](const double &x) {
      pose p = some_pose();
      p.m[3] = x;
      return proved_apart(p, lo, hi, x, from, to);
    });
  }
}
void call_ends_in(caller &under) {
  static constexpr float lo[3] = {0x1p-149F, -1, 0}, hi[3] = {1, 1, 1};
  for_some_numbers(under, [&](const double &x) {
    double ends[6] = {};
    pose p = some_pose();
    p.m[3] = x;
    const bool found = ends_in(p, lo, hi, x, ends, ends + 3);
    return found ? ends[0] : -1.0;
  });
}
void call_posed(caller &under) {
  const box far{{-2, -2, -2}, {2, 2, 0x1p-149F}};
  for (const pair_of_sets &p : every_pair_of_sets()) {
    std::optional<prepared> out;
    under([&] { out = posed(p.set_a, some_pose(), {&far, 1}); });
    if (out)
      add(under, *out);
  }
}
void call_movable(caller &under) {
  for_some_numbers(under, [](const double &x) {
    pose p;
    p.grid = x;
    return movable(*touching().a, p);
  });
}
void call_move_rows(caller &under) {
  for (const pair_of_sets &p : every_pair_of_sets())
    for (const double grid : {0.0, 0x1p-149, 0x1p-10}) {
      rows r = p.a;
      const pose at = some_pose(grid);
      under([&] { move_rows(*p.by.a, at, r.data(), r.size() / static_cast<std::size_t>(p.by.a->fields)); });
      under.add_all(r);
    }
}

// ---- memory and texts ----

void call_allocate(caller &under) {
  for (const std::size_t bytes : {std::size_t{100}, std::size_t{5} << 20}) {
    owned_memory m;
    under([&] { m = allocate(bytes); });
    under.add(m != nullptr);
  }
}
void call_wish_for_large_pages(caller &under) {
  const owned_memory m = allocate(std::size_t{5} << 20);
  under([&] { wish_for_large_pages(m.get(), std::size_t{5} << 20); });
}
void call_bump_allocator(caller &under) {
  alignas(64) static std::byte bytes[1024];
  std::size_t used = 0, at = 0;
  under([&] {
    bump_allocator from({bytes, sizeof bytes});
    from.take<float>(3);
    at = static_cast<std::size_t>(reinterpret_cast<std::byte *>(from.take<double>(5)) - bytes);
    used = from.bytes();
  });
  under.add(used), under.add(at);
}
void call_text(caller &under) {
  const char *said = nullptr;
  under([&] { said = text(status::bad_value); });
  under.answer += said;
}

constexpr entry all[] = {
    {"ask", call_ask},
    {"chosen", call_ask},
    {"find_kind", call_ask},
    {"collide", call_collide},
    {"collide_in_chunks", call_collide_in_chunks},
    {"pairs", call_pairs},
    {"workspace", call_workspace},
    {"require_first_met", call_require_first_met},
    {"answer_from_list", call_answer_from_list},
    {"counts_of", call_counts_of},
    {"flags_of", call_flags_of},
    {"name_items", call_name_items},
    {"items", call_items},
    {"find_predicate", call_find_predicate},
    {"evaluate", call_evaluate},
    {"columns_of", call_columns_of},
    {"common_objects", call_common_objects},
    {"require_rows", call_require_rows},
    {"formula_named", call_formula_named},
    {"find_formula", call_find_formula},
    {"formula_values::column", call_column},
    {"prepare", call_prepare},
    {"prepared::bounds", call_members_of_prepared},
    {"prepared::elements", call_members_of_prepared},
    {"prepared::fits", call_members_of_prepared},
    {"prepared::kind", call_members_of_prepared},
    {"prepared::set", call_members_of_prepared},
    {"prepared::stored", call_members_of_prepared},
    {"prepared::whole", call_members_of_prepared},
    {"prepared::prepared", call_prepared},
    {"prepared::topology", call_topology},
    {"refuse", call_refuse},
    {"cancelled::cancelled", call_cancelled},
    {"execution::execution", call_execution},
    {"execution::go_on", call_execution},
    {"execution_on", call_execution},
    {"go_on", call_execution},
    {"thread_count", call_execution},
    {"moving_set::moving_set", call_moving_set},
    {"moving_set::update", call_moving_set},
    {"moving_set::reorder", call_moving_set},
    {"moving_set::now", call_moving_set},
    {"moving_set::looseness", call_moving_set},
    {"prepared::normalised", call_normalised},
    {"input_error::input_error", call_input_error},
    {"check", call_check},
    {"describe", call_describe},
    {"pose::identity", call_identity},
    {"is_grid", call_is_grid},
    {"moved_by_grid", call_moved_by_grid},
    {"grid_within", call_grid_within},
    {"can_move", call_can_move},
    {"lies_along_axes", call_lies_along_axes},
    {"keeps_axes", call_keeps_axes},
    {"proved_apart", call_proved_apart},
    {"ends_in", call_ends_in},
    {"posed", call_posed},
    {"movable", call_movable},
    {"move_rows", call_move_rows},
    {"allocate", call_allocate},
    {"wish_for_large_pages", call_wish_for_large_pages},
    {"bump_allocator::bump_allocator", call_bump_allocator},
    {"bump_allocator::bytes", call_bump_allocator},
    {"bump_allocator::take", call_bump_allocator},
    {"text", call_text},
};

} // namespace

std::span<const entry> core_entries() {
  return all;
}

} // namespace words_test
