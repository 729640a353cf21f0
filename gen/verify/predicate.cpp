#include "gen/ir/evaluate.hpp"
#include "gen/oracle/convex.hpp"
#include "gen/verify/verify.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace meetc::verify {
namespace {

// Stored numbers on a lattice that is so small that operands often share corners, planes and lines.
class lattice {
public:
  explicit lattice(unsigned seed) : random_(seed) {}
  int number(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
  bool one_in(int n) { return number(1, n) == 1; }

private:
  std::mt19937 random_;
};

struct sample {
  std::vector<oracle::rational> row; // as stored
  oracle::hull hull;
  oracle::rational pad = 0;
};

// A point of the hull: a corner, the midpoint of two corners, or a point inside.
oracle::point point_of(lattice &random, const oracle::hull &hull) {
  const auto corner = [&] {
    return hull[static_cast<std::size_t>(random.number(0, static_cast<int>(hull.size()) - 1))];
  };
  oracle::point out = corner();
  const int way = random.number(0, 2);
  if (way == 0)
    return out;
  const oracle::point other = corner(), third = corner();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (way == 1)
      out[axis] = (out[axis] + other[axis]) / 2;
    else
      out[axis] = (2 * out[axis] + other[axis] + third[axis]) / 4;
  return out;
}

// An operand whose corners are on the lattice or, half of the time, come from the other operand.
sample draw(lattice &random, std::size_t reals, const lower::enclosure &e, int size, int flat_axis,
            const oracle::hull *near) {
  sample out;
  for (std::size_t i = 0; i < reals; ++i)
    out.row.emplace_back(random.number(0, size));
  for (const std::vector<int> &point : e.hull) {
    if (flat_axis >= 0 && static_cast<std::size_t>(flat_axis) < point.size())
      out.row[static_cast<std::size_t>(point[static_cast<std::size_t>(flat_axis)])] = 1;
    if (!near || !random.one_in(2))
      continue;
    const oracle::point from = point_of(random, *near);
    for (std::size_t axis = 0; axis < point.size(); ++axis)
      out.row[static_cast<std::size_t>(point[axis])] = from[axis];
  }
  for (const std::vector<int> &point : e.hull) {
    oracle::point p{};
    for (std::size_t axis = 0; axis < point.size(); ++axis)
      p[axis] = out.row[static_cast<std::size_t>(point[axis])];
    out.hull.push_back(p);
  }
  if (e.pad >= 0)
    out.pad = out.row[static_cast<std::size_t>(e.pad)];
  return out;
}

int sign_of(const oracle::rational &q) {
  return sgn(q);
}

} // namespace

report verify_predicate(const lower::model &m, const lower::kernel &k, long cases, unsigned seed) {
  report out;
  const lower::enclosure ea = lower::enclosing(m, *k.asked.kinds[0]), eb = lower::enclosing(m, *k.asked.kinds[1]);
  if (ea.hull.empty() || eb.hull.empty()) {
    out.note = "not checked: an operand has no hull";
    return out;
  }
  const auto mode = k.asked.asked->mode == "surface" ? oracle::touch_mode::surface : oracle::touch_mode::solid;
  const lower::predicate &p = k.decision;
  const auto reals = [&](std::size_t i) { return m.layout(*k.asked.kinds[i]).reals.size(); };
  lattice random(seed);
  for (long i = 0; i < cases; ++i) {
    // Lattices have 2, 5 and 17 points along each axis; every fourth case lies in one plane.
    const int size = i % 3 == 0 ? 1 : i % 3 == 1 ? 4 : 16;
    const int flat_axis = i % 4 == 3 ? random.number(0, 2) : -1;
    // Either operand may provide the corners.
    const bool swapped = random.one_in(2);
    sample a, b;
    if (swapped) {
      b = draw(random, reals(1), eb, size, flat_axis, nullptr);
      a = draw(random, reals(0), ea, size, flat_axis, random.one_in(3) ? nullptr : &b.hull);
    } else {
      a = draw(random, reals(0), ea, size, flat_axis, nullptr);
      b = draw(random, reals(1), eb, size, flat_axis, random.one_in(3) ? nullptr : &a.hull);
    }
    if (!lower::obeys(ea.rule, a.row) || !lower::obeys(eb.rule, b.row))
      continue;
    std::vector<oracle::rational> row = a.row;
    row.insert(row.end(), b.row.begin(), b.row.end());
    std::vector<int> signs(p.signs.atoms().size());
    bool zero = false;
    for (const lower::stage *s : lower::stages(p)) {
      if (s->atoms.empty())
        continue;
      const auto values = ir::evaluate(s->code, row);
      for (std::size_t v = 0; v < values.size(); ++v) {
        signs[static_cast<std::size_t>(s->atoms[v])] = sign_of(values[v]);
        zero = zero || (s != &p.rare && values[v] == 0);
      }
    }
    const bool want = oracle::touches(a.hull, a.pad, b.hull, b.pad, mode);
    const bool hit = p.signs.evaluate(p.truths.hit, signs);
    const bool rejected =
        std::any_of(p.truths.reject.begin(), p.truths.reject.end(), [&](int t) { return p.signs.evaluate(t, signs); });
    const bool rare =
        std::any_of(p.conditions.begin(), p.conditions.end(), [&](int t) { return p.signs.evaluate(t, signs); });
    // A reject line may only save time, and the usual case decides alone where no condition holds.
    const bool staged = !rejected && (rare ? hit : p.signs.evaluate(p.usual, signs));
    ++out.cases;
    out.degenerate += zero;
    out.hits += want;
    if (hit == want && staged == want)
      continue;
    if (out.wrong++ == 0) {
      std::string numbers;
      for (const auto &q : row)
        numbers += (numbers.empty() ? "" : ", ") + q.get_str();
      out.first_wrong = fmt::format("{}({}) is {}, and should be {}{}", k.asked.text, numbers, hit ? "a hit" : "a miss",
                                    want ? "a hit" : "a miss",
                                    hit == want ? ", but a reject line or the usual case gets it wrong" : "");
    }
  }
  return out;
}

} // namespace meetc::verify
