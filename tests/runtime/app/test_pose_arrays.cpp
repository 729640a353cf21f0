// Poses of bodies as an array of NumPy: each way in which one may lie in its file, and each fault.
#include "fixture.hpp"

#include "meet/io/files/endian.hpp"

using namespace fixture;

namespace {

using meetc::io::store;

// A file of the format, made from its description.
struct array_file {
  std::vector<std::size_t> shape;
  std::vector<double> numbers; // the last index varies first
  int version = 1;
  std::string type = "<f8";
  bool columns_first = false;

  std::string header() const {
    return fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({},), }}", type,
                       columns_first ? "True" : "False", fmt::join(shape, ", "));
  }
  // The numbers in the order and type of the file.
  std::string body() const {
    std::vector<std::size_t> steps(shape.size(), 1); // of an index, in the file
    for (std::size_t i = 1; i < shape.size(); ++i)
      if (columns_first)
        steps[i] = steps[i - 1] * shape[i - 1];
      else
        for (std::size_t k = 0; k < i; ++k)
          steps[k] *= shape[i];
    std::vector<double> placed(numbers.size());
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      std::size_t rest = n, place = 0;
      for (std::size_t i = shape.size(); i-- > 0; rest /= shape[i])
        place += rest % shape[i] * steps[i];
      placed[place] = numbers[n];
    }
    const std::endian order = type[0] == '>' ? std::endian::big : std::endian::little;
    std::string out;
    const auto add = [&out](const auto &bytes) { out.append(bytes.begin(), bytes.end()); };
    for (const double x : placed)
      if (type[2] == '4')
        add(store(static_cast<float>(x), order));
      else
        add(store(x, order));
    return out;
  }
  static std::string bytes(int version, std::string header, const std::string &body) {
    header.resize((header.size() + 64) / 64 * 64, ' ');
    header.back() = '\n';
    const auto length = store(static_cast<std::uint32_t>(header.size()), std::endian::little);
    return "\x93NUMPY" + std::string{static_cast<char>(version), '\0'} +
           std::string(length.begin(), length.begin() + (version == 1 ? 2 : 4)) + header + body;
  }
  std::string bytes() const { return bytes(version, header(), body()); }
};

void put_world() {
  put_mesh("cube.ply", meetc::bodies::block(1, 1, 1, 0));
  put("cell.json", R"({"bodies": [{"name": "a", "file": "cube.ply"}, {"name": "b", "file": "cube.ply"},
                                  {"name": "c", "file": "cube.ply"}]})");
}

// Three frames of three bodies, which have turned and lie at x; the numbers are exact in float32.
array_file three_frames() {
  array_file out;
  out.shape = {3, 3, 4, 4};
  const double places[] = {0, 0.5, 9, 0, 5, 5.25, 3, 2.5, 2};
  for (const double x : places)
    for (const double m : {0.0, -1.0, 0.0, x, 1.0, 0.0, 0.0, x / 8, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0})
      out.numbers.push_back(m);
  return out;
}

json frames_of(const std::string &bytes) {
  put("poses.npy", bytes);
  json frames = answer({"--world", "cell.json", "--poses", "poses.npy"})["frames"];
  return frames;
}

} // namespace

TEST_CASE("an array of poses answers as the same rows of text, however it lies in its file") {
  put_world();
  array_file a = three_frames();
  std::string rows = "frame,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n";
  for (std::size_t i = 0; i < 9; ++i)
    rows += fmt::format("{},{},{}\n", i / 3, "abc"[i % 3],
                        fmt::join(a.numbers.begin() + static_cast<std::ptrdiff_t>(16 * i),
                                  a.numbers.begin() + static_cast<std::ptrdiff_t>(16 * i + 12), ","));
  put("poses.csv", rows);
  const json want = answer({"--world", "cell.json", "--poses", "poses.csv"})["frames"];
  REQUIRE(want.size() == 3);
  CHECK(want[0]["touching"].size() == 1);
  CHECK(want[2]["touching"].size() == 3);
  for (const int version : {1, 2, 3})
    for (const char *const type : {"<f4", "<f8", ">f4", ">f8"})
      for (const bool columns_first : {false, true}) {
        CAPTURE(version, type, columns_first);
        a.version = version, a.type = type, a.columns_first = columns_first;
        CHECK(frames_of(a.bytes()) == want);
      }
  CHECK(frames_of(array_file::bytes(1, R"({"shape":(3,3,4,4),"fortran_order":True,"descr":">f8"})", a.body())) == want);

  array_file one = a; // one frame
  one.shape = {3, 4, 4};
  one.numbers.resize(48);
  const json frame = frames_of(one.bytes());
  REQUIRE(frame.size() == 1);
  CHECK(frame[0]["frame"] == "");
  CHECK(frame[0]["touching"] == want[0]["touching"]);
}

TEST_CASE("rotations are motions to the accuracy of float32, in arrays and in tables") {
  put_world();
  array_file a;
  a.shape = {3, 4, 4};
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (const double x : {0.0, 0.5, 9.0})
    for (const double m : {c, -s, 0.0, x, s, c, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0})
      a.numbers.push_back(m);
  a.type = "<f4";
  CHECK(frames_of(a.bytes())[0]["touching"].size() == 1);
  a.type = "<f8";
  CHECK(frames_of(a.bytes())[0]["touching"].size() == 1);
  put("poses.csv", "frame,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n"
                   "1,a,0.955336,-0.295520,0,0,0.295520,0.955336,0,0,0,0,1,0\n");
  CHECK(answer({"--world", "cell.json", "--poses", "poses.csv"})["frames"].size() == 1);
  a.numbers[0] += 1e-4;
  put("poses.npy", a.bytes());
  CHECK(has(complaint({"collide", "--world", "cell.json", "--poses", "poses.npy"}),
            "poses.npy: body a: the matrix is no rotation"));
}

TEST_CASE("a fault of an array is one line that names the file, the frame and the body") {
  put_world();
  const auto fault_of = [](const std::string &bytes) {
    put("poses.npy", bytes);
    return complaint({"collide", "--world", "cell.json", "--poses", "poses.npy"});
  };
  const array_file good = three_frames();
  array_file a = good;
  a.numbers[16 * 7 + 3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(has(fault_of(a.bytes()), "poses.npy: frame 2, body b: a number of the pose is not finite"));
  a = good, a.numbers[16 * 5 + 12] = 0.5;
  CHECK(
      has(fault_of(a.bytes()), "poses.npy: frame 1, body c: the last row of the 4x4 matrix is 0.5,0,0,1, not 0,0,0,1"));
  a = good, a.numbers[16 * 3] = 2;
  CHECK(has(fault_of(a.bytes()), "poses.npy: frame 1, body a: the matrix is no rotation with one scale"));
  a = good, a.shape = {9, 4, 4};
  CHECK(
      has(fault_of(a.bytes()), "poses.npy: its shape is (9, 4, 4); for 3 bodies it is (frames, 3, 4, 4) or (3, 4, 4)"));
  a = good, a.shape = {144};
  CHECK(has(fault_of(a.bytes()), "its shape is (144,); for 3 bodies"));
  a = good, a.shape = {0, 3, 4, 4}, a.numbers.clear();
  CHECK(has(fault_of(a.bytes()), "poses.npy: it has no frame"));

  const std::string head = good.header(), body = good.body();
  const auto with = [&](const std::string &from, const std::string &to) {
    std::string h = head;
    REQUIRE(h.find(from) != std::string::npos);
    return array_file::bytes(1, h.replace(h.find(from), from.size(), to), body);
  };
  CHECK(has(fault_of(with("<f8", "|O")), "poses.npy: its numbers are of type '|O'; float32 and float64 are read"));
  CHECK(has(fault_of(with("<f8", "<i8")), "of type '<i8'; float32 and float64"));
  CHECK(has(fault_of(with("'<f8'", "[('m', '<f8')]")), "float32 and float64 are read"));
  CHECK(has(fault_of(with("<f8", "<f4")),
            "1152 bytes follow the header, which is not what an array of shape (3, 3, 4, 4) has"));
  CHECK(has(fault_of(with("(3,", "(18446744073709551615,")), "is not what an array of shape"));
  CHECK(has(fault_of(with("(3,", "(18446744073709551616,")), "poses.npy: its header is no dictionary of"));
  CHECK(has(fault_of(with("(3,", "(-3,")), "poses.npy: its header is no dictionary of"));
  for (const char *const part : {"'descr'", "'fortran_order'", "'shape'", "{", "}", "(", ")", ":", "False", ","})
    CHECK(has(fault_of(with(part, "x")),
              "poses.npy: its header is no dictionary of 'descr', 'fortran_order' and 'shape': "));
  CHECK(has(fault_of(with("'shape'", "'descr': '<f8', 'shape'")), "its header is no dictionary"));
  CHECK(has(fault_of(with("}", "} 1")), "its header is no dictionary"));
  CHECK(has(fault_of(array_file::bytes(1, "", body)), "its header is no dictionary"));
  CHECK(has(fault_of(good.bytes() + "x"), "1153 bytes follow the header"));
  const std::string all = good.bytes();
  for (const std::size_t size : {std::size_t{6}, std::size_t{7}, std::size_t{9}, std::size_t{11}, std::size_t{100}})
    CHECK(has(fault_of(all.substr(0, size)), "poses.npy: the file ends within its header"));
  CHECK(has(fault_of(all.substr(0, all.size() - 1)), "1151 bytes follow the header"));
  CHECK(has(fault_of(array_file::bytes(4, head, body)), "poses.npy: version 4 of the format; 1 to 3 are read"));
  CHECK(has(fault_of(array_file::bytes(0, head, body)), "poses.npy: version 0 of the format"));
}
