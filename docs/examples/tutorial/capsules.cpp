// Which balls of a lattice touch an arm of three capsules?
#include "scene.hpp"

#include <cell/cell_runtime.hpp>
#include <meet/core/query/collide.hpp>
#include <meet/core/query/find.hpp>

int main() {
  const meetc::predicate_info &touch = meetc::find_predicate(cell::catalogue(), "ball_capsule");
  const std::vector<cell::sphere<float>> balls = lattice();
  const meetc::prepared a = meetc::prepare(rows(balls), *touch.a), b = meetc::prepare(rows(arm), *touch.b);
  print(meetc::collide(a, b, touch, meetc::rung::certified));
}
