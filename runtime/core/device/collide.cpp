#include "meet/core/device/collide.hpp"

#include "meet/core/device/answers/answers_for.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/query/query.hpp"
#include "meet/core/device/set/cull.hpp"
#include "meet/core/device/set/order.hpp"
#include "meet/core/threads/execution.hpp"

#include <chrono>
#include <vector>

namespace meetc {
namespace {

// Also after an error no kernel works on a set, or on what culling left, when a query has ended.
class wait_for {
public:
  explicit wait_for(cudaStream_t stream) : stream_(stream) {}
  ~wait_for() { cudaStreamSynchronize(stream_); } // an error here is that of the query
  wait_for(const wait_for &) = delete;
  wait_for &operator=(const wait_for &) = delete;

private:
  cudaStream_t stream_;
};

// Whether `tolerant` decides depends on all elements, and what is met first is said of all.
bool culls(const device_set &a, const device_set &b, rung precision, const device_options &options) {
  return a.as_given() && b.as_given() && &a != &b && precision != rung::tolerant && !options.first_met &&
         options.cull.value_or(cull_pays(*a.as_given(), *b.as_given()));
}

device_result find_touching(const device &on, device_set &a, device_set &b, const predicate_info &predicate,
                            rung precision, const device_options &options) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const auto ask = [&](bool clock_runs) {
    return query(on, a.rows(), b.rows(), predicate, precision, options,
                 on_device::answers_for(launchers_of(on.kernels(), predicate).pairs, options), clock_runs);
  };
  std::vector<needed_elements> given;
  for (device_set *const s : {&a, &b})
    if (s->as_given() && (given.empty() || s != &a))
      given.push_back({s, s->as_given()->there()});
  if (given.empty())
    return ask(false);

  const device_buffers &buffers = on.buffers();
  const wait_for ended(buffers.beside);
  culled left;
  const bool culled =
      culls(a, b, precision, options) && cull(on, *a.as_given(), *b.as_given(), never_wrong(precision), left);
  if (culled)
    left.keep_only(given[0].elements, given[1].elements);
  order(on, given, left.common, culled);
  // A walk stops where there is no order, and its query reads what was found; where there is none, it is read here.
  const bool walks = a.rows().elements() > 0 && b.rows().elements() > 0;
  if (!walks)
    buffers.read_notes("ordering a set");
  device_result r;
  if (walks || are_in_order(on, given))
    r = ask(true);
  if (!are_in_order(on, given)) { // what was found means nothing
    for (const needed_elements &s : given)
      s.of->rows().make(*s.of->as_given(), 0);
    const double before = elapsed();
    r = ask(false);
    r.device_seconds += before;
  }
  r.seconds = elapsed();
  return r;
}

} // namespace

device_result collide(const device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options) {
  return under_standard_word([&] {
    const auto lock = on.use();
    if (options.leave_there)
      options.leave_there->clear();
    require_query(on, a, b, predicate, precision, options);
    go_on(options.stop);
    return find_touching(on, a, b, predicate, precision, options);
  });
}

} // namespace meetc
