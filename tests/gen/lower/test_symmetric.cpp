// Which predicates are proved to be the same with their operands exchanged.
#include "gen/lower/predicate/symmetric.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <fmt/format.h>
#include <random>
#include <set>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

bool is_symmetric(const spec_copy &copy) {
  return copy.compile().kernels.front().decision.symmetric;
}

// The answer on stored numbers, by the exact signs.
bool answer(const lower::predicate &p, const std::vector<poly::rational> &numbers) {
  std::vector<int> signs;
  for (const poly::poly &atom : p.signs.atoms())
    signs.push_back(sgn(atom.evaluate(numbers)));
  bool rejected = false;
  for (const int r : p.truths.reject)
    rejected = rejected || p.signs.evaluate(r, signs);
  return !rejected && p.signs.evaluate(p.truths.hit, signs);
}

} // namespace

TEST_CASE("symmetric: the shipped predicates on two operands of one kind") {
  std::set<std::string> proved;
  for (const lower::kernel *k : default_kernels(want::predicates))
    if (k->decision.symmetric)
      proved.insert(k->asked.name());
  CHECK(proved ==
        std::set<std::string>{"segment_segment", "triangle_triangle", "sphere_sphere", "ball_ball", "box_box"});
}

// Small integers, so that every kind of coincidence occurs.
TEST_CASE("symmetric: exact answers are the same with the operands exchanged") {
  std::mt19937_64 random(1);
  for (const lower::kernel *k : default_kernels(want::predicates)) {
    const lower::predicate &p = k->decision;
    if (!p.symmetric)
      continue;
    INFO(k->asked.text);
    int hits = 0, different = 0;
    for (int i = 0; i < 600; ++i) {
      std::vector<poly::rational> numbers, exchanged;
      for (int n = 0; n < p.inputs_a + p.inputs_b; ++n)
        numbers.emplace_back(static_cast<long>(random() % 3));
      exchanged.assign(numbers.begin() + p.inputs_a, numbers.end());
      exchanged.insert(exchanged.end(), numbers.begin(), numbers.begin() + p.inputs_a);
      const bool hit = answer(p, numbers);
      hits += hit;
      different += hit != answer(p, exchanged);
    }
    CHECK(different == 0);
    CHECK(hits > 30);
    CHECK(hits < 600);
  }
}

TEST_CASE("symmetric: not claimed where the decision is another one") {
  const char *const flat = "predicates/flat.toml", *const round_ones = "predicates/round.toml";
  const struct {
    const char *kernel, *file, *from, *to;
  } changes[] = {
      {"segment_segment", flat, "turn(k, s.p, s.q, e.q) <= 0", "turn(k, s.p, s.q, e.q) < 0"},
      {"segment_segment", "predicates/words.toml", "p[k] <= q[k]", "p[k] < q[k]"},
      {"triangle_triangle", flat, "reject = ['apart(B, A.corners)', 'apart(A, B.corners)']",
       "reject = ['apart(B, A.corners)']"},
      {"triangle_triangle", flat, "or any(e in B.edges: segment_triangle(e, A))",
       "or segment_triangle(segment(B.a, B.b), A)"},
      {"ball_ball", round_ones, "4*S.r*T.r) >= 0", "4*S.r*S.r) >= 0"},
      {"sphere_sphere", round_ones, "sign(norm2(meet(S, T))) >= 0", "sign(norm2(meet(S, T))) >= 0 and sign(S.r) > 0"},
  };
  for (const auto &m : changes) {
    INFO(m.kernel << ": '" << m.from << "' to '" << m.to << "'");
    const spec_copy copy({m.kernel});
    CHECK(is_symmetric(copy));
    copy.replace(m.file, m.from, m.to);
    CHECK_FALSE(is_symmetric(copy));
  }
}
