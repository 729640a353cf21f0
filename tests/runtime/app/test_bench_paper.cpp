// `meet bench paper`: its rows exist, its counts are those of collide, and its fitted exponents follow from its rows.
#include "fixture.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace fixture;

namespace {

json paper_json(std::vector<std::string> more) {
  more.insert(more.begin(), {"bench", "paper", "--quick", "--json", "--device", "cpu"});
  const said s = run(more);
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(s.err.empty());
  return json::parse(s.out);
}

const json &rows(const json &result, const std::string &name) {
  for (const json &t : result["tables"])
    if (t["name"] == name)
      return t["rows"];
  throw std::runtime_error("no table " + name);
}

// Built in, once.
const json &built_in() {
  static const json j = paper_json({});
  return j;
}

std::vector<std::string> words_of(const json &options) {
  std::istringstream in(options.get<std::string>());
  std::vector<std::string> words;
  for (std::string w; in >> w;)
    words.push_back(w);
  return words;
}

// The answer of `meet collide` on two meshes in the pose that the benchmark prints.
void check_row(const json &row, const std::string &a, const std::string &b, const json &pose) {
  std::vector<std::string> arguments{a, b};
  for (const std::string &w : words_of(pose))
    arguments.push_back(w);
  const json j = answer(arguments);
  CHECK(row["armadillo"] == j["b"]["elements"]);
  CHECK(row["pairs"] == j["pairs"]);
  CHECK(row["bunny_hit"] == j["touched_a"]);
  CHECK(row["armadillo_hit"] == j["touched_b"]);
  CHECK(j["pairs"] > 0);
}

meetc::bodies::mesh larger(meetc::bodies::mesh m, float by) {
  for (float &x : m.xyz)
    x *= by;
  return m;
}

bool is_png(const fs::path &path) {
  return get(path).rfind("\x89PNG\r\n", 0) == 0 && fs::file_size(path) > 2000;
}

} // namespace

// Sections of one case, so that one process makes the page for all.
TEST_CASE("bench paper: the page of built-in bodies") {
  SECTION("counts of built-in meshes are those of collide") {
    using namespace meetc::bodies;
    const json &j = built_in();
    CHECK(j["meshes"] == "built-in");
    CHECK(j["device"].is_null());
    const json &meshes = rows(j, "meshes");
    REQUIRE(meshes.size() == 3);
    put_mesh("ring.ply", torus(25, 20));
    put_mesh("knot.ply", knot(100, 25));
    check_row(meshes[0], "ring.ply", "knot.ply", j["pose"]);
    put_mesh("knot.ply", knot(400, 125));
    check_row(meshes[2], "ring.ply", "knot.ply", j["pose"]);
    CHECK(meshes[0]["paper_row"] == "1K-5K");
    CHECK(meshes[0]["paper_bunny_hit"] == 187);
    CHECK(meshes[2]["paper_armadillo_hit"] == 2215);
  }
  SECTION("the exponent is the slope of its rows, and near enough to the square root") {
    const json &j = built_in();
    std::vector<double> x, y;
    for (const json &row : rows(j, "meshes")) {
      x.push_back(std::log(row["armadillo"].get<double>()));
      y.push_back(std::log(row["armadillo_hit"].get<double>()));
    }
    double mean = 0, absolute = 0, square = 0, product = 0;
    for (const double v : x)
      mean += v / static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      absolute += std::abs(x[i] - mean);
      square += (x[i] - mean) * (x[i] - mean);
      product += (x[i] - mean) * y[i];
    }
    const json &law = j["laws"]["armadillo_hit"];
    CHECK(law["exponent"].get<double>() == Approx(product / square).margin(1e-5));
    // Counts of some hundred triangles scatter by a few per cent, and a coarser mesh is another surface. If each is off
    // by 10 %, the slope can be off by this much and no more.
    const double tolerance = std::log(1.1) * absolute / square;
    CHECK(law["tolerance"].get<double>() == Approx(tolerance).margin(1e-5));
    CHECK(std::abs(law["exponent"].get<double>() - 0.5) <= tolerance);
    CHECK(tolerance < 0.1); // far from 0 and 1, which other scalings would give
    CHECK(law["holds"] == true);
    CHECK(j["laws"]["paper_armadillo_hit"]["holds"] == true);
    CHECK(j["laws"]["paper_armadillo_hit"]["worst"].get<double>() < -0.15); // its row of 1000K
  }
  SECTION("spheres touch as often as random ones must") {
    std::size_t n = 0;
    const json &spheres = rows(built_in(), "spheres");
    REQUIRE(spheres.size() == 5);
    for (const json &row : spheres) {
      const double count = row["spheres"], pairs = row["pairs"], expected = row["expected"];
      CHECK(count == std::vector<double>{500, 1000, 2500, 5000, 10000}[n++]);
      // Half a neighbour each, less the effect of the walls. The number of rare pairs scatters by its square root.
      CHECK(expected <= count / 4);
      CHECK(expected >= 0.85 * count / 4);
      CHECK(std::abs(pairs - expected) <= 4 * std::sqrt(expected));
      CHECK(row["touched"] <= 2 * pairs);
      CHECK(row["touched"] >= pairs);
    }
  }
  SECTION("segments, times, and the columns without a device") {
    const json &j = built_in();
    const json &segments = rows(j, "segments");
    REQUIRE(segments.size() == 8);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      CHECK(segments[i]["triangles"] == 1000 * std::pow(4, static_cast<double>(i / 2)));
      CHECK(segments[i]["segments"] == (i % 2 ? 1000 : 1));
      CHECK(segments[i]["pairs"] > 0);
    }
    CHECK(segments[0]["pairs"] >= 2); // a closed surface is entered and left
    for (const char *const name : {"mesh_times", "spheres", "segments"})
      for (const json &row : rows(j, name)) {
        CHECK(row["core"].get<double>() > 0);
        CHECK(row["blind_over_search"].get<double>() > 0);
        for (const char *const column : {"gpu_ms", "gpu_ms_with_transfers", "core_over_gpu"})
          CHECK(row[column].is_null());
      }
    for (const json &row : rows(j, "moller")) {
      CHECK(row["conformal_over_moller"].get<double>() > 0);
      CHECK(row["certified_over_moller"].get<double>() > 0);
      CHECK(row["hits"] > 0);
    }
    CHECK(j.dump().find("seconds") == std::string::npos); // CPU times are ratios
  }
  SECTION("a page and six pictures, and text that says what it is") {
    fs::remove_all(at("again"));
    const said s = run({"bench", "paper", "--quick", "-o", "again", "--device", "auto", "--threads", "1"});
    INFO(s.err);
    REQUIRE(s.code == 0);
    CHECK(s.err.empty());
    CHECK(files_in(at("again")) == 7);
    for (int i = 1; i <= 6; ++i)
      CHECK(is_png(folder() / fmt::format("again/figure_{}.png", i)));
    const std::string page = get(at("again/paper.md"));
    for (const char *const part : {"Built-in bodies", "the scaling holds", "1K-5K", "no device"}) {
      CHECK(has(s.out, part));
      CHECK(has(page, part));
    }
    for (int i = 1; i <= 6; ++i)
      CHECK(has(page, fmt::format("](figure_{}.png)", i)));
    for (const json &row : rows(built_in(), "meshes")) {
      const int n = row["armadillo_hit"];
      const std::string hit = n < 1000 ? fmt::format("{}", n) : fmt::format("{},{:03}", n / 1000, n % 1000);
      CHECK(has(page, fmt::format("| {} |", hit)));
      CHECK(has(s.out, hit));
    }
    CHECK(has(s.out, "wrote again/figure_6.png"));
  }
}

TEST_CASE("bench paper: counts of files, and of parts cut out of them, are those of collide") {
  using namespace meetc::bodies;
  // In the units for which the pose is given.
  fs::create_directories(at("meshes"));
  put_mesh("meshes/bunny_1k.ply", larger(torus(25, 20), 0.08F));
  const mesh small = larger(knot(100, 25), 60), middle = larger(knot(150, 50), 60);
  put_mesh("meshes/armadillo_5k.ply", small);
  put_mesh("meshes/armadillo_15k.ply", middle);
  put("meshes/armadillo_notes.txt", "no mesh");
  const json j = paper_json({"--data", "meshes"});
  CHECK(j["meshes"] == "files");
  const json &meshes = rows(j, "meshes");
  REQUIRE(meshes.size() == 3); // 5K, 15K, and 15K cut in four
  check_row(meshes[0], "meshes/bunny_1k.ply", "meshes/armadillo_5k.ply", j["pose"]);
  check_row(meshes[1], "meshes/bunny_1k.ply", "meshes/armadillo_15k.ply", j["pose"]);
  put_mesh("finer.ply", subdivide(middle));
  check_row(meshes[2], "meshes/bunny_1k.ply", "finer.ply", j["pose"]);
  CHECK(meshes[1]["paper_row"] == "1K-20K"); // the nearest
  CHECK(meshes[2]["paper_row"].is_null());   // none is near
}

TEST_CASE("bench paper: an error is one line, and nothing is written") {
  const auto with = [](std::vector<std::string> more, int code = 2) {
    more.insert(more.begin(), {"bench", "paper", "--quick"});
    return complaint(more, code);
  };
  fs::create_directories(at("bare"));
  CHECK(with({"--data", "nowhere", "-o", "unmade"}) == "--data nowhere: is not a folder");
  CHECK(has(with({"--data", "bare", "-o", "unmade"}), "bare/bunny_1k.ply: "));
  put("bare/bunny_1k.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                           "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n");
  CHECK(with({"--data", "bare", "-o", "unmade"}) ==
        "bare/bunny_1k.ply: no faces, lines or points to collide; it holds nothing");
  put_mesh("bare/bunny_1k.ply", meetc::bodies::torus(25, 20));
  CHECK(with({"--data", "bare", "-o", "unmade"}) == "--data bare: holds no armadillo_*.ply");
  put_mesh("bare/armadillo_big.ply", meetc::bodies::knot(400, 200));
  CHECK(with({"--data", "bare", "-o", "unmade"}) == "bare: no armadillo_*.ply of up to 100,000 triangles");
  put("bare/armadillo_bad.ply", "ply\nnonsense\n");
  CHECK(has(with({"--data", "bare", "-o", "unmade"}), "bare/armadillo_bad.ply"));
  CHECK_FALSE(fs::exists(at("unmade")));
  put("plain", "no folder");
  CHECK(has(with({"-o", "plain"}), "plain: is not a folder"));
  CHECK(has(with({"-o", "/proc/none"}), "/proc"));
  CHECK(with({"--device", "tpu"}) == "--device 'tpu': unknown; known: auto, cpu, cuda");
  CHECK(has(with({"--threads", "-1"}), "is not a number from 0 to 256"));
  CHECK(has(with({"extra"}), "not expected: extra (meet bench paper --help says more)"));
  CHECK(complaint({"bench"}) ==
        "meet bench: what to measure is needed; known: paper, gpu, cpu, read, formulas (meet bench --help says more)");
  CHECK(has(complaint({"bench", "frob"}), "meet bench: unknown 'frob'; known: paper, gpu, cpu"));
  CHECK(run({"bench", "paper", "--help"}).code == 0);
}
