// Which balls of a lattice touch an arm of three capsules?
#include "scene.hpp"

#include <cell/cell_runtime.hpp>

int main() {
  const meetc::catalogue &kinds = cell::catalogue();
  const std::vector<cell::sphere<float>> balls = lattice();
  const meet::prepared a = meet::prepare(meet::elements_of(meetc::find_kind(kinds, "sphere"), balls));
  const meet::prepared b = meet::prepare(meet::elements_of(meetc::find_kind(kinds, "capsule"), arm));
  print(meet::pairs(a, b, {}, kinds));
}
