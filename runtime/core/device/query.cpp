#include "meet/core/device/query.hpp"

#include "meet/core/device/parts.hpp"

#include <cstring>
#include <stdexcept>
#include <string>

namespace meetc {
namespace {

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
}

} // namespace

const cuda::predicate_launchers &launchers_of(const cuda::catalogue &all, const predicate_info &p) {
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::strcmp(all.predicates[i].name, p.name) == 0)
      return all.predicates[i];
  throw device_error(std::string("no CUDA kernels were generated for ") + p.name);
}

void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options) {
  const auto same = [](const kind_info &x, const kind_info &y) {
    return x.fields == y.fields && std::strcmp(x.name, y.name) == 0;
  };
  require(same(a.kind(), *predicate.a) && same(b.kind(), *predicate.b), "the predicate is for other kinds of element");
  require(a.is_on(on) && b.is_on(on), "a set is on another device");
  require(predicate.decide[static_cast<int>(precision)] != nullptr, text(status::no_such_rung));
  require_first_met(predicate, options.want, options.first_met, options.owner_a);
  require(options.list_capacity >= least_capacity, "a list holds at least 2^11 pairs");
}

} // namespace meetc
