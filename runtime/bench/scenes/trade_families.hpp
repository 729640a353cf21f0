// bench/scenes/trade_families.hpp: the families of pairs on which `meet trade` measures, each hard for a float in its own way.
#ifndef MEETC_BENCH_SCENES_TRADE_FAMILIES_HPP
#define MEETC_BENCH_SCENES_TRADE_FAMILIES_HPP

#include "meet/bench/truth/near_pairs.hpp"
#include "meet/io/elements/element_set.hpp"

#include <array>

namespace meetc::bench {

struct trade_family {
  const char *name; // one word
  const char *words;
  pair_difficulty pairs;
};

// The distance of a pair from a contact, in bits of its size.
inline constexpr int nearest_bits = 60;

inline constexpr std::array trade_families{
    trade_family{"random", "random, boxes touch", {}},
    trade_family{"far", "random, 100,000 sizes from the origin", {0, 1e5}},
    trade_family{"small", "random, scaled by 2^-50 (about 1e-15)", {-50, 0}},
    trade_family{"large", "random, scaled by 2^40 (about 1e12)", {40, 0}},
    trade_family{"near", "a contact, moved by 1 to 2^-60 of the size", {0, 0, true, 0, nearest_bits}},
    trade_family{"near_far", "the same, 1,000 sizes from the origin", {0, 1e3, true, 0, nearest_bits}},
};

// At most `most` candidates of two sets, spread evenly over all of them. The predicate's kinds are those of the sets.
element_pairs candidates_of(const predicate_info &p, const io::element_set &a, const io::element_set &b,
                            std::size_t most);

} // namespace meetc::bench

#endif
