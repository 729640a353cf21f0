#include "fixture.hpp"

#include "meet/io/files/atomic_file.hpp"
#include "meet/io/write.hpp"

using namespace fixture;
using Catch::Matchers::EndsWith;
using meetc::io::rgb;

TEST_CASE("pairs are written as CSV", "[write]") {
  const fs::path path = folder() / "pairs.csv";
  meetc::io::write_pairs_csv(path, {});
  CHECK(get(path) == "a,b\n");
  const meetc::index_pair pairs[] = {{0, 0}, {7, 4294967295}};
  meetc::io::write_pairs_csv(path, pairs);
  CHECK(get(path) == "a,b\n0,0\n7,4294967295\n");
  std::string expected = "a,b\n";
  std::vector<meetc::index_pair> many;
  for (std::uint32_t i = 0; i < 50000; ++i) {
    many.push_back({i, i * 7});
    expected += std::to_string(i) + "," + std::to_string(i * 7) + "\n";
  }
  meetc::io::write_pairs_csv(path, many);
  CHECK(get(path) == expected);
}

TEST_CASE("a mesh comes back from PLY as it was, polygons and unused vertices too", "[write]") {
  const auto mesh = read("a.obj", "v 0 0 0.1\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\n"
                                  "f 1 2 3\nf 1 2 3 4\nf 4 3 2\nf 1 2 3 4 5\nf 1 2 5\n");
  const rgb colours[] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {255, 0, 128}, {0, 0, 0}};
  const fs::path path = folder() / "out.ply";
  for (const bool coloured : {false, true}) {
    meetc::io::write_ply(path, mesh, coloured ? std::span<const rgb>(colours) : std::span<const rgb>());
    const auto back = meetc::io::read(path, kinds);
    CHECK(back.data == mesh.data);
    CHECK(back.index == mesh.index);
    CHECK(back.owner == mesh.owner);
    CHECK(back.items == 5);
    CHECK(back.vertices == 5);
  }
  const std::string text = get(path);
  CHECK_THAT(text, contains("property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"));
  CHECK_THAT(text, contains(std::string("\x04\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0\4\5\6", 20)));
}

TEST_CASE("rows, plain arrays and wide polygons make PLY too", "[write]") {
  const auto soup = read("a.csv", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,0,1,0,0,0,1,0\n5,0,0,1,5,0,0,1,5\n");
  const fs::path path = folder() / "out.ply";
  meetc::io::write_ply(path, soup);
  auto back = meetc::io::read(path, kinds);
  CHECK(back.data == soup.data);
  CHECK(back.index == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  meetc::io::write_ply(path, soup.data, back.index, std::vector<rgb>{{1, 1, 1}, {2, 2, 2}});
  CHECK(meetc::io::read(path, kinds).index == back.index);
  std::string wide, face = "f";
  for (int i = 1; i <= 300; ++i) {
    wide.append("v ").append(std::to_string(i)).append(" 0 0\n");
    face.append(" ").append(std::to_string(i));
  }
  const auto polygon = read("a.obj", wide + face + "\n");
  meetc::io::write_ply(path, polygon);
  back = meetc::io::read(path, kinds);
  CHECK(back.items == 1);
  CHECK(back.index == polygon.index);
}

TEST_CASE("binary STL and ascii PLY agree with what is written", "[write]") {
  const auto set = read("a.stl", "solid\nfacet normal 0 0 0\nouter loop\nvertex .1 .2 .3\nvertex 1 0 0\nvertex 0 1 0\n"
                                 "endloop\nendfacet\nendsolid\n");
  meetc::io::write_ply(folder() / "out.ply", set);
  CHECK(meetc::io::read(folder() / "out.ply", kinds).data == set.data);
}

TEST_CASE("writers refuse elements that do not fit", "[write]") {
  const auto mesh = read("a.obj", "v 0 0 0\nf 1 1 1\n");
  const fs::path path = folder() / "refused.ply";
  CHECK_THROWS_WITH(meetc::io::write_ply(path, mesh, std::vector<rgb>(2)),
                    EndsWith("refused.ply: 2 colours for 1 faces"));
  CHECK_THROWS_WITH(meetc::io::write_ply(path, read("a.csv", "x,y,z,r\n")), contains("only triangles make a PLY mesh"));
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("a file is there whole or not at all", "[write]") {
  const fs::path own = folder() / "own";
  fs::create_directory(own);
  const fs::path target = own / "t.bin";
  {
    meetc::io::atomic_file file(target);
    file.write("abc");
    CHECK_FALSE(fs::exists(target));
    CHECK(files_in(own) == 1);
  }
  CHECK(files_in(own) == 0);
  {
    meetc::io::atomic_file file(target);
    std::fputs("new", file.stream());
    file.commit();
  }
  CHECK(get(target) == "new");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("t.bin", own / "link");
  {
    meetc::io::atomic_file file(own / "link");
    file.write("through");
    file.commit();
  }
  CHECK(get(target) == "through");
  CHECK(fs::is_symlink(own / "link"));
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(files_in(own) == 2);
}

TEST_CASE("failures of writing name the file and leave nothing", "[write]") {
  const fs::path own = folder() / "failing";
  fs::create_directories(own / "folder");
  CHECK_THROWS_WITH(meetc::io::write_pairs_csv(own / "folder", {}), contains("failing/folder: is a directory"));
  CHECK_THROWS_WITH(meetc::io::write_pairs_csv(own / "none" / "a.csv", {}),
                    contains("none/a.csv: cannot be written: No such file"));
  CHECK(files_in(own) == 1);
  if (fs::exists("/dev/full")) {
    const std::vector<meetc::index_pair> pairs(100000);
    CHECK_THROWS_WITH(meetc::io::write_pairs_csv("/dev/full", pairs),
                      contains("/dev/full: cannot be written: No space"));
    CHECK_THROWS_AS(meetc::io::write_pairs_csv("/dev/full", {}), meetc::io::error);
  }
  CHECK_NOTHROW(meetc::io::write_pairs_csv("/dev/null", {}));
  // A relative name without a folder lies in the current one.
  const fs::path before = fs::current_path();
  fs::current_path(own);
  meetc::io::write_pairs_csv("here.csv", {});
  fs::current_path(before);
  CHECK(get(own / "here.csv") == "a,b\n");
}
