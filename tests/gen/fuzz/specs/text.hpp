// Specs drawn at random: a shipped algebra with some kernels of its scene, a few of whose bytes, words, lines or values of
// TOML are replaced.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace meetc::fuzz {

struct drawn_spec {
  std::string algebra, scene; // a.toml and s.toml
};

// The material of mutants. An algebra that imports is taken with the paths of what it imports made absolute.
struct spec_seed {
  std::string algebra;
  std::vector<std::string> kernels;
};

std::vector<spec_seed> read_spec_seeds(const std::string &algebra_spec);

// The same for the same seed and index, on any machine.
drawn_spec draw_spec(const std::vector<spec_seed> &seeds, std::uint64_t seed, std::uint64_t index);

} // namespace meetc::fuzz
