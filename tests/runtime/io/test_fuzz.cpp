// Small valid files with random but reproducible damage: only io::error may be thrown, and accepted content satisfies
// all promises.
#include "fixture.hpp"

#include <cmath>
#include <random>

using namespace fixture;

namespace {

// std::uniform_int_distribution differs between libraries.
class dice {
public:
  explicit dice(std::uint32_t seed) : engine_(seed) {}
  std::size_t below(std::size_t n) { return engine_() % n; }

private:
  std::mt19937 engine_;
};

std::string damage(std::string text, dice &roll) {
  static const std::string_view pieces[] = {"-1",    "4294967295",
                                            "1e999", "nan",
                                            "0",     "\n",
                                            " ",     "\\\n",
                                            ",",     "/",
                                            "#",     "\r",
                                            "99",    "list",
                                            "3",     "inf",
                                            "uchar", "\xff\xff\xff\xff",
                                            "end",   "property int q\n",
                                            "\r\n",  "l 1 2\n",
                                            "p 1\n", ";",
                                            "\"",    "433832.18",
                                            "\x1a",  "v 1 1 1\n"};
  const std::size_t changes = 1 + roll.below(4);
  for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = roll.below(text.size());
    switch (roll.below(6)) {
    case 0:
      text[at] = static_cast<char>(roll.below(256));
      break;
    case 1:
      text[at] = static_cast<char>(text[at] ^ (1 << roll.below(8)));
      break;
    case 2:
      text.resize(at);
      break;
    case 3:
      text.insert(at, pieces[roll.below(std::size(pieces))]);
      break;
    case 4:
      text.erase(at, 1 + roll.below(8));
      break;
    default: { // named, since the order in which arguments are evaluated differs between compilers
      const std::size_t from = roll.below(text.size());
      const std::size_t length = 1 + roll.below(16);
      text.insert(at, text.substr(from, length));
    }
    }
  }
  return text;
}

// All that a reader says of a text, as one string.
std::string outcome(const fs::path &path, const meetc::io::read_options &how) {
  try {
    const auto set = meetc::io::read(path, kinds, how);
    std::string out = std::string(set.kind->name) + "\n" + std::to_string(set.elements) + " " +
                      std::to_string(set.items) + " " + std::to_string(set.vertices) + " " +
                      std::to_string(set.rounded.numbers) + "\n";
    append(out, set.rounded.largest);
    for (const float v : set.data)
      append(out, v);
    for (const std::uint32_t v : set.index)
      append(out, v);
    for (const std::uint32_t v : set.owner)
      append(out, v);
    for (const std::string &note : set.notes)
      out += note + "\n";
    return out;
  } catch (const meetc::io::error &e) {
    return e.what();
  }
}

// Cut into pieces at any place, the text is what it is in one piece.
void same_in_pieces(const fs::path &path, const meetc::io::transform &move, std::size_t from, std::size_t to) {
  const std::string whole = outcome(path, {move, {}, {}, 1, std::size_t{1} << 30});
  for (std::size_t bytes = from; bytes <= to; ++bytes) {
    INFO("in pieces of " << bytes << " bytes");
    const std::string cut = outcome(path, {move, {}, {}, bytes % 8 == 0 ? 2 : 1, bytes});
    if (cut != whole)
      FAIL(cut << "\n---\n" << whole);
  }
}

// True where the file was accepted.
bool survives(const std::string &name, const std::string &text, const meetc::io::transform &move) {
  try {
    const auto set = read(name, text, move);
    REQUIRE(set.kind != nullptr);
    for (const float v : set.data)
      REQUIRE(std::isfinite(v));
    for (const std::uint32_t v : set.index)
      REQUIRE(v < set.vertices);
    REQUIRE((set.owner.empty() ? set.items == set.elements : set.owner.size() == set.elements));
    for (const std::uint32_t o : set.owner)
      REQUIRE(o < set.items);
    if (set.index.empty())
      REQUIRE((set.elements == 0 || set.data.size() == set.elements * static_cast<std::size_t>(set.kind->fields)));
    else
      REQUIRE(set.index.size() == static_cast<std::size_t>(set.kind->points) * set.elements);
    return true;
  } catch (const meetc::io::error &e) {
    const std::string_view what = e.what();
    REQUIRE(what.find(name) != std::string_view::npos);
    REQUIRE(what.find('\n') == std::string_view::npos);
    return false;
  }
}

void fuzz(const std::string &name, const std::string &good, std::uint32_t seed) {
  constexpr int rounds = 3000;
  dice roll(seed);
  meetc::io::transform move;
  move.scale = 1e30;
  REQUIRE(survives(name, good, {}));
  same_in_pieces(folder() / name, {}, 1, 64);
  int accepted = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto &by = i % 4 == 0 ? move : meetc::io::transform{};
    accepted += survives(name, damage(good, roll), by);
    const std::size_t bytes = 1 + roll.below(64);
    same_in_pieces(folder() / name, by, bytes, bytes + i % 2);
  }
  // If all or none were refused, the damage would test nothing.
  CHECK(accepted > 0);
  CHECK(accepted < rounds);
  // Every prefix, since a truncated file is the most common damage.
  for (std::size_t n = 0; n < good.size(); ++n) {
    survives(name, good.substr(0, n), {});
    same_in_pieces(folder() / name, {}, 1 + n % 40, 1 + n % 40);
  }
}

const std::string ply_parts =
    "element vertex 4\nproperty float x\nproperty uchar c\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list char short s\n"
    "end_header\n";

std::string binary_ply(std::endian order) {
  std::string out = std::string("ply\nformat binary_") + (order == std::endian::little ? "little" : "big") +
                    "_endian 1.0\n" + ply_parts;
  for (int i = 0; i < 4; ++i) {
    append(out, static_cast<float>(i), order);
    out += 'c';
    append(out, 0.5F, order);
    append(out, static_cast<float>(i * i), order);
  }
  for (int n = 3; n <= 4; ++n) {
    out += static_cast<char>(n);
    for (int i = 0; i < n; ++i)
      append(out, std::int32_t{i}, order);
    out += '\1';
    append(out, std::int16_t{5}, order);
  }
  return out;
}

// Where all faces have as many corners, rows have one size.
std::string even_ply() {
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
                    "property float z\nelement face 2\nproperty uchar c\nproperty list uchar uint vertex_indices\n"
                    "end_header\n";
  for (int i = 0; i < 4; ++i) {
    append(out, 433832.18 * i);
    append(out, static_cast<float>(i % 2));
    append(out, static_cast<float>(i / 2));
  }
  for (int i = 0; i < 2; ++i) {
    out += "c\4";
    for (const std::uint32_t v : {0U, 1U, 3U, 2U})
      append(out, v);
  }
  return out;
}

} // namespace

TEST_CASE("damaged binary PLY with rows of one size", "[fuzz]") {
  fuzz("f.ply", even_ply(), 11);
}
TEST_CASE("damaged ascii PLY", "[fuzz]") {
  fuzz("f.ply",
       "ply\nformat ascii 1.0\ncomment c\n" + ply_parts +
           "0 1 0 0\n1 2 0 0\n1 3 1 0\n0 4 1 1.5e0\n3 0 1 2 0\n4 0 1 2 3 2 5 6\n",
       1);
}
TEST_CASE("damaged little-endian PLY", "[fuzz]") {
  fuzz("f.ply", binary_ply(std::endian::little), 2);
}
TEST_CASE("damaged big-endian PLY", "[fuzz]") {
  fuzz("f.ply", binary_ply(std::endian::big), 3);
}
TEST_CASE("damaged OBJ", "[fuzz]") {
  fuzz("f.obj",
       "# m\nv 0 0 0\nv 1 0 433832.18\nv 1 1 0 1\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf -1//1 \\\n1/1 2/1/1\nl 1 2 -1\nxyz 1\n"
       "v 0 1 0.25\nf 1 2 3 4\np -1\nf 1 2 3 4 -1 \\\r\n -2\n",
       4);
}
TEST_CASE("damaged OBJ without faces", "[fuzz]") {
  fuzz("f.obj", "v 0 0 0\r\nv 1 0 433832.18\r\nv 1 1 0\r\nl 1 2 3\r\nl -1 -2\r\nv 5 5 5\r\nl 4 -1\r\n", 8);
}
TEST_CASE("damaged OFF", "[fuzz]") {
  fuzz("f.off",
       "COFF\n# c\n5 3 0\n0 0 0 1 1 1 1\n1 0 0 0 0 0\n# c\n1 1 0 # d\n\n0 1 0.1\n4 4 433832.18\n3 0 1 2 255 0 0\n"
       "4 0 1 2 3\n3 2 3 4\n",
       9);
}
TEST_CASE("damaged ascii STL", "[fuzz]") {
  fuzz("f.stl",
       "# c\nsolid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 "
       "0\nendloop\nendfacet\nfacet\n outer loop\nvertex 0 0 433832.18\nvertex 1 0 0 vertex 0 1 0\nendloop\nendfacet\n"
       "endsolid a b\nsolid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\n"
       "endfacet\nendsolid\n",
       5);
}
TEST_CASE("damaged binary STL", "[fuzz]") {
  std::string out(80, 's');
  append(out, std::uint32_t{2});
  for (int i = 0; i < 24; ++i)
    append(out, static_cast<float>(i));
  out.insert(84 + 48, 2, '\0');
  out.append(2, '\0');
  fuzz("f.stl", out, 6);
}
TEST_CASE("damaged CSV", "[fuzz]") {
  fuzz("f.csv", "# s\nx,y,z,r\n1,2,3,4\n-1,+2e0,3.5,0\n#\n433832.18,1,1,1\n\n", 7);
}
TEST_CASE("damaged CSV with other separators, quotes and columns", "[fuzz]") {
  fuzz("f.csv", "R;Name;x;Y;\"z\"\r\n1,5;\"a;b\";3;4;0\r\n0;;\"1\";2;433832,18\r\n 2 ; c ; 1e1 ;2;3\r\n", 10);
}
