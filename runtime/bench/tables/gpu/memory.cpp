// The times of queries beside the time in which the memory gives both sets once.
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"

namespace meetc::bench {

namespace {

constexpr int runs = 7;

// The bytes of a set as it is given: of a mesh its vertices and its indices.
std::size_t bytes_of(const io::element_set &s) {
  return s.data.size() * sizeof s.data[0] + s.index.size() * sizeof s.index[0];
}

struct row {
  std::string scene;
  std::uint64_t found, bytes;
  double read, given;

  auto gigabytes_a_second() const { return static_cast<std::uint64_t>(static_cast<double>(bytes) / read / 1e9); }
};

} // namespace

table gpu_bench::measure_memory(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  std::vector<row> rows;
  for (const scene &of : scenes) {
    const sets_here sets(of, all_);
    const given_times given = time_given(sets);
    const std::size_t bytes = bytes_of(sets.a()) + (of.itself ? 0 : bytes_of(sets.b())), n = bytes / sizeof(uint4);
    device_memory<uint4> both;
    device_memory<unsigned> unused;
    both.reserve(n, "as many bytes as both sets have");
    unused.reserve(1, "a number");
    check(cudaMemsetAsync(both.data(), 0, n * sizeof(uint4), on_.stream()), "clearing memory");
    const double read =
        timer_.seconds([&] { check(read_all(both.data(), n, unused.data(), on_.stream()), "starting to read"); }, runs);
    rows.push_back({of.name, given.found, bytes, read, given.device});
    progress();
  }
  return table_of<row>("memory", "How far queries are from reading both sets once",
                       {{"scene", "scene", of_words, &row::scene},
                        {"pairs", "pairs", of_count, &row::found},
                        {"bytes", "bytes|of both", of_count, &row::bytes},
                        {"read", "both read|once, ms", of_milliseconds, &row::read},
                        {"bytes_a_second", "read,|GB/s", of_count, &row::gigabytes_a_second},
                        {"given", "given:|all of it, ms", of_milliseconds, &row::given},
                        {"of_reading", "given /|read once", [](const row &r) { return of_ratio(r.given / r.read); }}},
                       rows,
                       {"Both read once: a kernel that reads as many bytes as both sets have as they were uploaded, "
                        "side by side, and does "
                        "nothing with them. It is warm as the queries are: what fits into the second-level cache is "
                        "read from there, and a "
                        "small set takes no longer than a kernel takes to start. Given: as in `--only growth`."});
}

} // namespace meetc::bench
