// Every emitted meet, norm2 of a meet, and blade maker: exactly, in rationals, against the dense product, and in float
// and double within a proven rounding bound.
#include "tests/catch.hpp"
#include "tests/generated/judge/blades.hpp"

#include <fstream>
#include <set>
#include <string>

using namespace meetc;
using namespace meetc::generated_test;

namespace {

multivector padded(const mpq_class &s) {
  multivector m(32);
  m[0] = s;
  return m;
}

// The headers whose formulas the tests below have run, for a comparison with what generated/default includes.
std::set<std::string> &covered() {
  static std::set<std::string> names;
  return names;
}

// Compares a result in F with the exact one: each coefficient must be within the bound that the same program, run on
// error_count, gives for the u of F. Returns the largest share of a bound that was used.
template <class Have, class Count> double share_of_bound(Have have, Count count, const multivector &want, double u) {
  double most = 0;
  const auto bounds = fields(count);
  const auto values = fields(have);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const mpq_class error = abs(mpq_class(*values[i].second) - want[values[i].first]);
    const mpq_class bound = bounds[i].second->bound(mpq_class(u));
    if (error > bound)
      return 1e9;
    if (bound > 0)
      most = std::max(most, mpq_class(error / bound).get_d());
  }
  return most;
}

// Numbers of magnitude at most 2^2 that float32 holds exactly, with full mantissas, so that nothing underflows or
// overflows. A replay gives the same numbers to every type.
std::vector<float> floats(random_numbers &random) {
  std::vector<float> f(20);
  for (float &x : f)
    x = random.unit() * 4;
  return f;
}
template <class T> auto replay(const std::vector<float> &from) {
  return [at = from.begin()]() mutable { return static_cast<T>(static_cast<double>(*at++)); };
}

double most_used = 0; // the largest share of any bound that was used, over all checks in floating point

// f maps operands to a result; `of` gives the exact result from exact operands.
template <template <class> class X, template <class> class Y, class F, class Of>
void check_rounding(random_numbers &random, F f, Of of) {
  for (int i = 0; i < 60; ++i) {
    const std::vector<float> numbers = floats(random);
    const auto operands = [&]<class T>(T) {
      std::pair<X<T>, Y<T>> k;
      auto next = replay<T>(numbers);
      fill(k.first, next), fill(k.second, next);
      return k;
    };
    const auto [xe, ye] = operands(exact());
    const auto [xc, yc] = operands(error_count());
    const auto [xd, yd] = operands(double());
    const auto [xf, yf] = operands(float());
    const multivector want = of(xe, ye);
    const double used = std::max(share_of_bound(f(xd, yd), f(xc, yc), want, 0x1p-53),
                                 share_of_bound(f(xf, yf), f(xc, yc), want, 0x1p-24));
    REQUIRE(used <= 1);
    most_used = std::max(most_used, used);
  }
}

// Formulas for many pairs: a struct whose functions compute what each object stores, and then what a pair adds.
int for_pairs_checked = 0;
template <class P, template <class> class X, template <class> class Y> void check_for_pairs(const std::string &name) {
  INFO(name);
  ++for_pairs_checked;
  random_numbers random(500 + static_cast<unsigned>(for_pairs_checked));
  const auto value = []<class T>(const X<T> &x, const Y<T> &y) {
    T fa[P::fields_a + 1] = {}, fb[P::fields_b + 1] = {};
    P::object_a(x, fa);
    P::object_b(y, fb);
    return P::pair(x, fa, y, fb);
  };
  const auto want = [&](const auto &x, const auto &y) {
    const multivector b = space().meet(defined(x), defined(y), I());
    return padded(name.starts_with("norm2") ? oracle::scalar_part(space().geometric(b, b)) : b[0]);
  };
  for (int i = 0; i < 150; ++i) {
    X<exact> x;
    Y<exact> y;
    const auto next = [&] { return exact(random.fraction()); };
    fill(x, next), fill(y, next);
    REQUIRE(dense(value(x, y)) == want(x, y));
  }
  check_rounding<X, Y>(random, value, want);
}

template <template <class> class X, template <class> class Y> void check_pair(const std::string &names) {
  INFO(names);
  covered().insert("meet_" + names);
  covered().insert("norm2_meet_" + names);
  random_numbers random(1000 + covered().size());
  const auto want = [](const multivector &x, const multivector &y) { return space().meet(x, y, I()); };
  const auto square = [](const multivector &b) { return padded(oracle::scalar_part(space().geometric(b, b))); };
  for (int i = 0; i < 150; ++i) {
    X<exact> x;
    Y<exact> y;
    const auto next = [&] { return exact(random.fraction()); };
    fill(x, next), fill(y, next);
    const multivector b = want(defined(x), defined(y));
    REQUIRE(dense(cga::meet(x, y)) == b);
    REQUIRE(dense(cga::norm2_meet(x, y)) == square(b));
    // A formula on blades holds for every element of the support, not only for blades of that kind.
    auto general_x = cga::blade(x);
    auto general_y = cga::blade(y);
    fill_blade(general_x, next), fill_blade(general_y, next);
    const multivector general = want(dense(general_x), dense(general_y));
    REQUIRE(dense(cga::meet(general_x, general_y)) == general);
    REQUIRE(dense(cga::norm2_meet(general_x, general_y)) == square(general));
  }
  const auto exactly = [&](const auto &x, const auto &y) { return want(defined(x), defined(y)); };
  check_rounding<X, Y>(
      random, [](const auto &x, const auto &y) { return cga::meet(x, y); }, exactly);
  check_rounding<X, Y>(
      random, [](const auto &x, const auto &y) { return cga::norm2_meet(x, y); },
      [&](const auto &x, const auto &y) { return square(exactly(x, y)); });
}

template <template <class> class K> void check_blade() {
  random_numbers random(77);
  for (int i = 0; i < 200; ++i) {
    K<exact> k;
    fill(k, [&] { return exact(random.fraction()); });
    REQUIRE(dense(cga::blade(k)) == defined(k));
  }
  check_rounding<K, cga::point>(
      random, [](const auto &k, const auto &) { return cga::blade(k); },
      [](const auto &k, const auto &) { return defined(k); });
}

cga::point<exact> random_point(random_numbers &random) {
  cga::point<exact> p;
  fill(p, [&] { return exact(random.fraction(4)); });
  return p;
}

} // namespace

TEST_CASE("formulas: every meet and its square against the dense product") {
  using namespace cga;
  check_pair<plane, line>("plane_line");
  check_pair<sphere, line>("sphere_line");
  check_pair<plane, plane>("plane_plane");
  check_pair<sphere, plane>("sphere_plane");
  check_pair<sphere, sphere>("sphere_sphere");
  check_pair<line, line>("line_line");
  check_pair<circle, line>("circle_line");
  check_pair<circle, circle>("circle_circle");
  check_pair<circle, plane>("circle_plane");
  check_pair<circle, sphere>("circle_sphere");
  check_pair<point_pair, line>("point_pair_line");
  check_pair<point_pair, circle>("point_pair_circle");
  check_pair<point_pair, plane>("point_pair_plane");
  check_pair<point_pair, sphere>("point_pair_sphere");
  check_for_pairs<norm2_meet_plane_line, plane, line>("norm2_meet_plane_line");
  check_for_pairs<norm2_meet_sphere_line, sphere, line>("norm2_meet_sphere_line");
  check_for_pairs<norm2_meet_plane_plane, plane, plane>("norm2_meet_plane_plane");
  check_for_pairs<norm2_meet_sphere_plane, sphere, plane>("norm2_meet_sphere_plane");
  check_for_pairs<norm2_meet_sphere_sphere, sphere, sphere>("norm2_meet_sphere_sphere");
  check_for_pairs<norm2_meet_circle_line, circle, line>("norm2_meet_circle_line");
  check_for_pairs<norm2_meet_circle_circle, circle, circle>("norm2_meet_circle_circle");
  check_for_pairs<norm2_meet_circle_plane, circle, plane>("norm2_meet_circle_plane");
  check_for_pairs<norm2_meet_circle_sphere, circle, sphere>("norm2_meet_circle_sphere");
  check_for_pairs<norm2_meet_point_pair_line, point_pair, line>("norm2_meet_point_pair_line");
  check_for_pairs<norm2_meet_point_pair_circle, point_pair, circle>("norm2_meet_point_pair_circle");
  check_for_pairs<norm2_meet_point_pair_plane, point_pair, plane>("norm2_meet_point_pair_plane");
  check_for_pairs<norm2_meet_point_pair_sphere, point_pair, sphere>("norm2_meet_point_pair_sphere");
  check_for_pairs<meet_point_pair_line, point_pair, line>("meet_point_pair_line");
  check_for_pairs<meet_point_pair_circle, point_pair, circle>("meet_point_pair_circle");
  // The bound has the right size: it is never exceeded, and not so wide that it would hide a wrong formula.
  CHECK(most_used > 0.02);

  // Every emitted formula is tested: the umbrella header names them all.
  std::ifstream header(MEETC_GENERATED "/cga/cga.hpp");
  std::set<std::string> emitted;
  int structs = 0;
  for (std::string text; std::getline(header, text);)
    for (const char *prefix : {"meet_", "norm2_meet_"})
      if (const std::string start = std::string("#include <cga/") + prefix; text.starts_with(start)) {
        const std::string name =
            prefix + text.substr(start.size(), text.size() - start.size() - std::string(".hpp>").size());
        emitted.insert(name);
        std::ifstream one(MEETC_GENERATED "/cga/" + name + ".hpp");
        for (std::string line; std::getline(one, line);)
          structs += line == "struct " + name + " {";
      }
  CHECK(emitted == covered());
  CHECK(structs == for_pairs_checked);
}

TEST_CASE("formulas: the blade of every kind") {
  check_blade<cga::point>();
  check_blade<cga::point_pair>();
  check_blade<cga::flat_point>();
  check_blade<cga::line>();
  check_blade<cga::circle>();
  check_blade<cga::plane>();
  check_blade<cga::sphere>();
}

TEST_CASE("formulas: blades made from points or a direction") {
  random_numbers random(78);
  for (int i = 0; i < 200; ++i) {
    const auto a = random_point(random), b = random_point(random), c = random_point(random), d = random_point(random);
    cga::direction<exact> v;
    fill(v, [&] { return exact(random.fraction(4)); });
    const multivector A = defined(a), B = defined(b), C = defined(c), D = defined(d);
    REQUIRE(dense(cga::line_from_direction(a, v)) == oracle::scale(2, outer(outer(A, defined(v)), infinity())));
    REQUIRE(dense(cga::circle_from_points(a, b, c)) == outer(outer(A, B), C));
    REQUIRE(dense(cga::plane_from_points(a, b, c)) == outer(outer(outer(A, B), C), infinity()));
    REQUIRE(dense(cga::sphere_from_points(a, b, c, d)) == outer(outer(outer(A, B), C), D));
  }
}

// The definitions mean what their names say, by geometry alone: a point lies on an object iff their outer product
// vanishes.
TEST_CASE("formulas: points lie on what the stored numbers describe") {
  random_numbers random(79);
  const auto on = [](const cga::point<exact> &p, const multivector &m) {
    return oracle::is_zero(outer(dense(cga::blade(p)), m));
  };
  for (int i = 0; i < 100; ++i) {
    const auto c = random_point(random), other = random_point(random);
    // An orthogonal frame with rational lengths, (1,2,2), (2,1,-2), (2,-2,1), and a rational point of its
    // circle.
    const exact r{random.fraction(4)}, t{random.fraction(4)};
    const exact one(1), two(2), three(3), w = one + t * t, cosine = (one - t * t) / w, sine = two * t / w;
    const exact f = r / three;
    const cga::point<exact> p{c.x + f * (two * cosine + two * sine), c.y + f * (cosine - two * sine),
                              c.z + f * (sine - two * cosine)};
    const cga::direction<exact> N{one, two, two};
    REQUIRE(on(p, dense(cga::blade(cga::circle<exact>{c, N, r}))));
    REQUIRE(on(p, dense(cga::blade(cga::sphere<exact>{c, r}))));
    REQUIRE(on(p, dense(cga::blade(cga::plane<exact>{N, c.x + two * c.y + two * c.z}))));
    const cga::point<exact> between{c.x + t * (other.x - c.x), c.y + t * (other.y - c.y), c.z + t * (other.z - c.z)};
    REQUIRE(on(between, dense(cga::blade(cga::line<exact>{c, other}))));
    const cga::point<exact> off{p.x + one, p.y, p.z};
    REQUIRE_FALSE(on(off, dense(cga::blade(cga::circle<exact>{c, N, r}))));
    REQUIRE_FALSE(on(off, dense(cga::blade(cga::plane<exact>{N, c.x + two * c.y + two * c.z}))));
  }
}
