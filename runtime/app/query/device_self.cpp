#include "meet/app/query/device_self.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "meet/core/device/contacts.hpp"
#include "meet/core/device/self_pairs.hpp"
#include "neighbours/neighbours_cuda.hpp"

#include <chrono>
#endif

namespace meetc::app {

#if MEETC_WITH_CUDA
device_self self_pairs_on_device(const io::element_set &mesh, const self_predicates &by, const self_options &options) {
  using clock = std::chrono::steady_clock;
  using seconds = std::chrono::duration<double>;
  try {
    const auto start = clock::now();
    device on(cga::cuda::catalogue());
    const auto ready = clock::now();
    const view elements = view_of(mesh);
    device_set set(on, elements, *mesh.kind, {}, options.threads);
    device_self out;
    set.bounds(out.around.lo, out.around.hi);
    out.prepare_seconds = seconds(clock::now() - ready).count();
    device_self_options o;
    o.merge = options.merge, o.owner = options.owner, o.progress = options.progress;
    if (elements.index)
      o.vertices = {elements.index, 3 * elements.elements};
    device_self_result r = self_pairs(on, set, by, neighbours::cuda::catalogue(), o);
    out.account = {on.facts().name, 1, r.device_seconds, seconds(ready - start).count()};
    out.found = std::move(r);
    return out;
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}

template <class Real>
contact_set<Real> contacts_on_device(const io::element_set &a, const io::element_set &b,
                                     const predicate_info &predicate, std::span<const index_pair> pairs,
                                     const contact_options &options) {
  try {
    return contacts<Real>(device(cga::cuda::catalogue()), view_of(a), view_of(b), predicate, pairs, options);
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}
#else
device_self self_pairs_on_device(const io::element_set &, const self_predicates &, const self_options &) {
  throw failure("this build has no CUDA kernels", no_device);
}
template <class Real>
contact_set<Real> contacts_on_device(const io::element_set &, const io::element_set &, const predicate_info &,
                                     std::span<const index_pair>, const contact_options &) {
  throw failure("this build has no CUDA kernels", no_device);
}
#endif

template contact_set<float> contacts_on_device(const io::element_set &, const io::element_set &, const predicate_info &,
                                               std::span<const index_pair>, const contact_options &);
template contact_set<double> contacts_on_device(const io::element_set &, const io::element_set &,
                                                const predicate_info &, std::span<const index_pair>,
                                                const contact_options &);

} // namespace meetc::app
