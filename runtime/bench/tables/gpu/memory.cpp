// How far queries are from the time in which the memory gives both sets once.
#include "app/sets.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "core/find.hpp"

namespace meetc::bench {

namespace {

constexpr int runs = 7;

// The bytes of a set as it is given: of a mesh its vertices and its indices.
std::size_t bytes_of(const io::element_set &s) {
  return s.data.size() * sizeof s.data[0] + s.index.size() * sizeof s.index[0];
}

} // namespace

table gpu_bench::measure_memory(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress) {
  table t;
  t.name = "memory";
  t.title = "How far queries are from reading both sets once";
  t.columns = {{"scene", "scene"},
               {"pairs", "pairs"},
               {"bytes", "bytes|of both"},
               {"read", "both read|once, ms"},
               {"bytes_a_second", "read,|GB/s"},
               {"given", "given:|all of it, ms"},
               {"of_reading", "given /|read once"}};
  t.notes.emplace_back("Both read once: a kernel that reads as many bytes as both sets have as they were uploaded, "
                       "side by side, and does "
                       "nothing with them. It is warm as the queries are: what fits into the second-level cache is "
                       "read from there, and a "
                       "small set takes no longer than a kernel takes to start. Given: as in `--only growth`.");
  for (const gpu_scene &scene : scenes) {
    const auto [first, second] = scene.make();
    const io::element_set &b = scene.itself ? first : second;
    const given_times given = time_given(scene, first, b, find_predicate(all_, scene.predicate));
    const std::size_t bytes = bytes_of(first) + (scene.itself ? 0 : bytes_of(b)), n = bytes / sizeof(uint4);
    device_memory<uint4> both;
    device_memory<unsigned> unused;
    both.reserve(n, "as many bytes as both sets have");
    unused.reserve(1, "a number");
    check(cudaMemsetAsync(both.data(), 0, n * sizeof(uint4), on_.stream()), "clearing memory");
    const double read =
        timer_.seconds([&] { check(read_all(both.data(), n, unused.data(), on_.stream()), "starting to read"); }, runs);
    t.rows.push_back({of_words(scene.name), of_count(given.found), of_count(bytes), of_milliseconds(read),
                      of_count(static_cast<std::uint64_t>(static_cast<double>(bytes) / read / 1e9)),
                      of_milliseconds(given.device), of_ratio(given.device / read)});
    progress();
  }
  return t;
}

} // namespace meetc::bench
