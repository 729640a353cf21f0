#include "tests/cgal/scenes.hpp"

#include "meet/core/query/collide.hpp"
#include "tests/catch.hpp"

#include <cga/cga_runtime.hpp>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>

namespace meetc::cgal_test {
namespace {

const char *name_of(shape s) {
  return s == shape::sphere ? "sphere" : s == shape::segment ? "segment" : "triangle";
}

const meetc::predicate_info &predicate_for(shape a, shape b, bool surface) {
  const meetc::catalogue &c = cga::catalogue();
  for (int i = 0; i < c.predicate_count; ++i) {
    const meetc::predicate_info &p = c.predicates[i];
    if (std::strcmp(p.a->name, name_of(a)) == 0 && std::strcmp(p.b->name, name_of(b)) == 0 &&
        (*p.mode == 0 || std::string(p.mode) == (surface ? "surface" : "solid")))
      return p;
  }
  throw std::invalid_argument("no predicate");
}

meetc::prepared ready(const body &b, const meetc::kind_info &kind) {
  meetc::view v;
  v.data = b.rows.data();
  v.elements = b.size();
  v.stride_bytes = floats_of(b.kind) * sizeof(float);
  return meetc::prepare(v, kind);
}

pair_list by_meet(const body &a, const body &b, bool surface) {
  const meetc::predicate_info &p = predicate_for(a.kind, b.kind, surface);
  const meetc::result r = meetc::collide(ready(a, *p.a), ready(b, *p.b), p, meetc::rung::exact);
  pair_list out;
  for (const meetc::index_pair &i : r.pairs)
    out.emplace_back(i.a, i.b);
  return out;
}

std::string text(const body &b, std::size_t i) {
  std::ostringstream out;
  out << std::hexfloat;
  for (std::size_t k = 0; k < floats_of(b.kind); ++k)
    out << b.row(i)[k] << ' ';
  return out.str();
}

} // namespace

body triangles_of(const meetc::bodies::mesh &m) {
  body b{shape::triangle, {}};
  for (const std::uint32_t i : m.index)
    b.rows.insert(b.rows.end(), m.xyz.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                  m.xyz.begin() + 3 * static_cast<std::ptrdiff_t>(i) + 3);
  return b;
}
body segments_of(const std::vector<float> &rows) {
  return {shape::segment, rows};
}
body spheres_of(const std::vector<float> &rows) {
  return {shape::sphere, rows};
}

body placed(const body &b, const placing &at) {
  const double length = std::hypot(at.axis[0], at.axis[1], at.axis[2]);
  const double x = at.axis[0] / length, y = at.axis[1] / length, z = at.axis[2] / length;
  const double c = std::cos(at.degrees * std::numbers::pi / 180), s = std::sin(at.degrees * std::numbers::pi / 180);
  const double turn[3][3] = {{c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s},
                             {y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s},
                             {z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)}};
  body out = b;
  const std::size_t fields = floats_of(b.kind);
  for (std::size_t i = 0; i < b.rows.size(); i += fields) {
    for (std::size_t p = 0; p + 3 <= fields; p += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        double sum = 0;
        for (std::size_t j = 0; j < 3; ++j)
          sum += turn[k][j] * static_cast<double>(b.rows[i + p + j]);
        out.rows[i + p + k] = static_cast<float>(at.scale * sum + at.move[k]);
      }
    if (b.kind == shape::sphere)
      out.rows[i + 3] = static_cast<float>(at.scale * static_cast<double>(b.rows[i + 3]));
  }
  return out;
}

body in_float32(const body &b, float factor, float offset) {
  body out = b;
  const std::size_t fields = floats_of(b.kind);
  for (std::size_t i = 0; i < out.rows.size(); ++i) {
    const bool radius = b.kind == shape::sphere && i % fields == 3;
    const volatile float product = out.rows[i] * factor; // rounded before the sum, under any flags
    out.rows[i] = radius ? product : product + offset;
  }
  return out;
}

std::size_t same_pairs(const std::string &name, const body &a, const body &b, bool surface) {
  std::size_t candidates = 0;
  const pair_list want = touching_pairs(a, b, surface, &candidates), have = by_meet(a, b, surface);
  INFO(name << ": " << a.size() << " x " << b.size() << ", " << candidates << " candidates, CGAL " << want.size()
            << " pairs, meet " << have.size());
  if (want != have) {
    pair_list extra, missed;
    std::set_difference(have.begin(), have.end(), want.begin(), want.end(), std::back_inserter(extra));
    std::set_difference(want.begin(), want.end(), have.begin(), have.end(), std::back_inserter(missed));
    for (const auto &[list, what] : {std::pair(&extra, "extra"), std::pair(&missed, "missed")})
      if (!list->empty())
        UNSCOPED_INFO(list->size() << ' ' << what << ", first " << list->front().first << ' ' << list->front().second
                                   << ": " << text(a, list->front().first) << "| " << text(b, list->front().second));
  }
  CHECK(want == have);
  return want.size();
}

} // namespace meetc::cgal_test
