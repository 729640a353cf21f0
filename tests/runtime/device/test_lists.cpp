// How a warp appends to lists: the device's own code, on the host.
#include "tests/runtime/device/host/host_warp.hpp"

#include "meetc/cuda/lists.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;

namespace {

using pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The marks of every lane in each of several rounds, four pairs at a time.
struct marked_pairs {
  unsigned marks;
  index_pair of[4];
};

constexpr unsigned rounds = 7;

std::vector<marked_pairs> random_marks(std::mt19937_64 &random, unsigned of_16) {
  std::vector<marked_pairs> out(rounds * host_warp::width);
  for (marked_pairs &m : out) {
    m.marks = 0;
    for (unsigned k = 0; k < 4; ++k) {
      m.marks |= static_cast<unsigned>(random() % 16 < of_16) << k;
      m.of[k] = {static_cast<std::uint32_t>(random() % 9), static_cast<std::uint32_t>(random() % 9)};
    }
  }
  return out;
}

} // namespace

TEST_CASE("lists: every marked pair is appended once, or both ways, and no more than there is room for") {
  std::mt19937_64 random(3);
  for (const auto &[waits, by_block] : {std::pair(false, false), std::pair(true, false), std::pair(true, true)})
    for (const bool both_ways : {false, true})
      for (const unsigned of_16 : {0U, 1U, 7U, 16U})
        for (const std::size_t capacity : {std::size_t{0}, std::size_t{50}, std::size_t{10'000}}) {
          const std::vector<marked_pairs> all = random_marks(random, of_16);
          pairs expected;
          for (const marked_pairs &m : all)
            for (unsigned k = 0; k < 4; ++k)
              if (m.marks >> k & 1) {
                expected.emplace_back(m.of[k].a, m.of[k].b);
                if (both_ways && m.of[k].a != m.of[k].b)
                  expected.emplace_back(m.of[k].b, m.of[k].a);
              }
          constexpr index_pair untouched{0xffffffff, 0xffffffff};
          std::vector<index_pair> list(capacity + 64, untouched);
          unsigned long long count = 0;
          const pair_list to{list.data(), &count, capacity, both_ways};
          static index_pair room[256];
          host_warp::the_blocks.run([&] {
            waiting_list<256> waiting(to, room);
            for (unsigned r = 0; r < rounds; ++r) {
              const marked_pairs &m = all[r * host_warp::width + threadIdx.x];
              waits ? waiting.append(m.marks, m.of) : append_hits(m.marks, m.of, to);
            }
            by_block ? waiting.flush_block<1>() : waiting.flush();
          });
          INFO((waits ? "waiting" : "at once")
               << (both_ways ? ", both ways, " : ", ") << of_16 << " of 16, room for " << capacity);
          CHECK(count == expected.size());
          CHECK(std::all_of(list.begin() + static_cast<std::ptrdiff_t>(capacity), list.end(),
                            [&](index_pair p) { return p.a == untouched.a && p.b == untouched.b; }));
          pairs found;
          for (std::size_t i = 0; i < std::min<std::size_t>(count, capacity); ++i)
            found.emplace_back(list[i].a, list[i].b);
          std::sort(found.begin(), found.end());
          std::sort(expected.begin(), expected.end());
          CHECK((capacity < expected.size() || found == expected));
          CHECK(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
        }
}
