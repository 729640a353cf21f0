// CGAL's do_intersect with its kernel of exact predicates. MEETC_CGAL_PAIRS is the name of the function that this defines.
#include "meet/bench/peers/each.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct pairs_of_triangles {
  std::vector<kernel::Triangle_3> a, b;
};

kernel::Triangle_3 triangle(const float *row) {
  const auto point = [row](std::size_t i) { return kernel::Point_3(row[3 * i], row[3 * i + 1], row[3 * i + 2]); };
  return {point(0), point(1), point(2)};
}

void *make(const float *a, const float *b, std::size_t n) {
  auto made = std::make_unique<pairs_of_triangles>();
  for (std::size_t i = 0; i < n; ++i) {
    made->a.push_back(triangle(a + 9 * i));
    made->b.push_back(triangle(b + 9 * i));
  }
  return made.release();
}

void decide(const void *made, meetc::answer *out) {
  const auto &pairs = *static_cast<const pairs_of_triangles *>(made);
  for (std::size_t i = 0; i < pairs.a.size(); ++i)
    out[i] = CGAL::do_intersect(pairs.a[i], pairs.b[i]) ? meetc::answer::yes : meetc::answer::no;
}

void drop(void *made) {
  delete static_cast<pairs_of_triangles *>(made);
}

} // namespace

const meetc::bench::peers::exact_pairs *MEETC_CGAL_PAIRS() {
  static constexpr meetc::bench::peers::exact_pairs table{make, decide, drop};
  return &table;
}
