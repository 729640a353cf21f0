// The rung tolerant against the exact one: how often they differ, and how far a differing answer is from being right.
#ifndef MEETC_TESTS_GENERATED_TOLERANT_CAMPAIGN_HPP
#define MEETC_TESTS_GENERATED_TOLERANT_CAMPAIGN_HPP

#include "meetc/support.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace meetc::tolerant_test {

enum class family {
  random,   // points in a cube
  near,     // around a contact, moved by 2^-k
  needle,   // the corners of an element nearly on one line, near the other element
  parallel, // an edge of each nearly parallel, near each other
  far,      // around a contact, near a corner of the box
  large     // around a contact, as large as the box
};
inline constexpr family families[] = {family::random,   family::near, family::needle,
                                      family::parallel, family::far,  family::large};
const char *name_of(family f);

inline constexpr double widest = 8; // before they are scaled to the reach

struct rows {
  std::vector<float> a, b; // pair i is row i with row i
  std::size_t count = 0;
};
// Pairs of a predicate with all numbers within a reach (tolerance_info::reach); the same on every machine.
rows make(const predicate_info &p, family f, std::size_t n, std::uint64_t seed, double reach = widest);

struct tally {
  std::uint64_t pairs = 0, hits = 0, differing = 0;
  double farthest = 0; // of the differing answers, by how much one element must be moved to make the answer right
};

// The tolerant answers, on rows that are rounded first where the rung rounds.
std::vector<answer> tolerant_answers(const predicate_info &p, rows r);
// `exact`: the same predicate with the rung exact.
tally compare(const predicate_info &p, const predicate_info &exact, const rows &r);

struct subject {
  std::string scene;
  const predicate_info *tolerant, *exact;
};
// Every predicate of the scenes.
std::vector<subject> subjects();

} // namespace meetc::tolerant_test

#endif
