// Real meshes with known counts, if they are available.
#include "fixture.hpp"

#include <chrono>

namespace {

struct known {
  const char *name;
  std::size_t vertices, triangles;
};

constexpr known meshes[] = {
    {"bunny_69k", 35947, 69451},        {"bunny_5k", 2549, 4999},         {"bunny_1k", 517, 1000},
    {"armadillo_345k", 172974, 345944}, {"armadillo_100k", 49990, 99976}, {"armadillo_20k", 10002, 20000},
    {"armadillo_5k", 2502, 5000},       {"dragon_48k", 22998, 47794},     {"happy_20k", 9990, 20000},
    {"fandisk_13k", 6475, 12946},       {"rockerarm_20k", 10044, 20088},  {"cycloidal_43k", 21384, 43368},
    {"beetle_39k", 19887, 38656},       {"fcl_env_2k", 6540, 2180},       {"fcl_rob_216", 648, 216},
};

} // namespace

TEST_CASE("real meshes have their known counts", "[data]") {
  namespace fs = std::filesystem;
  for (const known &mesh : meshes) {
    const fs::path path = fs::path(MEETC_DATA) / (std::string(mesh.name) + ".ply");
    if (!fs::exists(path))
      continue;
    INFO(mesh.name);
    const auto start = std::chrono::steady_clock::now();
    const auto set = meetc::io::read(path, fixture::kinds);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    CHECK(set.vertices == mesh.vertices);
    CHECK(set.items == mesh.triangles);
    CHECK(set.elements == mesh.triangles);
    CHECK(set.owner.empty());
    CHECK(set.index.size() == 3 * mesh.triangles);
    CHECK(set.data.size() == 3 * mesh.vertices);
    // This is generous: a sanitizer or a busy machine must not make it fail, but a slow reader must.
    CHECK(took.count() < 5000);
    if (mesh.triangles > 300000)
      UNSCOPED_INFO("read in " << took.count() << " ms");
  }
}
