// Calls that are cancelled: how much is still done after the request, and that the sets are as they were. Work is counted,
// since a shared machine may take any time for it.
#include "scenes.hpp"
#include "tests/catch.hpp"

#include "meet/core/query/evaluate.hpp"
#include "meet/core/query/pairs.hpp"
#include "meet/core/world/world.hpp"

#include <atomic>

using namespace live_test;

namespace {

// A stop is requested at the call of this number; then the elements or pairs of further calls are counted.
std::stop_source source;
std::atomic<long> calls_left{-1};
std::atomic<std::uint64_t> later{0};

void stop_after(long calls) {
  source = std::stop_source();
  calls_left = calls, later = 0;
}
void count(std::size_t n) {
  if (source.stop_requested())
    later += n;
  if (calls_left-- == 0)
    source.request_stop();
}

const predicate_info &original() {
  return predicate("triangle_triangle");
}
template <int Rung> void counted(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  count(n);
  original().decide[Rung](a, b, pairs, n, out);
}
template <int Rung>
void counted_bounded(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  count(n);
  original().certify[Rung](a, b, pairs, n, out);
}
void counted_boxes(const float *rows, std::size_t n, float *out) {
  count(n);
  original().a->boxes(rows, n, out);
}
void counted_contacts(const float *a, const float *b, const index_pair *pairs, std::size_t n, std::uint64_t *codes) {
  count(n);
  original().contacts(a, b, pairs, n, codes);
}
// The predicate that counts.
predicate_info counting() {
  predicate_info p = original();
  p.decide[static_cast<int>(rung::exact)] = counted<static_cast<int>(rung::exact)>;
  p.certify[0] = counted_bounded<0>;
  p.stored_a = p.stored_b = {};
  p.contacts = counted_contacts;
  return p;
}

// The most that one thread does between two looks: a batch of a query, and a chunk of prepare().
constexpr std::uint64_t pairs_at_once = 8192, exact_at_once = 1024, rows_at_once = 2048, contacts_at_once = 256;

struct scene {
  mesh a = self_test::eight_torus(0.6, 120, 60), b = shaken(a, 0.02F, 1);
  prepared set_a = prepare(a.view(), *original().a), set_b = prepare(b.view(), *original().a);
};

// Calls ask(stop) so that it is stopped at some of its calls; none does more than `most` afterwards.
template <class Ask> void check_stops(std::uint64_t most, const Ask &ask) {
  stop_after(-1);
  ask(source.get_token());
  const long calls = -calls_left - 1;
  REQUIRE(calls > 8);
  for (const long at : {0L, 1L, calls / 3, calls / 2}) {
    stop_after(at);
    CHECK_THROWS_AS(ask(source.get_token()), cancelled);
    CHECK(later <= most);
  }
}

} // namespace

TEST_CASE("a query ends soon after the request, on each rung and number of threads") {
  const scene s;
  const predicate_info p = counting();
  for (const rung precision : {rung::exact, rung::certified})
    for (const int threads : {1, 2, 4}) {
      CAPTURE(static_cast<int>(precision), threads);
      const auto want = collide(s.set_a, s.set_b, p, precision);
      check_stops(static_cast<std::uint64_t>(threads) * (precision == rung::exact ? exact_at_once : pairs_at_once),
                  [&](const std::stop_token &stop) {
                    collide_options o;
                    o.threads = threads, o.stop = stop;
                    return collide(s.set_a, s.set_b, p, precision, o);
                  });
      CHECK((plain(collide(s.set_a, s.set_b, p, precision).pairs) == plain(want.pairs)));
    }
}

TEST_CASE("chunks end soon after the request") {
  const scene s;
  const predicate_info p = counting();
  check_stops(2 * pairs_at_once, [&](const std::stop_token &stop) {
    collide_options o;
    o.threads = 2, o.stop = stop;
    collide_in_chunks(
        s.set_a, s.set_b, p, rung::certified, 100, [](std::span<const index_pair>) {}, o);
  });
  // A request of the consumer itself: no other chunk comes.
  std::stop_source own;
  collide_options o;
  o.stop = own.get_token();
  int chunks = 0;
  const auto take = [&](std::span<const index_pair>) { own.request_stop(), ++chunks; };
  CHECK_THROWS_AS(collide_in_chunks(s.set_a, s.set_b, p, rung::certified, 100, take, o), cancelled);
  CHECK(chunks == 1);
}

TEST_CASE("preparing and refitting end soon after the request, and a moving set stays as it was") {
  const scene s;
  kind_info kind = *original().a;
  kind.boxes = counted_boxes;
  for (const int threads : {1, 2}) {
    const auto most = static_cast<std::uint64_t>(threads) * rows_at_once;
    check_stops(most, [&](const std::stop_token &stop) { prepare(s.a.view(), kind, {}, threads, nullptr, stop); });
    stop_after(-1);
    moving_set moving(s.a.view(), kind);
    for (const long at : {0L, 1L, 20L}) {
      stop_after(at);
      CHECK_THROWS_AS(moving.update(s.b.view(), {}, threads, source.get_token()), cancelled);
      CHECK(later <= most);
      CHECK(plain(collide(moving, s.set_b, original(), rung::certified).pairs) ==
            plain(collide(s.set_a, s.set_b, original(), rung::certified).pairs));
    }
    stop_after(0);
    CHECK_THROWS_AS(moving.reorder(s.b.view(), {}, threads, source.get_token()), cancelled);
    stop_after(-1);
    moving.update(s.b.view(), {}, threads);
    CHECK(plain(collide(moving, s.set_a, original(), rung::certified).pairs) ==
          plain(collide(s.set_b, s.set_a, original(), rung::certified).pairs));
  }
}

TEST_CASE("contacts and the pairs of a mesh with itself end soon after the request") {
  const scene s;
  const predicate_info p = counting();
  const auto pairs = collide(s.set_a, s.set_b, original(), rung::certified).pairs;
  for (const int threads : {1, 2}) {
    check_stops(static_cast<std::uint64_t>(threads) * contacts_at_once, [&](const std::stop_token &stop) {
      contact_options o;
      o.threads = threads, o.stop = stop;
      contacts(s.a.view(), s.b.view(), p, pairs, o);
    });
    const self_predicates others = self_test::predicates();
    check_stops(static_cast<std::uint64_t>(threads) * pairs_at_once, [&](const std::stop_token &stop) {
      self_options o;
      o.threads = threads, o.stop = stop;
      self_pairs(s.set_a, s.a.view(), {p, others.one_common, others.two_common}, o);
    });
  }
}

TEST_CASE("a world ends soon after the request, and answers afterwards") {
  const scene s;
  catalogue all = cga::catalogue();
  const predicate_info p = counting();
  all.predicates = &p, all.predicate_count = 1;
  const auto shape = std::make_shared<prepared>(prepare(s.a.view(), *original().a));
  world bodies(all);
  for (int i = 0; i < 3; ++i) {
    pose at;
    at.m[3] = 0.01 * i;
    bodies.add("body " + std::to_string(i), shape, at);
  }
  const auto ask = [&](const std::stop_token &stop) {
    world_options o;
    o.threads = 2, o.stop = stop;
    return bodies.touching(o);
  };
  check_stops(2 * pairs_at_once, ask);
  stop_after(-1);
  CHECK(ask({}).touching.size() == 3);
}

TEST_CASE("a query in the caller's memory ends soon after the request, and says so") {
  const scene s;
  const view a = s.a.view(), b = s.b.view();
  const predicate_info p = counting();
  std::vector<index_pair> list(collide(s.set_a, s.set_b, original(), rung::exact).pairs.size());
  for (const int threads : {1, 3}) {
    std::vector<std::byte> work(workspace(p, a.elements, b.elements, threads));
    std::uint64_t n = 7;
    const auto ask = [&](const std::stop_token &stop) {
      pairs_options o;
      o.threads = threads, o.stop = stop;
      const status said =
          pairs(p, rung::certified, a, {}, b, {}, {list.data(), list.size(), &n}, {work.data(), work.size()}, o);
      if (said == status::cancelled) {
        CHECK(n == 0);
        throw cancelled();
      }
      CHECK(said == status::ok);
      CHECK(n == list.size());
    };
    check_stops(pairs_at_once * static_cast<std::uint64_t>(threads), ask);
  }
}

TEST_CASE("values end soon after the request") {
  static const formula_info &f = formula_named(cga::catalogue(), "norm2(meet(sphere, sphere))");
  formula_info counted = f;
  counted.float32 = [](const column *in, const std::uint32_t *rows, std::size_t n, float *const *out) {
    count(n);
    f.float32(in, rows, n, out);
  };
  constexpr std::size_t n = 200'000, at_once = 4096;
  const std::vector<float> rows(4 * n, 1);
  std::vector<column> numbers(4);
  columns_of(rows.data(), numbers);
  const operand_columns operands[] = {{numbers, n}, {numbers, n}};
  std::vector<float> values(n);
  float *const out[] = {values.data()};
  const std::vector<std::uint32_t> listed(2 * n, 1);
  for (const int threads : {1, 3}) {
    const std::uint64_t most = at_once * static_cast<std::uint64_t>(threads);
    check_stops(most, [&](const std::stop_token &stop) { evaluate(counted, operands, out, {threads, stop}); });
    check_stops(most, [&](const std::stop_token &stop) { evaluate(counted, operands, listed, out, {threads, stop}); });
  }
}

TEST_CASE("a request that came before the call ends it at once") {
  const scene s;
  std::stop_source before;
  before.request_stop();
  const std::stop_token stop = before.get_token();
  collide_options of_query;
  of_query.stop = stop;
  CHECK_THROWS_WITH(prepare(s.a.view(), *original().a, {}, 0, nullptr, stop), "cancelled");
  for (const answer_kind want : {answer_kind::pairs, answer_kind::counts, answer_kind::any}) {
    of_query.want = want;
    CHECK_THROWS_AS(collide(s.set_a, s.set_b, original(), rung::certified, of_query), cancelled);
  }
  contact_options of_contacts;
  of_contacts.stop = stop;
  CHECK_THROWS_AS(contacts(s.a.view(), s.b.view(), original(), std::vector<index_pair>{{0, 0}}, of_contacts),
                  cancelled);
}
