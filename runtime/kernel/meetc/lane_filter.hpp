// The separable filter on a CPU: pairs whose enclosing balls are apart, many at a time.
//
// The form is the one that feeds a device's matrix unit (matrix.hpp), in float32 and with the margins of to_floats():
// where the balls of two elements touch, the computed sum is negative. An element of one set is compared with tiles of
// the other, which stand in structure-of-arrays form, so that nothing is gathered. A ball encloses the element's box, so
// a query whose candidates are pairs of touching boxes loses none of them. Included where lanes.hpp may be.
#ifndef MEETC_LANE_FILTER_HPP
#define MEETC_LANE_FILTER_HPP

#include <meetc/lanes.hpp>

#include <meetc/bounds.hpp>
#include <meetc/matrix.hpp>
#include <meetc/table.hpp>

MEETC_NAMESPACE(meetc) {

template <class Shape> void widen_extent(const float *rows, std::size_t n, filter_extent &all) {
  interval around[3];
  for (std::size_t i = 0; i < n; ++i)
    widen<Shape>(around, rows + i * std::size_t{Shape::fields});
  for (int k = 0; k < 3; ++k) {
    const interval wider = joined(around[k], {all.lo[k], all.hi[k]});
    all.lo[k] = wider.lo, all.hi[k] = wider.hi;
  }
}

inline matrix_frame frame_of(const filter_extent &e) {
  const interval around[3] = {{e.lo[0], e.hi[0]}, {e.lo[1], e.hi[1]}, {e.lo[2], e.hi[2]}};
  return frame_of(around);
}

// Calls take(i, numbers) for each of n elements.
template <class Shape, class Form, bool First, class Take>
void each_in_frame(const filter_extent &of_frame, const float *rows, std::size_t n, const Take &take) {
  const matrix_frame frame = frame_of(of_frame);
  for (std::size_t i = 0; i < n; ++i) {
    double ball[4];
    const placing where = place_object<Shape>(frame, cover::box, rows + i * std::size_t{Shape::fields}, 0, 1, ball);
    float numbers[Form::products + 1];
    to_floats<Form, First, in_fp64::value>(ball, where, numbers);
    take(i, numbers);
  }
}
template <class Shape, class Form>
void filter_singles(const filter_extent &frame, const float *rows, std::size_t n, float *out) {
  constexpr std::size_t floats = Form::products + 1;
  each_in_frame<Shape, Form, true>(frame, rows, n, [out](std::size_t i, const float *numbers) {
    for (std::size_t k = 0; k < floats; ++k)
      out[i * floats + k] = numbers[k];
  });
}
template <class Shape, class Form>
void filter_tiles(const filter_extent &frame, const float *rows, std::size_t n, float *out) {
  constexpr std::size_t floats = Form::products + 1;
  const auto put = [out](std::size_t i, const float *numbers) {
    for (std::size_t k = 0; k < floats; ++k)
      out[i / filter_tile * filter_tile * floats + k * filter_tile + i % filter_tile] = numbers[k];
  };
  each_in_frame<Shape, Form, false>(frame, rows, n, put);
  float nowhere[floats];
  to_floats<Form, false, in_fp64::value>(nullptr, placing::nowhere, nowhere);
  for (std::size_t i = n; i % filter_tile != 0; ++i)
    put(i, nowhere);
}

// The elements of a tile that are not ruled out.
template <class Form> MEETC_INLINE std::uint32_t near_elements(const lanes *single, const float *tile) {
  std::uint32_t elements = 0;
  for (int from = 0; from < filter_tile; from += lane_count) {
    lanes sum = single[Form::products] + lanes::from(tile + Form::products * filter_tile + from);
    for (int k = 0; k < Form::products; ++k)
      sum = fma(single[k], lanes::from(tile + k * filter_tile + from), sum);
    elements |= greater(lanes(0.0F), sum) << from;
  }
  return elements;
}
// Most tiles are ruled out whole, so there is one branch for several of them, and none within.
template <class Form>
near_tile *near_tiles(const float *single, const float *tiles, std::size_t count, near_tile *out) {
  constexpr std::size_t floats = (Form::products + 1) * filter_tile, together = 4;
  lanes x[Form::products + 1];
  for (int k = 0; k <= Form::products; ++k)
    x[k] = lanes(single[k]);
  const auto put = [&out](std::size_t t, std::uint32_t elements) {
    *out = {static_cast<std::uint32_t>(t), elements};
    out += elements != 0;
  };
  std::size_t t = 0;
  for (; t + together <= count; t += together) {
    std::uint32_t elements[together], any = 0;
    for (std::size_t i = 0; i < together; ++i)
      any |= elements[i] = near_elements<Form>(x, tiles + (t + i) * floats);
    if (any == 0)
      continue;
    for (std::size_t i = 0; i < together; ++i)
      put(t + i, elements[i]);
  }
  for (; t < count; ++t)
    put(t, near_elements<Form>(x, tiles + t * floats));
  return out;
}

template <class Shape, class Form>
inline constexpr kind_filter filter_of{Form::products + 1, widen_extent<Shape>, filter_singles<Shape, Form>,
                                       filter_tiles<Shape, Form>, near_tiles<Form>};

} // MEETC_NAMESPACE(meetc)

#endif
