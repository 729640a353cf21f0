// bench/tables/gpu/measure.hpp: one table of `meet bench gpu`: kernels and queries on the CUDA device, with the classic tests.
#ifndef MEETC_BENCH_TABLES_GPU_MEASURE_HPP
#define MEETC_BENCH_TABLES_GPU_MEASURE_HPP

#include "bench/baselines/gpu_baselines.hpp"
#include "bench/harness/gpu_timer.hpp"
#include "bench/harness/table.hpp"
#include "bench/scenes/gpu_scenes.hpp"
#include "core/device/every_pair/engine.hpp"
#include "core/device/given.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace meetc::bench {

class gpu_bench {
public:
  // Throws device_error, as do all members.
  gpu_bench(const catalogue &all, bool quick);

  std::string device_in_words();
  table measure(const gpu_scene &scene);
  table measure_tangent();
  // Times a query, and every pair beside it where that is quick. Calls `progress` after each scene.
  table measure_searches(const std::string &name, const std::string &title, const std::vector<gpu_scene> &scenes,
                         const std::function<void()> &progress);
  // Times a hierarchy of the usual kind beside ours, likewise.
  table measure_lbvh(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress);
  // What segments meet first, beside the nearest hits of a hierarchy of the usual kind, likewise.
  table measure_first(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress);
  // The same queries on one device of this host and on all of them, likewise. Throws app::failure where there is one.
  table measure_group(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress);
  // Queries on sets as they are given, beside the time that reading both sets once takes, likewise.
  table measure_memory(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress);
  // One mesh against another in many poses, of three classes and mixed.
  table measure_poses(const posed_meshes &meshes);

private:
  struct counted_pairs {
    std::optional<std::uint64_t> found; // empty where only a part of b was taken
    double seconds;                     // scaled to all pairs
  };
  struct filtered {
    std::uint64_t found;
    double seconds, hertz;
  };
  struct whole_query {
    std::uint64_t found;
    double seconds, with_transfers;
  };

  struct given_times {
    std::uint64_t found;
    double device, wall; // medians of seconds
  };

  // Certified, of the scene's sets as they are given, with the sorted pairs left on the device.
  given_times time_given(const gpu_scene &scene, const io::element_set &a, const io::element_set &b,
                         const predicate_info &p);
  counted_pairs count(baseline by, const device_set &a, const device_set &b);
  std::uint64_t counted_on_device();
  filtered filter_alone(every_pair::filter f, device_set &a, device_set &b);
  // `ask` gives the pairs of two sets, and the device's seconds.
  struct counted {
    std::uint64_t found;
    double device_seconds;
  };
  whole_query query(const std::function<counted(device_set &a, device_set &b)> &ask, const prepared &a,
                    const prepared &b, device_set &on_a, device_set &on_b);

  const catalogue &all_;
  bool quick_;
  device on_;
  every_pair::engine every_pair_;
  gpu_timer timer_;
  device_memory<index_pair> list_;
  device_memory<unsigned long long> counts_;
};

} // namespace meetc::bench

#endif
