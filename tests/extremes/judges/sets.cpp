#include "tests/extremes/judges/sets.hpp"

#include "tests/downstream/flags/words.hpp"
#include "tests/extremes/families/families.hpp"

#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"

#include <cga/cga_runtime.hpp>
#include <fmt/format.h>
#include <mutex>
#include <optional>
#include <thread>

namespace meetc::extremes_test {
namespace {

// The rows of one operand, one after another.
struct side_rows {
  shape kind;
  row all;
  std::size_t fields() const { return static_cast<std::size_t>(generated_test::floats_of(kind)); }
  std::size_t elements() const { return all.size() / fields(); }
  const float *at(std::size_t i) const { return all.data() + i * fields(); }
  void add(const row &r) { all.insert(all.end(), r.begin(), r.end()); }
};
view view_of(const side_rows &r) {
  return {.data = r.all.data(), .elements = r.elements()};
}

using pair_list = std::vector<index_pair>;
bool same(const pair_list &x, const pair_list &y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](index_pair p, index_pair q) { return p.a == q.a && p.b == q.b; });
}

pair_list truth_of(const subject &s, const side_rows &a, const side_rows &b) {
  pair_list out;
  for (std::uint32_t i = 0; i < a.elements(); ++i)
    for (std::uint32_t k = 0; k < b.elements(); ++k)
      if (s.truth(a.at(i), b.at(k)) != 0)
        out.push_back({i, k});
  return out;
}

// Asks under a control word, and judges the list.
class judged {
public:
  judged(const subject &s, const family &f, set_counts &to) : s_(s), f_(f), to_(to) {}

  template <class Ask>
  void query(const char *how, std::size_t word, const side_rows &a, const side_rows &b, const pair_list &want,
             const Ask &ask) {
    pair_list found;
    const auto w = word < std::size(strange_words) ? strange_words[word] : plain_word;
    bool kept = false;
    std::string thrown;
    {
      const other_word changed(w);
      try {
        call_apart([&] { ask(found); });
      } catch (const std::exception &e) {
        set_control_word(plain_word);
        thrown = e.what();
        set_control_word(w);
      }
      kept = settings(control_word()) == settings(w);
    }
    ++to_.queries;
    if (same(found, want) && kept)
      return;
    ++to_.wrong;
    if (to_.first_wrong.empty())
      to_.first_wrong = describe(how, w, a, b, want, found) + thrown;
  }

private:
  template <class Word>
  std::string describe(const char *how, Word word, const side_rows &a, const side_rows &b, const pair_list &want,
                       const pair_list &found) const {
    std::string out = fmt::format("{} on {}, {}, word {:#x}: {} pairs, {} touch", s_.name, f_.name, how, word,
                                  found.size(), want.size());
    const auto lies_in = [](const pair_list &l, index_pair p) {
      return std::any_of(l.begin(), l.end(), [p](index_pair q) { return p.a == q.a && p.b == q.b; });
    };
    for (const pair_list *const l : {&want, &found})
      for (const index_pair p : *l)
        if (!lies_in(l == &want ? found : want, p))
          return out + (l == &want ? "; missed: " : "; wrongly found: ") +
                 text({row(a.at(p.a), a.at(p.a) + a.fields()), row(b.at(p.b), b.at(p.b) + b.fields())});
    return out;
  }

  const subject &s_;
  const family &f_;
  set_counts &to_;
};

std::size_t any_word(random_numbers &random) {
  return random.bits() % (std::size(strange_words) + 1);
}

void ask_all(const subject &s, const family &f, random_numbers &random, set_counts &to) {
  const predicate_info &by = find_predicate(cga::catalogue(), s.name);
  side_rows a{s.a, {}}, b{s.b, {}};
  for (int i = random.integer(2, 14); i > 0; --i) {
    const pair_of_rows p = f.make(s.a, s.b, random);
    a.add(p.a), b.add(p.b);
    if (random.one_in(4))
      a.add(f.make(s.a, s.b, random).a);
  }
  const pair_list want = truth_of(s, a, b);
  to.cases += a.elements() * b.elements(), to.hits += want.size();
  judged j(s, f, to);
  const int threads = random.integer(1, 3);
  std::vector<std::byte> work(workspace(by, a.elements(), b.elements(), threads));
  const bool near = random.one_in(3);
  j.query("pairs()", any_word(random), a, b, want, [&](pair_list &found) {
    found.resize(a.elements() * b.elements());
    std::uint64_t count = 0;
    pairs_out out{found.data(), found.size(), &count};
    pairs_options o;
    o.threads = threads;
    if (pairs(by, meetc::rung::certified, view_of(a), {}, view_of(b), {}, out, {work.data(), work.size()}, o) !=
        status::ok)
      count = 0;
    found.resize(count);
  });
  for (const meetc::rung r : {meetc::rung::certified, meetc::rung::exact})
    j.query(r == meetc::rung::exact ? "exact" : "certified", any_word(random), a, b, want, [&](pair_list &found) {
      const prepared x = prepare(view_of(a), *by.a, {}, threads),
                     y = prepare(view_of(b), *by.b, {}, threads, near ? &x : nullptr);
      collide_options o;
      o.threads = threads;
      found = collide(x, y, by, r, o).pairs;
    });
}

// One prepared set and partners of other magnitudes, from several threads.
void share(const subject &s, const family &f, random_numbers &random, set_counts &to) {
  const predicate_info &by = find_predicate(cga::catalogue(), s.name);
  constexpr std::size_t partners = 4;
  int powers[partners];
  for (int &p : powers)
    p = random.one_in(4) ? 0 : random.integer(-140, 110);
  side_rows a{s.a, {}}, b[partners] = {{s.b, {}}, {s.b, {}}, {s.b, {}}, {s.b, {}}};
  for (std::size_t k = 0; k < partners; ++k)
    for (int i = 0; i < 4; ++i) {
      const pair_of_rows p = f.make(s.a, s.b, random);
      if (k < 2 || random.one_in(2)) // often none of this magnitude, so that the shared set is not normalised for all
        a.add(generated_test::scaled(p.a, powers[k]));
      b[k].add(generated_test::scaled(p.b, powers[k]));
    }
  pair_list want[partners];
  for (std::size_t k = 0; k < partners; ++k) {
    want[k] = truth_of(s, a, b[k]);
    to.cases += a.elements() * b[k].elements(), to.hits += want[k].size();
  }
  const prepared shared = prepare(view_of(a), *by.a);
  std::mutex lock;
  std::size_t words[partners];
  for (std::size_t &w : words)
    w = any_word(random);
  std::vector<std::jthread> pool;
  for (std::size_t t = 0; t < partners; ++t)
    pool.emplace_back([&, t] {
      set_counts mine;
      judged j(s, f, mine);
      for (std::size_t i = 0; i < 2 * partners; ++i) {
        const std::size_t k = (t + i) % partners;
        j.query("shared", words[t], a, b[k], want[k], [&](pair_list &found) {
          const prepared partner = prepare(view_of(b[k]), *by.b, {}, 1);
          found = collide(shared, partner, by, i % 2 == 0 ? meetc::rung::certified : meetc::rung::exact, {.threads = 1})
                      .pairs;
        });
      }
      const std::scoped_lock hold(lock);
      to += mine;
    });
}

} // namespace

set_counts &set_counts::operator+=(const set_counts &o) {
  cases += o.cases, hits += o.hits, queries += o.queries, wrong += o.wrong;
  if (first_wrong.empty())
    first_wrong = o.first_wrong;
  return *this;
}

set_counts run_sets(const set_plan &what, const std::function<void(const set_counts &)> &report) {
  std::vector<std::pair<const subject *, const family *>> cells;
  for (const family &f : families())
    for (const subject &s : subjects())
      if (!s.sign && f.applies(s.a, s.b) && (what.family.empty() || what.family == f.name))
        cells.emplace_back(&s, &f);
  set_counts all;
  std::mutex lock;
  std::uint64_t next = 0;
  const auto work = [&] {
    for (;;) {
      std::uint64_t round = 0;
      {
        const std::scoped_lock hold(lock);
        if (all.cases >= what.cases)
          return;
        round = next++;
      }
      random_numbers random(what.seed * 0x9e3779b97f4a7c15 + round);
      const auto &[s, f] = cells[round % cells.size()];
      set_counts found;
      if ((round / cells.size()) % 4 == 3)
        share(*s, *f, random, found);
      else
        ask_all(*s, *f, random, found);
      const std::scoped_lock hold(lock);
      all += found;
      if (report && round % 10'000 == 9'999)
        report(all);
    }
  };
  std::vector<std::jthread> pool;
  for (unsigned i = 1; i < what.threads; ++i)
    pool.emplace_back(work);
  work();
  pool.clear();
  return all;
}

} // namespace meetc::extremes_test
