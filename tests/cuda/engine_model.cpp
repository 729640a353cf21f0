// The filter on the host: the same columns, every product exact, and the unit's sum anywhere within its model.
#include "engine.hpp"

#include "core/element_set.hpp"

#include <cga/ball_form.hpp>
#include <cga/shapes.hpp>
#include <meet/enclosing.hpp>
#include <meet/matrix.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace cuda_test {
namespace {

using namespace meet;
using form = cga::ball_form;
using ball = std::array<double, 4>;

template <class Shape> ball enclosing(const float *row, cover c) {
  ball out;
  object_ball<Shape>(c, row, 0, 1, out.data());
  return out;
}
ball enclosing(const kind_info &kind, const float *row, cover c) {
  const std::string_view name = kind.name;
  if (name == "point")
    return enclosing<cga::point_shape>(row, c);
  if (name == "sphere")
    return enclosing<cga::sphere_shape>(row, c);
  if (name == "segment")
    return enclosing<cga::segment_shape>(row, c);
  if (name == "triangle")
    return enclosing<cga::triangle_shape>(row, c);
  throw std::runtime_error("a kind without a shape: " + std::string(name));
}

std::vector<ball> balls_of(const prepared &p, cover c) {
  std::vector<ball> out;
  const auto fields = static_cast<std::size_t>(p.kind().fields);
  for (std::size_t i = 0; i < p.elements(); ++i)
    out.push_back(enclosing(p.kind(), p.set().rows + i * fields, c));
  return out;
}

matrix_frame frame_around(const prepared &p) {
  double lo[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, hi[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const ball &b : balls_of(p, cover::box))
    for (std::size_t k = 0; k < 3; ++k)
      lo[k] = std::fmin(lo[k], b[k] - b[3]), hi[k] = std::fmax(hi[k], b[k] + b[3]);
  return frame_of(lo, hi);
}

struct columns {
  double halves[matrix_columns];
  float floats[form::products + 1];
};
template <bool First> std::vector<columns> columns_of(const std::vector<ball> &balls, const matrix_frame &frame) {
  std::vector<columns> out(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    ball b = balls[i];
    const placing where = place_ball(frame, b.data());
    std::uint16_t halves[matrix_columns];
    to_columns<form, First>(b.data(), where, halves);
    for (int k = 0; k < matrix_columns; ++k)
      out[i].halves[k] = from_half(halves[k]);
    to_floats<form, First>(b.data(), where, out[i].floats);
  }
  return out;
}

struct verdict {
  bool must, may; // come out negative
};
verdict judge(const columns &x, const columns &y, cuda::filter by) {
  if (by == cuda::filter::float32) {
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

expectation expect(const predicate_info &p, const prepared &a, const prepared &b, cuda::filter by) {
  const std::vector<ball> balls_a = balls_of(a, cover::element), balls_b = balls_of(b, cover::element);
  expectation out;
  if (balls_a.empty() || balls_b.empty())
    return out;
  const matrix_frame frame = frame_around(balls_b.size() < balls_a.size() ? a : b);
  const std::vector<columns> x = columns_of<true>(balls_a, frame), y = columns_of<false>(balls_b, frame);
  const std::vector<box> boxes_a = boxes_of(a), boxes_b = boxes_of(b);
  std::vector<index_pair> pairs;
  std::vector<bool> sure; // that the filter lets it through
  const auto count = [](range &r, bool must) { r.least += must, ++r.most; };
  for (std::uint32_t i = 0; i < x.size(); ++i)
    for (std::uint32_t j = 0; j < y.size(); ++j) {
      const verdict v = judge(x[i], y[j], by);
      if (!v.may)
        continue;
      count(out.near_balls, v.must);
      bool touch = true;
      for (int k = 0; k < 3; ++k)
        touch = touch && boxes_a[i].lo[k] <= boxes_b[j].hi[k] && boxes_b[j].lo[k] <= boxes_a[i].hi[k];
      if (!touch)
        continue;
      count(out.candidates, v.must);
      pairs.push_back({i, j});
      sure.push_back(v.must);
    }
  std::vector<answer> answers;
  for (int r = 0; r < bounded_rungs; ++r) {
    answers.resize(pairs.size());
    p.certify[r](a.set().rows, b.set().rows, pairs.data(), pairs.size(), answers.data());
    std::size_t left = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (answers[i] == answer::unsure) {
        count(out.unsure[r], sure[i]);
        pairs[left] = pairs[i], sure[left] = sure[i];
        ++left;
      }
    pairs.resize(left), sure.resize(left);
  }
  return out;
}

} // namespace cuda_test
