// Compares the scripts with the emitted code. Gappa proves what a script says; this test shows that the script says
// what the code does: its computed side gives the same float32 as the code, its exact side gives the exact value, and
// its bound is the one that the code uses.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include "gen/driver.hpp"
#include "gen/ir/evaluate.hpp"
#include "tests/proofs/script.hpp"

#include <algorithm>
#include <cga/for_each.hpp>
#include <cga/header_only.hpp>
#include <cmath>
#include <random>

using namespace meetc;
using namespace meetc::proofs_test;

namespace {

constexpr int cases = 200;

struct emitted_stage {
  int inputs_a, signs;
  void (*values)(const float *row, float *v); // object A's numbers, then B's
  meetc::box_factor (*box)(int);
};

// The values of a stage in the schedule without fma.
template <class P, class Stage> void unfused_values(const float *row, float *v) {
  using number = meetc::unfused<float>;
  const meetc::rows_in<P, number> rows(row, row + P::inputs_a);
  number values[Stage::atoms];
  meetc::stage_values<Stage>(rows.a, rows.b, values);
  for (int i = 0; i < Stage::atoms; ++i)
    v[i] = values[i];
}
template <class P, class Stage> void add(std::map<std::string, emitted_stage> &to, const std::string &name) {
  if constexpr (Stage::atoms > 0) {
    to[name] = {P::inputs_a, Stage::atoms,
                [](const float *row, float *v) { meetc::stage_values<Stage>(row, row + P::inputs_a, v); }, Stage::box};
    to[name + "_unfused"] = {P::inputs_a, Stage::atoms, unfused_values<P, Stage>, Stage::box_unfused};
  }
}
template <class P> void add_predicate(std::map<std::string, emitted_stage> &to, const std::string &name) {
  add<P, typename P::reject_stage>(to, name + " reject");
  add<P, typename P::common_stage>(to, name + " common");
  add<P, typename P::rare_stage>(to, name + " rare");
}

// Indexed by "kernel stage". If the default scene has a new predicate, it is reported by name.
const std::map<std::string, emitted_stage> &emitted_stages() {
  static const auto all = [] {
    std::map<std::string, emitted_stage> out;
    cga::for_each_sign([&out]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) {
      add<P, typename P::common_stage>(out, std::string(p.name) + " common");
    });
    add<cga::first_met_segment_triangle_pair_sign, cga::first_met_segment_triangle_pair_sign::common_stage>(
        out, "first_met_segment_triangle_pair common");
    cga::for_each_predicate([&out](auto p) {
      if (std::string_view(p.name) != "box_box") // which has no bound to be proved
        add_predicate<typename decltype(p)::type>(out, p.name);
    });
    return out;
  }();
  return all;
}

// A script with the stage that it names, in the emitted code and in the compiler.
struct subject {
  std::string path;
  script proof;
  std::vector<cover> covered;
  const lower::predicate *predicate;
  const lower::stage *stage;
  emitted_stage code;

  rational input(const std::vector<float> &row, const std::string &name) const {
    const auto &names = predicate->stored_inputs;
    const auto at = std::find(names.begin(), names.end(), name);
    REQUIRE(at != names.end());
    return row[static_cast<std::size_t>(at - names.begin())];
  }
  std::map<std::string, rational> leaves(const std::vector<float> &row) const {
    std::map<std::string, rational> out;
    for (const leaf &l : proof.leaves)
      out[l.name] =
          l.subtrahend.empty() ? input(row, l.minuend) : rational(input(row, l.minuend) - input(row, l.subtrahend));
    return out;
  }
};

const compilation &scene() {
  static const compilation c = [] {
    compilation out = load(MEETC_SCENE);
    compile_all(out);
    return out;
  }();
  return c;
}

const std::vector<subject> &subjects() {
  static const auto all = [] {
    std::vector<subject> out;
    compilation c = load(MEETC_SCENE);
    compile_all(c);
    for (const target::file &f : emit_all(c))
      if (f.path.find("/proofs/") != std::string::npos && f.text.find("|v - e|") != std::string::npos) // of a sign
        out.push_back({f.path, parse(f.text), covers(f.text), nullptr, nullptr, {}});
    for (subject &s : out) {
      for (const lower::kernel &k : scene().kernels)
        if (k.is_predicate && k.asked.name() == s.proof.kernel)
          s.predicate = &k.decision;
      INFO(s.path);
      REQUIRE(s.predicate);
      s.stage = s.proof.stage.starts_with("reject")   ? &s.predicate->reject
                : s.proof.stage.starts_with("common") ? &s.predicate->common
                                                      : &s.predicate->rare;
      const auto code = emitted_stages().find(s.proof.kernel + ' ' + s.proof.stage);
      REQUIRE(code != emitted_stages().end());
      s.code = code->second;
    }
    return out;
  }();
  return all;
}

// Coordinates in [-1/2, 1/2] and radii in [0, 1/2], so that every leaf is within 1. Some are close together, and all
// have different exponents, so that differences are rounded.
std::vector<float> random_row(const lower::predicate &p, std::mt19937 &random) {
  std::uniform_real_distribution<float> in(-0.5F, 0.5F);
  const bool close = random() % 2;
  std::vector<float> out;
  for (std::size_t v = 0; v < p.stored_inputs.size(); ++v) {
    const bool position = p.local->stored(static_cast<int>(v)).position;
    const float x = std::ldexp(in(random), -static_cast<int>(random() % 6));
    out.push_back(!position ? std::abs(x) : close ? 0.25F + x / 1024 : x);
  }
  return out;
}

float computed_by_code(const subject &s, const std::vector<float> &row) {
  std::vector<float> v(static_cast<std::size_t>(s.code.signs));
  s.code.values(row.data(), v.data());
  return v[s.proof.sign];
}

// alpha beta^2 D, as in the scripts.
std::string powers(const meetc::box_factor &box) {
  std::string out;
  for (const auto &[name, power] : {std::pair{"alpha", box.a}, std::pair{"beta", box.b}, std::pair{"D", box.pair}})
    if (power) {
      out += out.empty() ? "" : " ";
      out += name;
      if (power > 1)
        out += '^' + std::to_string(power);
    }
  return out;
}

} // namespace

TEST_CASE("proofs: there is one for every shape of sign") {
  CHECK(subjects().size() > 10);
}

TEST_CASE("proofs: the computed side is the emitted code, bit for bit") {
  std::mt19937 random(1);
  for (const subject &s : subjects()) {
    INFO(s.path);
    int flipped = 0;
    for (int i = 0; i < cases; ++i) {
      const std::vector<float> row = random_row(*s.predicate, random);
      const float said = nearest_float(s.proof.run(s.leaves(row)).at("v")), done = computed_by_code(s, row);
      flipped += said == -done && done != 0; // a negation after the last rounding is not in the script
      REQUIRE((said == done || said == -done));
    }
    CHECK((flipped == 0 || flipped > cases * 9 / 10));
  }
}

TEST_CASE("proofs: the exact side is the exact value, and the seen error is within the bound") {
  std::mt19937 random(2);
  for (const subject &s : subjects()) {
    INFO(s.path);
    for (int i = 0; i < cases; ++i) {
      const std::vector<float> row = random_row(*s.predicate, random);
      const std::vector<rational> exact = ir::evaluate(s.stage->code, {row.begin(), row.end()});
      const auto values = s.proof.run(s.leaves(row));
      REQUIRE(abs(values.at("e")) == abs(exact[s.proof.sign]));
      REQUIRE(abs(rational(values.at("v") - values.at("e"))) <= s.proof.bound);
    }
  }
}

TEST_CASE("proofs: the bound is the one that the code tests with") {
  for (const subject &s : subjects()) {
    INFO(s.path);
    CHECK(s.proof.bound == rational(s.code.box(static_cast<int>(s.proof.sign)).c));
  }
}

TEST_CASE("proofs: every bound that the code tests with has its script") {
  // The signs that the scripts say they are about, "kernel stage: sign" with the powers, and the bound.
  std::map<std::string, std::pair<std::string, rational>> said;
  for (const subject &s : subjects())
    for (const cover &c : s.covered)
      for (const std::size_t sign : c.signs) {
        INFO(s.path << ": " << c.stage << ' ' << sign);
        CHECK(said.try_emplace(c.stage + ' ' + std::to_string(sign), c.powers, s.proof.bound).second);
      }
  std::size_t bounds = 0;
  for (const auto &[stage, code] : emitted_stages())
    for (int sign = 0; sign < code.signs; ++sign) {
      const meetc::box_factor box = code.box(sign);
      if (box.c == 0) // a leaf
        continue;
      ++bounds;
      INFO(stage << ' ' << sign);
      const auto at = said.find(stage + ' ' + std::to_string(sign));
      REQUIRE(at != said.end());
      CHECK(at->second.first == powers(box));
      CHECK(at->second.second == rational(box.c));
    }
  CHECK(bounds == said.size());
}

TEST_CASE("proofs: a script without one of its roundings is not the emitted code") {
  std::mt19937 random(77);
  for (const subject &s : subjects())
    for (std::size_t l = 0; l < s.proof.lines.size(); ++l) {
      if (s.proof.lines[l].expression.rfind("rnd(", 0) != 0)
        continue;
      INFO(s.path << ": " << s.proof.lines[l].name << " = " << s.proof.lines[l].expression);
      subject other = s;
      other.proof.lines[l].expression.erase(0, 3);
      bool told = false;
      for (int i = 0; i < 10 * cases && !told; ++i) {
        const std::vector<float> row = random_row(*s.predicate, random);
        const float said = nearest_float(other.proof.run(other.leaves(row)).at("v"));
        told = std::abs(said) != std::abs(computed_by_code(s, row));
      }
      CHECK(told);
    }
}
