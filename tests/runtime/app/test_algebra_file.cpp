// The places searched for the shipped algebra: next to the program first, even after it has been moved.
#include "fixture.hpp"

#include "meet/app/input/algebra_file.hpp"
#include "meet/app/input/failure.hpp"

using namespace fixture;
using meetc::app::algebra_path;
using meetc::app::algebra_places;

TEST_CASE("the algebra is looked for from the program first, then where it was installed and built") {
  const std::vector<fs::path> places = algebra_places("/moved/bin");
  REQUIRE(places.size() >= 3);
  CHECK(places[0] == "/moved/share/meetc/algebra_spec/cga3.toml");
  CHECK(places.back() == fs::path(MEETC_ALGEBRA).lexically_normal());
  // For a program in its build folder, the second place is in the source tree.
  const std::vector<fs::path> built = algebra_places(fs::path(MEETC_MEET).parent_path());
  CHECK(built[1] == fs::path(MEETC_ALGEBRA).lexically_normal());
  CHECK(algebra_places(fs::path()).size() == 2);
}

TEST_CASE("the first place with a file is taken, and a failure names them all") {
  put("second.toml", "");
  const std::vector<fs::path> places{folder() / "first.toml", folder() / "second.toml", folder() / "third.toml"};
  CHECK(algebra_path({}, places) == places[1]);
  put("third.toml", "");
  CHECK(algebra_path({}, places) == places[1]);
  CHECK(algebra_path(folder() / "third.toml", places) == places[2]);
  fs::remove(folder() / "second.toml"), fs::remove(folder() / "third.toml");
  const auto what = [&](const std::optional<fs::path> &asked) -> std::string {
    try {
      algebra_path(asked, places);
    } catch (const meetc::app::failure &e) {
      return e.what();
    }
    return "";
  };
  for (const fs::path &p : places)
    CHECK(has(what({}), p.string()));
  CHECK(has(what({}), "--algebra PATH"));
  CHECK(has(what(folder() / "none.toml"), "none.toml: no such file"));
}

TEST_CASE("a program that was moved names the algebra that was moved with it") {
  const fs::path bin = folder() / "moved/bin", algebra = folder() / "moved/share/meetc/algebra_spec/cga3.toml";
  fs::create_directories(bin);
  fs::create_directories(algebra.parent_path());
  fs::copy_file(MEETC_MEET, bin / "meet", fs::copy_options::overwrite_existing);
  fs::copy_file(MEETC_ALGEBRA, algebra, fs::copy_options::overwrite_existing);
  put("one.csv", "x,y,z,r\n0,0,0,1\n");
  const said s = run_program(bin / "meet", {"inspect", "one.csv", "one.csv", "--scene", "moved/scene.toml"});
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(has(get(at("moved/scene.toml")), "algebra   = 'share/meetc/algebra_spec/cga3.toml'"));
  fs::remove_all(folder() / "moved");
}
