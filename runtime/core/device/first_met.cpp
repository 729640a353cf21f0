#include "core/device/first_met.hpp"

#include "core/device/kernels.hpp"

namespace meetc {

void first_met_there::start(const device_set &a, cudaStream_t stream) {
  static_assert(no_element == cuda::no_slot);
  first_.reserve(a.elements(), "what is met first");
  named_.reserve(a.elements(), "what is met first");
  if (a.elements() > 0) // all bits: no_slot
    check(cudaMemsetAsync(first_.data(), 0xff, a.elements() * sizeof *first_.data(), stream),
          "clearing what is met first");
}

void first_met_there::add(const cuda::predicate_launchers &by, const device_set &a, const device_set &b,
                          const index_pair *hits, std::size_t n, cudaStream_t stream) {
  check(by.first_met({a.rows(), b.rows(), b.order(), hits, n, first_.data()}, stream), "starting a kernel");
}

void first_met_there::finish(const device_set &a, const device_set &b, std::span<const std::uint32_t> owner_b,
                             result &r, cudaStream_t stream) {
  r.first_met.assign(a.elements(), no_element);
  if (a.elements() == 0 || b.elements() == 0)
    return;
  check(name_slots(first_.data(), a.elements(), a.order(), b.order(), named_.data(), stream), "starting a kernel");
  check(cudaMemcpyAsync(r.first_met.data(), named_.data(), a.elements() * sizeof *named_.data(), cudaMemcpyDeviceToHost,
                        stream),
        "downloading what is met first");
  check(cudaStreamSynchronize(stream), "downloading what is met first");
  name_items(owner_b, r.first_met);
}

} // namespace meetc
