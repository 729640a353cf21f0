// `meet collide --evaluate`: the values of a formula for the pairs that touch, and its refusals.
#include "fixture.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/output/pair_values.hpp"

#include <cmath>
#include <random>
#include <sstream>

using namespace fixture;

TEST_CASE("the values of found pairs") {
  put("a.csv", "x,y,z,r\n0,0,0,1\n1,0,0,1\n5,0,0,1\n");
  put("b.csv", "x,y,z,r\n2,0,0,1\n0,0,0,0.25\n");
  for (const char *const formula : {"norm2(meet(sphere, sphere))", "norm2( meet(sphere,sphere) )"}) {
    const json j = answer({"a.csv", "b.csv", "--evaluate", formula, "values.csv"});
    CHECK(j["pairs"] == 4);
    // B² is 0 where two spheres touch, positive where they meet in a circle, and negative where one lies in the other.
    CHECK(get(at("values.csv")) == "a,b,norm2_meet\n0,0,0\n0,1,-3.515625\n1,0,12\n1,1,0.984375\n");
  }
  answer({"a.csv", "b.csv", "--mode", "surface", "--evaluate", "meet(sphere, sphere)", "values.csv", "--pairs",
          "pairs.csv"});
  CHECK(get(at("values.csv")).starts_with("a,b,e1_e2_e3,e1_e2_n,"));
  CHECK(get(at("values.csv")).substr(0, 3) == get(at("pairs.csv")).substr(0, 3));
  put("none.csv", "x,y,z,r\n");
  answer({"a.csv", "none.csv", "--evaluate", "norm2(meet(sphere, sphere))", "values.csv"});
  CHECK(get(at("values.csv")) == "a,b,norm2_meet\n");
}

TEST_CASE("values in float32 and in float64, for more pairs than are computed at once") {
  std::mt19937 random(3);
  std::string rows = "x,y,z,r\n";
  for (int i = 0; i < 300; ++i)
    rows +=
        fmt::format("{},{},{},{}\n", static_cast<float>(random() % 1000) / 1000.0F,
                    static_cast<float>(random() % 1000) / 1000.0F, static_cast<float>(random() % 1000) / 1000.0F, 1.5F);
  put("many.csv", rows);
  const auto values = [](const char *precision) {
    answer({"many.csv", "many.csv", "--precision", precision, "--evaluate", "norm2(meet(sphere, sphere))", "values.csv",
            "--translate-a", "0.125,0,0"});
    std::istringstream in(get(at("values.csv")));
    std::string line;
    std::getline(in, line);
    std::vector<double> out;
    unsigned a = 0, b = 0;
    double value = 0;
    for (char comma = 0; in >> a >> comma >> b >> comma >> value;) {
      REQUIRE(out.size() == 300 * a + b); // all of them meet
      out.push_back(value);
    }
    return out;
  };
  const std::vector<double> single = values("fp32"), wide = values("certified");
  REQUIRE(single.size() == 90000);
  REQUIRE(wide.size() == 90000);
  double most = 0;
  for (std::size_t i = 0; i < single.size(); ++i) {
    CHECK(static_cast<double>(static_cast<float>(single[i])) == Approx(single[i]).epsilon(1e-7));
    most = std::max(most, std::abs(single[i] - wide[i]) / std::abs(wide[i]));
  }
  CHECK(most > 0);
  CHECK(most < 1e-5);
}

TEST_CASE("formulas that do not fit") {
  put("a.csv", "x,y,z,r\n0,0,0,1\n");
  put("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto refused = [](std::vector<std::string> more, const std::string &b = "a.csv") {
    std::vector<std::string> all{"collide", "a.csv", b};
    all.insert(all.end(), more.begin(), more.end());
    const std::string text = complaint(all);
    CHECK_FALSE(fs::exists(at("out.csv")));
    return text;
  };
  CHECK(refused({"--evaluate", "norm2(meet(sphere,sphre))", "out.csv"}) ==
        "--evaluate: no formula 'norm2(meet(sphere,sphre))'; did you mean 'norm2(meet(sphere, sphere))'?");
  CHECK(refused({"--evaluate", "norm2(meet(sphere, line))", "out.csv"}) ==
        "--evaluate: 'norm2(meet(sphere, line))' takes other kinds; for spheres and spheres the scene has meet(sphere, "
        "sphere); norm2(meet(sphere, sphere))");
  CHECK(refused({"--evaluate", "x", "out.csv"}, "mesh.obj") ==
        "--evaluate: no formula 'x'; for spheres and triangles the scene has none");
  CHECK(refused({"--evaluate", "x"}) == "--evaluate 'x': the file for the values is missing");
  CHECK(has(refused({"--evaluate", "meet(sphere, sphere)", "out.csv", "--any"}), "--any stops at the first pair"));
  CHECK(has(refused({"--evaluate", "meet(sphere, sphere)", "a.csv"}), "a.csv: is an input"));
  CHECK(has(refused({"--evaluate", "meet(sphere, sphere)", "out.csv", "--pairs", "out.csv"}), "two outputs"));
}

TEST_CASE("a formula takes the two kinds in either order") {
  // f(segment, point) is the first number of each.
  static const meetc::kind_info point{"point", "x,y,z", 3, nullptr, 1, nullptr, nullptr};
  static const meetc::kind_info segment{"segment", "x0,y0,z0,x1,y1,z1", 6, nullptr, 2, nullptr, nullptr};
  static const meetc::formula_operand operands[] = {{"segment", segment.csv, 6}, {"point", point.csv, 3}};
  const auto values = [](const meetc::column *in, const std::uint32_t *, std::size_t n, auto *const *out) {
    for (std::size_t i = 0; i < n; ++i)
      out[0][i] = in[0].data[static_cast<std::ptrdiff_t>(i) * in[0].stride],
      out[1][i] = in[6].data[static_cast<std::ptrdiff_t>(i) * in[6].stride];
  };
  static const meetc::formula_info formula{"f(segment, point)", operands, 2, "s,p", 2, 9, values, values};
  meetc::catalogue all{};
  all.space = "toy", all.formulas = &formula, all.formula_count = 1;
  meetc::io::element_set points, segments;
  points.kind = &point, points.data = {1, 0, 0, 2, 0, 0}, points.elements = points.items = 2;
  segments.kind = &segment, segments.data = {3, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0},
  segments.elements = segments.items = 2;
  const meetc::index_pair pairs[] = {{0, 0}, {0, 1}, {1, 1}};
  const auto written = [&](const meetc::io::element_set &a, const meetc::io::element_set &b) {
    const auto by = meetc::app::choose_formula(all, a, b, "f(segment,point)", true);
    meetc::app::write_pair_values(at("toy.csv"), by, a, b, pairs, 1);
    return get(at("toy.csv"));
  };
  CHECK(written(segments, points) == "a,b,s,p\n0,0,3,1\n0,1,3,2\n1,1,4,2\n");
  CHECK(written(points, segments) == "a,b,s,p\n0,0,3,1\n0,1,4,1\n1,1,4,2\n");
  segments.owner = {0, 0};
  CHECK_THROWS_WITH(written(points, segments), Catch::Contains("B has items that were cut into several elements"));
}

TEST_CASE("bench formulas: columns and listed rows beside the least") {
  const said s = run({"bench", "formulas", "--quick", "--repetitions", "3", "--json"});
  INFO(s.err);
  REQUIRE(s.code == 0);
  const json rows = table(json::parse(s.out), "formulas");
  REQUIRE(rows.size() == 5);
  for (const json &row : rows)
    for (const char *const key : {"columns", "copy", "share_of_copy", "listed", "gather", "share_of_gather"})
      CHECK(row[key].get<double>() > 0);
}
