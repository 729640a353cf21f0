// The program in a process in which another library has set flush-to-zero and denormals-are-zero.
#include "fixture.hpp"

using namespace fixture;

namespace {

// Runs the program with the library loaded into it, if `flushing`.
said run_with(bool flushing, const std::vector<std::string> &arguments) {
  if (flushing)
    setenv("LD_PRELOAD", MEETC_FLUSHING, 1);
  said s = run(arguments);
  unsetenv("LD_PRELOAD");
  return s;
}

} // namespace

TEST_CASE("flushing: files of subnormal numbers are read, moved and answered as they are") {
  put("triangle.csv", "x0,y0,z0,x1,y1,z1,x2,y2,z2\n0,0,1e-40,1,0,1e-40,0,1,1e-40\n");
  put("points.csv", "x,y,z\n0.25,0.25,1e-40\n0.25,0.25,0\n0.25,0.25,2e-40\n");
  put("tiny.csv", "x,y,z,r\n1e-40,0,0,1e-41\n3e-41,0,0,2e-41\n");
  put("mesh.obj", "v 0 0 1e-40\nv 1 0 1e-40\nv 0 1 1e-40\nf 1 2 3\n");
  for (const std::vector<std::string> &arguments :
       {std::vector<std::string>{"collide", "triangle.csv", "points.csv", "--json"},
        {"collide", "triangle.csv", "points.csv", "--translate-b", "0,0,1e-40", "--json"},
        {"collide", "tiny.csv", "tiny.csv", "--json"},
        {"collide", "mesh.obj", "points.csv", "--json"},
        {"inspect", "mesh.obj", "tiny.csv"}}) {
    const said plain = run_with(false, arguments), flushed = run_with(true, arguments);
    const auto without_times = [](std::string text) {
      for (const std::string_view from : {"\"seconds\"", " ms"})
        if (const std::size_t at = text.find(from); at != std::string::npos)
          text.resize(at);
      return text;
    };
    INFO(arguments[0] << " " << arguments[1] << " " << arguments[2]);
    CHECK(flushed.code == plain.code);
    CHECK(without_times(flushed.out) == without_times(plain.out));
    CHECK(flushed.err == plain.err);
  }
  setenv("LD_PRELOAD", MEETC_FLUSHING, 1);
  const json one = answer({"triangle.csv", "points.csv"}),
             moved = answer({"triangle.csv", "points.csv", "--translate-b", "0,0,1e-40"}),
             balls = answer({"tiny.csv", "tiny.csv"});
  unsetenv("LD_PRELOAD");
  CHECK(one["pairs"] == 1);
  CHECK(moved["pairs"] == 1);
  CHECK(balls["pairs"] == 2);
}
