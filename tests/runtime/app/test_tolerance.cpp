// `meet collide --tolerance`: its answers, its words, and its refusals.
#include "fixture.hpp"

using namespace fixture;

namespace {

nlohmann::json collided(const std::vector<std::string> &more) {
  std::vector<std::string> words{"collide", "a.csv", "b.csv", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const said s = run(words);
  INFO(s.err);
  REQUIRE(s.code == 0);
  return nlohmann::json::parse(s.out);
}

} // namespace

TEST_CASE("tolerance: an answer may be wrong, but only by the tolerance") {
  put("a.csv", "x,y,z,r\n0,0,0,1\n");
  put("b.csv", "x,y,z,r\n2.01,0,0,1\n-1.99,0,0,1\n0,2.3,0,1\n");
  CHECK(collided({})["pairs"] == 1);
  CHECK_FALSE(collided({}).contains("tolerance"));
  const nlohmann::json coarse = collided({"--tolerance", "0.5"});
  CHECK(coarse["pairs"] == 2); // 2.01 becomes 2, and 2.3 becomes 2.25
  CHECK(coarse["tolerance"] == 0.5);
  CHECK(coarse["grid"] == 0.125);
  CHECK(coarse["precision"] == "certified");
  CHECK(collided({"--tolerance", "1e-3"})["pairs"] == 1);
  CHECK(collided({"--tolerance", "0"})["pairs"] == 1);
  CHECK_FALSE(collided({"--tolerance", "0"}).contains("grid"));
  // In either order of the kinds, and after the move.
  put("rods.csv", "x0,y0,z0,x1,y1,z1\n-1,1.01,0,1,1.01,0\n");
  for (const auto &files : {std::pair("a.csv", "rods.csv"), std::pair("rods.csv", "a.csv")}) {
    CHECK(has(run({"collide", files.first, files.second}).out, "Nothing touches"));
    const std::string said = run({"collide", files.first, files.second, "--tolerance", "0.1"}).out;
    CHECK(has(said, "1 pair touches"));
    CHECK(has(said, "ball_segment (solid), certified within 0.1, on the CPU"));
    CHECK(has(said,
              "rounded to multiples of 2^-5: an answer may be wrong only where moving one element\nby at most 0.0"));
  }
  CHECK(collided({"--tolerance", "0.1", "--translate-b", "-0.004,0,0"})["pairs"] == 2);
}

TEST_CASE("tolerance: a refusal is one line") {
  put("a.csv", "x,y,z,r\n0,0,0,1\n");
  put("b.csv", "x,y,z,r\n2.01,0,0,1\n");
  put("rods.csv", "x0,y0,z0,x1,y1,z1\n-1,1.01,0,1,1.01,0\n");
  const auto refused = [](const std::vector<std::string> &more, const std::string &b = "b.csv") {
    std::vector<std::string> words{"collide", "a.csv", b};
    words.insert(words.end(), more.begin(), more.end());
    return complaint(words);
  };
  for (const char *bad : {"-1", "inf", "nan", "-0.0001", "much", "", "1,2", "1e999"})
    CHECK(has(refused({"--tolerance", bad}), "--tolerance: "));
  CHECK(has(refused({"--tolerance", "1e-60"}), "beyond what float32 can be rounded to"));
  CHECK(has(refused({"--tolerance", "1e300"}), "beyond what float32 can be rounded to"));
  CHECK(has(refused({"--tolerance", "1", "--precision", "fp32"}), "with --tolerance the precision is certified"));
  CHECK(has(refused({"--tolerance", "1", "--mode", "surface"}, "rods.csv"), "sphere_segment keeps none"));
  for (const char *option : {"--tolerance=1.6e38", "--tolerance=1e35"}) { // there is no pose, and no word of one
    const bool coarse = std::string_view(option).back() == '8';
    put("large.csv", coarse ? "x,y,z,r\n3.4e38,0,0,1\n" : "x,y,z,r\n0,0,0,1\n3.4028234663852886e38,0,0,1\n");
    const std::string line = refused({option}, "large.csv");
    CHECK(has(line, coarse ? ": B, element 0: x becomes inf, rounded to a multiple of 2^125; without the option"
                           : ": B, element 1: x becomes inf, rounded to a multiple of 2^114; without the option"));
    CHECK_FALSE(has(line, "pose"));
  }
  put("big.csv", "x,y,z,r\n3.4e38,0,0,1\n");
  CHECK(has(complaint({"collide", "big.csv", "b.csv", "--tolerance", "1.6e38"}), ": A, element 0: x becomes inf"));
  CHECK(has(refused({"--precision", "tolerant"}), "known: fp32, fp64, fp64x2, exact, certified"));
}
