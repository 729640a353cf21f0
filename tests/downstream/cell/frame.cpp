#include <cell/cell_runtime.hpp>
#include <cstdio>
#include <cstring>
#include <meet/core/query/collide.hpp>

int main() {
  const float balls[] = {0, 0, 0, 1, 3, 0, 0, 1, 9, 0, 0, 1}, probe[] = {2, 0, 0, 1};
  const meetc::catalogue &all = cell::catalogue();
  for (int i = 0; i < all.predicate_count; ++i) {
    const meetc::predicate_info &p = all.predicates[i];
    if (std::strcmp(p.name, "ball_ball") != 0)
      continue;
    const meetc::view a{balls, 3, 16, nullptr, 3}, b{probe, 1, 16, nullptr, 1};
    const meetc::result r = meetc::collide(meetc::prepare(a, *p.a), meetc::prepare(b, *p.b), p, meetc::rung::exact);
    std::printf("%llu pairs\n", static_cast<unsigned long long>(r.count));
  }
  for (const meetc::instruction_set set : {meetc::instruction_set::avx2, meetc::instruction_set::avx512})
    std::printf("%s: %s\n", meetc::name_of(set),
                cell::catalogue_for(set) ? "compiled"
                : meetc::runs_here(set)  ? "runs here, but is not compiled"
                                         : "does not run here");
}
