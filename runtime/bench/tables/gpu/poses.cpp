// One mesh against another in many poses, in one call.
#include "meet/app/input/sets.hpp"
#include "meet/app/text/words.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/core/device/collide.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>

namespace meetc::bench {

namespace {

constexpr int pose_runs = 5, halvings = 14;

struct ball {
  double centre[3], radius;
};
ball around(const prepared &set) {
  float lo[3], hi[3];
  set.bounds(lo, hi);
  ball out{};
  for (int k = 0; k < 3; ++k) {
    const double low = static_cast<double>(lo[k]), high = static_cast<double>(hi[k]);
    out.centre[k] = (low + high) / 2;
    out.radius += (high - low) * (high - low) / 4;
  }
  out.radius = std::sqrt(out.radius);
  return out;
}

// A random turn about the centre of `of`, and a random direction in which it then goes from `from`.
struct line_of_poses {
  double turn[9], direction[3], start[3];

  line_of_poses(const ball &of, const double from[3], std::mt19937_64 &random) {
    std::normal_distribution<double> normal;
    const auto unit = [&](double *v, int n) {
      double length = 0;
      for (int i = 0; i < n; ++i)
        v[i] = normal(random), length += v[i] * v[i];
      for (int i = 0; i < n; ++i)
        v[i] /= std::sqrt(length);
    };
    double q[4];
    unit(q, 4);
    unit(direction, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      turn[4 * i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
      turn[3 * i + j] = 2 * (q[i] * q[j] - q[3] * q[k]);
      turn[3 * i + k] = 2 * (q[i] * q[k] + q[3] * q[j]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      start[i] = from[i];
      for (std::size_t k = 0; k < 3; ++k)
        start[i] -= turn[3 * i + k] * of.centre[k];
    }
  }
  pose at(double t) const {
    pose p;
    for (std::size_t i = 0; i < 3; ++i) {
      std::copy_n(turn + 3 * i, 3, p.m + 4 * i);
      p.m[4 * i + 3] = start[i] + t * direction[i];
    }
    return p;
  }
};

std::size_t touching(const std::vector<std::uint64_t> &counts) {
  return counts.size() - static_cast<std::size_t>(std::count(counts.begin(), counts.end(), 0));
}

} // namespace

table gpu_bench::measure_poses(const posed_meshes &meshes) {
  const predicate_info &p = find_predicate(all_, "triangle_triangle");
  const prepared a = app::prepare(meshes.large), b = app::prepare(meshes.small);
  device_set on_a(on_, a), on_b(on_, b);
  const auto ask = [&](answer_kind want, const std::vector<pose> &poses) {
    device_options o;
    o.want = want;
    return meetc::collide(on_, on_a, on_b, poses, p, rung::certified, o);
  };
  const ball large = around(a), small = around(b);
  const std::size_t third = meshes.poses / 3;
  std::mt19937_64 random(1);
  std::vector<line_of_poses> lines;
  for (std::size_t i = 0; i < 2 * third + meshes.poses % 3; ++i) { // through elements of A
    const float *const corner = a.set().rows + random() % a.elements() * static_cast<std::size_t>(p.a->fields);
    const double from[3] = {corner[0], corner[1], corner[2]};
    lines.emplace_back(small, from, random);
  }
  std::vector<pose> far, touch, near;
  for (std::size_t i = 0; i < third; ++i)
    far.push_back(line_of_poses(small, large.centre, random).at(2 * (large.radius + small.radius)));
  for (std::size_t i = third; i < lines.size(); ++i)
    touch.push_back(lines[i].at(0));
  // The last place on its way from afar at which a pose still misses, to a small part of an edge.
  std::vector<double> hit(third, 0), miss(third, 2 * (large.radius + small.radius));
  for (int step = 0; step < halvings; ++step) {
    std::vector<pose> middle;
    for (std::size_t i = 0; i < third; ++i)
      middle.push_back(lines[i].at((hit[i] + miss[i]) / 2));
    const std::vector<std::uint64_t> found = ask(answer_kind::any, middle).counts;
    for (std::size_t i = 0; i < third; ++i)
      (found[i] > 0 ? hit : miss)[i] = (hit[i] + miss[i]) / 2;
  }
  for (std::size_t i = 0; i < third; ++i)
    near.push_back(lines[i].at(miss[i]));
  std::vector<pose> mixed; // one of each in turn
  for (std::size_t i = 0; i < touch.size(); ++i) {
    mixed.push_back(touch[i]);
    if (i < third)
      mixed.push_back(far[i]), mixed.push_back(near[i]);
  }

  struct row {
    std::string name;
    std::uint64_t poses, touch, pairs, candidates, alike;
    double device, wall, any_device, any_wall;

    double each_in_microseconds() const { return 1e6 * any_wall / static_cast<double>(poses); }
  };
  const auto measure_class = [&](const char *name, const std::vector<pose> &poses) -> row {
    poses_result counted, any;
    const auto time = [&](answer_kind want, poses_result &last) {
      return medians_of<2>(pose_runs, [&] {
        last = ask(want, poses);
        return std::array{last.device_seconds, last.seconds};
      });
    };
    const auto [device, wall] = time(answer_kind::count, counted);
    const auto [any_device, any_wall] = time(answer_kind::any, any);
    std::atomic<std::size_t> alike{0}, any_alike{0};
    for_chunks(thread_count(0), poses.size(), 4, [&](int, std::size_t begin, std::size_t end) {
      collide_options one;
      one.threads = 1;
      one.want = answer_kind::count;
      for (std::size_t i = begin; i < end; ++i) {
        const prepared there = prepare(io::view_of(meshes.small), *p.b, poses[i], 1);
        alike += collide(a, there, p, rung::certified, one).count == counted.counts[i];
        any_alike += (counted.counts[i] > 0) == (any.counts[i] > 0);
      }
    });
    require_truth("poses", "a count of a pose beside the CPU's", difference_of(alike, poses.size()));
    require_truth("poses", "whether a pose touches, beside its count,", difference_of(any_alike, poses.size()));
    return {name,
            poses.size(),
            touching(counted.counts),
            std::accumulate(counted.counts.begin(), counted.counts.end(), std::uint64_t{0}),
            counted.candidates,
            alike,
            device,
            wall,
            any_device,
            any_wall};
  };
  return table_of<row>(
      "poses",
      fmt::format("{} in many poses x {}, in one call", app::counted(meshes.small), app::counted(meshes.large)),
      {{"class", "poses that are", of_words, &row::name},
       {"poses", "poses", of_count, &row::poses},
       {"touch", "of them touch", of_count, &row::touch},
       {"pairs", "pairs", of_count, &row::pairs},
       {"candidates", "boxes touch", of_count, &row::candidates},
       {"device", "counts: queries|alone, ms", of_milliseconds, &row::device},
       {"wall", "counts: wall|clock, ms", of_milliseconds, &row::wall},
       {"any_device", "any: queries|alone, ms", of_milliseconds, &row::any_device},
       {"any_wall", "any: wall|clock, ms", of_milliseconds, &row::any_wall},
       {"each", "any: for a|pose, us", of_ratio, &row::each_in_microseconds},
       {"as_cpu", "counts as on|the CPU", of_count, &row::alike}},
      std::vector<row>{measure_class("far", far), measure_class("touching", touch), measure_class("near misses", near),
                       measure_class("mixed", mixed)},
      {fmt::format(
          "Counts: of the pairs of each pose. Any: whether there is one. Near: moved from afar along a line until "
          "less than {:.2g} of both sets' size is left before they touch. The call also poses B and uploads the "
          "poses. Each count was compared with that of the CPU for B prepared in that pose.",
          std::ldexp(1, -halvings))});
}

} // namespace meetc::bench
