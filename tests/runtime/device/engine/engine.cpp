#include "engine.hpp"

#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/normalised.hpp"

#include <cga/cga_every_pair.hpp>

#include "tests/runtime/device/kernels/cuda_test.hpp"

#include <algorithm>
#include <cstring>

namespace cuda_test {

using namespace meetc;

const char *name_of(rung r) {
  static const char *const names[] = {"fp32", "fp64", "fp64x2", "exact", "certified"};
  return names[static_cast<int>(r)];
}
void each_predicate(const std::function<void(const predicate_info &)> &f) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    f(all.predicates[i]);
}

const predicate_info &predicate_named(std::string_view name) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i)
    if (all.predicates[i].name == name)
      return all.predicates[i];
  throw std::runtime_error("no predicate " + std::string(name));
}

// ---- sets ----

view view_of(const rows_of &r) {
  return {r.rows.data(), 0, static_cast<std::size_t>(r.kind->fields) * sizeof(float), nullptr, r.size()};
}

void put_in_order(rows_of &r) {
  if (!lies_along_axes(*r.kind))
    return;
  for (float *row = r.rows.data(), *const end = row + r.rows.size(); row != end; row += r.kind->fields)
    for (int k = 0; k < 3; ++k)
      if (row[3 + k] < row[k])
        std::swap(row[k], row[3 + k]);
}

pose pose_for(const kind_info &kind, const pose &at) {
  if (!lies_along_axes(kind))
    return at;
  pose out = at;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      out.m[4 * i + k] = i == k ? at.length_scale : 0;
  return out;
}

namespace {
double between(engine &random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
} // namespace

rows_of random_rows(const kind_info &kind, std::size_t n, const place &at, engine &random) {
  rows_of out{&kind, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const bool lattice = random() % 2;
    const auto snapped = [&](double x) { return lattice ? std::nearbyint(x * 16) / 16 : x; };
    double centre[3];
    for (double &c : centre)
      c = snapped(between(random, -at.cube, at.cube));
    int axis = 0;
    for (int f = 0; f < kind.fields; ++f) {
      if (kind.roles[f] == role::length) {
        out.rows.push_back(static_cast<float>(snapped(between(random, 0, at.size)) * at.scale));
        continue;
      }
      const double off = kind.fields > 4 ? snapped(between(random, -at.size, at.size)) : 0; // a point is its place
      out.rows.push_back(static_cast<float>((centre[axis] + off) * at.scale + at.offset));
      axis = (axis + 1) % 3;
    }
  }
  put_in_order(out);
  return out;
}

rows_of family_rows(const kind_info &kind, std::size_t n, int family, engine &random) {
  rows_of out{&kind, {}};
  for (std::size_t i = 0; i < n; ++i)
    for (int f = 0; f < kind.fields; ++f) {
      const float v = number(random, family < 0 ? static_cast<int>(i) : family);
      out.rows.push_back(kind.roles[f] == role::length ? std::fabs(v) : v);
    }
  put_in_order(out);
  return out;
}

rows_of rows_in(const prepared &set) {
  const auto fields = static_cast<std::size_t>(set.kind().fields);
  rows_of out{&set.kind(), std::vector<float>(set.elements() * fields)};
  for (std::size_t i = 0; i < set.elements(); ++i)
    std::copy_n(set.set().rows + i * fields, fields, out.rows.data() + set.set().order[i] * fields);
  return out;
}

rows_of same_rows(const kind_info &kind, std::size_t n) {
  static constexpr float row[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}; // of any kind; all of them touch at 0, 0, 0 or at 1, 0, 0
  static constexpr float sphere[] = {0, 0, 0, 1};
  rows_of out{&kind, {}};
  for (std::size_t i = 0; i < n; ++i)
    out.rows.insert(out.rows.end(), kind.fields == 4 ? sphere : row, (kind.fields == 4 ? sphere : row) + kind.fields);
  return out;
}

// ---- comparing ----

namespace {

bool before(index_pair x, index_pair y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

} // namespace

comparison::comparison(device &on) : on_(on), every_pair_(on, cga::every_pair::catalogue()) {
  using every_pair::filter;
  for (const filter f : {filter::float32, filter::mma, filter::wgmma})
    if (every_pair_.offers(f))
      filters_.push_back(f);
}

line &comparison::at(const key &of) {
  const auto [found, fresh] = lines_.try_emplace(of);
  if (fresh)
    order_.push_back(of);
  return found->second;
}

void comparison::fail(const key &of, const std::string &what) {
  ++at(of).differences;
  if (++printed_ <= 60)
    std::printf("DIFFERENT  %s, %s: %s\n", of.first.c_str(), of.second.c_str(), what.c_str());
}

void comparison::require(const std::string &scene, bool holds, const std::string &what) {
  const key of{scene, "-"};
  ++at(of).queries;
  if (!holds)
    fail(of, what);
}

void comparison::add(const std::string &scene, const predicate_info &p, const result &r, std::uint64_t parts,
                     double device_seconds) {
  line &l = at({scene, p.name});
  ++l.queries;
  l.pairs += r.count, l.candidates += r.candidates, l.unsure += r.rungs.unsure[0];
  l.most_parts = std::max(l.most_parts, parts);
  l.device_ms += device_seconds * 1000;
}

const catalogue *fusing() {
  for (const instruction_set set : {instruction_set::avx2, instruction_set::avx512})
    if (const catalogue *c = cga::catalogue_for(set))
      return c;
#if defined(__FMA__) || defined(__aarch64__)
  return &cga::catalogue();
#else
  return nullptr;
#endif
}

bool fewer_candidates_on_cpu(const predicate_info &p) {
  return p.a->hull == 2 || p.b->hull == 2;
}
bool fewer_unsure_on_cpu(const predicate_info &p, const prepared &a, const prepared &b) {
  return !fusing() || fewer_candidates_on_cpu(p) || normalising_power(a.set(), b.set()) != 0;
}

void comparison::same(const std::string &scene, const predicate_info &p, const prepared &a, const prepared &b,
                      std::span<const rung> rungs, const options &o) {
  device_set da(on_, a), db(on_, b);
  same(scene, p, a, da, b, db, rungs, o);
  const rows_of x = rows_in(a), y = rows_in(b);
  device_set ga = device_set::given(on_, view_of(x), *x.kind), gb = device_set::given(on_, view_of(y), *y.kind);
  for (const auto &[set, from] : {std::pair(&ga, &a), std::pair(&gb, &b)}) {
    pose at;
    at.grid = from->set().grid;
    set->move(at);
  }
  same_given(scene, p, a, ga, b, gb, rungs, o);
}

void comparison::same(const std::string &scene, const predicate_info &p, const prepared &a, device_set &da,
                      const prepared &b, device_set &db, std::span<const rung> rungs, const options &o) {
  compare(scene, p, a, b, rungs, o, {{"a query"}},
          [&](const way &, rung r, const device_options &with) { return collide(on_, da, db, p, r, with); });
  compare_every_pair(scene, p, a, da, b, db, rungs, o);
}

void comparison::same_given(const std::string &scene, const predicate_info &p, const prepared &a, device_set &ga,
                            const prepared &b, device_set &gb, std::span<const rung> rungs, const options &o) {
  compare(scene, p, a, b, rungs, o, {{"given"}, {"given, culled", true}},
          [&](const way &w, rung r, device_options &with) {
            with.cull = w.culled;
            // A query for the first element met does not cull.
            with.first_met = with.first_met && !w.culled;
            return collide(on_, ga, gb, p, r, with);
          });
}

void comparison::compare(const std::string &scene, const predicate_info &p, const prepared &a, const prepared &b,
                         std::span<const rung> rungs, const options &o, const std::vector<way> &ways,
                         const query &ask) {
  const key of{scene, p.name};
  for (const rung r : rungs) {
    collide_options on_cpu;
    on_cpu.owner_a = o.owner_a, on_cpu.owner_b = o.owner_b;
    on_cpu.first_met = p.first_met && o.owner_a.empty();
    const result want = collide(a, b, p, r, on_cpu);
    for (const way &by : ways) {
      const auto fails = [&](const std::string &what) {
        fail(of, std::to_string(a.elements()) + " by " + std::to_string(b.elements()) + ", " + name_of(r) + ", " +
                     by.name + ": " + what);
      };
      device_options with;
      with.owner_a = o.owner_a, with.owner_b = o.owner_b;
      with.list_capacity = o.list_capacity;
      with.first_met = on_cpu.first_met;
      const device_result have = ask(by, r, with);
      add(scene, p, have);
      if (have.first_met != want.first_met && with.first_met)
        fails("other elements are met first");
      if (have.count != have.pairs.size())
        fails("the count is " + std::to_string(have.count) + " and the list has " + std::to_string(have.pairs.size()));
      if (!std::is_sorted(have.pairs.begin(), have.pairs.end(), before))
        fails("the pairs are not sorted");
      if (!same_list(want.pairs, have.pairs))
        fails(std::to_string(have.count) + " pairs, and the CPU has " + std::to_string(want.count));
      // The CPU's candidates are touching boxes, and the device's are among them; for the plain rungs they are the same.
      // For the others a walk of balls rules out more on the device.
      if ((have.candidates > want.candidates && !(never_wrong(r) && fewer_candidates_on_cpu(p))) ||
          (!never_wrong(r) && have.candidates != want.candidates))
        fails(std::to_string(have.candidates) + " candidates, and the CPU has " + std::to_string(want.candidates));
      // After fp32 the CPU's lanes find zeros by residues, and the device within windows.
      if (have.rungs.unsure[0] > want.rungs.unsure[0] && !fewer_unsure_on_cpu(p, a, b))
        fails(std::to_string(have.rungs.unsure[0]) + " unsure, and on the CPU " + std::to_string(want.rungs.unsure[0]));
      with.want = answer_kind::none;
      for (const bool alone : {false, true}) {
        if (!with.first_met)
          continue;
        with.first_alone = alone;
        const device_result first = ask(by, r, with);
        if (first.first_met != want.first_met)
          fails(std::string("other elements are met first where nothing else is asked") + (alone ? ", alone" : ""));
        if (first.count != 0 || !first.pairs.empty())
          fails("where only first ones are asked, pairs are counted or listed");
      }
      if (!o.all_modes)
        continue;
      with.want = answer_kind::count;
      const device_result counted = ask(by, r, with);
      if (counted.count != have.count || !counted.pairs.empty())
        fails("counted " + std::to_string(counted.count) + ", listed " + std::to_string(have.count));
      if (counted.candidates != have.candidates)
        fails("counting looks at other candidates than listing");
      if (counted.first_met != want.first_met && with.first_met)
        fails("other elements are met first where pairs are only counted");
      with.first_met = false;
      with.want = answer_kind::any;
      const device_result any = ask(by, r, with);
      if (any.count != (have.count > 0) || !any.pairs.empty())
        fails("any says " + std::to_string(any.count) + " of " + std::to_string(have.count));
      const std::size_t items_a = items(o.owner_a, a.elements()), items_b = items(o.owner_b, b.elements());
      if (items_a + items_b > std::size_t{1} << 24) // an array of items would take gigabytes
        continue;
      with.want = answer_kind::flags;
      const device_result flagged = ask(by, r, with);
      const per_element<std::uint8_t> flags = flags_of(want.pairs, items_a, items_b);
      if (flagged.count != have.count || !flagged.pairs.empty() || flagged.flags.a != flags.a ||
          flagged.flags.b != flags.b)
        fails("the flags are not those of the pairs");
      with.want = answer_kind::counts;
      const device_result each = ask(by, r, with);
      const per_element<std::uint64_t> counts = counts_of(want.pairs, items_a, items_b);
      if (each.count != have.count || !each.pairs.empty() || each.counts.a != counts.a || each.counts.b != counts.b)
        fails("the counts of elements are not those of the pairs");
    }
  }
}

void comparison::print() const {
  std::printf("\n%-26s %-18s %8s %12s %12s %10s %6s %10s %s\n", "scene", "predicate", "queries", "pairs", "candidates",
              "unsure", "parts", "device_ms", "different");
  for (const key &k : order_) {
    const line &l = lines_.at(k);
    std::printf("%-26s %-18s %8ld %12llu %12llu %10llu %6llu %10.2f %ld\n", k.first.c_str(), k.second.c_str(),
                l.queries, static_cast<unsigned long long>(l.pairs), static_cast<unsigned long long>(l.candidates),
                static_cast<unsigned long long>(l.unsure), static_cast<unsigned long long>(l.most_parts), l.device_ms,
                l.differences);
  }
}

long comparison::differences() const {
  long sum = 0;
  for (const auto &[k, l] : lines_)
    sum += l.differences;
  return sum;
}

} // namespace cuda_test
