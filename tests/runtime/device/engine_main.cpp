// Whole queries on the device against the CPU's:
//   test_cuda_pairs [--small] [--seed N] [--part pairs|made|orders|given|poses|ends|group|words] [--data FOLDER]
#include "engine.hpp"

#include "cuda_test.hpp"

#include <cga/cga_cuda.hpp>

#include <cstdlib>
#include <cstring>

namespace {

bool read(int argc, char **argv, cuda_test::settings &s) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--small") == 0) {
      s.small = true;
      continue;
    }
    if (i + 1 == argc)
      return false;
    if (std::strcmp(argv[i], "--seed") == 0)
      s.seed = std::strtoull(argv[++i], nullptr, 10);
    else if (std::strcmp(argv[i], "--data") == 0)
      s.data = argv[++i];
    else if (std::strcmp(argv[i], "--part") == 0)
      s.part = argv[++i];
    else
      return false;
  }
  return s.part.empty() || s.part == "pairs" || s.part == "made" || s.part == "orders" || s.part == "given" ||
         s.part == "poses" || s.part == "ends" || s.part == "group" || s.part == "words";
}

} // namespace

int main(int argc, char **argv) {
  using namespace cuda_test;
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12); // what was found is seen also where the run is cut off
  settings s;
  if (!read(argc, argv, s)) {
    std::fputs(
        "usage: test_cuda_pairs [--small] [--seed N] [--part pairs|made|orders|given|poses|ends|group|words] [--data "
        "FOLDER]\n",
        stderr);
    return 2;
  }
  if (no_device())
    return skipped;
  try {
    meetc::device on(cga::cuda::catalogue());
    const meetc::cuda::probe_result &probe = on.probe();
    std::printf(
        "%s, %d.%d; of %u probe cases a unit mma.sync left the model in %u, wgmma (%s) in %u; best filter: %s\n",
        on.facts().name.c_str(), on.facts().major, on.facts().minor, probe.cases, probe.mma_faults,
        probe.has_wgmma ? "there" : "not there", probe.wgmma_faults, name_of(on.best_filter()));
    comparison with(on);
    if (s.data.empty()) {
      const auto scenes = [&](const char *part, void (*run)(comparison &, const settings &)) {
        if (s.part.empty() || s.part == part)
          run(with, s);
      };
      scenes("pairs", pair_scenes), scenes("made", made_scenes), scenes("orders", order_scenes),
          scenes("given", given_scenes), scenes("poses", pose_scenes), scenes("ends", end_scenes),
          scenes("group", group_scenes), scenes("words", word_scenes);
    } else {
      mesh_scenes(with, s);
    }
    with.print();
    std::printf("%ld differences\n", with.differences());
    return with.differences() ? 1 : 0;
  } catch (const std::exception &e) {
    std::printf("error: %s\n", e.what());
    return 1;
  }
}
