// bench/tables/gpu/measure.hpp: the tables of `meet bench gpu`: kernels and queries on the CUDA device, with the classic tests.
#ifndef MEETC_BENCH_TABLES_GPU_MEASURE_HPP
#define MEETC_BENCH_TABLES_GPU_MEASURE_HPP

#include "meet/bench/baselines/gpu_baselines.hpp"
#include "meet/bench/harness/device_clock.hpp"
#include "meet/bench/harness/method.hpp"
#include "meet/bench/harness/table.hpp"
#include "meet/bench/scenes/scenes.hpp"
#include "meet/core/device/collide.hpp"
#include "meet/core/device/every_pair/engine.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace meetc::bench {

struct sets_here;

class gpu_bench {
public:
  // Throws device_error, as do all members.
  explicit gpu_bench(const scene_source &from);

  std::string device_in_words();
  table measure(const scene &of);
  table measure_tangent();
  // These call `progress` after each scene.
  //
  // Queries as sets grow, and every pair beside them where that is quick.
  table measure_growth(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // Queries of sets that do not lie evenly, beside those of sets that do.
  table measure_hard(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // A hierarchy of the usual kind beside ours.
  table measure_lbvh(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // The first triangles that segments meet, beside the nearest hits of a hierarchy of the usual kind.
  table measure_first(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // Where pairs meet, and where meshes cross themselves, beside the CPU.
  table measure_contacts(const std::vector<scene> &scenes, const std::function<void()> &progress);
  table measure_self(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // The same queries on one device of this host and on all of them. Throws app::failure where there is one.
  table measure_group(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // Queries on sets as they are given, beside the time that reading both sets once takes.
  table measure_memory(const std::vector<scene> &scenes, const std::function<void()> &progress);
  // So many values of formulas, beside the least that moving their numbers takes.
  table measure_formulas(std::size_t values);
  // One mesh against another in many poses, of three classes and mixed.
  table measure_poses(const posed_meshes &meshes);
  // So many bodies that move before each question, on the device and on the CPU.
  table measure_bodies(std::size_t count, int frames);

private:
  struct counted_pairs {
    std::optional<std::uint64_t> found; // empty where only a part of b was taken
    double seconds;                     // scaled to all pairs
  };
  struct filtered {
    std::uint64_t found;
    double seconds, hertz;
  };
  // The answer of a query with the device's seconds, or with medians of these and of a query with transfers.
  struct asked {
    std::uint64_t found;
    double device_seconds;
  };
  struct whole_query {
    std::uint64_t found;
    double seconds, with_transfers;
  };
  struct given_times {
    std::uint64_t found;
    double device, wall; // medians of seconds
  };
  struct query_times;

  // Certified, of the scene's sets as they are given, with the sorted pairs left on the device.
  given_times time_given(const sets_here &sets);
  query_times time_query(const scene &of, bool beside_every_pair);
  counted_pairs count(baseline by, const device_set &a, const device_set &b);
  std::uint64_t counted_on_device();
  filtered filter_alone(every_pair::filter f, device_set &a, device_set &b);
  whole_query query(const std::string &what, const std::function<asked(device_set &a, device_set &b)> &ask,
                    const prepared &a, const prepared &b, device_set &on_a, device_set &on_b);

  const scene_source source_;
  const catalogue &all_;
  device on_;
  every_pair::engine every_pair_;
  device_clock timer_;
  device_memory<index_pair> list_;
  device_memory<unsigned long long> counts_;
};

} // namespace meetc::bench

#endif
