#include "meet/core/device/answers/first_met.hpp"

#include "meet/core/device/answers/kernels.hpp"
#include "meet/core/device/answers/owners.hpp"
#include "meet/core/device/memory/buffers.hpp"

namespace meetc::on_device {

void first_met::start(const queried_sets &sets) {
  static_assert(no_element == cuda::no_slot);
  on_ = &sets.on, a_ = &sets.a, b_ = &sets.b;
  slots_ = &on_->buffers().first_slots, numbers_ = &on_->buffers().first_numbers;
  upload_owners(owner_b_, owners_there_, on_->stream());
  slots_->reserve(a_->elements(), "what is met first");
  numbers_->reserve(a_->elements(), "what is met first");
  if (a_->elements() > 0) // all bits: no_slot
    check(cudaMemsetAsync(slots_->data(), 0xff, a_->elements() * sizeof *slots_->data(), on_->stream()),
          "clearing what is met first");
}

void first_met::take(const part_hits &hits) {
  check(by_.first_met({a_->data(), b_->data(), b_->order(), owners_there_.data(), hits.pairs, hits.n, slots_->data()},
                      on_->stream()),
        "starting a kernel");
}

void first_met::finish() {
  if (a_->elements() > 0 && b_->elements() > 0)
    check(name_slots(slots_->data(), a_->elements(), a_->order(), b_->order(), numbers_->data(), on_->stream()),
          "starting a kernel");
}

void first_met::download(device_result &r) {
  r.first_met.assign(a_->elements(), no_element);
  if (a_->elements() == 0 || b_->elements() == 0)
    return;
  check(cudaMemcpyAsync(r.first_met.data(), numbers_->data(), a_->elements() * sizeof *numbers_->data(),
                        cudaMemcpyDeviceToHost, on_->stream()),
        "downloading what is met first");
  check(cudaStreamSynchronize(on_->stream()), "downloading what is met first");
  name_items(owner_b_, r.first_met);
}

} // namespace meetc::on_device
