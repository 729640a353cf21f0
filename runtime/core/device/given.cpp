#include "meet/core/device/given.hpp"

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/hits.hpp"
#include "meet/core/device/query.hpp"
#include "meet/core/views/rows.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace meetc {
namespace {

constexpr std::uint64_t most = 0xffffffff; // elements, and vertices

// Bytes from the first element's first to the last one's last.
std::size_t bytes_of(const kind_info &kind, std::size_t rows, std::size_t stride, bool indexed) {
  return rows > 0 ? (rows - 1) * stride + (indexed ? 3 : static_cast<std::size_t>(kind.fields)) * sizeof(float) : 0;
}

} // namespace

const cuda::set_launchers &launchers_of(const cuda::catalogue &all, const kind_info &kind) {
  for (int k = 0; k < all.kind_count; ++k)
    if (std::strcmp(all.kinds[k].name, kind.name) == 0 && all.kinds[k].fields == kind.fields)
      return all.kinds[k];
  throw device_error(std::string("no CUDA kernels were generated for the kind ") + kind.name);
}

void require_pose(const kind_info &kind, const pose &at) {
  if (const status s = movable(kind, at); s != status::ok)
    throw std::invalid_argument(text(s));
}

view require_view(const view &elements, const kind_info &kind) {
  if (wrong_with(elements, kind))
    throw input_error(meetc::check(elements, kind), kind);
  return with_stride(elements, kind);
}

cuda::pose_matrix cuda_pose(const pose &at) {
  return under_standard_word([&] {
    cuda::pose_matrix out{{}, at.length_scale, at.identity(), at.grid != 0, at.grid != 0 ? std::ilogb(at.grid) : 0};
    std::copy_n(at.m, 12, out.m);
    return out;
  });
}

given_set::given_set(device &on, const kind_info &kind, const pose &at)
    : on_(&on), kind_(&kind), launchers_(&launchers_of(on.kernels(), kind)), at_(at) {
  require_pose(kind, at);
}
given_set::~given_set() = default;
given_set::given_set(given_set &&) noexcept = default;

given_set::given_set(device &on, const view &elements, const kind_info &kind, const pose &at)
    : given_set(on, kind, at) {
  const control_word_guard guard;
  if (elements.elements > most || (elements.index && elements.vertices > most))
    throw std::length_error(text(status::too_many_elements));
  if (!upload(require_view(elements, kind)))
    throw device_error("not enough device memory for a set; the CPU decides the same pairs (--device cpu)");
  check(cudaStreamSynchronize(on.stream()), "uploading a set"); // the caller may change the elements now
}

std::unique_ptr<given_set> given_set::if_it_fits(device &on, const view &stated, const kind_info &kind,
                                                 const pose &at) {
  const control_word_guard guard;
  const view elements = require_view(stated, kind);
  const std::size_t n = elements.elements, given = elements.index ? elements.vertices : n,
                    packed = n * static_cast<std::size_t>(kind.fields) * sizeof(float);
  if (n > most || given > most)
    return nullptr;
  if (bytes_of(kind, given, elements.stride_bytes, elements.index != nullptr) > 4 * packed + (std::size_t{1} << 20))
    return nullptr;
  std::unique_ptr<given_set> out(new given_set(on, kind, at));
  return out->upload(elements) ? std::move(out) : nullptr;
}

bool given_set::upload(const view &elements) {
  const std::size_t given = elements.index ? elements.vertices : elements.elements,
                    bytes = bytes_of(*kind_, given, elements.stride_bytes, elements.index != nullptr),
                    indices = elements.index ? elements.elements * static_cast<std::size_t>(kind_->points) : 0;
  const cudaStream_t stream = on_->stream();
  if (!data_.grow(bytes, 0, stream) || !index_.grow(indices, 0, stream))
    return false;
  transfers &moving = on_->buffers().moving;
  moving.upload(data_.data(), elements.data, bytes, stream, "uploading a set");
  moving.upload(index_.data(), elements.index, indices * sizeof(std::uint32_t), stream, "uploading a set");
  there_ = {reinterpret_cast<const float *>(data_.data()), elements.stride_bytes,
            elements.index ? index_.data() : nullptr, static_cast<std::uint32_t>(elements.vertices),
            static_cast<std::uint32_t>(elements.elements)};
  return true;
}

given_set::given_set(device &on, const cuda::view &there, const kind_info &kind, const pose &at)
    : given_set(on, kind, at) {
  if (there.only)
    throw std::invalid_argument("a given set has all of its elements");
  there_ = there;
  there_.stride_bytes =
      require_view({there.data, there.vertices, there.stride_bytes, there.index, there.elements}, kind).stride_bytes;
}

given_set::copy given_set::download() const {
  copy c;
  const bool indexed = there_.index != nullptr;
  c.data.resize(bytes_of(*kind_, indexed ? there_.vertices : there_.elements, there_.stride_bytes, indexed));
  c.index.resize(indexed ? there_.elements * static_cast<std::size_t>(kind_->points) : 0);
  transfers &moving = on_->buffers().moving;
  moving.download(c.data.data(), there_.data, c.data.size(), on_->stream(), "downloading a set");
  moving.download(c.index.data(), there_.index, c.index.size() * sizeof(std::uint32_t), on_->stream(),
                  "downloading a set");
  c.elements = {reinterpret_cast<const float *>(c.data.data()), there_.vertices, there_.stride_bytes,
                indexed ? c.index.data() : nullptr, there_.elements};
  return c;
}

void given_set::refuse() const {
  if (const fault f = meetc::check(download().elements, *kind_, at_))
    throw input_error(f, *kind_);
}

device_set &given_set::ordered() {
  if (!ordered_)
    ordered_ = std::make_unique<device_set>(*on_, *kind_);
  return *ordered_;
}

namespace {

// Puts the sets, or what is left of them, into order and makes their hierarchies, both at once. `common` is that of
// order_request. Starts the clock unless it runs.
// Returns how many numbers are cleared for the query.
std::size_t order_both(device &on, given_set &a, given_set &b, const cuda::view &left_a, const cuda::view &left_b,
                       const cuda::joined_box *common, bool clock_runs) {
  constexpr float least_share = 0.125F; // of the device
  device_buffers &buffers = on.buffers();
  const cudaStream_t stream = on.stream();
  const bool both = &a != &b, alike = both && &a.launchers() == &b.launchers() && can_arrange(left_a.elements) &&
                                      can_arrange(left_b.elements);
  const float all = static_cast<float>(left_a.elements) + static_cast<float>(left_b.elements);
  const std::size_t cleared = counters + hit_pairs::room_to_order;
  buffers.take_notes(cleared - counters);
  const auto request = [&](given_set &s, const cuda::view &left) {
    const float share = std::clamp(static_cast<float>(left.elements) / all, least_share, 1 - least_share);
    const bool first = &s == &a;
    return device_set::order_request{left,
                                     s.at(),
                                     s.elements(),
                                     both ? share : 1,
                                     buffers.found() + (first ? 0 : 1),
                                     {buffers.counts(), first ? cleared : 0},
                                     common};
  };
  const auto start_clock = [&] {
    if (!clock_runs)
      check(cudaEventRecord(buffers.events[0], stream), "starting a clock");
  };
  if (alike) { // by one kernel
    const std::optional<cuda::arrange_job> job_a = a.ordered().plan_order(request(a, left_a), stream),
                                           job_b = b.ordered().plan_order(request(b, left_b), stream);
    start_clock();
    if (job_a && job_b) {
      const cuda::arrange_job jobs[2] = {*job_a, *job_b};
      check(a.launchers().arrange(jobs, 2, stream), "starting a kernel");
    } else if (job_a || job_b) {
      check(a.launchers().arrange(job_a ? &*job_a : &*job_b, 1, stream), "starting a kernel");
    }
    for (given_set *const s : {&a, &b})
      s->ordered().tree(stream);
    return cleared;
  }
  const auto order = [&](given_set &s, const cuda::view &left, cudaStream_t on_stream) {
    s.ordered().order(request(s, left), on_stream);
    if (left.elements > 0)
      s.ordered().tree(on_stream);
  };
  const auto follow = [](cudaStream_t from, cudaEvent_t mark, cudaStream_t to) {
    check(cudaEventRecord(mark, from), "joining streams");
    check(cudaStreamWaitEvent(to, mark, 0), "joining streams");
  };
  start_clock();
  if (both) {
    follow(stream, buffers.forked, buffers.beside);
    order(b, left_b, buffers.beside);
  }
  order(a, left_a, stream);
  if (both)
    follow(buffers.beside, buffers.joined, stream);
  return cleared;
}

// Also after an error no kernel works on a set, or on what culling left, when a query has ended.
class wait_for {
public:
  explicit wait_for(cudaStream_t stream) : stream_(stream) {}
  ~wait_for() { cudaStreamSynchronize(stream_); }
  wait_for(const wait_for &) = delete;
  wait_for &operator=(const wait_for &) = delete;

private:
  cudaStream_t stream_;
};

device_result find_touching(device &on, given_set &a, given_set &b, const predicate_info &predicate, rung precision,
                            const device_options &options, pairs_there *left_there) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  require_query(on, a.ordered(), b.ordered(), predicate, precision, options);
  if (left_there)
    *left_there = {};
  device_buffers &buffers = on.buffers();
  const wait_for ended(buffers.beside);
  cuda::view left_a = a.there(), left_b = b.there();
  culled left;
  // Whether `tolerant` decides depends on all elements, and what is met first is said of all.
  const bool culls = options.cull.value_or(cull_pays(a, b)) && &a != &b && precision != rung::tolerant &&
                     !options.first_met && cull(on, a, b, never_wrong(precision), left);
  if (culls) {
    if (left.bad_a)
      a.refuse();
    if (left.bad_b)
      b.refuse();
    const bool some = left.elements_a > 0 && left.elements_b > 0;
    left_a.only = left.a, left_a.elements = some ? left.elements_a : 0;
    left_b.only = left.b, left_b.elements = some ? left.elements_b : 0;
  }
  // Where little was left out, that box may be far larger than the elements, which one vertex can make it.
  const bool few_left =
      culls && std::uint64_t{left_a.elements} + left_b.elements < (std::uint64_t{a.elements()} + b.elements()) / 2;
  const std::size_t cleared = order_both(on, a, b, left_a, left_b, few_left ? left.around : nullptr, culls);
  query_notes &seen = buffers.seen->of_query;
  const auto in_order = [&] {
    return (left_a.elements == 0 || is_order(seen.found[0], left_a.elements)) &&
           (&a == &b || left_b.elements == 0 || is_order(seen.found[1], left_b.elements));
  };
  // A walk stops where there is no order, and its query reads what was found; where there is none, it is read here.
  const bool walks = left_a.elements > 0 && left_b.elements > 0;
  if (!walks) {
    check(cudaMemcpyAsync(&seen, buffers.notes.data(), sizeof seen, cudaMemcpyDeviceToHost, on.stream()),
          "ordering a set");
    check(cudaStreamSynchronize(on.stream()), "ordering a set");
  }
  device_result r;
  if (walks || in_order())
    r = query(on, a.ordered(), b.ordered(), predicate, precision, options, {}, left_there, cleared);
  if (!in_order()) { // what was found means nothing
    double before = 0;
    if (left_there)
      *left_there = {};
    device_set in_order_a(on, a);
    if (&a == &b) {
      before = elapsed();
      r = query(on, in_order_a, in_order_a, predicate, precision, options, {}, left_there);
    } else {
      device_set in_order_b(on, b);
      before = elapsed();
      r = query(on, in_order_a, in_order_b, predicate, precision, options, {}, left_there);
    }
    r.device_seconds += before;
  }
  r.seconds = elapsed();
  return r;
}

} // namespace

device_result collide(device &on, given_set &a, given_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options, pairs_there *left_there) {
  return under_standard_word([&] { return find_touching(on, a, b, predicate, precision, options, left_there); });
}

} // namespace meetc
