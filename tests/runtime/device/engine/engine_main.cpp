// Whole queries on the device against the CPU's:
//   test_cuda_pairs [--small] [--seed N] [--part NAME] [--data FOLDER], the parts as in `parts` below, or reset
#include "engine.hpp"

#include "tests/runtime/device/kernels/cuda_test.hpp"

#include <cga/cga_cuda.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace {

using namespace cuda_test;

struct part {
  const char *name;
  void (*run)(comparison &, const settings &);
};
constexpr part parts[] = {{"pairs", pair_scenes},       {"again", again_scenes},  {"every_pair", every_pair_scenes},
                          {"made", made_scenes},        {"orders", order_scenes}, {"given", given_scenes},
                          {"poses", pose_scenes},       {"ends", end_scenes},     {"group", group_scenes},
                          {"device", device_scenes},    {"words", word_scenes},   {"formulas", formula_scenes},
                          {"contacts", contact_scenes}, {"self", self_scenes},    {"bodies", body_scenes},
                          {"stops", stop_scenes}};

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
  return s.part.empty() || s.part == "reset" ||
         std::any_of(std::begin(parts), std::end(parts), [&s](const part &p) { return s.part == p.name; });
}

} // namespace

int main(int argc, char **argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12); // what was found is seen also where the run is cut off
  settings s;
  if (!read(argc, argv, s)) {
    std::fputs("usage: test_cuda_pairs [--small] [--seed N] [--data FOLDER] [--part reset", stderr);
    for (const part &p : parts)
      std::fprintf(stderr, "|%s", p.name);
    std::fputs("]\n", stderr);
    return 2;
  }
  if (no_device())
    return skipped;
  try {
    if (s.data.empty() && (s.part.empty() || s.part == "reset")) {
      const bool answers = answers_after_reset();
      std::printf("a device that was reset answers %s\n", answers ? "as before" : "otherwise: DIFFERENT");
      if (!answers || !s.part.empty())
        return answers ? 0 : 1;
    }
    meetc::device on(cga::cuda::catalogue());
    comparison with(on);
    const meetc::every_pair::probe_result &probe = with.every_pair().probe();
    std::printf(
        "%s, %d.%d; of %u probe cases a unit mma.sync left the model in %u, wgmma (%s) in %u; best filter: %s\n",
        on.facts().name.c_str(), on.facts().major, on.facts().minor, probe.cases, probe.mma_faults,
        probe.has_wgmma ? "there" : "not there", probe.wgmma_faults, name_of(with.every_pair().best_filter()));
    if (s.data.empty()) {
      for (const part &p : parts)
        if (s.part.empty() || s.part == p.name)
          p.run(with, s);
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
