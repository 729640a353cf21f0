// Real meshes, where they are present.
#include "fixture.hpp"

#include <algorithm>

using namespace fixture;

namespace {

bool present(const std::string &name) {
  return fs::exists(fs::path(MEETC_DATA) / name);
}
std::string data(const std::string &name) {
  return (fs::path(MEETC_DATA) / name).string();
}

} // namespace

TEST_CASE("two scans that cross", "[data]") {
  if (!present("bunny_69k.ply") || !present("armadillo_345k.ply")) {
    WARN("no meshes in " MEETC_DATA);
    return;
  }
  const std::string a = data("bunny_69k.ply"), b = data("armadillo_345k.ply");
  const std::vector<std::string> pose{a, b, "--scale-b", "0.001", "--translate-b", "0,0.1,0"};
  const json j = answer(pose);
  CHECK(j["pairs"] == 2420);
  CHECK(j["touched_a"] == 659);
  CHECK(j["touched_b"] == 1755);
  CHECK(j["seconds"]["collide"] < 10.0);
  const pair_list certified = pairs_of(pose);
  const std::string bytes = get(at("pairs.csv"));
  std::vector<std::string> with_exact = pose;
  with_exact.insert(with_exact.end(), {"--precision", "exact"});
  CHECK(pairs_of(with_exact) == certified);
  CHECK(get(at("pairs.csv")) == bytes);
  for (const char *const rung : {"fp64x2", "fp64", "fp32"}) {
    std::vector<std::string> plain = pose;
    plain.insert(plain.end(), {"--precision", rung});
    const pair_list rounded = pairs_of(plain);
    pair_list different;
    std::set_symmetric_difference(certified.begin(), certified.end(), rounded.begin(), rounded.end(),
                                  std::back_inserter(different));
    CHECK(different.size() < certified.size() / 100);
  }
}

TEST_CASE("the curves in which two scans meet", "[data]") {
  if (!present("bunny_69k.ply") || !present("armadillo_345k.ply"))
    return;
  const json j = answer({data("armadillo_345k.ply"), data("bunny_69k.ply"), "--scale-b", "700", "--contacts", "c.obj"});
  CHECK(j["pairs"] == 4762);
  CHECK(j["contacts"]["pieces"] == 4762); // in general position each pair is one
  CHECK(j["contacts"]["nodes"] == 4764);
  CHECK(j["contacts"]["polylines"] == 9);
  CHECK(j["contacts"]["closed"] == 7);
  CHECK(j["contacts"]["single_nodes"] == 0);
}

TEST_CASE("a scan against itself", "[data]") {
  if (!present("bunny_69k.ply"))
    return;
  // As counted independently.
  CHECK(answer({data("bunny_69k.ply"), data("bunny_69k.ply")})["pairs"] == 911703);
}
