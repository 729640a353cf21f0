#include "meet/core/device/set/device_set.hpp"

#include <algorithm>
#include <utility>

namespace meetc {

device_set::device_set(const device &on, const prepared &set) : on_(on), rows_(on, set.kind()) {
  const control_word_guard guard;
  const auto lock = on_.use();
  rows_.upload(set);
}

device_set::device_set(const device &on, const view &elements, const kind_info &kind, const pose &at, int threads)
    : on_(on), rows_(on, kind) {
  const control_word_guard guard;
  const auto lock = on_.use();
  require_pose(kind, at);
  if (std::optional<given_elements> there = given_elements::if_it_fits(on, elements, kind)) {
    there->at = at;
    ordered_seconds_ = rows_.make(*there, threads);
  } else {
    rows_.upload(prepare(elements, kind, at, threads));
  }
}

device_set::device_set(const device &on, given_elements &&elements)
    : on_(on), rows_(on, elements.kind()), given_(std::move(elements)) {}

device_set device_set::given(const device &on, const view &elements, const kind_info &kind) {
  const control_word_guard guard;
  const auto lock = on.use();
  return {on, given_elements(on, elements, kind)};
}
device_set device_set::given(const device &on, const cuda::view &there, const kind_info &kind) {
  return {on, given_elements(on, there, kind)};
}

void device_set::move(const pose &at) {
  const control_word_guard guard;
  const auto lock = on_.use();
  if (!given_) {
    rows_.move(at);
    return;
  }
  require_movable(kind(), at);
  given_->at = at;
}

void device_set::bounds(float lo[3], float hi[3]) {
  const control_word_guard guard;
  const auto lock = on_.use();
  const cuda::tree_box all = given_ ? given_->bounds() : rows_.bounds();
  std::copy_n(all.low, 3, lo);
  std::copy_n(all.high, 3, hi);
}

} // namespace meetc
