// The filter on the host: the same columns, every product exact, and the unit's sum anywhere within its model.
#include "engine.hpp"

#include "meet/core/sets/element_set.hpp"

#include <cga/ball_form.hpp>
#include <cga/shapes.hpp>
#include <meetc/every_pair/frame.hpp>
#include <meetc/every_pair/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cuda_test {
namespace {

using namespace meetc;
using form = cga::ball_form;
// f(Shape()), where Shape is that of the kind.
template <class F> auto of_shape(const kind_info &kind, F &&f) {
  const std::string_view name = kind.name;
  if (name == "point")
    return f(cga::point_shape());
  if (name == "sphere")
    return f(cga::sphere_shape());
  if (name == "segment")
    return f(cga::segment_shape());
  if (name == "triangle")
    return f(cga::triangle_shape());
  if (name == "box")
    return f(cga::box_shape());
  throw std::runtime_error("a kind without a shape: " + std::string(name));
}

matrix_frame frame_around(const prepared &p) {
  return of_shape(p.kind(), [&]<class Shape>(Shape) {
    interval around[3];
    for (std::size_t i = 0; i < p.elements(); ++i)
      widen<Shape>(around, p.set().rows + i * std::size_t{Shape::fields});
    return frame_of(around);
  });
}

struct columns {
  double halves[matrix_columns];
  float floats[form::products + 1];
};
template <bool First> std::vector<columns> columns_of(const prepared &p, const matrix_frame &frame) {
  return of_shape(p.kind(), [&]<class Shape>(Shape) {
    std::vector<columns> out(p.elements());
    for (std::uint32_t i = 0; i < out.size(); ++i) {
      double ball[4];
      const placing where =
          place_element<Shape>(frame, cover::element, p.set().rows + i * std::size_t{Shape::fields}, ball);
      std::uint16_t halves[matrix_columns];
      to_columns<form, First>(ball, where, halves);
      for (int k = 0; k < matrix_columns; ++k)
        out[i].halves[k] = from_half(halves[k]);
      to_floats<form, First>(ball, where, out[i].floats);
    }
    return out;
  });
}

struct verdict {
  bool must, may; // come out negative
};
verdict judge(const columns &x, const columns &y, every_pair::filter by) {
  if (by == every_pair::filter::float32) {
    const bool negative = std::signbit(bilinear<form>(x.floats, y.floats));
    return {negative, negative};
  }
  double sum = 0, size = 0;
  for (int k = 0; k < matrix_columns; ++k) {
    const double t = x.halves[k] * y.halves[k]; // exact
    sum += t, size += std::fabs(t);
  }
  const double off = size * (17 * 0x1p-23 + 0x1p-48); // and this sum's own rounding
  return {sum + off < 0, sum - off < 0};
}

struct box {
  float lo[3], hi[3];
};
std::vector<box> boxes_of(const prepared &p) {
  std::vector<box> out(p.elements());
  for (std::size_t i = 0; i < out.size(); ++i)
    p.kind().box(p.set().rows + i * static_cast<std::size_t>(p.kind().fields), out[i].lo, out[i].hi);
  return out;
}

} // namespace

expectation expect(const predicate_info &p, const prepared &a, const prepared &b, every_pair::filter by) {
  expectation out;
  if (a.elements() == 0 || b.elements() == 0)
    return out;
  const matrix_frame frame = frame_around(b.elements() < a.elements() ? a : b);
  const std::vector<columns> x = columns_of<true>(a, frame), y = columns_of<false>(b, frame);
  const std::vector<box> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  std::vector<index_pair> pairs;
  const auto count = [](range &r, bool must) { r.least += must, ++r.most; };
  for (std::uint32_t i = 0; i < x.size(); ++i)
    for (std::uint32_t j = 0; j < y.size(); ++j) {
      const verdict v = judge(x[i], y[j], by);
      if (!v.may)
        continue;
      count(out.near, v.must);
      bool touch = true;
      for (int k = 0; k < 3; ++k)
        touch = touch && boxes_a[i].lo[k] <= boxes_b[j].hi[k] && boxes_b[j].lo[k] <= boxes_a[i].hi[k];
      if (!touch)
        continue;
      count(out.candidates, v.must);
      pairs.push_back({i, j});
    }
  // A device decides pairs one by one, and with that some which lanes leave unsure.
  std::vector<answer> answers(pairs.size());
  p.certify[0](a.set().rows, b.set().rows, pairs.data(), pairs.size(), answers.data());
  out.most_unsure = static_cast<std::uint64_t>(std::count(answers.begin(), answers.end(), answer::unsure));
  return out;
}

} // namespace cuda_test
