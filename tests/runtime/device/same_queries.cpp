// The launchers of whole queries, on views in device memory: every pair that the CPU's table decides, counted and listed.
#include "cuda_test.hpp"

#include <algorithm>
#include <cga/cga_cuda.hpp>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <core/collide.hpp>
#include <cstring>

namespace cuda_test {
namespace {

using pair_vector = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

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

pair_vector sorted(const meetc::index_pair *pairs, std::size_t n) {
  pair_vector out;
  for (std::size_t i = 0; i < n; ++i)
    out.emplace_back(pairs[i].a, pairs[i].b);
  std::sort(out.begin(), out.end());
  return out;
}

} // namespace

long same_queries() {
  std::mt19937_64 random(4);
  const meetc::catalogue &all = cga::catalogue();
  const meetc::cuda::catalogue &launchers = cga::cuda::catalogue();
  const buffer<meetc::cuda::query_result> result(1);
  long differences = 0, queries = 0, hits = 0;
  const auto expect = [&differences](bool holds, const char *predicate, const char *what) {
    if (!holds) {
      std::printf("%s: %s\n", predicate, what);
      ++differences;
    }
  };
  meetc::pose turned; // about z by asin 0.6, twice as large, and away
  const double m[12] = {1.6, -1.2, 0, 0.25, 1.2, 1.6, 0, -1, 0, 0, 2, 3};
  std::copy_n(m, 12, turned.m);
  turned.length_scale = 2;
  for (int p = 0; p < launchers.predicate_count; ++p) {
    const meetc::predicate_info &info = all.predicates[p];
    const meetc::cuda::predicate_launchers &launch = launchers.predicates[p];
    if (std::strcmp(info.name, launch.name) != 0) {
      expect(false, launch.name, "stands in another place of the CPU's table");
      continue;
    }
    for (int family = 0; family < 6; ++family)
      for (const meetc::rung precision : {meetc::rung::certified, meetc::rung::exact, meetc::rung::fp32})
        for (const bool move : {false, true}) {
          if (move && family == 3)
            continue; // leaves float32
          const operand_data a = make(*info.a, 150, random, family), b = make(*info.b, 170, random, family);
          const auto pose_for = [&](const meetc::kind_info &kind) {
            meetc::pose at = move ? turned : meetc::pose{};
            if (move && meetc::lies_along_axes(kind)) // which is not turned
              at.m[0] = at.m[5] = 2, at.m[1] = at.m[4] = 0;
            return at;
          };
          const meetc::pose at_a = pose_for(*info.a), at_b = pose_for(*info.b);
          const meetc::prepared ready_a = meetc::prepare(on_cpu(a), *info.a, at_a, 1),
                                ready_b = meetc::prepare(on_cpu(b), *info.b, at_b, 1);
          meetc::collide_options options;
          options.threads = 1;
          const meetc::result want = meetc::collide(ready_a, ready_b, info, precision, options);

          const on_device da(a), db(b);
          constexpr unsigned long long list = std::size_t{1} << 16;
          const buffer<char> space(launch.workspace(a.elements, b.elements, list));
          const buffer<meetc::index_pair> out(want.count + 1);
          meetc::cuda::query q{precision,
                               meetc::cuda::filter::mma,
                               da.v,
                               as_pose_matrix(at_a),
                               db.v,
                               as_pose_matrix(at_b),
                               out.data(),
                               want.count + 1,
                               result.data(),
                               space.data(),
                               launch.workspace(a.elements, b.elements, list),
                               list};
          const auto run = [&] {
            check(launch.pairs(q, nullptr), "query");
            check(cudaDeviceSynchronize(), info.name);
            return result.read()[0];
          };
          meetc::cuda::query_result r = run();
          expect(r.bad_a == ~0ULL && r.bad_b == ~0ULL, info.name, "good elements are called bad");
          expect(r.candidates <= list && r.kept <= list, info.name, "the lists were too short");
          expect(r.count == want.count, info.name, "another count");
          if (r.count == want.count)
            expect(sorted(out.read().data(), r.count) == sorted(want.pairs.data(), want.pairs.size()), info.name,
                   "other pairs");
          if (want.count > 1) { // too little room for the result: the count is right all the same
            q.capacity = 1;
            expect(run().count == want.count, info.name, "another count where there is too little room");
          }
          ++queries;
          hits += static_cast<long>(want.count);
        }
    // A bad element is named, and a list that is too short is reported.
    operand_data a = make(*info.a, 40, random, 0);
    const operand_data b = make(*info.b, 50, random, 0);
    const on_device db(b);
    const buffer<char> space(launch.workspace(a.elements, b.elements, 64));
    {
      const on_device da(a);
      meetc::cuda::query q{meetc::rung::exact,
                           meetc::cuda::filter::mma,
                           da.v,
                           as_pose_matrix({}),
                           db.v,
                           as_pose_matrix({}),
                           nullptr,
                           0,
                           result.data(),
                           space.data(),
                           launch.workspace(a.elements, b.elements, 64),
                           64};
      check(launch.pairs(q, nullptr), "query");
      const meetc::cuda::query_result r = result.read()[0];
      expect(r.kept > 64 || r.candidates > 64 || r.count <= 64, info.name, "a short list is not told");
      q.bytes -= 1;
      expect(launch.pairs(q, nullptr) == cudaErrorInvalidValue, info.name, "too small a workspace is taken");
    }
    if (a.index.empty())
      a.data[a.stride * 7] = NAN;
    else
      a.index[3 * 7 + 1] = 4000000;
    const on_device da(a);
    const meetc::cuda::query q{meetc::rung::exact,
                               meetc::cuda::filter::mma,
                               da.v,
                               as_pose_matrix({}),
                               db.v,
                               as_pose_matrix({}),
                               nullptr,
                               0,
                               result.data(),
                               space.data(),
                               launch.workspace(a.elements, b.elements, 64),
                               64};
    check(launch.pairs(q, nullptr), "query");
    expect(result.read()[0].bad_a >> 32 == 7, info.name, "a bad element is not named");
  }
  // Enough groups for the large kernels of every filter.
  const buffer<meetc::cuda::probe_result> probed(1);
  check(launchers.probe(probed.data(), nullptr), "probe");
  const bool has_wgmma = probed.read()[0].has_wgmma != 0;
  for (int p = 0; p < launchers.predicate_count; ++p) {
    const meetc::predicate_info &info = all.predicates[p];
    if (std::strcmp(info.name, "ball_ball") != 0)
      continue;
    operand_data a, b;
    for (operand_data *const d : {&a, &b}) {
      d->elements = 5003, d->stride = 4;
      for (std::uint32_t i = 0; i < 4 * d->elements; ++i)
        d->data.push_back(static_cast<float>(random() % 4096) / (i % 4 == 3 ? 16384.0f : 64.0f));
    }
    const meetc::prepared ready_a = meetc::prepare(on_cpu(a), *info.a), ready_b = meetc::prepare(on_cpu(b), *info.b);
    const meetc::result want = meetc::collide(ready_a, ready_b, info, meetc::rung::certified);
    const on_device da(a), db(b);
    constexpr unsigned long long list = 5008ULL * 5008;
    const std::size_t bytes = launchers.predicates[p].workspace(a.elements, b.elements, list);
    const buffer<char> space(bytes);
    const buffer<meetc::index_pair> out(want.count + 1);
    using meetc::cuda::filter;
    for (const filter by : {filter::float32, filter::mma, filter::wgmma, filter::wgmma_half}) {
      meetc::cuda::query q{meetc::rung::certified,
                           by,
                           da.v,
                           as_pose_matrix({}),
                           db.v,
                           as_pose_matrix({}),
                           out.data(),
                           want.count + 1,
                           result.data(),
                           space.data(),
                           bytes,
                           list};
      check(launchers.predicates[p].pairs(q, nullptr), "query");
      check(cudaDeviceSynchronize(), info.name);
      const meetc::cuda::query_result r = result.read()[0];
      const bool there = has_wgmma || by == filter::float32 || by == filter::mma;
      expect(there ? r.count == want.count &&
                         sorted(out.read().data(), r.count) == sorted(want.pairs.data(), want.pairs.size())
                   : r.candidates > list,
             info.name, there ? "other pairs of many groups" : "a missing filter is not told");
      ++queries;
      hits += static_cast<long>(want.count);
    }
  }
  std::printf("%ld whole queries, %ld touching pairs: %ld differences\n", queries, hits, differences);
  if (hits < 1000)
    throw std::runtime_error("too few pairs touch for this test to mean anything");
  return differences;
}

} // namespace cuda_test
