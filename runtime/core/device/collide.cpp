#include "core/device/collide.hpp"

#include "core/device/answers/answers_for.hpp"
#include "core/device/query.hpp"

#include <stdexcept>

namespace meetc {

device_result collide(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options) {
  return under_standard_word([&] {
    if (options.leave_there)
      options.leave_there->clear();
    require_query(on, a, b, predicate, precision, options);
    for (const device_set *const s : {&a, &b})
      if (s->elements() > 0 && !s->order())
        throw std::invalid_argument("a set in several poses is for collide_poses() alone");
    return query(on, a, b, predicate, precision, options,
                 on_device::answers_for(launchers_of(on.kernels(), predicate).pairs, options));
  });
}

} // namespace meetc
