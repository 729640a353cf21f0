#include "meet/core/cascade/cascade.hpp"

#include "meet/core/sets/element_set.hpp"

#include <algorithm>
#include <cstring>

namespace meetc {

// Nothing is rounded here: reach and longest are stored numbers, and 2 box is exact or infinite.
static bool lies_in(const element_set &set, float box) {
  return set.reach <= box && set.longest <= 2 * box;
}

cascade::cascade(const predicate_info &of, rung precision) : predicate(&of), tolerant(precision == rung::tolerant) {
  if (precision == rung::certified || precision == rung::tolerant)
    stored_a = of.stored_a, stored_b = of.stored_b;
  else if (precision == rung::fp32)
    stored_a = of.plain_stored_a, stored_b = of.plain_stored_b;
  if (precision != rung::certified) {
    rungs[0] = of.decide[static_cast<int>(precision)];
    count = rungs[0] ? 1 : 0;
    return;
  }
  bool whole = true;
  for (int i = 0; i <= bounded_rungs; ++i) {
    rungs[i] = i < bounded_rungs ? of.certify[i] : of.decide[static_cast<int>(rung::exact)];
    whole = whole && rungs[i];
  }
  count = whole ? bounded_rungs + 1 : 0;
  if (whole && of.decide_last)
    rungs[bounded_rungs] = of.decide_last;
}

status cascade::check(const element_set &a, const element_set &b) {
  if (!tolerant)
    return status::ok;
  const tolerance_info &t = predicate->tolerance;
  if (!t.fits(a.grid) || !t.fits(b.grid))
    return status::not_on_grid;
  const bool left_a = !t.holds(a.reach, a.longest), left_b = !t.holds(b.reach, b.longest);
  if (!left_a && !left_b)
    return status::ok;
  *this = cascade(*predicate, rung::certified);
  start.left_box_a = left_a, start.left_box_b = left_b;
  return count > 0 ? status::ok : status::left_box;
}

void cascade::enter_box(float box, const element_set &a, const element_set &b) {
  if (count < 2 || box == 0)
    return;
  start.left_box_a |= !lies_in(a, box);
  start.left_box_b |= !lies_in(b, box);
  const float least = power_above(2 * box);
  if (predicate->certify_in_box && !start.left_box_a && !start.left_box_b && least >= predicate->box_least &&
      least <= predicate->box_most)
    side = least;
}

// The first unsure answer of n, or n.
static std::size_t first_unsure(const answer *answers, std::size_t n) {
  static_assert(sizeof(answer) == 1);
  const void *const at = std::memchr(answers, static_cast<int>(answer::unsure), n);
  return at ? static_cast<std::size_t>(static_cast<const answer *>(at) - answers) : n;
}

void cascade::decide(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                     bool any, const unsure_pairs &handed_on) const {
  constexpr std::size_t block = 1024; // of unsure pairs
  if (n == 0)
    return;
  index_pair unsure[block];
  std::size_t places[block]; // of these in `out`
  answer said[block];
  ask(0, a, b, pairs, n, out);
  std::size_t i = count > 1 ? first_unsure(out, n) : n;
  bool stops = any && i < n && std::find(out, out + n, answer::yes) != out + n;
  while (i < n && !stops) {
    std::size_t left = 0;
    for (; i < n && left < block; ++i) {
      places[left] = i;
      left += out[i] == answer::unsure;
    }
    for (int at = 1; at < count && left > 0 && !stops; ++at) {
      for (std::size_t k = 0; k < left; ++k)
        unsure[k] = pairs[places[k]];
      if (handed_on)
        handed_on(at - 1, {unsure, left});
      ask(at, a, b, unsure, left, said);
      std::size_t still = 0;
      for (std::size_t k = 0; k < left; ++k) {
        out[places[k]] = said[k];
        stops |= any && said[k] == answer::yes;
        places[still] = places[k];
        still += said[k] == answer::unsure;
      }
      left = still;
    }
  }
}

} // namespace meetc
