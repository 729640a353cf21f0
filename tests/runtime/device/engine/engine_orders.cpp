// Orders that the blocks of a kernel make together, of elements and of hits, of as many as change what a block does.
#include "engine.hpp"

#include "meet/core/device/collide.hpp"
#include "meet/core/sets/element_set.hpp"

#include "meetc/volume/tree_order.hpp"

#include <algorithm>
#include <cstring>
#include <functional>

namespace cuda_test {

using namespace meetc;

bool same_list(const std::vector<index_pair> &x, const std::vector<index_pair> &y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](index_pair p, index_pair q) { return p.a == q.a && p.b == q.b; });
}

bool is_in_order(const device_set &there, const prepared &set) {
  const std::size_t n = there.elements(), fields = static_cast<std::size_t>(there.kind().fields);
  std::vector<std::uint32_t> order(n);
  std::vector<float> rows(n * fields), want(n * fields);
  const auto download = [](auto &to, const auto *from) {
    check(cudaMemcpy(to.data(), from, to.size() * sizeof to[0], cudaMemcpyDeviceToHost), "a test");
  };
  download(order, there.rows().order()), download(rows, there.rows().data());
  for (std::size_t i = 0; i < n; ++i)
    std::memcpy(&want[set.set().order[i] * fields], set.set().rows + i * fields, fields * sizeof(float));
  for (std::size_t i = 0; i < n; ++i)
    if (order[i] >= n || std::memcmp(&rows[i * fields], &want[order[i] * fields], fields * sizeof(float)) != 0)
      return false;
  const auto box_of = [&](const float *row) {
    cuda::tree_box b;
    there.kind().box(row, b.low, b.high);
    return b;
  };
  const auto by_cells_of = [&](int bits, const cuda::tree_box &around) {
    const cuda::hilbert_cells cells(around, bits);
    std::vector<std::uint64_t> seen;
    for (std::size_t i = 0; i < n; ++i)
      seen.push_back(cuda::in_order(cells.place_of(box_of(&rows[i * fields])), order[i]));
    return std::adjacent_find(seen.begin(), seen.end(), std::greater_equal<>()) == seen.end();
  };
  cuda::tree_box all, some; // around all, and around some, by which packed rows have their places
  for (std::size_t i = 0; i < n; ++i)
    all.widen(box_of(&want[i * fields]));
  const cuda::sample taken(static_cast<std::uint32_t>(n));
  for (std::size_t i = taken.first; i < n; i += taken.step)
    some.widen(box_of(&want[i * fields]));
  const bool by_all = by_cells_of(10, all) || by_cells_of(8, all); // fine cells, or coarse ones
  return by_all || by_cells_of(10, some) || by_cells_of(8, some);
}

namespace {

// Whether each lane of each node has the box around what is below it, and is empty where that is nothing.
bool has_its_tree(device_set &there, cudaStream_t stream) {
  const std::size_t n = there.elements(), fields = static_cast<std::size_t>(there.kind().fields);
  const cuda::tree_view tree = there.rows().tree(stream);
  std::vector<cuda::tree_node> nodes(tree.shape.nodes());
  std::vector<float> rows(n * fields);
  check(cudaStreamSynchronize(stream), "a test");
  check(cudaMemcpy(nodes.data(), tree.nodes, nodes.size() * sizeof nodes[0], cudaMemcpyDeviceToHost), "a test");
  check(cudaMemcpy(rows.data(), there.rows().data(), rows.size() * sizeof rows[0], cudaMemcpyDeviceToHost), "a test");
  const auto same = [](const cuda::tree_box &x, const cuda::tree_box &y) {
    return std::equal(x.low, x.low + 3, y.low) && std::equal(x.high, x.high + 3, y.high);
  };
  std::vector<cuda::tree_box> below(n); // what the lanes of a level are around
  for (std::size_t i = 0; i < n; ++i)
    there.kind().box(&rows[i * fields], below[i].low, below[i].high);
  for (int level = 0; level < tree.shape.depth; ++level) {
    std::vector<cuda::tree_box> all(tree.shape.count[level]);
    for (std::uint32_t node = 0; node < all.size(); ++node)
      for (std::uint32_t lane = 0; lane < cuda::tree_width; ++lane) {
        const std::size_t child = std::size_t{node} * cuda::tree_width + lane;
        const cuda::tree_box have = cuda::box_of(nodes[tree.shape.first[level] + node], lane),
                             want = child < below.size() ? below[child] : cuda::tree_box();
        if (!same(have, want))
          return false;
        all[node].widen(want);
      }
    below = std::move(all);
  }
  return below.size() == 1;
}

// Small elements all over a cube; half of them in a part of it, so that cells have very different numbers of them.
rows_of spread(const kind_info &kind, std::size_t n, double size, double part, engine &random) {
  const rows_of some = random_rows(kind, 500, {size, size, 1, 0}, random);
  const auto fields = static_cast<std::size_t>(kind.fields);
  rows_of out{&kind, std::vector<float>(n * fields)};
  std::uniform_real_distribution<double> unit(0, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const double side = random() % 2 == 0 ? 1 : part;
    double move[3];
    for (double &m : move)
      m = unit(random) * side;
    for (std::size_t f = 0; f < fields; ++f) {
      const role r = kind.roles[f];
      const double by = r == role::x ? move[0] : r == role::y ? move[1] : r == role::z ? move[2] : 0;
      out.rows[i * fields + f] = static_cast<float>(some.rows[i % some.size() * fields + f] + by);
    }
  }
  put_in_order(out);
  return out;
}

void of_elements(comparison &with, const settings &s) {
  engine random(s.seed + 60);
  std::vector<std::size_t> sizes = {1, 31, 32, 33, 255, 257, 1023, 1025};
  if (!s.small)
    sizes.insert(sizes.end(), {2048, 4095, 4097, 20'000, 32'767, 32'768, 32'769, 100'000});
  for (const char *const name : {"ball_ball", "point_triangle", "box_box", "triangle_triangle", "segment_segment"}) {
    const predicate_info &p = predicate_named(name);
    const bool is_ball = p.a->fields == 4;
    std::vector<std::size_t> all = sizes;
    if (!s.small && is_ball)
      all.insert(all.end(), {270'336, 524'289, 1'048'575, 1'048'576, 1'048'577});
    for (const std::size_t n : all) {
      const std::string scene = "orders of elements", what = std::string(name) + ", " + std::to_string(n) + ": ";
      const double part = n > 100'000 ? 0.05 : 0.2;
      const rows_of x = spread(*p.a, n, 0.02, part, random), y = spread(*p.b, 60, 0.1, part, random);
      const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
      device_set da(with.on(), view_of(x), *p.a), db(with.on(), b);
      with.require(scene, da.ordered_seconds() > 0, what + "the host has ordered it");
      with.require(scene, is_in_order(da, a), what + "another order");
      with.require(scene, has_its_tree(da, with.on().stream()), what + "another tree");
      const result want = collide(a, b, p, rung::certified);
      const device_result have = collide(with.on(), da, db, p, rung::certified);
      with.add(scene, p, have);
      with.require(scene, same_list(have.pairs, want.pairs), what + "another list");
      device_set ga = device_set::given(with.on(), view_of(x), *p.a),
                 gb = device_set::given(with.on(), view_of(y), *p.b);
      for (const bool culls : {false, true}) {
        device_options o;
        o.cull = culls;
        for (int again = 0; again < 2; ++again)
          with.require(scene, same_list(collide(with.on(), ga, gb, p, rung::certified, o).pairs, want.pairs),
                       what + (culls ? "given and culled: another list" : "given: another list"));
      }
    }
  }
}

// Given elements that are too close to each other for the order of their places: a query finds this while it runs.
void too_close(comparison &with, const settings &s) {
  engine random(s.seed + 62);
  for (const char *const name : {"segment_triangle", "ball_ball", "triangle_triangle"}) {
    const predicate_info &p = predicate_named(name);
    rows_of x = spread(*p.a, s.small ? 2500 : 6000, 1e-4, 1, random), y = spread(*p.b, 300, 0.05, 0.1, random);
    for (std::size_t i = 0; i < x.rows.size() - static_cast<std::size_t>(20 * p.a->fields); ++i)
      x.rows[i] /= s.small ? 4096 : 64; // all but twenty
    const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
    device_set ga = device_set::given(with.on(), view_of(x), *p.a), gb = device_set::given(with.on(), view_of(y), *p.b);
    collide_options here;
    device_options there;
    for (const answer_kind want :
         {answer_kind::pairs, answer_kind::counts, answer_kind::flags, answer_kind::any, answer_kind::none}) {
      if (want == answer_kind::none && !p.first_met)
        continue;
      here.want = there.want = want;
      here.first_met = there.first_met = p.first_met && (want == answer_kind::pairs || want == answer_kind::none);
      there.first_alone = true;
      const result on_cpu = collide(a, b, p, rung::certified, here);
      for (int again = 0; again < 2; ++again) {
        const device_result have = collide(with.on(), ga, gb, p, rung::certified, there);
        with.add("too close", p, have);
        with.require("too close",
                     have.count == on_cpu.count && same_list(have.pairs, on_cpu.pairs) &&
                         have.counts.a == on_cpu.counts.a && have.flags.a == on_cpu.flags.a &&
                         have.first_met == on_cpu.first_met,
                     std::string(name) + ": another answer");
      }
    }
  }
}

// Two meshes, each with a vertex far away that no element names.
void far_vertices(comparison &with, const settings &s) {
  engine random(s.seed + 63);
  const predicate_info &p = predicate_named("triangle_triangle");
  const rows_of x = spread(*p.a, s.small ? 300 : 9000, 0.1, 0.2, random),
                y = spread(*p.b, s.small ? 200 : 5000, 0.1, 0.2, random);
  const auto mesh = [](const rows_of &of, std::vector<float> &points, std::vector<std::uint32_t> &index) {
    points = of.rows;
    points.insert(points.end(), {1e30F, 1e30F, 1e30F});
    index.resize(of.rows.size() / 3);
    for (std::uint32_t i = 0; i < index.size(); ++i)
      index[i] = i;
    return view{points.data(), points.size() / 3, 3 * sizeof(float), index.data(), of.size()};
  };
  std::vector<float> points_x, points_y;
  std::vector<std::uint32_t> index_x, index_y;
  device_set gx = device_set::given(with.on(), mesh(x, points_x, index_x), *p.a),
             gy = device_set::given(with.on(), mesh(y, points_y, index_y), *p.b);
  const result want = collide(prepare(view_of(x), *p.a), prepare(view_of(y), *p.b), p, rung::certified);
  device_options o;
  o.cull = true;
  const device_result have = collide(with.on(), gx, gy, p, rung::certified, o);
  with.add("far vertices", p, have);
  with.require("far vertices", want.count > 0 && same_list(have.pairs, want.pairs), "another list");
}

void of_hits(comparison &with, const settings &s) {
  engine random(s.seed + 61);
  const predicate_info &p = predicate_named("ball_ball");
  // Balls that all touch all others, and some that touch none.
  const auto balls = [&](std::size_t n, std::size_t others) {
    std::uniform_real_distribution<float> unit(0, 1);
    rows_of out{p.a, {}};
    for (std::size_t i = 0; i < n + others; ++i) {
      const float at = i < n ? 0 : 10 + unit(random) * 1e4F;
      out.rows.insert(out.rows.end(), {at + unit(random), unit(random), unit(random), i < n ? 2.0F : 1e-6F});
    }
    return out;
  };
  using counts = std::pair<std::size_t, std::size_t>;
  std::vector<counts> all = {{1, 1},   {1, 128}, {129, 1}, {8, 64},  {1, 513},
                             {700, 1}, {60, 50}, {64, 64}, {241, 17}}; // the most of one block, and one more
  if (!s.small)
    all.insert(all.end(),
               {{1, 5000}, {5000, 1}, {65, 65}, {3, 90'000}, {90'000, 3}, {1200, 1100}, {3000, 1500}, {1024, 1025}});
  for (const auto &[of_a, of_b] : all)
    for (const std::size_t others : {std::size_t{0}, std::size_t{s.small ? 200U : 30'000U}}) {
      const rows_of x = balls(of_a, others), y = balls(of_b, others / 3);
      const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
      device_set da(with.on(), a), db(with.on(), b);
      const result want = collide(a, b, p, rung::certified);
      const std::string scene = "orders of hits";
      for (int again = 0; again < 4; ++again) {
        device_options o;
        if (again == 3) // in parts, whose hits are sorted together
          o.list_capacity = std::size_t{1} << 18;
        const device_result have = collide(with.on(), da, db, p, rung::certified, o);
        with.add(scene, p, have);
        with.require(scene, same_list(have.pairs, want.pairs),
                     std::to_string(of_a) + " x " + std::to_string(of_b) + ": another list");
      }
    }
}

// Heaps of balls, of which another heap touches one, or none, and then another one: no query depends on what was before.
void of_other_numbers_of_hits(comparison &with, const settings &s) {
  engine random(s.seed + 64);
  const predicate_info &p = predicate_named("ball_ball");
  std::uniform_real_distribution<float> unit(0, 1);
  const auto heap = [&](rows_of &to, std::size_t n, float at) {
    for (std::size_t i = 0; i < n; ++i)
      to.rows.insert(to.rows.end(), {at + unit(random), unit(random), unit(random), 2.0F});
  };
  const std::vector<std::size_t> heaps =
      s.small ? std::vector<std::size_t>{70, 2, 0} : std::vector<std::size_t>{2500, 40, 7, 2, 0};
  const std::size_t others = s.small ? 40 : 600;
  rows_of x{p.a, {}}, y{p.a, {}};
  heap(y, others, 0);
  std::vector<std::size_t> begin;
  for (std::size_t k = 0; k < heaps.size(); ++k)
    begin.push_back(x.size()), heap(x, heaps[k], 64 * static_cast<float>(k));
  device_set da(with.on(), prepare(view_of(x), *p.a)), db(with.on(), prepare(view_of(y), *p.b));
  const auto ask = [&](std::size_t k) {
    pose at;
    at.m[3] = 64 * static_cast<float>(k);
    db.move(at);
    for (int again = 0; again < 2; ++again) {
      const device_result have = collide(with.on(), da, db, p, rung::certified);
      with.add("other numbers of hits", p, have);
      bool right = have.pairs.size() == heaps[k] * others;
      for (std::size_t i = 0; right && i < have.pairs.size(); ++i)
        right = have.pairs[i].a == begin[k] + i / others && have.pairs[i].b == i % others;
      with.require("other numbers of hits", right, "heap " + std::to_string(k) + ": another list");
    }
  };
  for (std::size_t k = 0; k < heaps.size(); ++k)
    for (std::size_t after = 0; after < heaps.size(); ++after)
      ask(k), ask(after);
}

} // namespace

void order_scenes(comparison &with, const settings &s) {
  of_elements(with, s);
  too_close(with, s);
  far_vertices(with, s);
  of_hits(with, s);
  of_other_numbers_of_hits(with, s);
}

} // namespace cuda_test
