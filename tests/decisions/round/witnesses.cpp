#include "tests/decisions/round/witnesses.hpp"

#include "gen/oracle/convex.hpp"

#include <algorithm>
#include <optional>
#include <random>

namespace meetc::decisions_round {
namespace {

using oracle::point;

point minus(const point &x, const point &y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
rational dot(const point &x, const point &y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
point corner(const std::vector<rational> &row, std::size_t i) {
  return {row[3 * i], row[3 * i + 1], row[3 * i + 2]};
}
std::size_t corners_of(const emitted &e) {
  return e.second == other::triangle ? 3 : e.second == other::segment ? 2 : 1;
}
oracle::hull hull_of(const emitted &e, const std::vector<rational> &row) {
  oracle::hull out;
  for (std::size_t i = 0; i < corners_of(e); ++i)
    out.push_back(corner(row, i));
  return out;
}

std::optional<rational> root(const rational &q) {
  const mpz_class n = sqrt(q.get_num()), d = sqrt(q.get_den());
  if (n * n != q.get_num() || d * d != q.get_den())
    return std::nullopt;
  return rational(n, d);
}

// The location of the nearest point, and the squared distances of the nearest and the farthest one. Corners come
// first, then the inside of edges, then the face, so that of equal distances the smallest part of the figure is named.
struct place {
  std::string nearest;
  rational least, most;
};
place find(const point &c, const oracle::hull &h) {
  place out{"corner a", 0, 0};
  bool any = false;
  const auto take = [&](const std::string &name, const rational &square) {
    if (!any || square < out.least)
      out.nearest = name, out.least = square;
    any = true;
  };
  static constexpr const char *names = "abc";
  for (std::size_t i = 0; i < h.size(); ++i) {
    const rational square = dot(minus(c, h[i]), minus(c, h[i]));
    take(std::string("corner ") + names[i], square);
    out.most = std::max(out.most, square);
  }
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t j = i + 1; j < h.size(); ++j) {
      const point w = minus(c, h[i]), d = minus(h[j], h[i]);
      const rational along = dot(w, d), length = dot(d, d);
      if (along > 0 && along < length)
        take(std::string("edge ") + names[i] + names[j], dot(w, w) - along * along / length);
    }
  if (h.size() == 3) {
    const point w = minus(c, h[0]), d1 = minus(h[1], h[0]), d2 = minus(h[2], h[0]);
    const rational g11 = dot(d1, d1), g12 = dot(d1, d2), g22 = dot(d2, d2), area = g11 * g22 - g12 * g12;
    const rational s = dot(w, d1) * g22 - dot(w, d2) * g12, t = dot(w, d2) * g11 - dot(w, d1) * g12;
    if (area > 0 && s > 0 && t > 0 && s + t < area)
      take("face", dot(w, w) - (dot(w, d1) * s + dot(w, d2) * t) / area);
  }
  return out;
}

std::string compared(const rational &x, const rational &y) {
  return x < y ? "<" : x == y ? "=" : ">";
}

std::string form_of(const oracle::hull &h) {
  if (std::all_of(h.begin(), h.end(), [&](const point &p) { return p == h[0]; }))
    return "a point";
  if (h.size() == 2)
    return "a segment";
  const point d1 = minus(h[1], h[0]), d2 = minus(h[2], h[0]);
  return dot(d1, d1) * dot(d2, d2) == dot(d1, d2) * dot(d1, d2) ? "collinear" : "a triangle";
}

std::string case_of(const emitted &e, const witness &w) {
  const rational &r = w.a[3];
  const place at = find(corner(w.a, 0), hull_of(e, w.b));
  if (e.second == other::point)
    return "least " + compared(at.least, r * r);
  if (e.second == other::sphere) {
    const rational sum = r + w.b[3], difference = r - w.b[3];
    return "d " + compared(at.least, sum * sum) + " r1 + r2, d " + compared(at.least, difference * difference) +
           " |r1 - r2|";
  }
  std::string out = form_of(hull_of(e, w.b)) + ", " + at.nearest + ", least " + compared(at.least, r * r) + " r";
  if (e.surface && at.least <= r * r)
    out += ", most " + compared(at.most, r * r) + " r";
  return out;
}

class numbers {
public:
  explicit numbers(unsigned seed) : engine_(seed) {}
  int next(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

private:
  std::mt19937 engine_;
};

} // namespace

std::vector<witness> witnesses(const emitted &e, int count, unsigned seed) {
  numbers random(seed);
  std::vector<witness> out;
  const std::size_t corners = corners_of(e);
  const poly::ring stored(row_names(e));
  const std::vector<polynomial> images = gram::ring().images(e, stored);
  for (int k = 0; k < count; ++k) {
    witness w;
    for (std::size_t i = 0; i < 3 * corners; ++i)
      w.b.emplace_back(random.next(-3, 3));
    // Some figures are flat: all corners on one line, or at one point.
    if (const int flat = random.next(0, 7); flat <= 1 && corners > 1)
      for (std::size_t i = 1; i < corners; ++i) {
        const int along = flat == 0 ? random.next(-2, 2) : 0;
        for (std::size_t x = 0; x < 3; ++x)
          w.b[3 * i + x] = w.b[x] + along * (w.b[(x + 1) % 3] - 1);
      }
    for (int x = 0; x < 3; ++x)
      w.a.emplace_back(random.next(-4, 4));
    if (random.next(0, 9) == 0) // a point of the figure
      for (std::size_t x = 0; x < 3; ++x)
        w.a[x] = (w.b[x] + w.b[3 * (corners - 1) + x]) / 2;
    const place at = find(corner(w.a, 0), hull_of(e, w.b));
    rational r = rational(random.next(0, 36), 4);
    const int how = random.next(0, 5);
    if (const auto exactly = root(how % 2 ? at.least : at.most); exactly && how < 5) {
      r = *exactly;
      if (random.next(0, 3) == 0)
        r += rational(random.next(0, 1) ? 1 : -1, 8);
    }
    r.canonicalize();
    r = abs(r);
    if (e.second == other::sphere) { // two radii, whose sum or difference is sometimes the distance
      rational first(random.next(0, 12), 4);
      first.canonicalize();
      w.b.push_back(how == 0 ? rational(abs(r - first)) : how == 1 ? rational(r + first) : first);
      r = how <= 1 ? first : r;
    }
    w.a.push_back(r);
    w.where = case_of(e, w);
    std::vector<rational> row = w.a;
    row.insert(row.end(), w.b.begin(), w.b.end());
    for (const polynomial &p : images)
      w.products.push_back(p.evaluate(row));
    out.push_back(std::move(w));
  }
  return out;
}

std::vector<std::string> cases_of(const emitted &e) {
  if (e.second == other::point)
    return {"least <", "least =", "least >"};
  if (e.second == other::sphere) {
    // |r1 - r2| <= r1 + r2; equal where a radius is 0.
    std::vector<std::string> out;
    for (const char *c :
         {"< r1 + r2, d <", "< r1 + r2, d =", "< r1 + r2, d >", "= r1 + r2, d =", "= r1 + r2, d >", "> r1 + r2, d >"})
      out.push_back(std::string("d ") + c + " |r1 - r2|");
    return out;
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> forms;
  const std::vector<std::string> all = {"corner a", "corner b", "edge ab", "corner c", "edge ac", "edge bc", "face"};
  if (e.second == other::segment)
    forms = {{"a point", {all[0]}}, {"a segment", {all[0], all[1], all[2]}}};
  else
    // On a line, a point inside edge bc is corner a or is inside another edge, which is named first.
    forms = {{"a point", {all[0]}}, {"collinear", {all.begin(), all.end() - 2}}, {"a triangle", all}};
  std::vector<std::string> out;
  for (const auto &[form, places] : forms)
    for (const std::string &place : places)
      for (const char *least : {"<", "=", ">"}) {
        const std::string start = form + ", " + place + ", least " + least + " r";
        if (!e.surface || least[0] == '>')
          out.push_back(start);
        else
          for (const char *most : {"<", "=", ">"})
            // The nearest and the farthest distance are equal if and only if the figure is one point.
            if (form == "a point" ? most[0] == least[0] : least[0] == '<' || most[0] == '>')
              out.push_back(start + ", most " + most + " r");
      }
  return out;
}

bool touching(const emitted &e, const witness &w) {
  const rational pad = e.second == other::sphere ? w.b[3] : rational(0);
  return oracle::touches({corner(w.a, 0)}, w.a[3], hull_of(e, w.b), pad,
                         e.surface ? oracle::touch_mode::surface : oracle::touch_mode::solid);
}

std::vector<int> signs_of(const decision &d, const witness &w) {
  std::vector<int> out;
  for (const polynomial &p : d.atoms)
    out.push_back(sgn(p.evaluate(w.products)));
  return out;
}

} // namespace meetc::decisions_round
