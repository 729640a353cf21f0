// Readers under every control word that a caller may have set.
#include "fixture.hpp"

#include <meetc/control_word.hpp>

using namespace fixture;

#if defined(__SSE2__)
TEST_CASE("subnormal coordinates are read under any control word", "[read]") {
  // Denormals are zero; results are flushed; both; exceptions that are not masked; rounding down, up and to zero.
  const std::uint32_t words[] = {0x1f80, 0x1fc0, 0x9f80, 0x9fc0, 0x1e80, 0x1780,
                                 0x0f80, 0x0000, 0x3f80, 0x5f80, 0x7f80};
  std::string stl(80, ' ');
  append(stl, std::uint32_t{1});
  for (int i = 0; i < 12; ++i)
    append(stl, i % 3 == 2 ? 0x1p-140F : static_cast<float>(i));
  stl.append(2, '\0');
  const std::string header = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::string binary = "ply\nformat binary_little_endian 1.0\n" + header;
  for (int i = 0; i < 9; ++i)
    append(binary, i % 3 == 2 ? 0x1p-140F : static_cast<float>(i));
  binary += '\3';
  for (const std::uint32_t v : {0U, 1U, 2U})
    append(binary, v);
  const std::string tiny = "7.17464813734306e-43"; // 2^-140
  const std::pair<const char *, std::string> files[] = {
      {"a.csv", "x,y,z,r\n0,1," + tiny + "," + tiny + "\n"},
      {"a.obj", "v 0 1 " + tiny + "\nv 3 4 " + tiny + "\nv 6 7 " + tiny + "\nf 1 2 3\n"},
      {"a.ply", "ply\nformat ascii 1.0\n" + header + "0 1 " + tiny + "\n3 4 " + tiny + "\n6 7 " + tiny + "\n3 0 1 2\n"},
      {"b.ply", binary},
      {"b.stl", stl},
      {"a.stl", "solid\nfacet\nouter loop\nvertex 0 1 " + tiny + "\nvertex 0 1 " + tiny + "\nvertex 0 1 " + tiny +
                    "\nendloop\nendfacet\nendsolid\n"}};
  meetc::io::transform half;
  half.scale = 0.5;
  for (const auto &[name, content] : files) {
    const fs::path path = put(name, content);
    const auto plain = meetc::io::read(path, kinds), moved = meetc::io::read(path, kinds, half);
    CHECK(plain.data[2] == 0x1p-140F);
    for (const std::uint32_t word : words) {
      const std::uint32_t before = meetc::control_word();
      meetc::set_control_word(word);
      const auto set = meetc::io::read(path, kinds), set_moved = meetc::io::read(path, kinds, half);
      const std::uint32_t after = meetc::control_word();
      meetc::set_control_word(before);
      INFO(name << " under " << word);
      CHECK(set.data == plain.data);
      CHECK(set_moved.data == moved.data);
      CHECK((after & 0xffc0) == (word & 0xffc0));
    }
  }
}
#endif
