// The form of touching balls: its graph is the separated polynomial, and the emitted header gives the same numbers.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/generated/judge/numbers.hpp"

#include "gen/bound/matrix.hpp"
#include "gen/lower/ball_form.hpp"

#include <algorithm>
#include <cga/ball_form.hpp>

using namespace meetc;
using namespace meetc::compiler_test;
using generated_test::exact;
using rational = poly::rational;

TEST_CASE("the graphs of the ball form are its factors, and the whole is |c - c'|^2 - (r + r')^2, halved") {
  const lower::ball_form form = *lower::find_ball_form(*default_scene().model);
  CHECK(form.parts.terms() == 6);
  CHECK(form.parts.products.size() == 4);
  CHECK(poly::to_poly(form.parts) == form.whole);
  const auto a = ir::to_poly(form.a, *form.numbers), b = ir::to_poly(form.b, *form.numbers);
  REQUIRE(a.size() == 5);
  REQUIRE(b.size() == 5);
  poly::poly sum = a[4] + b[4];
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(a[k] == form.parts.products[k].f);
    CHECK(b[k] == form.parts.products[k].g);
    sum = sum + a[k] * b[k];
  }
  CHECK(sum == form.whole);
  // It is the sign by which the shipped predicate of solid balls decides.
  const lower::predicate &solid = default_kernel("ball_ball").decision;
  const poly::poly atom = solid.signs.atoms().at(0);
  std::vector<poly::poly> images;
  for (int v = 0; v < form.numbers->size(); ++v)
    images.push_back(poly::poly::variable(*solid.numbers, v));
  const poly::poly same = form.whole.substitute(images, *solid.numbers).scaled(2);
  CHECK((same == atom || same.scaled(-1) == atom));
}

TEST_CASE("the emitted features give half of |c - c'|^2 - (r + r')^2, exactly") {
  static_assert(cga::ball_form::inputs == 4 && cga::ball_form::products == 4);
  std::mt19937_64 random(3);
  const auto number = [&] {
    mpq_class q(static_cast<long>(random() % 20001) - 10000, static_cast<long>(random() % 64) + 1);
    q.canonicalize();
    return q;
  };
  int touching = 0;
  for (int i = 0; i < 500; ++i) {
    exact x[4], y[4], f[5], g[5];
    for (int k = 0; k < 4; ++k) {
      x[k] = exact(number());
      y[k] = exact(number());
    }
    cga::ball_form::features_a(x, f);
    cga::ball_form::features_b(y, g);
    mpq_class value = f[4].v + g[4].v, wanted = 0;
    for (int k = 0; k < 4; ++k)
      value += f[k].v * g[k].v;
    for (int k = 0; k < 3; ++k)
      wanted += (x[k].v - y[k].v) * (x[k].v - y[k].v);
    wanted -= (x[3].v + y[3].v) * (x[3].v + y[3].v);
    CHECK(value == wanted / 2);
    touching += wanted <= 0;
  }
  CHECK(touching > 20);
  CHECK(touching < 480);
}

TEST_CASE("the emitted margins are the compiler's") {
  using form = cga::ball_form;
  const auto same = [](float emitted, const bound::dyadic &wanted) { return rational(emitted) == wanted.value(); };
  CHECK(same(form::largest_input, bound::matrix_input));
  CHECK(same(form::additive_unit, bound::matrix_unit));
  CHECK(same(form::least_part, bound::matrix_flush));
  CHECK(same(form::margin_square, bound::margin_square));
  CHECK(same(form::margin_additive, bound::margin_additive));
  CHECK(same(form::margin_linear, bound::margin_linear));
  CHECK(same(form::margin_absolute, bound::margin_absolute));
}

TEST_CASE("scenes with predicates get the ball form with every pair, and those of formulas alone do not") {
  const auto holds = [](const compilation &scene) {
    compilation c = load(scene.scene->files.front()->path);
    c.scene->backends = scene.scene->backends;
    compile_all(c);
    const std::vector<target::file> files = emit_all(c);
    return std::any_of(files.begin(), files.end(),
                       [&](const target::file &f) { return f.path == c.scene->space + "/ball_form.hpp"; });
  };
  for (const std::vector<std::string> &backends :
       {std::vector<std::string>{"cpp", "cuda", "every_pair"}, {"every_pair"}, {"cpp", "cuda"}, {"cpp"}}) {
    const spec_copy copy({"segment_triangle"});
    compilation c = copy.compile();
    c.scene->backends = backends;
    CHECK(holds(c) == (backends.back() == "every_pair"));
    const spec_copy formula({"meet(sphere, line)"}); // without a predicate there is nothing to filter
    c = formula.compile();
    c.scene->backends = backends;
    CHECK_FALSE(holds(c));
  }
}

TEST_CASE("the ball form is found by what a predicate says, not by its name, and only where it is covered") {
  const auto form_with = [](const std::string &hit) {
    const spec_copy copy({"segment_triangle"});
    copy.replace("predicates/round.toml", "sign(((I*S) | (I*T)) + 4*S.r*T.r) >= 0", hit);
    const compilation c = load(copy.scene().string());
    return lower::find_ball_form(*c.model);
  };
  const auto shipped = lower::find_ball_form(*default_scene().model);
  REQUIRE(shipped.has_value());
  CHECK(shipped->of->name == "ball_ball");
  // Negated, and twice the sign: the form is the same.
  for (const char *same : {"sign(-((I*S) | (I*T)) - 4*S.r*T.r) <= 0", "sign(2*((I*S) | (I*T)) + 8*S.r*T.r) >= 0"}) {
    const auto form = form_with(same);
    INFO(same);
    REQUIRE(form.has_value());
    CHECK(form->whole.text() == shipped->whole.text());
  }
  // A strict test, the difference of the radii, two signs: the proved margins cover none of these.
  for (const char *other :
       {"sign(((I*S) | (I*T)) + 4*S.r*T.r) > 0", "sign(((I*S) | (I*T)) + 4*S.r*T.r) >= 0 and sign(S.r - T.r) >= 0",
        "sign(S.r*S.r*S.c[e1]*T.c[e1] - T.r*S.r) >= 0"}) {
    INFO(other);
    CHECK_FALSE(form_with(other).has_value());
  }
}

TEST_CASE("an algebra without balls has launchers on a device, and every pair is an error that says what is missing") {
  const auto files = [](const std::string &backends) {
    const spec_copy copy({"segment_triangle"});
    copy.replace("pga3.toml", "'primitives/ball.toml', ", "");
    copy.replace("scenes/asked.toml", "cga3.toml", "pga3.toml");
    copy.replace("scenes/asked.toml", "kernels", backends + "kernels");
    compilation c = load(copy.scene().string());
    compile_all(c);
    std::vector<std::string> out;
    for (const target::file &f : emit_all(c))
      if (f.path.ends_with(".cu"))
        out.push_back(f.path.substr(f.path.find('/') + 1));
    return out;
  };
  const std::vector<std::string> launchers = files("backends = ['cpp', 'cuda']\n");
  CHECK(launchers.size() == 4); // the catalogue, the predicate, and two kinds
  CHECK(std::find(launchers.begin(), launchers.end(), "src/segment_triangle.cu") != launchers.end());
  CHECK(files("") == launchers);
  CHECK(files("backends = ['cpp']\n").empty());
  try {
    files("backends = ['cpp', 'cuda', 'every_pair']\n");
    FAIL("no error");
  } catch (const spec_error &e) {
    const std::string said = e.what();
    INFO(said);
    CHECK(said.find("the backend 'every_pair'") != std::string::npos);
    CHECK(said.find("no predicate of the algebra says when two balls touch") != std::string::npos);
    CHECK(said.find("import 'primitives/ball.toml'") != std::string::npos);
  }
}

TEST_CASE("every pair is written beside the launchers that decide what it leaves, and only where it is asked for") {
  const auto sources = [](const std::vector<std::string> &backends) {
    const spec_copy copy({"segment_triangle"});
    compilation c = copy.compile();
    c.scene->backends = backends;
    bool launchers = false, every_pair = false, headers = false;
    for (const target::file &f : emit_all(c)) {
      launchers = launchers || f.path.ends_with("_cuda.cu");
      every_pair = every_pair || f.path.ends_with("_every_pair.cu");
      headers = headers || f.path == "meetc/every_pair/table.hpp";
    }
    CHECK(headers);
    return std::pair(launchers, every_pair);
  };
  CHECK(sources({"cpp", "cuda"}) == std::pair(true, false));
  CHECK(sources({"every_pair"}) == std::pair(true, true));
  CHECK(sources({"cpp"}) == std::pair(false, false));
}
