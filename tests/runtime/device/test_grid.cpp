// What all blocks of a kernel compute together: the device's own code, with a stand-in for the warp that a block has here.
#include "tests/runtime/device/host_warp.hpp"

#include "meetc/cuda_grid.hpp"
#include "tests/catch.hpp"

#include <random>
#include <vector>

using namespace meetc::cuda;

TEST_CASE("grid: running sums over the chunks of all blocks are those over all numbers") {
  constexpr unsigned threads = host_warp::width;
  static unsigned room[threads / 32], starts[threads];
  std::mt19937_64 random(5);
  for (const unsigned blocks : {1U, 2U, 7U, 32U})
    for (const std::uint32_t n : {1U, 31U, 32U, 33U, 64U, 1000U, 5001U}) {
      std::vector<std::uint32_t> numbers(n), totals(blocks, ~0U), want(n);
      std::uint32_t sum = 0;
      for (std::uint32_t i = 0; i < n; ++i) {
        numbers[i] = static_cast<std::uint32_t>(random() % 5);
        want[i] = sum;
        sum += numbers[i];
      }
      gridDim.x = blocks;
      const running_sums sums{numbers.data(), n, totals.data()};
      for (blockIdx.x = 0; blockIdx.x < blocks; ++blockIdx.x)
        host_warp::the_warp.run([&] { sums.sum_chunk<threads>(room); });
      INFO(n << " numbers, " << blocks << " blocks");
      for (blockIdx.x = 0; blockIdx.x < blocks; ++blockIdx.x) { // each block sees the same
        host_warp::the_warp.run([&] { sums.sum_totals<threads>(room, starts); });
        bool same = true;
        for (std::uint32_t i = 0; i < n; ++i)
          same = same && sums.at(starts, sums.shift(), i) == want[i];
        CHECK(same);
      }
      CHECK(starts[blocks - 1] + totals[blocks - 1] == sum);
    }
  gridDim.x = 1, blockIdx.x = 0;
}
