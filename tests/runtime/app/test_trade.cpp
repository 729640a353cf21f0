// `meet trade`: every predicate on every family, the rungs that are never wrong, its files, and wrong options.
#include "tests/runtime/app/fixture.hpp"

using namespace fixture;

namespace {

json trade(std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"trade", "--quick", "--repetitions", "1", "--json", "--device", "cpu"});
  const said s = run(more);
  INFO(s.err);
  REQUIRE(s.code == 0);
  CHECK(s.err.empty());
  return json::parse(s.out);
}

// The members that do not depend on time.
json counts(const json &all) {
  json out;
  for (const char *const family : {"random", "far", "small", "large", "near", "near_far"})
    for (const json &row : table(all, family))
      out.push_back({row["predicate"], row["method"], row["false"], row["missed"], row["farthest"], row["proved"]});
  return out;
}

} // namespace

TEST_CASE("trade: methods that are never wrong, others, and the same figures in each run") {
  const json all = trade();
  CHECK(all["quick"] == true);
  CHECK(!all["instruction_set"].get<std::string>().empty());
  std::size_t wrong = 0, bounded = 0;
  for (const char *const family : {"random", "far", "small", "large", "near", "near_far"}) {
    CHECK(table(all, family).size() ==
          61); // five rungs of ten predicates, three of them the paper's way, and eight rounded
    for (const json &row : table(all, family)) {
      INFO(family << row.dump());
      CHECK(row["ns"] > 0);
      const int errors = row["false"].get<int>() + row["missed"].get<int>();
      if (row["method"] == "exact" || row["method"] == "certified") {
        CHECK(errors == 0);
        CHECK(row["proved"] == 0);
      }
      if (row["proved"].is_number()) {
        CHECK(row["farthest"] <= row["proved"]);
        ++bounded;
      }
      wrong += errors > 0;
    }
  }
  CHECK(wrong > 50);
  CHECK(bounded > 100);
  for (const json &row : table(all, "losers"))
    CHECK(row["method"] != "certified"); // nothing that is never wrong is faster
  for (const json &row : table(all, "queries"))
    if (row["rung"] == "exact" || row["rung"] == "certified") {
      CHECK(row["false"] == 0);
      CHECK(row["missed"] == 0);
      CHECK(row["pairs"] > 0);
    }
  CHECK(counts(all) == counts(trade()));
}

TEST_CASE("trade: the user's own sets, in either order, and files that are written together") {
  put_mesh("ring.ply", meetc::bodies::torus(24, 12));
  put("balls.csv", "x,y,z,r\n1,0,0,0.25\n-1,0.1,0,0.5\n0,1,0,0.125\n");
  const json one = trade({"ring.ply", "balls.csv"}), other = trade({"balls.csv", "ring.ply"});
  CHECK(table(one, "files").size() == 11); // ball_triangle, also rounded, and sphere_triangle
  CHECK(table(one, "files").size() == table(other, "files").size());
  CHECK(table(one, "queries").size() == 25); // of the files and of four built-in scenes
  CHECK(table(one, "queries")[0]["pairs"] == table(other, "queries")[0]["pairs"]);
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
    return;
  const said s = run({"trade", "ring.ply", "ring.ply", "--quick", "--repetitions", "1", "-o", "trade_page"});
  REQUIRE(s.code == 0);
  CHECK(has(s.out, "wrote trade_page/trade.csv"));
  CHECK(files_in(at("trade_page")) == 13); // the page, its numbers, a picture, and ten maps
  CHECK(has(get(at("trade_page/trade.md")), "# The trade of speed for accuracy"));
  const std::string csv = get(at("trade_page/trade.csv"));
  CHECK(csv.rfind("family,predicate,method,pairs,hits,ns_a_pair,", 0) == 0);
  CHECK(has(csv, "\nfiles,triangle_triangle,\"certified\","));
  CHECK(csv.find("\nfiles,") < csv.find("\nrandom,")); // what was asked about comes first
  for (const char *const picture : {"trade.png", "map_triangle_triangle.png", "map_ball_ball.png"})
    CHECK(get(at(std::string("trade_page/") + picture)).rfind("\x89PNG", 0) == 0);
}

TEST_CASE("trade: names of files are names, and files without candidates") {
  put("it's|one.csv", "x,y,z,r\n1,0,0,0.25\n");
  put("far.csv", "x,y,z,r\n9,0,0,0.25\n");
  const json apart = trade({"it'\\''s|one.csv", "far.csv"});
  CHECK(has(table(apart, "queries")[0]["scene"].get<std::string>(), "it's?one.csv x far.csv"));
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
    return;
  put("a'; system('touch struck'); set title 'x.csv", "x,y,z,r\n1,0,0,0.25\n");
  const said s = run({"trade", "a'\\''; system('\\''touch struck'\\''); set title '\\''x.csv", "it'\\''s|one.csv",
                      "--quick", "--repetitions", "1", "-o", "names"});
  INFO(s.err);
  CHECK(s.code == 0);
  CHECK_FALSE(fs::exists(at("struck")));
  CHECK(get(at("names/trade.png")).rfind("\x89PNG", 0) == 0);
}

TEST_CASE("trade: an error is one line, and nothing is written") {
  put_mesh("ring.ply", meetc::bodies::torus(24, 12));
  const auto with = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"trade", "--quick", "-o", "unmade"});
    return complaint(more);
  };
  CHECK(with({"ring.ply"}) == "trade: a second set is needed beside the first");
  CHECK(has(with({"ring.ply", "nowhere.ply"}), "nowhere.ply"));
  CHECK(complaint({"trade", "--quick", "-o", ""}) == "-o: the folder's name is empty");
  CHECK(with({"--repetitions", "0"}) == "--repetitions: '0' is not a number from 1 to 1000");
  CHECK(has(with({"--threads", "-1"}), "is not a number from 0 to 256"));
  CHECK(has(with({"--instruction-set", "mmx"}), "mmx"));
  CHECK_FALSE(fs::exists(at("unmade")));
}
