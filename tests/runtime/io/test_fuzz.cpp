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
                                            "end",   "property int q\n"};
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
      REQUIRE(set.index.size() == 3 * set.elements);
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
  int accepted = 0;
  for (int i = 0; i < rounds; ++i)
    accepted += survives(name, damage(good, roll), i % 4 == 0 ? move : meetc::io::transform{});
  // If all or none were refused, the damage would test nothing.
  CHECK(accepted > 0);
  CHECK(accepted < rounds);
  // Every prefix, since a truncated file is the most common damage.
  for (std::size_t n = 0; n < good.size(); ++n)
    survives(name, good.substr(0, n), {});
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

} // namespace

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
       "# m\nv 0 0 0\nv 1 0 0\nv 1 1 0 1\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf -1//1 \\\n1/1 2/1/1\nv 0 1 0.25\nf 1 "
       "2 3 4\n",
       4);
}
TEST_CASE("damaged ascii STL", "[fuzz]") {
  fuzz("f.stl",
       "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 "
       "0\nendloop\nendfacet\n"
       "endsolid a b\n",
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
  fuzz("f.csv", "# s\nx,y,z,r\n1,2,3,4\n-1,+2e0,3.5,0\n\n", 7);
}
