#include "meet/core/device/first_met.hpp"

#include "meet/core/device/kernels.hpp"

namespace meetc {

void first_met_there::start(const device_set &a, cudaStream_t stream) {
  static_assert(no_element == cuda::no_slot);
  slots_.reserve(a.elements(), "what is met first");
  numbers_.reserve(a.elements(), "what is met first");
  if (a.elements() > 0) // all bits: no_slot
    check(cudaMemsetAsync(slots_.data(), 0xff, a.elements() * sizeof *slots_.data(), stream),
          "clearing what is met first");
}

void first_met_there::add(const cuda::predicate_launchers &by, const device_set &a, const device_set &b,
                          const std::uint32_t *owner_b, const index_pair *hits, std::size_t n, cudaStream_t stream) {
  check(by.pairs.first_met({a.rows(), b.rows(), b.order(), owner_b, hits, n, slots_.data()}, stream),
        "starting a kernel");
}

void first_met_there::name(const device_set &a, const device_set &b, cudaStream_t stream) {
  check(name_slots(slots_.data(), a.elements(), a.order(), b.order(), numbers_.data(), stream), "starting a kernel");
}

void first_met_there::finish(const device_set &a, const device_set &b, std::span<const std::uint32_t> owner_b,
                             result &r, cudaStream_t stream) {
  r.first_met.assign(a.elements(), no_element);
  if (a.elements() == 0 || b.elements() == 0)
    return;
  check(cudaMemcpyAsync(r.first_met.data(), numbers_.data(), a.elements() * sizeof *numbers_.data(),
                        cudaMemcpyDeviceToHost, stream),
        "downloading what is met first");
  check(cudaStreamSynchronize(stream), "downloading what is met first");
  name_items(owner_b, r.first_met);
}

} // namespace meetc
