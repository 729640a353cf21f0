// Keys that the blocks of a kernel put into order together: the device's own code, with a stand-in for the warp that a block
// has here. A block does a step after another one has done it; what they do at once, a device tests.
#include "tests/runtime/device/host/host_warp.hpp"

#include "meetc/cuda/distribute.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using namespace meetc::cuda;

namespace {

constexpr unsigned threads = host_warp::width;

struct scene {
  const char *name;
  int key_bits;
  std::vector<std::uint64_t> keys;
};

std::vector<std::uint64_t> different(std::mt19937_64 &random, std::uint32_t n, std::uint64_t low, std::uint64_t below) {
  std::set<std::uint64_t> all;
  while (all.size() < n)
    all.insert(low + random() % (below - low));
  std::vector<std::uint64_t> out(all.begin(), all.end());
  std::shuffle(out.begin(), out.end(), random);
  return out;
}

std::vector<scene> scenes(std::mt19937_64 &random) {
  std::vector<scene> out;
  for (const std::uint32_t n : {1U, 31U, 32U, 33U, 1000U, 9000U, 40'000U})
    out.push_back({"even", 40, different(random, n, 0, 1ULL << 40)});
  out.push_back({"64 bits", 64, different(random, 3000, 0, ~0ULL)});
  out.push_back({"all there are", 11, different(random, 1U << 11, 0, 1U << 11)});
  out.push_back({"in one cell", 62, different(random, 9000, 1ULL << 40, (1ULL << 40) + (1ULL << 49))});
  out.push_back({"many in one cell", 62, different(random, 20'000, 1ULL << 40, (1ULL << 40) + (1ULL << 49))});
  scene both{"near each other and far away", 50, different(random, 2000, 0, 1ULL << 50)};
  for (const std::uint64_t key : different(random, 8000, 1ULL << 49, (1ULL << 49) + (1ULL << 36)))
    both.keys.push_back(key);
  std::sort(both.keys.begin(), both.keys.end());
  both.keys.erase(std::unique(both.keys.begin(), both.keys.end()), both.keys.end());
  std::shuffle(both.keys.begin(), both.keys.end(), random);
  out.push_back(both);
  return out;
}

// All windows, one after another. Each is taken with some keys before it, which are left out here.
std::vector<std::uint64_t> windows(const scene &s, unsigned blocks, bool sparse, std::uint32_t window, bool &ordered) {
  using distributes = distributing<threads>;
  const auto n = static_cast<std::uint32_t>(s.keys.size());
  std::vector<std::uint64_t> keys(n), by_cell(n), out;
  std::vector<std::uint32_t> counted(counted_to_distribute);
  const distribution d{keys.data(), by_cell.data(), n, counted.data()};
  std::vector<distributes::room> rooms(blocks);
  const auto each_block = [&](auto &&step) {
    for (unsigned block = 0; block < blocks; ++block)
      host_warp::the_blocks.run([&] {
        distributes mine(d, s.key_bits, sparse, block, blocks, rooms[block]);
        step(mine, block);
      });
  };
  each_block([&](distributes &mine, unsigned) {
    mine.count<2>([&](const std::uint32_t(&i)[2], const bool(&there)[2], std::uint64_t(&key)[2]) {
      for (int k = 0; k < 2; ++k)
        if (there[k])
          key[k] = s.keys[i[k]];
    });
  });
  each_block([](distributes &mine, unsigned) { mine.distribute(); });
  std::vector<std::uint64_t> there = by_cell, given = s.keys;
  std::sort(there.begin(), there.end()), std::sort(given.begin(), given.end());
  CHECK((there == given));
  each_block([](distributes &mine, unsigned) { mine.clear(); });
  CHECK(std::all_of(counted.begin(), counted.end(), [](std::uint32_t c) { return c == 0; }));
  ordered = true;
  for (std::uint32_t first = 0; first < n; first += window) {
    const std::uint32_t block = first / window % blocks, last = std::min(n, first + window),
                        before = std::min(first, sparse ? 32U : 0U);
    unsigned said = 0;
    host_warp::the_blocks.run([&] {
      distributes mine(d, s.key_bits, sparse, block, blocks, rooms[block]);
      said += mine.window(first - before, last) ? 1 : 0;
    });
    CHECK((said == 0 || said == threads));
    ordered &= said > 0;
    out.insert(out.end(), rooms[block].keys + before, rooms[block].keys + before + (last - first));
  }
  // And each block's own share.
  std::vector<std::uint64_t> written(n, ~0ULL);
  unsigned said = 0, writes = 0;
  each_block([&](distributes &mine, unsigned) {
    said += mine.each_in_order([&](std::uint32_t at, std::uint64_t key) { written[at] = key, ++writes; }) ? 1 : 0;
  });
  CHECK(said % threads == 0);
  CHECK((said < blocks * threads || (written == given && writes == n)));
  ordered &= said == blocks * threads;
  return out;
}

} // namespace

TEST_CASE("distribute: the windows of keys that blocks put into order follow each other") {
  std::mt19937_64 random(5);
  for (const scene &s : scenes(random)) {
    std::vector<std::uint64_t> want = s.keys;
    std::sort(want.begin(), want.end());
    for (const unsigned blocks : {1U, 3U, 32U})
      for (const bool sparse : {false, true})
        for (const std::uint32_t window : {2500U, most_of_window}) {
          bool ordered = false;
          const std::vector<std::uint64_t> found = windows(s, blocks, sparse, window, ordered);
          INFO(s.name << ", " << want.size() << " keys, " << blocks << " blocks, windows of " << window);
          CHECK(ordered);
          CHECK((found == want));
        }
  }
}

TEST_CASE("distribute: keys too near each other have no order") {
  std::mt19937_64 random(6);
  std::vector<std::uint64_t> near(most_alike + 1), many(most_near_window + 1);
  std::iota(near.begin(), near.end(), 1ULL << 40), std::iota(many.begin(), many.end(), 1ULL << 40);
  near.push_back(0), near.push_back(1ULL << 45);
  std::shuffle(near.begin(), near.end(), random);
  bool ordered = true;
  windows({"one finer cell", 62, near}, 2, false, 4096, ordered);
  CHECK_FALSE(ordered);
  ordered = true;
  windows({"one cell", 62, many}, 4, false, 4096, ordered);
  CHECK_FALSE(ordered);
  // As many, all over their cell, so that nothing else refuses them.
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = i * ((1ULL << 51) / many.size());
  ordered = true;
  windows({"one cell, evenly", 62, many}, 4, false, 4096, ordered);
  CHECK_FALSE(ordered);
  many.resize(most_near_window);
  ordered = false;
  windows({"one cell, evenly, and one fewer", 62, many}, 4, false, 4096, ordered);
  CHECK(ordered);
  // Finer cells of 2000 keys, of which more reach into a window than a block has room for.
  std::vector<std::uint64_t> coarse;
  for (std::uint64_t key = 0; key < 16'000; ++key)
    coarse.push_back((key / 2000 << 48) + key);
  ordered = true;
  windows({"a few finer cells", 62, coarse}, 32, false, most_of_tile - 100, ordered);
  CHECK_FALSE(ordered);
}
