#include "bench/classic_set.hpp"

#include "app/sets.hpp"
#include "bench/baseline_moller.hpp"

namespace meetc::bench {

namespace {

constexpr std::size_t widest_lanes = 16;

} // namespace

classic_set::classic_set(const io::element_set &set, const std::uint32_t *order)
    : count_(set.elements), fields_(static_cast<std::size_t>(set.kind->fields)),
      stride_((set.elements + widest_lanes - 1) / widest_lanes * widest_lanes), rows_(stride_ * fields_) {
  for (std::size_t i = 0; i < count_; ++i)
    set.row(order ? order[i] : i, rows_.data() + i * fields_);
  const bool triangles = app::is_mesh(set);
  planes_.resize(triangles ? 4 * stride_ : 0);
  for (std::size_t i = 0; i < planes_.size() / 4; ++i) {
    const baselines::detail::plane<float> p(rows_.data() + 9 * i);
    float *const to = planes_.data() + 4 * i;
    to[0] = p.normal.x, to[1] = p.normal.y, to[2] = p.normal.z, to[3] = p.offset;
  }
  columns_ = allocate((fields_ + (triangles ? 4 : 0)) * stride_ * sizeof(float));
  for (std::size_t i = 0; i < stride_; ++i) {
    for (std::size_t f = 0; f < fields_; ++f)
      columns()[f * stride_ + i] = rows_[i * fields_ + f];
    for (std::size_t f = 0; f < (triangles ? 4 : 0); ++f)
      columns()[(fields_ + f) * stride_ + i] = planes_[4 * i + f];
  }
}

std::vector<float> stored_for(const stored_values &values, const classic_set &set) {
  std::vector<float> out(set.count() * static_cast<std::size_t>(values.floats));
  if (out.empty() || !values.compute(set.rows(), set.count(), out.data()))
    out.clear();
  return out;
}

} // namespace meetc::bench
