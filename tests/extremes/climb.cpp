#include "tests/extremes/climb.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace meetc::extremes_test {
namespace {

// The data of one sign: the value to 106 bits, the fp32 value, and its bound.
struct sample {
  double truth, computed, bound;
};

template <class Stage> double bound_in_box(const float *a, const float *b, double side, bound_form form, int i) {
  const auto extent = [&](float e) {
    const double least = std::ldexp(1.0, Stage::box_lowest);
    return form == bound_form::whole_box ? side : std::max(least, static_cast<double>(meetc::power_above(e)));
  };
  const meetc::box_factor f = meetc::in_fp32::box<Stage>(i);
  return static_cast<double>(f.c) * std::pow(extent(Stage::extent_a(a)), f.a) *
         std::pow(extent(Stage::extent_b(b)), f.b) * std::pow(side, f.pair);
}

template <class P> sample sample_at(const float *a, const float *b, double side, bound_form form, int atom) {
  sample out{};
  each_stage<P>([&](auto stage) {
    using Stage = decltype(stage);
    const int i = atom - Stage::first;
    if (i < 0 || i >= Stage::atoms)
      return;
    using number = meetc::in_fp32::value;
    const meetc::rows_in<P, number> rows(a, b);
    const meetc::rows_in<P, meetc::double_double> finer(a, b);
    number v[Stage::atoms], m[Stage::atoms];
    meetc::double_double t[Stage::atoms];
    meetc::stage_values<Stage>(rows.a, rows.b, v);
    meetc::stage_values<Stage>(finer.a, finer.b, t);
    out.truth = t[i].hi, out.computed = static_cast<double>(static_cast<float>(v[i]));
    if (form == bound_form::magnitude) {
      const meetc::leaf_magnitude<number> leaf{number(meetc::power_of_two(Stage::floor_fp32, 0.0F))};
      meetc::stage_magnitudes<Stage>(rows.a, rows.b, leaf, m);
      out.bound = static_cast<double>(meetc::in_fp32::factor<Stage>(i)) * static_cast<double>(static_cast<float>(m[i]));
    } else {
      out.bound = bound_in_box<Stage>(a, b, side, form, i);
    }
  });
  return out;
}
using sampler = sample (*)(const float *, const float *, double, bound_form, int);

// Floats by their position in the order of floats.
std::int64_t place(float f) {
  std::int32_t i;
  std::memcpy(&i, &f, sizeof i);
  return i < 0 ? std::int64_t{INT32_MIN} - i : i;
}
float at_place(std::int64_t p) {
  const auto i = static_cast<std::int32_t>(p < 0 ? INT32_MIN - p : p);
  float f;
  std::memcpy(&f, &i, sizeof f);
  return f;
}

class climber {
public:
  climber(const subject &s, sampler f, bound_form form, int atom, random_numbers &random)
      : s_(s), sample_(f), form_(form), atom_(atom), random_(random) {
    now_.a.resize(static_cast<std::size_t>(floats_of(s.a)));
    now_.b.resize(static_cast<std::size_t>(floats_of(s.b)));
    for (std::size_t i = 0; i < size(); ++i)
      set(now_, i, random.unit());
  }

  void step() {
    pair_of_rows p = now_;
    const std::size_t i = any();
    const float f = number(p, i);
    switch (random_.integer(0, 4)) {
    case 0:
      set(p, i, random_.unit());
      break;
    case 1:
      set(p, i, at_place(place(f) + random_.integer(-9, 9)));
      break;
    case 2:
      set(p, i, std::ldexp(f, random_.integer(-1, 1)));
      break;
    case 3:
      set(p, i, std::ldexp(static_cast<float>(random_.integer(-255, 255)), -8));
      break;
    default: // almost as wide as a box
      set(p, i, at_place(place(random_.one_in(2) ? 1.0F : -1.0F) + random_.integer(-9, 9)));
    }
    if (!to_root(p, any()))
      return;
    if (const double share = share_of(p); share >= best_.share)
      best_ = {share, p}, now_ = p;
  }
  const summit &best() const { return best_; }

private:
  std::size_t size() const { return now_.a.size() + now_.b.size(); }
  std::size_t any() { return random_.bits() % size(); }
  float &number(pair_of_rows &p, std::size_t i) const { return i < p.a.size() ? p.a[i] : p.b[i - p.a.size()]; }
  void set(pair_of_rows &p, std::size_t i, float f) const {
    const bool radius = (padded(s_.a) && i == 3) || (padded(s_.b) && i == p.a.size() + 3);
    number(p, i) = radius ? std::abs(f) : f;
  }

  sample at(const pair_of_rows &p) const {
    const double side = form_ == bound_form::magnitude ? 0 : static_cast<double>(box_side(s_.a, p.a, s_.b, p.b));
    return sample_(p.a.data(), p.b.data(), side, form_, atom_);
  }
  double share_of(const pair_of_rows &p) const {
    const sample v = at(p);
    const bool wrong = v.computed > 0 ? v.truth <= 0 : v.computed < 0 && v.truth >= 0;
    return wrong && v.bound > 0 ? std::abs(v.computed) / v.bound : 0;
  }

  // Moves number i to where the value changes its sign and then, nearby, to where the share is largest.
  bool to_root(pair_of_rows &p, std::size_t i) const {
    const auto truth = [&](float f) {
      set(p, i, f);
      return at(p).truth;
    };
    const float start = number(p, i);
    const double first = truth(start);
    if (first == 0)
      return true;
    float end = start;
    for (float d = 0x1p-20F; d < 8 && end == start; d *= 4)
      for (const float f : {start - d, start + d})
        if ((truth(f) > 0) != (first > 0))
          end = f;
    if (end == start)
      return false;
    std::int64_t low = place(start), high = place(end);
    while (std::abs(high - low) > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      const double t = truth(at_place(middle));
      (t != 0 && (t > 0) == (first > 0) ? low : high) = middle;
    }
    double best = -1;
    std::int64_t at_best = low;
    for (std::int64_t k = low - 6; k <= low + 6; ++k) {
      set(p, i, at_place(k));
      if (const double share = share_of(p); share > best)
        best = share, at_best = k;
    }
    set(p, i, at_place(at_best));
    return true;
  }

  const subject &s_;
  sampler sample_;
  bound_form form_;
  int atom_;
  random_numbers &random_;
  pair_of_rows now_;
  summit best_;
};

} // namespace

summit climb(const subject &s, bound_form form, random_numbers &random, int starts, double enough) {
  const auto f = for_type_of(s, []<class P>(P) -> sampler { return sample_at<P>; });
  const int atoms = for_type_of(s, []<class P>(P) { return P::atoms; });
  summit best;
  for (int i = 0; i < starts && best.share < enough; ++i) {
    climber c(s, f, form, random.integer(0, atoms - 1), random);
    for (int step = 0; step < 500; ++step)
      c.step();
    if (c.best().share > best.share)
      best = c.best();
  }
  return best;
}

} // namespace meetc::extremes_test
