// Real meshes from a folder: each against itself, and pairs of them one in the other, as stored, far, tiny and huge.
#include "engine.hpp"

#include "tests/runtime/device/kernels/cuda_test.hpp"
#include "tests/runtime/real_bodies.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>

namespace cuda_test {
namespace {

using namespace meetc;

using real_bodies::body, real_bodies::load_all, real_bodies::placed;

// Elements of a kind from at most `most` faces: the faces, their first edges or corners, spheres a quarter of the edge about
// the corners, or boxes around the edges.
prepared elements(const body &b, const kind_info &kind, const pose &at, std::size_t most) {
  const std::size_t faces = std::min(most, b.corners.size() / 9), fields = static_cast<std::size_t>(kind.fields);
  std::vector<float> rows;
  for (std::size_t i = 0; i < faces; ++i) {
    const float *c = &b.corners[9 * i];
    const bool is_box = lies_along_axes(kind);
    rows.insert(rows.end(), c, c + (kind.points > 0 || is_box ? fields : 3));
    if (kind.points == 0 && !is_box)
      rows.push_back(0.25F * std::hypot(c[3] - c[0], c[4] - c[1], c[5] - c[2]));
  }
  rows_of out{&kind, std::move(rows)};
  put_in_order(out);
  return prepare(view_of(out), kind, pose_for(kind, at));
}

struct transform {
  const char *name;
  double size; // 0: as the first is stored
  std::array<double, 3> place;
};
constexpr transform transforms[] = {
    {"as stored", 0, {}}, {"+1e6", 200, {1e6, -1e6, 1e6}}, {"1e-15", 1e-15, {}}, {"1e12", 1e12, {}}};

void heading() {
  std::printf("%-34s %-18s %-9s %-9s %10s %11s %9s %6s %-19s %9s %9s %s\n", "files", "predicate", "transform", "rung",
              "pairs", "candidates", "unsure", "parts", "by", "device_ms", "cpu_ms", "lists");
}

// `certified` on the CPU against `certified` and, where asked, `exact` on the device.
void compare(comparison &with, const std::string &files, const transform &t, const predicate_info &p, const prepared &a,
             const prepared &b, bool itself, bool every) {
  const auto start = std::chrono::steady_clock::now();
  const result want = collide(a, b, p, rung::certified);
  const double cpu_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  device_set da(with.on(), a), other(with.on(), b);
  device_set &db = itself ? da : other;
  const auto tell = [&](rung r, const std::string &by, const auto &have) {
    const bool right = same_list(want.pairs, have.pairs) && have.count == want.count &&
                       (have.candidates <= want.candidates || fewer_candidates_on_cpu(p)) &&
                       (have.rungs.unsure[0] <= want.rungs.unsure[0] || fewer_unsure_on_cpu(p, a, b));
    std::printf("%-34s %-18s %-9s %-9s %10llu %11llu %9llu %6llu %-19s %9.2f %9.0f %s\n", files.c_str(), p.name, t.name,
                name_of(r), static_cast<unsigned long long>(have.count),
                static_cast<unsigned long long>(have.candidates), static_cast<unsigned long long>(have.rungs.unsure[0]),
                static_cast<unsigned long long>(have.parts), by.c_str(), have.device_seconds * 1000, cpu_ms,
                right ? "equal" : "DIFFERENT");
    std::fflush(stdout);
    with.add(std::string("meshes, ") + t.name, p, have);
    with.require(std::string("meshes, ") + t.name, right, files + ", " + p.name + ", " + name_of(r) + ", " + by);
  };
  for (const rung r : {rung::certified, rung::exact}) {
    tell(r, "a query", collide(with.on(), da, db, p, r));
    for (const every_pair::filter f : with.filters())
      if (f == with.every_pair().best_filter() || (every && r == rung::certified))
        tell(r, std::string("every pair, ") + name_of(f), with.every_pair().collide(da, db, p, r, {.by = f}));
  }
}

} // namespace

void mesh_scenes(comparison &with, const settings &s) {
  const std::vector<body> bodies = load_all(s.data);
  with.require("meshes", !bodies.empty(), "no meshes in " + s.data);
  const std::size_t most = s.small ? 3000 : 400'000, most_others = s.small ? 500 : 20'000;
  const predicate_info &faces = predicate_named("triangle_triangle");
  heading();
  for (const body &b : bodies)
    for (const transform &t : transforms) {
      const prepared p = elements(b, *faces.a, t.size > 0 ? placed(b, t.size / b.size, true, t.place) : pose(), most);
      compare(with, b.name + ", itself", t, faces, p, p, true, t.size == 0);
      same_self(with, std::string("meshes with themselves, ") + t.name, view_of(rows_in(p)));
    }
  // Each and the one after next, at one size and place; the other predicates on parts of them.
  for (std::size_t i = 0; i < bodies.size() && i < 12; ++i) {
    const body &a = bodies[i], &b = bodies[(i + 2) % bodies.size()];
    for (const transform &t : transforms) {
      const double size = t.size > 0 ? t.size : a.size;
      const pose at_a = t.size > 0 ? placed(a, size / a.size, false, t.place) : pose(),
                 at_b = placed(b, size / b.size, true, t.size > 0 ? t.place : a.middle);
      for (int k = 0; k < cga::catalogue().predicate_count; ++k) {
        const predicate_info &p = cga::catalogue().predicates[k];
        const bool whole = &p == &faces;
        const prepared of_a = elements(a, *p.a, at_a, whole ? most : most_others),
                       of_b = elements(b, *p.b, at_b, whole ? most : most_others);
        compare(with, a.name + ", " + b.name, t, p, of_a, of_b, false, whole && t.size == 0);
        if (p.contacts)
          same_contacts(with, std::string("contacts of meshes, ") + t.name, view_of(rows_in(of_a)),
                        view_of(rows_in(of_b)), p, collide(of_a, of_b, p, rung::certified).pairs);
      }
    }
  }
}

} // namespace cuda_test
