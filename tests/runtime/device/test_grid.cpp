// What all blocks of a kernel compute together: the device's own code, with a stand-in for the warp that a block has here.
#include "tests/runtime/device/host_warp.hpp"

#include "meetc/cuda_grid.hpp"
#include "tests/catch.hpp"

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
