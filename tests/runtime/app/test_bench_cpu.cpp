// `meet bench cpu`: every family is there, answers are right, and wrong options give one line.
#include "tests/runtime/app/fixture.hpp"

using namespace fixture;

namespace {

json bench(std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"bench", "cpu", "--quick", "--repetitions", "1", "--json"});
  const said s = run(more);
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(s.err.empty());
  return json::parse(s.out);
}

} // namespace

TEST_CASE("bench cpu: every family, and certified answers that are those of exact") {
  const json all = bench();
  CHECK(all["quick"] == true);
  CHECK(all["meshes"] == "built-in");
  CHECK(all["threads"] == 1);
  CHECK(!all["machine"].get<std::string>().empty());
  CHECK(table(all, "precision").size() == 5);
  for (const json &row : table(all, "precision")) {
    CHECK(row["certified_differs"] == 0);
    CHECK(row["hits"] > 0);
  }
  for (const char *const scene : {"segments", "self", "bodies", "bodies_2_threads"})
    for (const json &row : table(all, scene)) {
      INFO(scene << row.dump());
      CHECK(row["query_ms"] > 0);
      const std::string method = row["method"];
      if (method.rfind("certified", 0) == 0 || method == "exact") {
        CHECK(row["false_hits"] == 0);
        CHECK(row["missed"] == 0);
        CHECK(row["found"] > 0);
      }
    }
  REQUIRE(table(all, "many_balls").size() == 1);
  CHECK(table(all, "many_balls")[0]["certified_differs"] == 0);
  CHECK(table(all, "refit").size() == 18);
  for (const json &row : table(all, "refit")) {
    CHECK(row["differs"] == 0);
    CHECK(row["refit_ms"] > 0);
  }
  CHECK(table(all, "cancel").size() == 4);
  for (const json &row : table(all, "families"))
    CHECK(row["differ"] == 0);
  CHECK(table(all, "families").size() % 6 == 0);

  const json &bars = table(all, "bars");
  CHECK(bars.size() > 20);
  for (const json &row : bars)
    CHECK(row["met"].is_null() == row["measured"].is_null());
}

TEST_CASE("bench cpu: one family, one instruction set, and a page") {
  const json one = bench({"--only", "precision", "--instruction-set", "baseline", "--threads", "2"});
  REQUIRE(one["tables"].size() == 2);
  CHECK(one["tables"][0]["name"] == "precision");
  CHECK(one["tables"][1]["name"] == "bars");
  CHECK(one["threads"] == 2);
  const said s = run({"bench", "cpu", "--quick", "--repetitions", "1", "--only", "families", "--instruction-set",
                      "baseline", "-o", "page"});
  REQUIRE(s.code == 0);
  CHECK(has(s.out, "wrote page/cpu.md"));
  const std::string page = get(at("page/cpu.md"));
  CHECK(has(page, "# Measured on a CPU"));
  CHECK(has(page, "| baseline | "));
  CHECK_FALSE(has(page, "| avx2 |"));
  CHECK(has(page, "## Speeds to reach"));
}

TEST_CASE("bench cpu: many balls on one thread, and on twice as many up to those that are asked for") {
  const json all = bench({"--only", "balls", "--threads", "3"});
  std::vector<int> threads;
  for (const json &row : table(all, "many_balls")) {
    threads.push_back(row["threads"]);
    CHECK(row["certified_differs"] == 0);
    CHECK(row["certified_ms"] > 0);
  }
  CHECK(threads == std::vector<int>{1, 2, 3});
  for (const json &row : table(all, "bars"))
    CHECK(row["met"].is_null()); // they are for 16
  const json on_16 = bench({"--only", "balls", "--threads", "16"});
  for (const json &row : table(on_16, "bars"))
    CHECK(row["met"].is_boolean());
}

TEST_CASE("bench cpu: files, and a folder that lacks one") {
  fs::create_directories(at("meshes"));
  CHECK(has(complaint({"bench", "cpu", "--quick", "--data", "meshes"}), "meshes/bunny_5k.ply"));
  put_mesh("meshes/armadillo_5k.ply", meetc::bodies::icosphere(2));
  put_mesh("meshes/bunny_5k.ply", meetc::bodies::torus(20, 10));
  const json all = bench({"--data", "meshes", "--only", "precision"});
  CHECK(all["meshes"] == "files");
  CHECK(table(all, "precision").size() == 5);
}

TEST_CASE("bench cpu: an error is one line, and nothing is written") {
  const auto with = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"bench", "cpu", "--quick", "-o", "unmade"});
    return complaint(more);
  };
  CHECK(with({"--data", "nowhere"}) == "--data nowhere: is not a folder");
  CHECK(with({"--only", "nonsense"}) == "--only 'nonsense': no family has this in its name");
  CHECK(with({"--repetitions", "0"}) == "--repetitions: '0' is not a number from 1 to 1000");
  CHECK(with({"--repetitions", "many"}) == "--repetitions: 'many' is not a number from 1 to 1000");
  CHECK(has(with({"--threads", "-1"}), "is not a number from 0 to 256"));
  CHECK(has(with({"--instruction-set", "mmx"}), "mmx"));
  CHECK(has(with({"extra"}), "not expected: extra (meet bench cpu --help says more)"));
  CHECK_FALSE(fs::exists(at("unmade")));
  CHECK(run({"bench", "cpu", "--help"}).code == 0);
}
