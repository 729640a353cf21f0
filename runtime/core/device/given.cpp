#include "core/device/given.hpp"

#include "core/device/buffers.hpp"
#include "core/device/hits.hpp"
#include "core/device/query.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace meetc {
namespace {

constexpr std::uint64_t most = 0xffffffff; // elements, and vertices

// Bytes from the first element's first to the last one's last.
std::size_t bytes_of(const kind_info &kind, std::size_t rows, std::size_t stride, bool indexed) {
  return rows > 0 ? (rows - 1) * stride + (indexed ? 3 : static_cast<std::size_t>(kind.fields)) * sizeof(float) : 0;
}

} // namespace

const cuda::kind_launchers &launchers_of(const cuda::catalogue &all, const kind_info &kind) {
  for (int k = 0; k < all.kind_count; ++k)
    if (std::strcmp(all.kinds[k].name, kind.name) == 0 && all.kinds[k].fields == kind.fields)
      return all.kinds[k];
  throw device_error(std::string("no CUDA kernels were generated for the kind ") + kind.name);
}

void require_pose(const kind_info &kind, const pose &at) {
  if (const status s = movable(kind, at); s != status::ok)
    throw std::invalid_argument(text(s));
}

cuda::pose_matrix cuda_pose(const pose &at) {
  cuda::pose_matrix out{{}, at.length_scale, at.identity(), at.grid != 0, at.grid != 0 ? std::ilogb(at.grid) : 0};
  std::copy_n(at.m, 12, out.m);
  return out;
}

given_set::given_set(device &on, const kind_info &kind, const pose &at)
    : on_(&on), kind_(&kind), launchers_(&launchers_of(on.kernels(), kind)), at_(at) {
  require_pose(kind, at);
}
given_set::~given_set() = default;
given_set::given_set(given_set &&) noexcept = default;

given_set::given_set(device &on, const view &elements, const kind_info &kind, const pose &at)
    : given_set(on, kind, at) {
  if (elements.elements > most || (elements.index && elements.vertices > most))
    throw std::length_error(text(status::too_many_elements));
  if (elements.index && kind.fields != 3 * kind.points)
    throw std::invalid_argument("elements of this kind have no index");
  if (!upload(elements))
    throw device_error("not enough device memory for a set; the CPU decides the same pairs (--device cpu)");
  check(cudaStreamSynchronize(on.stream()), "uploading a set"); // the caller may change the elements now
}

std::unique_ptr<given_set> given_set::if_it_fits(device &on, const view &elements, const kind_info &kind,
                                                 const pose &at) {
  const std::size_t n = elements.elements, given = elements.index ? elements.vertices : n,
                    packed = n * static_cast<std::size_t>(kind.fields) * sizeof(float);
  if (n > most || given > most || (elements.index && kind.fields != 3 * kind.points))
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
  if (there.index && kind.fields != 3 * kind.points)
    throw std::invalid_argument("elements of this kind have no index");
  if (there.only)
    throw std::invalid_argument("a given set has all of its elements");
  there_ = there;
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

// Puts the sets, or what is left of them, into order and makes their hierarchies, both at once. What the kernels find is
// brought to the host on the stream beside, while the query goes on.
void order_both(device &on, given_set &a, given_set &b, const cuda::view &left_a, const cuda::view &left_b) {
  constexpr float least_share = 0.125F; // of the device
  device_buffers &buffers = on.buffers();
  const bool both = &a != &b;
  const float all = static_cast<float>(left_a.elements) + static_cast<float>(left_b.elements);
  buffers.counts.reserve(counters + hit_pairs::room_for_starts(a.elements()), "counters");
  const auto order = [&](given_set &s, const cuda::view &left, cudaStream_t stream) {
    const float share = std::clamp(static_cast<float>(left.elements) / all, least_share, 1 - least_share);
    const std::span<unsigned long long> cleared(buffers.counts.data(), &s == &a ? counters : 0);
    s.ordered().order(left, s.at(), s.elements(), both ? share : 1, cleared, stream);
    if (left.elements > 0)
      s.ordered().tree(stream);
  };
  const auto bring = [&](given_set &s, cuda::order_findings &seen) {
    seen = {~0ULL, 0, 0};
    if (s.ordered().findings())
      check(cudaMemcpyAsync(&seen, s.ordered().findings(), sizeof seen, cudaMemcpyDeviceToHost, buffers.beside),
            "ordering a set");
  };
  const auto follow = [](cudaStream_t from, cudaEvent_t mark, cudaStream_t to) {
    check(cudaEventRecord(mark, from), "joining streams");
    check(cudaStreamWaitEvent(to, mark, 0), "joining streams");
  };
  if (both) {
    follow(on.stream(), buffers.forked, buffers.beside);
    order(b, left_b, buffers.beside);
  }
  order(a, left_a, on.stream());
  if (both)
    follow(buffers.beside, buffers.joined, on.stream());
  follow(on.stream(), buffers.forked, buffers.beside);
  bring(a, buffers.seen->found[0]);
  if (both)
    bring(b, buffers.seen->found[1]);
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

} // namespace

device_result collide(device &on, given_set &a, given_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options, pairs_there *left_there) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  device_options by = options;
  by.by = options.by.value_or(search::tree);
  require_query(on, a.ordered(), b.ordered(), predicate, precision, by);
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
  } else {
    check(cudaEventRecord(buffers.events[0], on.stream()), "starting a clock");
  }
  order_both(on, a, b, left_a, left_b);
  const auto in_order = [&] {
    check(cudaStreamSynchronize(buffers.beside), "ordering a set");
    return is_order(buffers.seen->found[0], left_a.elements) &&
           (&a == &b || is_order(buffers.seen->found[1], left_b.elements));
  };
  device_result r;
  if (by.by == search::tree || in_order()) // a walk stops where there is no order
    r = query(on, a.ordered(), b.ordered(), predicate, precision, by, {}, left_there, true);
  if (!in_order()) { // what was found means nothing
    double before = 0;
    if (left_there)
      *left_there = {};
    device_set in_order_a(on, a);
    if (&a == &b) {
      before = elapsed();
      r = query(on, in_order_a, in_order_a, predicate, precision, by, {}, left_there);
    } else {
      device_set in_order_b(on, b);
      before = elapsed();
      r = query(on, in_order_a, in_order_b, predicate, precision, by, {}, left_there);
    }
    r.device_seconds += before;
  }
  r.seconds = elapsed();
  return r;
}

} // namespace meetc
