// Many bodies that have all moved: on the CPU, and on the device that holds them.
#include "meet/app/text/words.hpp"
#include "meet/bench/scenes/many_bodies.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/core/device/world.hpp"

#include <fmt/format.h>

namespace meetc::bench {

table gpu_bench::measure_bodies(std::size_t count, int frames) {
  many_bodies scene(all_, count, 0);
  device_world there(on_, scene.bodies());
  world_answer by_cpu, by_device;
  std::uint64_t near = 0, touching = 0;
  difference differs;
  static_cast<void>(there.touching()); // uploads the bodies
  const auto [cpu_pose, cpu_collide, pose, collide] = medians_of<4>(frames, [&] {
    scene.move_all();
    by_cpu = scene.bodies().touching();
    by_device = there.touching();
    near = by_cpu.near, touching = by_cpu.touching.size();
    differs = difference_of(touching_pairs(by_device), touching_pairs(by_cpu));
    require_truth("bodies", "the device", differs);
    return std::array{by_cpu.pose_seconds, by_cpu.collide_seconds, by_device.pose_seconds, by_device.collide_seconds};
  });
  struct row {
    std::string name;
    double move, collide;
    std::uint64_t candidates;
    double both() const { return move + collide; }
  };
  return table_of<row>(
      "bodies",
      fmt::format("Many bodies: {} of {} triangles each, all moved", count, app::grouped(scene.faces().elements)),
      {{"method", "bodies on", of_words, &row::name},
       {"move_ms", "move,|ms", of_milliseconds, &row::move},
       {"collide_ms", "collide,|ms", of_milliseconds, &row::collide},
       {"both_ms", "both,|ms", of_milliseconds, &row::both},
       {"candidates", "candidates", of_count, &row::candidates}},
      std::vector<row>{{"the CPU, all cores", cpu_pose, cpu_collide, by_cpu.candidates},
                       {"the device", pose, collide, by_device.candidates}},
      {fmt::format(
          "The wall clock's medians of {} frames, in each of which every body has moved; in the last one {} pairs of "
          "bodies were near each other, and {} touched. The device holds the bodies, and gets poses; its counts of "
          "pairs come to the host. In each frame they were the CPU's.",
          frames, near, touching)});
}

} // namespace meetc::bench
