// What all blocks of a kernel compute together: the device's own code, with a stand-in for the warp that a block has here.
#include "tests/runtime/device/host_warp.hpp"

#include "meetc/cuda_grid.hpp"
#include "meetc/tree_order.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <random>
#include <vector>

using namespace meetc::cuda;

TEST_CASE("grid: running sums over the chunks of all blocks are those over all numbers") {
  constexpr unsigned threads = host_warp::width;
  static unsigned room[threads / 32];
  std::mt19937_64 random(5);
  for (const unsigned blocks : {1U, 2U, 7U, 32U})
    for (const std::uint32_t n : {1U, 31U, 32U, 33U, 64U, 1000U, 5001U}) {
      std::vector<std::uint32_t> numbers(n), want(n);
      std::vector<unsigned long long> totals(blocks, 0);
      std::uint32_t sum = 0;
      for (std::uint32_t i = 0; i < n; ++i) {
        numbers[i] = static_cast<std::uint32_t>(random() % 5);
        want[i] = sum;
        sum += numbers[i];
      }
      for (unsigned block = 0; block < blocks; ++block) // a block waits for those before it alone
        host_warp::the_warp.run([&] {
          running_sums{numbers.data(), n, totals.data(), block, blocks}.sum<threads>(room);
        });
      INFO(n << " numbers, " << blocks << " blocks");
      CHECK(numbers == want);
      for (unsigned block = 0; block < blocks; ++block)
        host_warp::the_warp.run([&] { running_sums{numbers.data(), n, totals.data(), block, blocks}.clear(); });
      CHECK(totals == std::vector<unsigned long long>(blocks, 0));
    }
}

// Elements in any order within their cells.
TEST_CASE("grid: an element's place in the order is that of a sort, where its cell is not too long") {
  constexpr int place_bits = 6, cell_bits = 3;
  std::mt19937_64 random(7);
  const auto cell = [](std::uint64_t element) { return cell_of(element, place_bits, cell_bits); };
  for (const std::uint32_t n : {1U, 2U, 40U, 400U})
    for (const std::uint32_t most : {3U, 60U, 1000U}) {
      std::vector<std::uint64_t> sorted(n);
      for (std::uint32_t i = 0; i < n; ++i)
        sorted[i] = in_order(static_cast<std::uint32_t>(random() % 60), i);
      std::sort(sorted.begin(), sorted.end());
      std::vector<std::uint64_t> by_cell = sorted;
      for (std::uint32_t begin = 0, end = 0; begin < n; begin = end) {
        while (end < n && cell(sorted[end]) == cell(sorted[begin]))
          ++end;
        std::shuffle(by_cell.begin() + begin, by_cell.begin() + end, random);
        for (std::uint32_t k = begin; k < end; ++k) {
          const place_in_order to([&](std::uint32_t i) { return by_cell[i]; }, cell, n, k, most);
          if (end - begin > most) {
            CHECK((to.end - to.begin > most && to.slot == k && !to.crowded));
            continue;
          }
          CHECK((to.begin == begin && to.end == end && sorted[to.slot] == by_cell[k]));
          const std::uint64_t place = by_cell[k] >> 32;
          const auto before = std::count_if(sorted.begin(), sorted.begin() + to.slot,
                                            [&](std::uint64_t e) { return e >> 32 == place; });
          CHECK(to.crowded == (before >= tree_width));
        }
      }
    }
}
