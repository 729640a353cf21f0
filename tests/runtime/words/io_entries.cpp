#include "entries.hpp"
#include "sets.hpp"

#include "meet/io/files/atomic_file.hpp"
#include "meet/io/files/endian.hpp"
#include "meet/io/read.hpp"
#include "meet/io/write.hpp"
#include "tests/folder.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

namespace words_test {
namespace {

using namespace meetc;
using test_files::put, test_files::get, test_files::folder;

std::vector<const kind_info *> kinds() {
  std::vector<const kind_info *> out;
  for (int i = 0; i < cga::catalogue().kind_count; ++i)
    out.push_back(&cga::catalogue().kinds[i]);
  return out;
}

// Decimals that subnormals, rounding and ties make hard.
constexpr const char *decimals[] = {"1e-40",
                                    "-3e-45",
                                    "1.00000005960464477540",
                                    "0.1",
                                    "16777217",
                                    "1.1754943e-38",
                                    "2.2250738585072011e-308",
                                    "-1e-46",
                                    "0.7006492321624085e-45",
                                    "1e-400",
                                    "433832.18",
                                    "3.4028235e38",
                                    "0.333333333333333314829616256247"};
std::string number(int i) {
  return decimals[static_cast<std::size_t>(i) % std::size(decimals)];
}
std::string point(int i, const char *between) {
  return number(i) + between + number(3 * i + 1) + between + number(7 * i + 2);
}

template <class T> void append(std::string &out, T value) {
  const auto bytes = io::store(value, std::endian::little);
  out.append(bytes.data(), bytes.size());
}

// One file of each format, and of each layout in bytes. Vertices 3 to 6 are a quad that is not planar.
std::vector<std::filesystem::path> files() {
  const auto ply = [](const char *format, const char *type) {
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex 30\nproperty " + type + " x\nproperty " + type +
           " y\nproperty " + type + " z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  };
  std::string csv = "x,y,z,r\n", obj, off = "OFF\n30 2 0\n", stl = "solid s\n", ascii = ply("ascii", "float"),
              binary = ply("binary_little_endian", "double"), binary_stl(80, ' ');
  append(binary_stl, std::uint32_t{10});
  constexpr float floats[] = {1e-40F, 0x1p-149F, -1e-42F, 1, 0x1p-126F, 1e38F, -0.0F};
  for (int i = 0; i < 30; ++i) {
    csv += point(i, ",") + "," + (number(i)[0] == '-' ? "1e-42" : number(i)) + "\n";
    obj += "v " + point(i, " ") + "\n";
    off += point(i, " ") + "\n";
    ascii += point(i, " ") + "\n";
    stl += (i % 3 == 0 ? "facet normal 0 0 0\nouter loop\n" : "") + ("vertex " + point(i, " ")) + "\n" +
           (i % 3 == 2 ? "endloop\nendfacet\n" : "");
    for (int c = 0; c < 3; ++c)
      append(binary, static_cast<double>(floats[(i + 3 * c) % 7]) * (c == 2 ? 1.0000001 : 1));
    if (i % 3 == 0)
      for (int c = 0; c < 12; ++c)
        append(binary_stl, floats[(i + c * c) % 7]);
    if (i % 3 == 0)
      append(binary_stl, std::uint16_t{0});
  }
  for (const int face : {0, 3}) {
    append(binary, static_cast<std::uint8_t>(face == 0 ? 3 : 4));
    for (int v = face; v < (face == 0 ? 3 : 7); ++v)
      append(binary, v);
  }
  return {put("a.csv", csv),
          put("a.obj", obj + "f 1 2 3\nf 4 5 6 7\n"),
          put("a.off", off + "3 0 1 2\n4 3 4 5 6\n"),
          put("a.stl", stl + "endsolid s\n"),
          put("a.ply", ascii + "3 0 1 2\n4 3 4 5 6\n"),
          put("b.ply", binary),
          put("b.stl", binary_stl)};
}

std::vector<io::transform> transforms() {
  std::vector<io::transform> out(4);
  out[1].translate = {0, 0, 0};
  out[2].scale = 1 / 3.0, out[2].translate = {0.1, 1e-310, 0x1.8p-148};
  out[3].matrix = {0, -0.5, 0, 1e-40, 0.5, 0, 0, 0.1, 0, 0, 0.5, 0};
  return out;
}

void add(caller &to, const io::element_set &s) {
  to.answer += s.kind->name;
  to.add(s.elements), to.add(s.items), to.add(s.vertices);
  to.add_all(s.data), to.add_all(s.index), to.add_all(s.owner);
  to.add(s.rounded.numbers), to.add(s.rounded.largest);
  for (const std::string &note : s.notes)
    to.answer += note;
}

void call_read(caller &under) {
  const std::vector<const kind_info *> of = kinds();
  for (const std::filesystem::path &file : files())
    for (const io::transform &by : transforms()) {
      const io::read_options in_pieces = {.move = by, .threads = 2, .piece_bytes = 64};
      std::optional<io::element_set> set, same;
      under([&] { set = io::read(file, of, by); });
      under([&] { same = io::read(file, of, in_pieces); });
      if (!set || !same)
        throw std::logic_error("not read: " + under.answer);
      add(under, *set), add(under, *same);
    }
  for (const char *const beyond : {"1e39", "3.4028235677973367e38", "-1e-40"}) {
    const std::filesystem::path bad = put("bad.csv", std::string("x,y,z,r\n1,2,3,") + beyond + "\n");
    under([&] { io::read(bad, of); });
  }
  io::transform large; // which takes the numbers out of float32
  large.scale = 1e300;
  const std::filesystem::path path = files()[0];
  under([&] { io::read(path, of, large); });
}
void call_format_named(caller &under) {
  io::file_format format{};
  under([&] { format = io::format_named("--format-a", "stl"); });
  under.add(format);
  under([&] { io::format_named("--format-a", "stil"); });
}
void call_lists(caller &under) {
  io::vertex_lists lists;
  std::size_t count = 0;
  under([&] { lists.end_list(3), lists.end_list(5), count = lists.count(1); });
  under.add(count);
}
void call_rounded(caller &under) {
  io::rounded_numbers sum;
  under([&] {
    io::rounded_numbers more;
    more.add(1e-310), more.add(0x1p-1070), sum.add(0x1p-1074), sum.add(more);
  });
  under.add(sum.numbers), under.add(sum.largest);
}
void call_members_of_set(caller &under) {
  const io::element_set set = io::read(files()[1], kinds());
  std::size_t owner = 0;
  float row[9];
  under([&] { owner = set.owner_of(1), set.row(1, row); });
  view of;
  under([&] { of = io::view_of(set); });
  under.add(owner), under.add_all(row, 9), under.add(of.elements);
}
void call_write_ply(caller &under) {
  const io::element_set set = io::read(files()[4], kinds());
  const std::filesystem::path path = (folder() / "out.ply");
  under([&] { io::write_ply(path, set); });
  under.answer += get(path);
  under([&] { io::write_ply(path, set.data, set.index); });
  under.answer += get(path);
}
void call_write_pairs_csv(caller &under) {
  const std::vector<index_pair> pairs = {{0, 1}, {4'000'000'000, 7}};
  const std::filesystem::path path = (folder() / "pairs.csv");
  under([&] { io::write_pairs_csv(path, pairs); });
  under.answer += get(path);
}
void call_atomic_file(caller &under) {
  const std::filesystem::path path = (folder() / "whole.txt");
  under([&] {
    io::atomic_file file(path);
    std::fputs("one", file.stream());
    file.write(" two");
    file.commit();
  });
  under.answer += get(path);
  under([&] { io::write_file(path, "three"); });
  under.answer += get(path);
}
void call_error(caller &under) {
  std::string said;
  under([&] { said = io::error("a.csv:1: it is wrong").what() + io::quote("to\nken"); });
  under.answer += said;
}
void call_members_of_transform(caller &under) {
  for (const io::transform &by : transforms()) {
    bool any = false;
    std::string options;
    std::array<double, 3> moved{};
    under([&] {
      by.check();
      any = by.any(), options = by.options() + by.option("scale"), moved = by.point({0x1p-149, -0.1, 1e-310});
    });
    under.add(any), under.add(moved);
    under.answer += options;
  }
  io::transform tiny;
  tiny.scale = 1e-310;
  under([&] { tiny.check(); });
  tiny.scale = -1e-310;
  under([&] { tiny.check(); });
}
void call_similarity_scale(caller &under) {
  for (const double size : {1.0, 1e-160, 0x1p-1060, 1e160, 0.3}) {
    const std::array<double, 12> matrix = {0, -size, 0, 1, size, 0, 0, 2, 0, 0, size, 3};
    std::optional<double> scale;
    under([&] { scale = io::similarity_scale(matrix); });
    under.add(scale.value_or(-1));
  }
}
void call_move_set(caller &under) {
  for (const std::filesystem::path &file : files())
    for (const io::transform &by : transforms()) {
      io::element_set set = io::read(file, kinds());
      std::optional<io::misplaced> fault;
      under([&] { fault = io::move_set(set, by, "a.csv", 2); });
      under.answer += fault ? fault->what : "";
      add(under, set);
    }
}
void call_round_point(caller &under) {
  for (const io::transform &by : transforms()) {
    std::array<float, 3> out{};
    const std::array<double, 3> in = {0x1p-149, -0.1, 1e-40};
    under([&] { out = io::round_point(by, in); });
    under.add(out);
  }
}
void call_describe_non_finite(caller &under) {
  std::string said;
  under(
      [&] { said = io::describe_non_finite("x", 1e39, HUGE_VALF) + io::describe_non_finite("x", 1e-310, HUGE_VALF); });
  under.answer += said;
}

constexpr entry all[] = {
    {"read", call_read},
    {"format_named", call_format_named},
    {"vertex_lists::end_list", call_lists},
    {"vertex_lists::count", call_lists},
    {"rounded_numbers::add", call_rounded},
    {"view_of", call_members_of_set},
    {"element_set::owner_of", call_members_of_set},
    {"element_set::row", call_members_of_set},
    {"write_ply", call_write_ply},
    {"write_pairs_csv", call_write_pairs_csv},
    {"atomic_file::atomic_file", call_atomic_file},
    {"atomic_file::commit", call_atomic_file},
    {"atomic_file::stream", call_atomic_file},
    {"atomic_file::write", call_atomic_file},
    {"write_file", call_atomic_file},
    {"error::error", call_error},
    {"quote", call_error},
    {"transform::any", call_members_of_transform},
    {"transform::check", call_members_of_transform},
    {"transform::option", call_members_of_transform},
    {"transform::options", call_members_of_transform},
    {"transform::point", call_members_of_transform},
    {"similarity_scale", call_similarity_scale},
    {"move_set", call_move_set},
    {"round_point", call_round_point},
    {"describe_non_finite", call_describe_non_finite},
};

} // namespace

std::span<const entry> io_entries() {
  return all;
}

} // namespace words_test
