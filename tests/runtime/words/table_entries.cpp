#include "entries.hpp"
#include "sets.hpp"

#include <algorithm>

namespace words_test {
namespace {

using namespace meetc;

// Calls f(table, predicate, rows of a, rows of b, their numbers) for every predicate on every instruction set of this machine.
template <class F> void for_each_predicate(const F &f) {
  for (int s = 0; s < instruction_set_count; ++s)
    if (const catalogue *const c = cga::catalogue_for(static_cast<instruction_set>(s)))
      for (int i = 0; i < c->predicate_count; ++i) {
        const predicate_info &p = c->predicates[i];
        const rows a = some_rows(*p.a, 3), b = some_rows(*p.b, 4);
        f(p, a, b, a.size() / static_cast<std::size_t>(p.a->fields), b.size() / static_cast<std::size_t>(p.b->fields));
      }
}
// A seventh of all pairs; the last elements, which are those of reports, are in all of theirs.
std::vector<index_pair> pairs_of(std::size_t a, std::size_t b) {
  std::vector<index_pair> out;
  for (std::uint32_t i = 0; i < a; ++i)
    for (std::uint32_t k = 0; k < b; ++k)
      if ((i + k) % 7 == 0 || i + 3 >= a || k + 3 >= b)
        out.push_back({i, k});
  return out;
}
// Calls ask(p, a, b, pairs, answers).
template <class Ask> void call_on_pairs(caller &under, const Ask &ask) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &b, std::size_t na, std::size_t nb) {
    const std::vector<index_pair> pairs = pairs_of(na, nb);
    std::vector<answer> out(pairs.size());
    under([&] { ask(p, row_array(a.data()), row_array(b.data()), pairs, out.data()); });
    under.add_all(out);
  });
}
using pair_list = std::vector<index_pair>;

void call_decide(caller &under) {
  for (int r = 0; r < rung_count; ++r)
    call_on_pairs(under, [r](const predicate_info &p, row_array a, row_array b, const pair_list &pairs, answer *out) {
      if (p.decide[r])
        p.decide[r](a, b, pairs.data(), pairs.size(), out);
    });
}
void call_certify(caller &under) {
  for (int r = 0; r < bounded_rungs; ++r)
    call_on_pairs(under, [r](const predicate_info &p, row_array a, row_array b, const pair_list &pairs, answer *out) {
      p.certify[r](a, b, pairs.data(), pairs.size(), out);
    });
}
void call_certify_in_box(caller &under) {
  call_on_pairs(under, [](const predicate_info &p, row_array a, row_array b, const pair_list &pairs, answer *out) {
    p.certify_in_box(p.box_most, a, b, pairs.data(), pairs.size(), out);
  });
}
void call_decide_last(caller &under) {
  call_on_pairs(under, [](const predicate_info &p, row_array a, row_array b, const pair_list &pairs, answer *out) {
    p.decide_last(a, b, pairs.data(), pairs.size(), out);
  });
}
void call_first_met(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &b, std::size_t na, std::size_t nb) {
    if (!p.first_met)
      return;
    std::vector<int> order(na * nb);
    under([&] {
      for (std::size_t i = 0; i < na; ++i)
        for (std::size_t k = 0; k < nb; ++k)
          order[i * nb + k] = p.first_met(a.data() + 6 * i, b.data() + 9 * k, b.data() + 9 * ((k + i + 1) % nb));
    });
    under.add_all(order);
    // A report: a segment that is subnormal itself, and two triangles that meet its ends.
    static constexpr float segment[] = {0, 0, 0, 0, 0, 0x1p-140F},
                           last[] = {-1, -1, 0x1p-141F, 1, -1, 0x1p-141F, 0, 1, 0x1p-141F},
                           first[] = {0, -1, -1, 0, 1, -1, 0, 0, 1};
    int which = 0;
    under([&] { which = p.first_met(segment, last, first); });
    under.answer += which == 1 ? "right" : "wrong";
  });
}
void call_boxes(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &, std::size_t n, std::size_t) {
    std::vector<float> ends(6 * n);
    under([&] { p.a->boxes(a.data(), n, ends.data()); });
    under.add_all(ends);
  });
}
void call_fault(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &, std::size_t n, std::size_t) {
    if (!p.a->fault)
      return;
    rows turned = a; // radii below 0, corners in the wrong order
    for (float &x : turned)
      x = -x;
    std::vector<int> broken(2 * n);
    under([&] {
      for (std::size_t i = 0; i < n; ++i) {
        broken[i] = p.a->fault(a.data() + i * static_cast<std::size_t>(p.a->fields)) != nullptr;
        broken[n + i] = p.a->fault(turned.data() + i * static_cast<std::size_t>(p.a->fields)) != nullptr;
      }
    });
    under.add_all(broken);
  });
}
void call_compute(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &b, std::size_t na, std::size_t nb) {
    const auto compute = [&](const stored_values &v, const rows &r, std::size_t n) {
      if (!v.compute)
        return;
      std::vector<float> out(n * static_cast<std::size_t>(v.floats));
      bool done = false;
      under([&] { done = v.compute(r.data(), n, out.data()); });
      under.add(done), under.add_all(out);
    };
    compute(p.stored_a, a, na), compute(p.plain_stored_a, a, na);
    compute(p.stored_b, b, nb), compute(p.plain_stored_b, b, nb);
  });
}

// Every formula on rows that are subnormal in part.
template <class Number, class Function> void call_formulas(caller &under, Function formula_info::*which) {
  for (int s = 0; s < instruction_set_count; ++s)
    if (const catalogue *const c = cga::catalogue_for(static_cast<instruction_set>(s)))
      for (int i = 0; i < c->formula_count; ++i) {
        const formula_info &f = c->formulas[i];
        static constexpr float some[] = {0x1p-149F, -1,       0x1p-70F, 0.1F,      0, -0x1.8p-130F,
                                         3,         0x1p-64F, -0.75F,   0x1p-100F, 7};
        std::vector<column> in;
        for (int k = 0; k < f.number_count; ++k)
          in.push_back({some + k % 5, 1}); // six rows, which overlap
        std::vector<Number> out(6 * static_cast<std::size_t>(f.result_count));
        std::vector<Number *> columns;
        for (int k = 0; k < f.result_count; ++k)
          columns.push_back(out.data() + 6 * static_cast<std::size_t>(k));
        under([&] { (f.*which)(in.data(), nullptr, 6, columns.data()); });
        under.add_all(out);
      }
}
void call_contacts(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &b, std::size_t na, std::size_t nb) {
    if (!p.contacts)
      return;
    const std::vector<index_pair> pairs = pairs_of(na, nb);
    std::vector<std::uint64_t> codes(pairs.size());
    under([&] { p.contacts(a.data(), b.data(), pairs.data(), pairs.size(), codes.data()); });
    under.add_all(codes);
  });
}
void call_winding(caller &under) {
  for_each_predicate([&](const predicate_info &p, const rows &a, const rows &b, std::size_t, std::size_t nb) {
    if (!p.winding)
      return;
    for (std::size_t i = 0; i < 20; ++i) {
      int number = 0;
      under([&] { number = p.winding(a.data() + 3 * i, b.data(), nb); });
      under.add(number);
    }
  });
}
void call_formulas_in_singles(caller &under) {
  call_formulas<float>(under, &formula_info::float32);
}
void call_formulas_in_doubles(caller &under) {
  call_formulas<double>(under, &formula_info::float64);
}

constexpr entry all[] = {
    {"predicate_info::decide", call_decide},
    {"predicate_info::certify", call_certify},
    {"predicate_info::certify_in_box", call_certify_in_box},
    {"predicate_info::decide_last", call_decide_last},
    {"predicate_info::first_met", call_first_met},
    {"predicate_info::contacts", call_contacts},
    {"predicate_info::winding", call_winding},
    {"kind_info::boxes", call_boxes},
    {"kind_info::fault", call_fault},
    {"stored_values::compute", call_compute},
    {"formula_info::float32", call_formulas_in_singles},
    {"formula_info::float64", call_formulas_in_doubles},
};

} // namespace

std::span<const entry> table_entries() {
  return all;
}

} // namespace words_test
