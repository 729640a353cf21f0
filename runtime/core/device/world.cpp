#include "meet/core/device/world.hpp"

#include "meet/core/device/collide.hpp"
#include "meet/core/threads/execution.hpp"

#include <chrono>
#include <cstring>

namespace meetc {
namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

bool same_bits(const pose &x, const pose &y) {
  static_assert(sizeof(pose) == 14 * sizeof(double)); // without padding
  return std::memcmp(&x, &y, sizeof x) == 0;
}

} // namespace

// Puts a body into its pose, and uploads it before if it is not there.
void device_world::place(std::uint32_t number) {
  std::optional<body> &b = bodies_[number];
  const pose &at = of_.at(number);
  if (!b)
    b.emplace(body{device_set(on_, of_.shape(number)), {}});
  if (same_bits(b->at, at))
    return;
  try {
    b->there.move(at);
  } catch (const input_error &e) {
    throw input_error(e.where, of_.shape(number).kind(), "body " + of_.name(number) + ", ");
  }
  b->at = at;
}

world_answer device_world::ask(const world_options &options) {
  const auto start = clock::now();
  if (options.nested)
    static_cast<void>(of_.nested({}, options)); // whether it may be asked
  const std::vector<near_bodies> pairs = of_.near(options.of);
  bodies_.resize(of_.size());
  for (const near_bodies &p : pairs)
    for (const std::uint32_t b : {p.a, p.b}) {
      go_on(options.stop);
      place(b);
    }
  world_answer out;
  out.near = pairs.size();
  out.pose_seconds = seconds_since(start);
  std::vector<near_bodies> apart;
  auto next = clock::now();
  const auto tell = [&](double pairs_done) {
    if (options.progress && clock::now() >= next) {
      options.progress(pairs_done / static_cast<double>(pairs.size()));
      next = clock::now() + std::chrono::milliseconds(100);
    }
  };
  for (std::size_t i = 0; i < pairs.size() && !(options.first && !out.touching.empty()); ++i) {
    const auto done = static_cast<double>(i);
    tell(done);
    const near_bodies &p = pairs[i];
    device_options of_pair;
    of_pair.want = options.want;
    of_pair.progress = [&](double of_this) { tell(done + of_this); };
    of_pair.stop = options.stop;
    of_pair.owner_a = of_.owners(p.first()), of_pair.owner_b = of_.owners(p.second());
    device_result r = collide(on_, bodies_[p.first()]->there, bodies_[p.second()]->there, *p.by.predicate,
                              options.precision, of_pair);
    out.candidates += r.candidates;
    if (r.count > 0)
      out.touching.push_back(p.told(std::move(r)));
    else
      apart.push_back(p);
  }
  if (options.nested && !(options.first && !out.touching.empty()))
    out.nested = of_.nested(apart, options);
  out.collide_seconds = seconds_since(start) - out.pose_seconds;
  return out;
}

world_answer device_world::touching(const world_options &options) {
  return under_standard_word([&] {
    const auto lock = on_.use();
    return ask(options);
  });
}

} // namespace meetc
