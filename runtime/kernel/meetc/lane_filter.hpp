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
#include <meetc/table_entry.hpp>

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

// Calls take(i, numbers) for each of the objects that `size` elements make, of n elements.
template <class Shape, class Form, bool First, class Take>
void each_in_frame(const filter_extent &of_frame, const float *rows, std::size_t n, std::uint32_t size,
                   const Take &take) {
  const matrix_frame frame = frame_of(of_frame);
  for (std::size_t i = 0; i < n; i += size) {
    const std::size_t here = n - i < size ? n - i : size;
    double ball[4];
    const placing where = place_object<Shape>(frame, cover::box, rows + i * std::size_t{Shape::fields}, 0,
                                              static_cast<std::uint32_t>(here), ball);
    float numbers[Form::products + 1];
    to_floats<Form, First, in_fp64::value>(ball, where, numbers);
    take(i / size, numbers);
  }
}
template <class Shape, class Form>
void filter_singles(const filter_extent &frame, const float *rows, std::size_t n, float *out) {
  constexpr std::size_t floats = Form::products + 1;
  each_in_frame<Shape, Form, true>(frame, rows, n, 1, [out](std::size_t i, const float *numbers) {
    for (std::size_t k = 0; k < floats; ++k)
      out[i * floats + k] = numbers[k];
  });
}
template <class Shape, class Form, std::uint32_t Size>
void filter_tiles(const filter_extent &frame, const float *rows, std::size_t n, float *out) {
  constexpr std::size_t floats = Form::products + 1;
  const auto put = [out](std::size_t i, const float *numbers) {
    for (std::size_t k = 0; k < floats; ++k)
      out[i / filter_tile * filter_tile * floats + k * filter_tile + i % filter_tile] = numbers[k];
  };
  each_in_frame<Shape, Form, false>(frame, rows, n, Size, put);
  float nowhere[floats];
  to_floats<Form, false, in_fp64::value>(nullptr, placing::nowhere, nowhere);
  for (std::size_t i = (n + Size - 1) / Size; i % filter_tile != 0; ++i)
    put(i, nowhere);
}

// The sums of a tile's elements with one element of the other set, but for that element's additive term: an element is not
// ruled out where its sum is less than the negative of the term. (A comparison does not round.)
template <class Form> struct tile_sums {
  static constexpr int parts = filter_tile / lane_count;
  lanes sums[parts];

  // Returns the least of each lane.
  MEETC_INLINE lanes compute(const lanes *single, const float *tile) {
    lanes least;
    for (int p = 0; p < parts; ++p) {
      const float *const part = tile + p * lane_count;
      sums[p] = lanes::from(part + Form::products * filter_tile);
      for (int k = 0; k < Form::products; ++k)
        sums[p] = fma(single[k], lanes::from(part + k * filter_tile), sums[p]);
      least = p == 0 ? sums[p] : smaller(least, sums[p]);
    }
    return least;
  }
  MEETC_INLINE std::uint32_t below(lanes limit) const {
    std::uint32_t elements = 0;
    for (int p = 0; p < parts; ++p)
      elements |= greater(limit, sums[p]) << p * lane_count;
    return elements;
  }
};
template <class Form> class near_finder {
public:
  MEETC_INLINE near_finder(const float *single, const float *tiles, near_tile *out)
      : limit_(-single[Form::products]), tiles_(tiles), out_(out) {
    for (int k = 0; k < Form::products; ++k)
      factors_[k] = lanes(single[k]);
  }

  // Most tiles are ruled out whole, so there is one comparison for several of them.
  MEETC_INLINE void look(std::size_t t, std::size_t end) {
    constexpr std::size_t together = lane_count < 8 ? 2 : 4; // the sums stay in registers
    for (; t + together <= end; t += together) {
      tile_sums<Form> of[together];
      lanes least = of[0].compute(factors_, tiles_ + t * floats);
      for (std::size_t i = 1; i < together; ++i)
        least = smaller(least, of[i].compute(factors_, tiles_ + (t + i) * floats));
      if (greater(limit_, least) == 0)
        continue;
      for (std::size_t i = 0; i < together; ++i)
        put(t + i, of[i]);
    }
    for (; t < end; ++t) {
      tile_sums<Form> last;
      last.compute(factors_, tiles_ + t * floats);
      put(t, last);
    }
  }
  // The same for the tiles whose groups are not ruled out.
  MEETC_INLINE void look_by_groups(const float *groups, std::size_t count) {
    for (std::size_t t = 0; t < count; t += filter_tile) {
      tile_sums<Form> sums;
      sums.compute(factors_, groups + t / filter_tile * floats);
      std::uint32_t left = sums.below(limit_);
      if (count - t < filter_tile)
        left &= (1U << (count - t)) - 1;
      while (left != 0) { // tiles side by side at once
        const std::size_t from = t + static_cast<std::size_t>(__builtin_ctz(left));
        left |= left - 1;
        const std::size_t to = t + static_cast<std::size_t>(__builtin_ctz(~left));
        left &= left + 1;
        look(from, to);
      }
    }
  }
  near_tile *end() const { return out_; }

private:
  static constexpr std::size_t floats = (Form::products + 1) * filter_tile; // of a tile

  MEETC_INLINE void put(std::size_t t, const tile_sums<Form> &sums) {
    *out_ = {static_cast<std::uint32_t>(t), sums.below(limit_)};
    out_ += out_->elements != 0;
  }

  lanes factors_[Form::products], limit_;
  const float *tiles_;
  near_tile *out_;
};
template <class Form>
near_tile *near_tiles(const float *single, const float *groups, const float *tiles, std::size_t count, near_tile *out) {
  near_finder<Form> find(single, tiles, out);
  if (groups)
    find.look_by_groups(groups, count);
  else
    find.look(0, count);
  return find.end();
}

template <class Shape, class Form>
inline constexpr kind_filter filter_of{Form::products + 1,
                                       guarded<widen_extent<Shape>>,
                                       guarded<filter_singles<Shape, Form>>,
                                       guarded<filter_tiles<Shape, Form, 1>>,
                                       guarded<filter_tiles<Shape, Form, filter_tile>>,
                                       guarded<near_tiles<Form>>};

} // MEETC_NAMESPACE(meetc)

#endif
