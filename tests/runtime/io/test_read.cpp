#include "fixture.hpp"

#include <sys/stat.h>

using namespace fixture;
using Catch::Matchers::EndsWith;

TEST_CASE("an unknown extension lists the supported ones", "[read]") {
  CHECK(complaint("a.stp", "x\n") == "a.stp: unknown extension '.stp'; supported: .ply, .obj, .off, .stl, .csv");
  CHECK(complaint("mesh", "x") == "mesh: the name has no extension; supported: .ply, .obj, .off, .stl, .csv");
}

TEST_CASE("files that cannot be read", "[read]") {
  for (const char *const name : {"none.ply", "none.obj", "none.stl", "none.off", "none.csv"})
    CHECK_THROWS_WITH(meetc::io::read(folder() / name, kinds), EndsWith(std::string(name) + ": no such file"));
  fs::create_directory(folder() / "folder.ply");
  CHECK_THROWS_WITH(meetc::io::read(folder() / "folder.ply", kinds), EndsWith("folder.ply: is a directory"));
  const fs::path pipe = folder() / "pipe.obj";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(meetc::io::read(pipe, kinds), EndsWith("pipe.obj: is not a regular file"));
  const fs::path device = folder() / "zero.csv";
  fs::create_symlink("/dev/zero", device);
  CHECK_THROWS_WITH(meetc::io::read(device, kinds), EndsWith("zero.csv: is not a regular file"));
  if (::geteuid() != 0) {
    const fs::path closed = put("closed.csv", "x,y,z,r\n");
    fs::permissions(closed, fs::perms::none);
    CHECK_THROWS_WITH(meetc::io::read(closed, kinds), contains("closed.csv: cannot be opened: "));
  }
  for (const char *const name : {"a.ply", "a.obj", "a.stl", "a.off", "a.csv"})
    CHECK(complaint(name, "") == std::string(name) + ": the file is empty");
}

TEST_CASE("a mesh needs the kind triangle", "[read]") {
  const meetc::kind_info *const few[] = {&sphere};
  CHECK_THROWS_WITH(meetc::io::read(put("a.obj", "v 0 0 0\nf 1 1 1\n"), few),
                    EndsWith("a.obj: a mesh needs a kind 'triangle' of three points, and there is none"));
}

TEST_CASE("the kind's rule holds for meshes too", "[read]") {
  meetc::kind_info flat = triangle;
  flat.fault = [](const float *row) { return row[2] != 0 ? "z0 != 0" : nullptr; };
  const meetc::kind_info *const one[] = {&flat};
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\n";
  CHECK(meetc::io::read(put("a.obj", vertices + "f 1 2 3\n"), one).elements == 1);
  CHECK_THROWS_WITH(meetc::io::read(put("a.obj", vertices + "f 1 2 3 4\nf 4 1 2\n"), one),
                    EndsWith("a.obj: face 1: z0 != 0"));
}

TEST_CASE("a message is one line whatever the file holds", "[read]") {
  const std::string what = complaint("two\nlines.stp", "x");
  CHECK_THAT(what, contains("two\\x0alines.stp: unknown extension"));
}
