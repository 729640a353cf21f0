// Every pair in the caller's memory, by one call on views in device memory: every pair that the CPU's table decides, counted
// and listed.
#include "engine.hpp"

#include "tests/runtime/device/kernels/cuda_test.hpp"

#include <cga/cga_cuda.hpp>
#include <cga/cga_every_pair.hpp>
#include <meetc/every_pair/query.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cuda_test {
namespace {

struct operand_data {
  std::vector<float> data;
  std::vector<std::uint32_t> index; // of three points where not empty
  std::size_t stride = 0;           // floats
  std::uint32_t elements = 0;
};

// Rows with room between them; triangles by indices.
operand_data make(const meetc::kind_info &kind, std::uint32_t n, std::mt19937_64 &random, int family) {
  operand_data d;
  d.elements = n;
  const bool indexed = kind.points == 3;
  const auto fields = static_cast<std::size_t>(indexed ? 3 : kind.fields);
  d.stride = fields + random() % 3;
  const std::size_t rows = indexed ? n + 2 : n;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t f = 0; f < d.stride; ++f) {
      const float v = f < fields ? number(random, family) : NAN;
      d.data.push_back(f < fields && kind.roles[f] == meetc::role::length ? std::fabs(v) / 4 : v);
    }
  if (meetc::lies_along_axes(kind))
    for (std::size_t i = 0; i < d.data.size(); i += d.stride)
      for (std::size_t k = i; k < i + 3; ++k)
        if (d.data[k + 3] < d.data[k])
          std::swap(d.data[k], d.data[k + 3]);
  for (std::uint32_t i = 0; indexed && i < 3 * n; ++i)
    d.index.push_back(static_cast<std::uint32_t>(random() % rows));
  return d;
}

meetc::view on_cpu(const operand_data &d) {
  return {d.data.data(), d.data.size() / d.stride, d.stride * sizeof(float), d.index.empty() ? nullptr : d.index.data(),
          d.elements};
}

struct on_device {
  buffer<float> data;
  buffer<std::uint32_t> index;
  meetc::cuda::view v;
  explicit on_device(const operand_data &d)
      : data(d.data), index(d.index.empty() ? std::vector<std::uint32_t>{0} : d.index),
        v{data.data(), d.stride * sizeof(float), d.index.empty() ? nullptr : index.data(),
          static_cast<std::uint32_t>(d.data.size() / d.stride), d.elements} {}
};

meetc::cuda::pose_matrix as_pose_matrix(const meetc::pose &p) {
  meetc::cuda::pose_matrix out{{}, p.length_scale, p.identity()};
  std::copy_n(p.m, 12, out.m);
  return out;
}

std::vector<meetc::index_pair> sorted(std::vector<meetc::index_pair> pairs) {
  std::sort(pairs.begin(), pairs.end(),
            [](meetc::index_pair x, meetc::index_pair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  return pairs;
}

// One predicate's queries, with memory for this many pairs between two stages.
class caller {
public:
  caller(const meetc::cuda::predicate_launchers &launch, std::uint32_t a, std::uint32_t b, unsigned long long list)
      : launch_(launch), list_(list),
        bytes_(meetc::every_pair::query_workspace(cga::cuda::catalogue(), launch, a, b, list)), space_(bytes_),
        result_(1) {}

  meetc::every_pair::query asks(meetc::rung precision, meetc::every_pair::filter by, const meetc::cuda::view &a,
                                const meetc::pose &at_a, const meetc::cuda::view &b, const meetc::pose &at_b) const {
    return {precision,     by,     a,    as_pose_matrix(at_a), b, as_pose_matrix(at_b), nullptr, 0, result_.data(),
            space_.data(), bytes_, list_};
  }
  cudaError_t start(const meetc::every_pair::query &q) const {
    return meetc::every_pair::pairs(cga::cuda::catalogue(), cga::every_pair::catalogue(), launch_, q, nullptr);
  }
  meetc::every_pair::query_result run(const meetc::every_pair::query &q) const {
    check(start(q), "query");
    check(cudaDeviceSynchronize(), launch_.name);
    return result_.read()[0];
  }

private:
  const meetc::cuda::predicate_launchers &launch_;
  unsigned long long list_;
  std::size_t bytes_;
  buffer<char> space_;
  buffer<meetc::every_pair::query_result> result_;
};

// Whether the query's pairs are those of the CPU, in room that is enough for one more.
bool are_all(const caller &on, meetc::every_pair::query q, const meetc::result &want,
             meetc::every_pair::query_result &found) {
  const buffer<meetc::index_pair> out(want.count + 1);
  q.pairs = out.data(), q.capacity = want.count + 1;
  found = on.run(q);
  return found.count == want.count && same_list(sorted(out.read(found.count)), want.pairs);
}

} // namespace

void caller_scenes(comparison &with, const settings &s) {
  using meetc::every_pair::filter;
  std::mt19937_64 random(s.seed + 3);
  const meetc::catalogue &all = cga::catalogue();
  const meetc::cuda::catalogue &launchers = cga::cuda::catalogue();
  meetc::pose turned; // about z by asin 0.6, twice as large, and away
  const double m[12] = {1.6, -1.2, 0, 0.25, 1.2, 1.6, 0, -1, 0, 0, 2, 3};
  std::copy_n(m, 12, turned.m);
  turned.length_scale = 2;
  std::uint64_t hits = 0, in_short_lists = 0; // the latter of queries with more hits than their lists hold
  for (int p = 0; p < launchers.predicate_count; ++p) {
    const meetc::predicate_info &info = all.predicates[p];
    const meetc::cuda::predicate_launchers &launch = launchers.predicates[p];
    const auto expect = [&](bool holds, const char *what) {
      with.require("in the caller's memory", holds, std::string(launch.name) + ": " + what);
    };
    expect(std::strcmp(info.name, launch.name) == 0, "stands in another place of the CPU's table");
    for (int family = 0; family < 6; ++family)
      for (const meetc::rung precision : {meetc::rung::certified, meetc::rung::exact, meetc::rung::fp32})
        for (const bool move : {false, true}) {
          if (move && (family == 3 || s.small))
            continue; // leaves float32
          const operand_data a = make(*info.a, 150, random, family), b = make(*info.b, 170, random, family);
          const auto pose_of = [&](const meetc::kind_info &kind) {
            meetc::pose at = move ? turned : meetc::pose{};
            if (move && meetc::lies_along_axes(kind)) // which is not turned
              at.m[0] = at.m[5] = 2, at.m[1] = at.m[4] = 0;
            return at;
          };
          const meetc::pose at_a = pose_of(*info.a), at_b = pose_of(*info.b);
          const meetc::prepared ready_a = meetc::prepare(on_cpu(a), *info.a, at_a, 1),
                                ready_b = meetc::prepare(on_cpu(b), *info.b, at_b, 1);
          meetc::collide_options options;
          options.threads = 1;
          const meetc::result want = meetc::collide(ready_a, ready_b, info, precision, options);
          const on_device da(a), db(b);
          constexpr unsigned long long list = std::size_t{1} << 15;
          const caller ask(launch, a.elements, b.elements, list);
          meetc::every_pair::query q = ask.asks(precision, filter::mma, da.v, at_a, db.v, at_b);
          meetc::every_pair::query_result r{};
          expect(are_all(ask, q, want, r), "other pairs");
          expect(r.bad_a == ~0ULL && r.bad_b == ~0ULL, "good elements are called bad");
          expect(r.near <= list && r.candidates <= r.near && r.kept <= r.candidates, "the lists were too short");
          if (want.count > 1) { // too little room for the result: the count is right all the same
            const buffer<meetc::index_pair> one(1);
            q.pairs = one.data(), q.capacity = 1;
            expect(ask.run(q).count == want.count, "another count where there is too little room");
          }
          hits += want.count;
        }
    // A list that is too short is reported, and so is a bad element.
    operand_data a = make(*info.a, 40, random, 0);
    const operand_data b = make(*info.b, 50, random, 0);
    const on_device db(b);
    const caller ask(launch, a.elements, b.elements, 64), roomy(launch, a.elements, b.elements, 40 * 50);
    {
      const on_device da(a);
      meetc::every_pair::query q = ask.asks(meetc::rung::exact, filter::mma, da.v, {}, db.v, {});
      const meetc::every_pair::query_result r = ask.run(q);
      const std::uint64_t all_hits = roomy.run(roomy.asks(meetc::rung::exact, filter::mma, da.v, {}, db.v, {})).count;
      in_short_lists += all_hits > 64 ? all_hits : 0;
      expect(all_hits <= 64 || r.near > 64 || r.candidates > 64, "a short list is not told");
      q.bytes -= 1;
      expect(ask.start(q) == cudaErrorInvalidValue, "too small a workspace is taken");
      q.bytes += 1, q.precision = meetc::rung::tolerant;
      expect(ask.start(q) == cudaErrorInvalidValue, "a tolerance is taken");
    }
    if (a.index.empty())
      a.data[a.stride * 7] = NAN;
    else
      a.index[3 * 7 + 1] = 4000000;
    const on_device da(a);
    expect(ask.run(ask.asks(meetc::rung::exact, filter::mma, da.v, {}, db.v, {})).bad_a >> 32 == 7,
           "a bad element is not named");
  }
  with.require("in the caller's memory", hits >= 1000, "too few pairs touch for this to mean anything");
  with.require("in the caller's memory", in_short_lists > 0, "no list was too short for the hits");
  // Enough elements for the large kernels of every filter.
  const auto n = static_cast<std::uint32_t>(s.small ? 700 : 5003);
  const meetc::predicate_info &balls = predicate_named("ball_ball");
  operand_data a, b;
  for (operand_data *const d : {&a, &b}) {
    d->elements = n, d->stride = 4;
    for (std::uint32_t i = 0; i < 4 * n; ++i)
      d->data.push_back(static_cast<float>(random() % 4096) / (i % 4 == 3 ? 16384.0F : 64.0F));
  }
  const meetc::result want = meetc::collide(meetc::prepare(on_cpu(a), *balls.a), meetc::prepare(on_cpu(b), *balls.b),
                                            balls, meetc::rung::certified);
  const on_device da(a), db(b);
  const unsigned long long list = std::uint64_t{n} * n;
  const caller ask(launchers.predicates[&balls - all.predicates], n, n, list);
  const bool has_wgmma = with.every_pair().probe().has_wgmma != 0;
  for (const filter by : {filter::float32, filter::mma, filter::wgmma}) {
    meetc::every_pair::query_result r{};
    const bool right = are_all(ask, ask.asks(meetc::rung::certified, by, da.v, {}, db.v, {}), want, r);
    const bool there = has_wgmma || by != filter::wgmma;
    with.require("in the caller's memory", there ? right : r.near > list,
                 std::string(name_of(by)) +
                     (there ? ": other pairs of many elements" : ": a missing filter is not told"));
  }
}

} // namespace cuda_test
