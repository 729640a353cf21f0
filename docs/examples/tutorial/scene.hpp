// scene.hpp: the arm and the balls of the programs in this folder.
#pragma once

#include <cell/cell.hpp>
#include <cstdio>
#include <meet/meet.hpp>
#include <vector>

// An arm of three links that are 1/4 thick.
inline constexpr cell::capsule<float> arm[] = {
    {{0, 0, 0}, {0, 0, 2}, 0.25F}, {{0, 0, 2}, {2, 0, 2}, 0.25F}, {{2, 0, 2}, {2, 2, 2}, 0.25F}};

// 9 x 9 x 9 balls of radius 1/4, a half apart from each other.
inline std::vector<cell::sphere<float>> lattice() {
  std::vector<cell::sphere<float>> balls;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = 0; k <= 8; ++k)
        balls.push_back(
            {{0.5F * static_cast<float>(i), 0.5F * static_cast<float>(j), 0.5F * static_cast<float>(k)}, 0.25F});
  return balls;
}

inline void print(const std::vector<meet::index_pair> &pairs) {
  std::size_t of_link[3] = {};
  for (const meet::index_pair &pair : pairs)
    ++of_link[pair.b];
  std::printf("%zu pairs: %zu %zu %zu\n", pairs.size(), of_link[0], of_link[1], of_link[2]);
}
