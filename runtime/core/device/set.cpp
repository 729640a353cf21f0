#include "core/device/set.hpp"

#include "core/device/kernels.hpp"
#include "core/element_set.hpp"
#include "core/two_points.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace meetc {
namespace {

std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

const cuda::kind_launchers &launchers_of(const cuda::catalogue &all, const kind_info &kind) {
  for (int k = 0; k < all.kind_count; ++k)
    if (std::strcmp(all.kinds[k].name, kind.name) == 0 && all.kinds[k].fields == kind.fields)
      return all.kinds[k];
  throw device_error(std::string("no CUDA kernels were generated for the kind ") + kind.name);
}

} // namespace

device_set::device_set(device &on, const prepared &set)
    : on_(&on), kind_(&set.kind()), launchers_(&launchers_of(on.kernels(), set.kind())),
      elements_(static_cast<std::uint32_t>(set.elements())), reach_(set.set().reach), longest_(set.set().longest),
      grid_(set.set().grid) {
  if (!set.whole())
    throw std::invalid_argument("a set on a device must not be prepared for collisions with one other set");
  const std::size_t floats = std::size_t{elements_} * static_cast<std::size_t>(kind_->fields);
  rows_.reserve(floats, "a set's elements");
  order_.reserve(elements_, "a set's order");
  around_.reserve(1, "a set's extent");
  check(cudaMemcpyAsync(rows_.data(), set.set().rows, floats * sizeof(float), cudaMemcpyHostToDevice, on.stream()),
        "uploading a set");
  check(cudaMemcpyAsync(order_.data(), set.set().order, elements_ * sizeof(std::uint32_t), cudaMemcpyHostToDevice,
                        on.stream()),
        "uploading a set");
  enclose();
  check(cudaStreamSynchronize(on.stream()), "uploading a set"); // the caller may now change the memory
}

void device_set::enclose() {
  version_ = next_version(); // first: if a launch fails, nothing that was made of other rows is taken for these
  check(on_->kernels().clear_extent(around_.data(), on_->stream()), "starting a kernel");
  check(launchers_->enclose(rows(), elements_, around_.data(), on_->stream()), "starting a kernel");
}

void device_set::move(const pose &at) {
  if (at.identity()) {
    if (std::exchange(moved_, false))
      enclose();
    return;
  }
  if (!can_move(*kind_))
    throw std::invalid_argument(text(status::cannot_move));
  if (!is_grid(at.grid))
    throw std::invalid_argument(text(status::bad_grid));
  if (!(at.length_scale >= 0))
    throw std::invalid_argument("a pose's length scale is negative or not a number");
  const auto fields = static_cast<std::size_t>(kind_->fields);
  device_memory<float> to;
  device_memory<unsigned long long> bad;
  to.reserve(elements_ * fields, "a set under a pose");
  bad.reserve(1, "a set under a pose");
  cuda::pose_matrix matrix{{}, at.length_scale, false, at.grid != 0, at.grid != 0 ? std::ilogb(at.grid) : 0};
  std::copy_n(at.m, 12, matrix.m);
  check(launchers_->pose({rows_.data(), fields * sizeof(float), nullptr, 0, elements_}, matrix, order_.data(),
                         to.data(), bad.data(), on_->stream()),
        "starting a kernel");
  unsigned long long first = 0;
  check(cudaMemcpyAsync(&first, bad.data(), sizeof first, cudaMemcpyDeviceToHost, on_->stream()), "moving a set");
  check(cudaStreamSynchronize(on_->stream()), "moving a set");
  if (first != ~0ULL) {
    const auto slot = static_cast<std::size_t>(first & 0xffffffff);
    std::vector<float> row(fields);
    fault f{fault_kind::moved, static_cast<std::size_t>(first >> 32), 0, 0, 0, nullptr};
    check(cudaMemcpy(row.data(), to.data() + slot * fields, fields * sizeof(float), cudaMemcpyDeviceToHost),
          "moving a set");
    while (std::isfinite(row[static_cast<std::size_t>(f.field)]))
      ++f.field;
    f.value = row[static_cast<std::size_t>(f.field)];
    throw input_error(f, *kind_);
  }
  moved_rows_ = std::move(to);
  moved_grid_ = at.grid;
  moved_ = true;
  enclose();
}

std::pair<float, float> device_set::reaches() const {
  if (!moved_)
    return {reach_, longest_};
  std::uint64_t lengths = 0;
  for (int f = 0; f < kind_->fields && f < 64; ++f)
    lengths |= static_cast<std::uint64_t>(kind_->roles[f] == role::length) << f;
  device_memory<float> most;
  most.reserve(2, "a set's reach");
  check(meetc::reaches(rows(), elements_, static_cast<unsigned>(kind_->fields), lengths, most.data(), on_->stream()),
        "starting a kernel");
  float seen[2] = {0, 0};
  check(cudaMemcpyAsync(seen, most.data(), sizeof seen, cudaMemcpyDeviceToHost, on_->stream()), "measuring a set");
  check(cudaStreamSynchronize(on_->stream()), "measuring a set");
  return {seen[0], seen[1]};
}

cuda::operand device_set::as(cuda::filter by, cuda::grouping g, cover c, bool first, const device_set &frame) {
  const made want{by == cuda::filter::float32, g, c, frame.version_, version_};
  cuda::operand out{rows(), elements_, g, nullptr};
  device_memory<std::byte> &columns = columns_[first];
  if (want != have_[first]) {
    const std::size_t bytes = matrix_padded(out.objects()) * (want.floats ? cuda::float_bytes : cuda::half_bytes);
    have_[first] = {};
    columns.reserve(bytes, "the filter's columns");
    check(launchers_->columns(by, g, c, first, rows(), elements_, frame.around(), columns.data(), on_->stream()),
          "starting a kernel");
    have_[first] = want;
  }
  out.columns = columns.data();
  return out;
}

search_sizes device_set::for_search(const device_set &b) const {
  const bool same = &b == this; // there is one hierarchy to make
  return {elements_,
          b.elements_,
          tree_of_ == version_,
          same || b.tree_of_ == b.version_,
          tree_.is_made(),
          same || b.tree_.is_made(),
          has_two_points(*kind_) || has_two_points(*b.kind_)};
}

cuda::tree_view device_set::tree(order_scratch &scratch, cudaStream_t stream) {
  if (tree_of_ != version_) {
    tree_of_ = 0;
    tree_.make(*launchers_, rows(), elements_, around(), scratch, stream);
    tree_of_ = version_;
  }
  return tree_.view(elements_);
}

const float *device_set::stored(const cuda::stored_launcher &values) {
  if (values.number < 0 || elements_ == 0)
    return nullptr;
  const auto at = static_cast<std::size_t>(values.number);
  if (stores_.size() <= at)
    stores_.resize(at + 1);
  store &s = stores_[at];
  if (s.of != version_) {
    s.of = 0;
    s.numbers.reserve(elements_ * static_cast<std::size_t>(values.floats), "a set's stored values");
    check(values.compute(rows(), elements_, s.numbers.data(), on_->stream()), "starting a kernel");
    s.of = version_;
  }
  return s.numbers.data();
}

} // namespace meetc
