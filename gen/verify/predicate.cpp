#include "gen/ir/evaluate.hpp"
#include "gen/oracle/bodies.hpp"
#include "gen/verify/dense_model.hpp"
#include "gen/verify/verify.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
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

// The numbers and the enclosures of both operands, and the meaning of a hit.
struct operands {
  std::array<std::size_t, 2> reals;
  std::array<lower::enclosure, 2> enclosures;
  const lang::predicate &asked;

  operands(const lower::model &m, const lower::kernel &k) : asked(*k.asked.asked) {
    for (std::size_t i = 0; i < 2; ++i)
      reals[i] = m.layout(*k.asked.kinds[i]).reals.size(), enclosures[i] = lower::enclosing(m, *k.asked.kinds[i]);
  }
  bool bounded() const { return !enclosures[0].hull.empty() && !enclosures[1].hull.empty(); }
  bool hit(const sample &a, const sample &b) const {
    const std::size_t dimensions = enclosures[0].hull[0].size();
    switch (asked.means) {
    case lang::meaning::touch:
      break;
    case lang::meaning::beyond:
      return oracle::meets_beyond(a.hull, b.hull, common(a.hull, b.hull));
    case lang::meaning::overlap:
      return oracle::overlaps({a.hull, a.pad, dimensions}, {b.hull, b.pad, dimensions});
    case lang::meaning::contains:
      return oracle::contains({a.hull, a.pad, dimensions}, {b.hull, b.pad, dimensions});
    }
    return oracle::touches(a.hull, a.pad, b.hull, b.pad,
                           asked.mode == "surface" ? oracle::touch_mode::surface : oracle::touch_mode::solid);
  }
  // The points that the predicate says to be common, else those that are equal.
  oracle::hull common(const oracle::hull &a, const oracle::hull &b) const {
    if (asked.common > 0)
      return {a.begin(), a.begin() + asked.common};
    oracle::hull out;
    std::copy_if(a.begin(), a.end(), std::back_inserter(out),
                 [&](const oracle::point &p) { return std::find(b.begin(), b.end(), p) != b.end(); });
    return out;
  }
};

// The hull and the pad that the stored numbers say.
void place(sample &s, const lower::enclosure &e) {
  s.hull.clear();
  for (const std::vector<int> &point : e.hull) {
    oracle::point p{};
    for (std::size_t axis = 0; axis < point.size(); ++axis)
      p[axis] = s.row[static_cast<std::size_t>(point[axis])];
    s.hull.push_back(p);
  }
  if (e.pad >= 0)
    s.pad = s.row[static_cast<std::size_t>(e.pad)];
}

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

// An operand whose corners are on the lattice or, half of the time, come from the other operand. Two points of which one must
// not be above the other become so; another rule may be broken.
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
  if (e.rule && e.rule->kind == lower::element_rule::type::not_above)
    for (std::size_t axis = 0; axis < e.rule->x.size(); ++axis) {
      auto &low = out.row[static_cast<std::size_t>(e.rule->x[axis])],
           &high = out.row[static_cast<std::size_t>(e.rule->y[axis])];
      if (high < low)
        std::swap(low, high);
    }
  place(out, e);
  return out;
}

// Gives b the points that are common.
void join(const operands &of, const sample &a, sample &b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(of.asked.common); ++i)
    for (std::size_t axis = 0; axis < of.enclosures[1].hull[i].size(); ++axis)
      b.row[static_cast<std::size_t>(of.enclosures[1].hull[i][axis])] = a.hull[i][axis];
  place(b, of.enclosures[1]);
}

// Both operands. Either may provide the corners of the other.
std::pair<sample, sample> draw_pair(lattice &random, const operands &of, int size, int flat_axis) {
  sample a, b;
  if (random.one_in(2)) {
    b = draw(random, of.reals[1], of.enclosures[1], size, flat_axis, nullptr);
    a = draw(random, of.reals[0], of.enclosures[0], size, flat_axis, random.one_in(3) ? nullptr : &b.hull);
  } else {
    a = draw(random, of.reals[0], of.enclosures[0], size, flat_axis, nullptr);
    b = draw(random, of.reals[1], of.enclosures[1], size, flat_axis, random.one_in(3) ? nullptr : &a.hull);
  }
  join(of, a, b);
  return {std::move(a), std::move(b)};
}

// Lattices have 2, 5 and 17 points along each axis; every fourth case lies in one plane.
std::pair<sample, sample> draw_case(lattice &random, const operands &of, long number) {
  const int size = number % 3 == 0 ? 1 : number % 3 == 1 ? 4 : 16;
  const int flat_axis = number % 4 == 3 ? random.number(0, 2) : -1;
  return draw_pair(random, of, size, flat_axis);
}

// Numbers of which many are zero, alike or opposite, without regard to their meaning.
std::pair<sample, sample> draw_numbers(lattice &random, const operands &of, long number) {
  const int size = number % 3 == 0 ? 1 : number % 3 == 1 ? 2 : 7;
  sample a, b;
  for (std::size_t i = 0; i < of.reals[0]; ++i)
    a.row.emplace_back(random.number(-size, size));
  for (std::size_t i = 0; i < of.reals[1]; ++i)
    b.row.emplace_back(random.number(-size, size));
  return {std::move(a), std::move(b)};
}

// "S: sphere = 1, 1, 0, 1", as `meetc eval --with` takes it.
std::string text_of(const lang::field &operand, const std::vector<oracle::rational> &row) {
  std::string numbers;
  for (const auto &q : row)
    numbers += (numbers.empty() ? "" : ", ") + q.get_str();
  return fmt::format("{}: {} = {}", operand.name, operand.type, numbers);
}
std::string text_of(const operands &of, const sample &a, const sample &b) {
  return text_of(of.asked.of[0], a.row) + "; " + text_of(of.asked.of[1], b.row);
}

// "K.p = K.q and S.c = K.p"; the numbers of b come behind those of a.
std::string equal_in_words(const operands &of, const lower::predicate &p,
                           const std::vector<bound::coincidence> &equal) {
  const auto point = [&](const std::vector<int> &inputs) {
    const auto input = static_cast<std::size_t>(inputs.front());
    const std::string &path = p.stored_inputs[input]; // "A.c.x"
    const std::size_t end = path.rfind('.');
    return of.asked.of[input < of.reals[0] ? 0 : 1].name + path.substr(1, end - 1);
  };
  std::string out;
  for (const bound::coincidence &c : equal)
    out += fmt::format("{}{} = {}", out.empty() ? "" : " and ", point(c.x), point(c.y));
  return out;
}

int sign_of(const oracle::rational &q) {
  return sgn(q);
}

// Without hulls nothing tells what is true of the operands, so the decision is compared with what the spec says of dense
// products.
class truth {
public:
  truth(const lower::model &m, const lower::kernel &k, const operands &of)
      : k_(k), of_(of), dense_(dense_evaluator_of(m)) {}

  bool operator()(const sample &a, const sample &b) const {
    if (of_.bounded())
      return of_.hit(a, b);
    std::size_t next_a = 0, next_b = 0;
    return dense_.hit(*k_.asked.asked, {dense_.operand(*k_.asked.kinds[0], a.row, next_a),
                                        dense_.operand(*k_.asked.kinds[1], b.row, next_b)});
  }

private:
  const lower::kernel &k_;
  const operands &of_;
  dense_evaluator dense_;
};

} // namespace

report verify_predicate(const lower::model &m, const lower::kernel &k, long cases, unsigned seed) {
  report out;
  const operands of(m, k);
  out.by_text = !of.bounded();
  const lower::predicate &p = k.decision;
  const truth is_hit(m, k, of);
  lattice random(seed);
  for (long i = 0; i < cases; ++i) {
    const auto [a, b] = of.bounded() ? draw_case(random, of, i) : draw_numbers(random, of, i);
    if (!lower::obeys(of.enclosures[0].rule, a.row) || !lower::obeys(of.enclosures[1].rule, b.row))
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
    const bool want = is_hit(a, b);
    const bool hit = p.signs.evaluate(p.truths.hit, signs);
    const bool rejected =
        std::any_of(p.truths.reject.begin(), p.truths.reject.end(), [&](int t) { return p.signs.evaluate(t, signs); });
    const bool rare =
        std::any_of(p.conditions.begin(), p.conditions.end(), [&](int t) { return p.signs.evaluate(t, signs); });
    // A reject line may only save time, and the common case decides alone where no condition holds.
    const bool staged = !rejected && (rare ? hit : p.signs.evaluate(p.usual, signs));
    ++out.cases;
    out.degenerate += zero;
    out.hits += want;
    if (hit == want && staged == want)
      continue;
    if (out.wrong++ == 0) {
      out.first_wrong = fmt::format("{} is {} by the predicate{}, and {} by {}", text_of(of, a, b),
                                    (hit == want ? staged : hit) ? "a hit" : "a miss",
                                    hit == want ? "'s reject lines or its common case" : "", want ? "a hit" : "a miss",
                                    out.by_text ? "the dense products of its text" : "the hulls");
    }
  }
  return out;
}

report verify_settled(const lower::model &m, const lower::kernel &k, const bound::kernel_bounds &bounds, long cases,
                      unsigned seed) {
  report out;
  const operands of(m, k);
  const truth is_hit(m, k, of);
  lattice random(seed);
  for (const std::uint32_t set : bounds.settled_by) {
    std::vector<bound::coincidence> equal;
    for (std::size_t c = 0; c < bounds.coincidences.size(); ++c)
      if (set >> c & 1)
        equal.push_back(bounds.coincidences[c]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(of.asked.common); ++i) {
      equal.push_back({of.enclosures[0].hull[i], of.enclosures[1].hull[i]});
      for (int &input : equal.back().y)
        input += static_cast<int>(of.reals[0]);
    }
    for (long i = 0; i < cases; ++i) {
      auto [a, b] = of.bounded() ? draw_case(random, of, i) : draw_numbers(random, of, i);
      const auto number = [&, &a = a, &b = b](int input) -> oracle::rational & {
        const auto at = static_cast<std::size_t>(input);
        return at < a.row.size() ? a.row[at] : b.row[at - a.row.size()];
      };
      // A point may be in several coincidences; the lesser number wins, so that all hold after as many rounds.
      for (std::size_t round = 0; round < equal.size(); ++round)
        for (const bound::coincidence &c : equal)
          for (std::size_t axis = 0; axis < c.x.size(); ++axis) {
            oracle::rational &x = number(c.x[axis]), &y = number(c.y[axis]);
            (x < y ? y : x) = x < y ? x : y;
          }
      place(a, of.enclosures[0]), place(b, of.enclosures[1]);
      ++out.cases;
      if (is_hit(a, b))
        continue;
      if (out.wrong++ == 0)
        out.first_wrong = fmt::format("{} is a miss by {}, and a hit by the predicate, as all are where {}",
                                      text_of(of, a, b), of.bounded() ? "the hulls" : "the dense products of its text",
                                      equal_in_words(of, k.decision, equal));
    }
  }
  out.hits = out.cases - out.wrong;
  return out;
}

} // namespace meetc::verify
