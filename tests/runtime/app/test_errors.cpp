// Every error is one line that says what is wrong, with exit code 2 (3 for the device) and nothing on standard output.
#include "fixture.hpp"

#include <algorithm>
#include <cstdlib>

using namespace fixture;

namespace {

void put_files() {
  put_mesh("ball.ply", meetc::bodies::icosphere(1));
  put("balls.csv", "x,y,z,r\n1,0,0,0.5\n");
  put("rods.csv", "x0,y0,z0,x1,y1,z1\n0,0,0,2,0,0\n");
  put("points.csv", "x,y,z\n0,0,0\n");
}

std::string collide_complaint(std::vector<std::string> more, int code = 2) {
  more.insert(more.begin(), "collide");
  return complaint(more, code);
}

} // namespace

TEST_CASE("usage") {
  put_files();
  CHECK(has(complaint({}), "a command is needed first: collide, inspect, demo, bench or trade"));
  CHECK(has(complaint({"--frob"}), "a command is needed"));
  CHECK(has(complaint({"frob"}), "unknown command 'frob'; known: collide, inspect, demo, bench, trade"));
  CHECK(has(complaint({"collide"}), "A is required (meet collide --help says more)"));
  CHECK(has(complaint({"collide", "ball.ply"}), "B is required"));
  CHECK(has(complaint({"inspect"}), "A is required (meet inspect --help says more)"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--frob"}), "not expected: --frob"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--pairs"}), "--pairs: its value is missing"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--mode", "solid", "--mode", "solid"}),
            "--mode: given more than once"));
  CHECK(has(complaint({"demo", "x"}), "not expected: x"));
  // A suggestion, where a known name is near.
  CHECK(has(complaint({"colide"}), "unknown command 'colide'; did you mean 'collide'?; known: "));
  CHECK(has(complaint({"bench", "papper"}), "unknown 'papper'; did you mean 'paper'?; known: "));
  CHECK(has(complaint({"--hlep"}),
            "a command is needed first: collide, inspect, demo, bench or trade; did you mean '--help'?"));
  CHECK(has(complaint({"collide", "--hlep"}),
            "not expected: --hlep; did you mean '--help'? (meet collide --help says more)"));
  CHECK(has(complaint({"bench", "cpu", "--onyl", "balls"}), "not expected: --onyl; did you mean '--only'?"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--pair", "p.csv"}),
            "not expected: --pair; did you mean '--pairs'?"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--translate=1,2,3"}),
            "not expected: --translate=1,2,3; did you mean '--translate-a'?"));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--image", "x.jpg"}),
            "--image x.jpg: pictures are PNG; name it x.png"));
  CHECK_FALSE(fs::exists(at("x.jpg")));
}

TEST_CASE("help says what there is, and only that") {
  const said all = run({"--help"}), one = run({"collide", "-h"});
  CHECK(all.code == 0);
  CHECK(one.code == 0);
  for (const char *const command : {"collide", "inspect", "demo", "bench", "trade"}) {
    CHECK(has(all.out, command));
    CHECK(run({command, "--help"}).code == 0);
  }
  CHECK_FALSE(has(one.out, "tolerant")); // --tolerance asks for it
  for (const char *const option :
       {"--predicate", "--mode",    "--precision",   "--tolerance", "--device",   "--translate-b", "--scale-b",
        "--matrix-b",  "--motor-b", "--translate-a", "--scale-a",   "--matrix-a", "--format-a",    "--format-b",
        "--kind-a",    "--kind-b",  "--any",         "--pairs",     "--first",    "--color",       "--image",
        "--json",      "--threads", "--devices",     "--camera",    "--size"})
    CHECK(has(one.out, option));
  CHECK(has(one.out, "pairs is 0 or 1"));
  CHECK(run({"--version"}).out.rfind("meet ", 0) == 0);
}

TEST_CASE("no device: one line, exit code 3, and nothing is written") {
  put_files();
  ::setenv("CUDA_VISIBLE_DEVICES", "", 1); // where there is one, it is hidden
  const std::string why =
      collide_complaint({"ball.ply", "ball.ply", "--device", "cuda", "--pairs", "p.csv", "--image", "p.png"}, 3);
  CHECK((why == "there is no CUDA device here; the CPU decides the same pairs (--device cpu)" ||
         why == "--device cuda: this build has no CUDA kernels (" MEETC_NO_CUDA "); use --device cpu"));
  for (const char *const file : {"p.csv", "p.png"})
    CHECK_FALSE(fs::exists(at(file)));
  const std::string bench = complaint({"bench", "gpu", "-o", "measured"}, 3);
  ::unsetenv("CUDA_VISIBLE_DEVICES");
  CHECK((has(bench, "there is no CUDA device here") || has(bench, "this build has no CUDA kernels")));
  CHECK_FALSE(fs::exists(at("measured")));
  CHECK(has(complaint({"bench", "gpu", "--only"}), "its value is missing"));
}

TEST_CASE("values of options") {
  put_files();
  const auto with = [](const std::string &option, const std::string &value, int code = 2) {
    return collide_complaint({"ball.ply", "ball.ply", option, value}, code);
  };
  for (const char *const p : {"fp16", "Certified", "FP32", ""})
    CHECK(has(with("--precision", p), "there is none of this name; known: fp32, fp64, fp64x2, exact, certified"));
  CHECK(with("--device", "tpu") == "--device 'tpu': unknown; known: auto, cpu, cuda");
  CHECK(with("--mode", "hollow") == "--mode 'hollow': unknown; known: solid, surface");
  for (const char *const n : {"-1", "257", "two", "1.5", ""})
    CHECK(has(with("--threads", n), "is not a number from 0 to 256"));
  for (const char *const n : {"-1", "0", "65", "two", "1.5", ""})
    CHECK(has(with("--devices", n), "is not a number from 1 to 64"));
  CHECK(with("--devices", "2") == "--devices 2: needs --device cuda");
  CHECK(with("--scale-b", "0") == "--scale-b: the scale is 0; it must be finite and above 0");
  CHECK(has(with("--scale-b", "-2"), "--scale-b: the scale is -2; it must be finite and above 0"));
  CHECK(has(with("--scale-b", "nan"), "--scale-b: the scale is nan; it must be finite"));
  CHECK(has(with("--scale-b", "big"), "--scale-b: 'big' is not a number"));
  CHECK(has(with("--scale-b", "1,2"), "--scale-b: 1 number expected, 2 given"));
  CHECK(has(with("--translate-b", "1,2"), "--translate-b: 3 numbers expected, with commas between them, 2 given"));
  CHECK(has(with("--translate-b", "1,2,x"), "'x' is not a number"));
  CHECK(has(with("--translate-b", "1,2,inf"), "--translate-b: the translation holds inf"));
  CHECK(has(with("--matrix-b", "1,2,3"), "--matrix-b: 12 numbers expected"));
  CHECK(has(with("--matrix-b", "1,0,0,0,0,nan,0,0,0,0,1,0"), "--matrix-b: the matrix holds nan"));
  for (const char *const list : {"1,,2,3", ",1,2,3", "1,2,3,", "1, ,2,3", "1,2,,3", ","})
    CHECK(with("--translate-b", list) == fmt::format("--translate-b: '{}' lacks a number beside a comma", list));
  CHECK(has(with("--translate-b", ""), "3 numbers expected"));
  CHECK(has(with("--scale-b", "1e39"), "ball.ply: vertex 0: x is "));
  CHECK(has(with("--scale-b", "1e39"), "not finite in float32 after --scale-b (read as "));
  CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--scale-b", "2", "--translate-b", "0,0,1e39"}),
            "z is inf, not finite in float32 after --scale-b, --translate-b (read as "));
  for (const char *const option : {"--pairs", "--color", "--image"})
    CHECK(has(collide_complaint({"ball.ply", "ball.ply", "--any", option, "x"}), "--any stops at the first pair"));
}

TEST_CASE("kinds and predicates that do not fit name those that do") {
  put_files();
  const std::string none = collide_complaint({"points.csv", "balls.csv"});
  CHECK(has(none, "no predicate for point with sphere; supported: segment with segment, point with triangle, "));
  CHECK(has(none, "sphere with triangle"));
  CHECK(has(collide_complaint({"balls.csv", "points.csv"}), "no predicate for sphere with point"));
  CHECK(collide_complaint({"ball.ply", "ball.ply", "--predicate", "ball_ball"}) ==
        "--predicate ball_ball: it is for sphere with sphere, but the files hold triangle with triangle; for "
        "these: "
        "triangle_triangle");
  CHECK(collide_complaint({"ball.ply", "balls.csv", "--predicate", "frob"}) ==
        "--predicate 'frob': unknown; for triangle with sphere there is: ball_triangle, sphere_triangle");
  CHECK(collide_complaint({"ball.ply", "balls.csv", "--predicate", "ball_triangle", "--mode", "surface"}) ==
        "--predicate ball_triangle answers for --mode solid, not surface");
}

TEST_CASE("files") {
  put_files();
  const auto with = [](const std::string &file) { return collide_complaint({"ball.ply", file}); };
  CHECK(has(with("missing.ply"), "missing.ply: "));
  CHECK(has(with("noextension"), "noextension: the name has no extension"));
  CHECK(has(with("body.xyz"), "unknown extension '.xyz'"));
  CHECK(has(with("."), ".: "));
  put("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nope\nf 1 2 3\n");
  CHECK(has(with("bad.obj"), "bad.obj:3: "));
  put("nan.csv", "x,y,z,r\n0,0,0,1\n0,nan,0,1\n");
  CHECK(has(with("nan.csv"), "nan.csv:3: sphere 1: y is nan"));
  put("negative.csv", "x,y,z,r\n0,0,0,-1\n");
  CHECK(has(with("negative.csv"), "negative.csv:2: sphere 0: r >= 0"));
  put("header.csv", "a,b\n1,2\n");
  CHECK(has(with("header.csv"), "unknown header 'a,b'; supported: "));
  put("cut.ply", get(at("ball.ply")).substr(0, 300));
  CHECK(has(with("cut.ply"), "cut.ply: "));
  put("empty.csv", "");
  CHECK(has(with("empty.csv"), "empty.csv: "));
  const std::string odd = "two\nlines.ply";
  CHECK(has(with(odd), "two\\x0alines.ply"));
}
