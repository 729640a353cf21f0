// The files that `meet collide` writes: their contents, which are the same for any number of threads, and that each is
// written whole or not at all.
#include "fixture.hpp"

#include "meet/io/read.hpp"
#include "meet/picture/palette.hpp"

#include <cstring>
#include <sys/stat.h>

using namespace fixture;
using namespace meetc::bodies;

namespace {

void put_files() {
  put_mesh("ball.ply", icosphere(3));
  put_mesh("ring.ply", torus(48, 24));
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
}

// Faces of each colour of a coloured PLY.
std::map<std::string, std::size_t> colours_in(const std::string &path, std::size_t faces) {
  const std::string file = get(path);
  const std::size_t size = 1 + 3 * 4 + 3;
  REQUIRE(has(file, "property uchar red"));
  REQUIRE(file.size() > faces * size);
  std::map<std::string, std::size_t> out;
  for (std::size_t i = 0; i < faces; ++i)
    ++out[file.substr(file.size() - (faces - i) * size + size - 3, 3)];
  return out;
}

} // namespace

TEST_CASE("the same bytes from any number of threads") {
  put_mesh("animal.ply", blob(48));
  put_mesh("knot.ply", knot(720, 24));
  std::string first;
  for (const char *const threads : {"1", "2", "7", "0"}) {
    fs::remove_all(at("colours"));
    answer({"animal.ply", "knot.ply", "--threads", threads, "--pairs", "pairs.csv", "--color", "colours"});
    const std::string all = get(at("pairs.csv")) + get(at("colours/a.ply")) + get(at("colours/b.ply"));
    if (first.empty())
      first = all;
    CHECK(first == all);
  }
  CHECK(first.size() > 100000);
}

TEST_CASE("the first triangle that each segment meets") {
  // Two walls across the x axis, the nearer one twice: at x = 2, and at x = 1 as face 1, and as faces 2 and 3, a square.
  put("walls.obj", "v 2 -9 -9\nv 2 9 -9\nv 2 0 9\nv 1 -9 -9\nv 1 9 -9\nv 1 0 9\nv 1 9 9\nv 1 -9 9\n"
                   "f 1 2 3\nf 4 5 6\nf 4 5 7 8\n");
  put("ways.csv", "x0,y0,z0,x1,y1,z1\n3,0,0,0,0,0\n0,0,0,3,0,0\n9,9,9,8,8,8\n0,0,0,1.5,0,0\n2,0,0,2,0,0\n");
  for (const char *const threads : {"1", "2"}) {
    const json j =
        answer({"ways.csv", "walls.obj", "--first", "first.csv", "--pairs", "pairs.csv", "--threads", threads});
    CHECK(get(at("first.csv")) == "a,b\n0,0\n1,1\n3,1\n4,0\n");
    CHECK(j["touched_a"] == 4);
    CHECK(j["pairs"] == 9);
  }
  // The mesh first: the same pairs, sorted by the triangle.
  answer({"walls.obj", "ways.csv", "--first", "first.csv"});
  CHECK(get(at("first.csv")) == "a,b\n0,0\n0,4\n1,1\n1,3\n");
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
  put("none.csv", "x0,y0,z0,x1,y1,z1\n");
  answer({"none.csv", "walls.obj", "--first", "first.csv"});
  CHECK(get(at("first.csv")) == "a,b\n");
  fs::remove(at("first.csv"));
  const auto refused = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "collide");
    arguments.insert(arguments.end(), {"--first", "first.csv"});
    const said s = run(arguments);
    CHECK(s.code == 2);
    CHECK_FALSE(fs::exists(at("first.csv")));
    return s.err;
  };
  CHECK(refused({"balls.csv", "walls.obj"}) ==
        "meet: --first needs segments and triangles (segment_triangle); ball_triangle has no order\n");
  CHECK(has(refused({"ways.csv", "walls.obj", "--any"}), "--any stops at the first pair"));
  CHECK(refused({"ways.csv", "walls.obj", "--tolerance", "0.1"}) ==
        "meet: --first is exact and goes with no --tolerance\n");
}

TEST_CASE("coloured meshes: as many bright faces as are touched") {
  put_files();
  const json j = answer({"ball.ply", "ring.ply", "--color", "new/folder"});
  const auto a = colours_in(at("new/folder/a.ply"), 1280), b = colours_in(at("new/folder/b.ply"), 2304);
  REQUIRE(a.size() == 2);
  REQUIRE(b.size() == 2);
  const auto bytes = [](meetc::picture::colour c) {
    return std::string{static_cast<char>(c.r), static_cast<char>(c.g), static_cast<char>(c.b)};
  };
  CHECK(a.at(bytes(meetc::picture::palette::yellow)) == j["touched_a"]);
  CHECK(b.at(bytes(meetc::picture::palette::vermilion)) == j["touched_b"]);
  CHECK(files_in(at("new/folder")) == 2);
  // B is written as it was moved, and can be read again.
  run({"collide", "ball.ply", "ring.ply", "--translate-b", "0.5,0,0", "--color", "new/folder"});
  CHECK(answer({"ball.ply", "new/folder/b.ply"})["pairs"] ==
        answer({"ball.ply", "ring.ply", "--translate-b", "0.5,0,0"})["pairs"]);
  // Sets that are not meshes have no colours.
  fs::remove_all(at("new"));
  const said s = run({"collide", "balls.csv", "ring.ply", "--colour", "new"});
  CHECK(s.code == 0);
  CHECK(has(s.out, "A is no mesh"));
  CHECK(files_in(at("new")) == 1);
  fs::remove_all(at("new"));
  CHECK(has(complaint({"collide", "balls.csv", "balls.csv", "--color", "new"}), "only the faces of a mesh"));
  CHECK_FALSE(fs::exists(at("new")));
}

TEST_CASE("pictures, of every kind") {
  put_files();
  put("rods.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,2,0,0\n");
  put("points.csv", "x,y,z\n0,0,0\n1.375,0,0\n");
  for (const char *const a : {"ball.ply", "balls.csv", "rods.csv", "points.csv"}) {
    const said s = run({"collide", a, "ring.ply", "--image", "picture.png"});
    CHECK(s.code == 0);
    CHECK(has(s.out, "wrote picture.png"));
    const std::string png = get(at("picture.png"));
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(png.size() > 10000);
  }
}

TEST_CASE("pictures from a camera and of a size") {
  put_files();
  const auto picture = [](std::vector<std::string> more) {
    std::vector<std::string> words{"collide", "ball.ply", "ring.ply", "--image", "p.png"};
    words.insert(words.end(), more.begin(), more.end());
    const said s = run(words);
    INFO(s.err);
    CHECK(s.code == 0);
    return get(at("p.png"));
  };
  const auto big_endian = [](const std::string &bytes, std::size_t i) {
    const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[i + k]); };
    return at(0) << 24 | at(1) << 16 | at(2) << 8 | at(3);
  };
  const std::string small = picture({"--size", "320x240"});
  CHECK(big_endian(small, 16) == 320);
  CHECK(big_endian(small, 20) == 240);
  CHECK(picture({"--size", "320x240", "--camera", "28,16"}) == small);
  CHECK(picture({"--size", "320x240", "--camera", "388,16,1"}) == small);
  for (const char *const other : {"100,16", "28,90", "28,16,2", "28,16,z", "3,4,5,0,0,0", "3,4,5,0,0,0,0,0,1"})
    CHECK(picture({"--size", "320x240", "--camera", other}) != small);
  CHECK(run({"collide", "--self", "ring.ply", "--image", "self.png", "--size", "100x64", "--camera", "0,0"}).code == 0);
  CHECK(big_endian(get(at("self.png")), 16) == 100);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--size", "0x900"}, "--size 0x900: width and height are from 64 to 8192 pixels"},
      {{"--size", "8193x64"}, "--size 8193x64: width and height are from 64 to 8192 pixels"},
      {{"--size", "8192x8192"}, "a picture has at most 16777216"},
      {{"--size", "1600"}, "--size: '1600' is not WIDTHxHEIGHT in pixels, such as 1600x900"},
      {{"--size", "axb"}, "'axb' is not WIDTHxHEIGHT"},
      {{"--camera", "nan,0"}, "--camera"},
      {{"--camera", "1e999,0"}, "--camera"},
      {{"--camera", "0,91"}, "--camera 0,91: the elevation 91 is beyond 90 degrees"},
      {{"--camera", "0,0,0"}, "--camera 0,0,0: the distance 0 is not above 0"},
      {{"--camera", "1"}, "--camera: '1' is neither azimuth,elevation"},
      {{"--camera", "1,2,3,4"}, "--camera: '1,2,3,4' is neither"},
      {{"--camera", "1,,2"}, "lacks a number beside a comma"},
      {{"--camera", "1,2,3,1,2,3"}, "the eye and the point that it looks at are one"},
      {{"--camera", "0,5,0,0,0,0"}, "it looks along the direction up, 0,1,0; name another one"},
      {{"--camera", "0,5,0,0,0,0,0,0,0"}, "the direction up has no length"},
      {{"--camera", "0,1e60,0,0,0,0"}, "is beyond all float32 numbers"}};
  for (const auto &[words, line] : wrong) {
    std::vector<std::string> all{"collide", "ball.ply", "ring.ply", "--image", "no.png"};
    all.insert(all.end(), words.begin(), words.end());
    CHECK(has(complaint(all), line));
    CHECK_FALSE(fs::exists(at("no.png")));
  }
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--size", "320x240"}),
            "--size: it is about a picture; write --image out.png as well"));
}

TEST_CASE("without a font a picture has no captions, and one line says so") {
  put_files();
  put("fonts.conf", "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"urn:fontconfig:fonts.dtd\"><fontconfig/>");
  const std::vector<std::string> words{"collide", "ball.ply", "ring.ply", "--image", "bare.png"};
  REQUIRE(::setenv("FONTCONFIG_FILE", at("fonts.conf").c_str(), 1) == 0);
  const said bare = run(words);
  ::unsetenv("FONTCONFIG_FILE");
  CHECK(bare.code == 0);
  CHECK(bare.err == "meet: this machine has no font, so that pictures have no captions; on Debian, the package "
                    "fonts-dejavu-core has one\n");
  const std::string without = get(at("bare.png"));
  const said named = run(words);
  CHECK(named.err.empty());
  CHECK(get(at("bare.png")) != without);
}

TEST_CASE("an output is never an input, nor another output") {
  put_files();
  const std::string before = get(at("ball.ply"));
  fs::remove(at("alias.ply"));
  fs::create_hard_link(at("ball.ply"), at("alias.ply"));
  for (const char *const name : {"ball.ply", "ring.ply", "alias.ply", "./ball.ply"})
    for (const char *const option : {"--pairs", "--image"})
      CHECK(has(complaint({"collide", "ball.ply", "ring.ply", option, name}), "is an input"));
  fs::create_directories(at("inputs"));
  fs::copy_file(at("ball.ply"), at("inputs/a.ply"), fs::copy_options::overwrite_existing);
  CHECK(has(complaint({"collide", "inputs/a.ply", "ring.ply", "--color", "inputs"}), "is an input"));
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "x", "--image", "x"}), "the same name"));
  CHECK(get(at("ball.ply")) == before);
  CHECK(get(at("inputs/a.ply")) == before);
  CHECK_FALSE(fs::exists(at("x")));
}

TEST_CASE("all outputs or none, and nothing is left over") {
  put_files();
  for (const char *const made : {"plain", "bad.ply", "p.csv"})
    fs::remove(at(made));
  const std::size_t before = [] {
    run({"--version"}); // its output files count
    return files_in(folder());
  }();
  put("plain", "no folder");
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "p.csv", "--image", "no/where.png"}),
            "no/where.png: cannot be written"));
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "p.csv", "--color", "plain"}),
            "plain: is not a folder"));
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "p.csv", "--color", "plain/x"}),
            "plain: is not a folder"));
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "."}), "."));
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", ""}), "not the name of a file"));
  // After bad input, existing outputs stay as they were.
  put("bad.ply", "ply\n");
  put("p.csv", "old");
  CHECK(has(complaint({"collide", "ball.ply", "bad.ply", "--pairs", "p.csv", "--color", "fresh"}), "bad.ply"));
  CHECK(get(at("p.csv")) == "old");
  CHECK_FALSE(fs::exists(at("fresh")));
  for (const char *const made : {"plain", "bad.ply", "p.csv"})
    fs::remove(at(made));
  CHECK(files_in(folder()) == before);
}

TEST_CASE("a file that is replaced keeps its mode and its links, special files are written to") {
  put_files();
  put("real.csv", "old");
  ::chmod(at("real.csv").c_str(), 0640);
  fs::remove(at("link.csv"));
  fs::create_symlink("real.csv", at("link.csv"));
  answer({"ball.ply", "ring.ply", "--pairs", "link.csv"});
  CHECK(fs::is_symlink(at("link.csv")));
  CHECK(pairs_in(at("real.csv")).size() > 100);
  struct stat info {};
  ::stat(at("real.csv").c_str(), &info);
  CHECK((info.st_mode & 0777) == 0640);
  CHECK(run({"collide", "ball.ply", "ring.ply", "--pairs", "/dev/null"}).code == 0);
  CHECK(has(complaint({"collide", "ball.ply", "ring.ply", "--pairs", "/dev/full"}), "/dev/full: cannot be written"));
}

TEST_CASE("standard output that is gone, closed or full") {
  put_files();
  // Text printed to a closed stream is lost, which is an error. A file is still written whole: it does not take the
  // stream's number.
  const said closed = run({"collide", "ball.ply", "ring.ply", "--pairs", "p.csv"}, ">&-");
  CHECK(closed.code == 2);
  CHECK(has(closed.err, "meet: standard output: "));
  CHECK(pairs_in(at("p.csv")).size() > 100);
  CHECK(run({"--help"}, ">&-").code == 2);
  CHECK(run({"collide", "ball.ply", "ring.ply"}, "2>&- <&-").code == 0);
  CHECK(run({"collide", "ball.ply", "ring.ply", "--pairs", "p.csv"}, ">&- 2>&- <&-").code == 2);
  CHECK(pairs_in(at("p.csv")).size() > 100);
  const said full = run({"collide", "ball.ply", "ring.ply", "--json"}, ">/dev/full");
  CHECK(full.code == 2);
  CHECK(has(full.err, "meet: standard output: "));
  // The reader exits before anything is written.
  const std::string command =
      fmt::format("cd '{}' && {{ sleep 0.2; '{}' collide ball.ply ring.ply; echo $? > code.txt; }} | true",
                  folder().string(), MEETC_MEET);
  CHECK(std::system(command.c_str()) == 0);
  CHECK(get(at("code.txt")) == "0\n");
}
