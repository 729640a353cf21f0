#include "meet/core/device/set/given.hpp"

#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/views/rows.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meetc/cuda/joined_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

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
    throw usage_error(text(s));
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

given_elements::given_elements(const device &on, const view &elements, const kind_info &kind)
    : given_elements(on, kind) {
  if (elements.elements > most || (elements.index && elements.vertices > most))
    throw std::length_error(text(status::too_many_elements));
  if (!upload(require_view(elements, kind)))
    throw device_memory_error("not enough device memory for a set; the CPU decides the same pairs (--device cpu)");
  check(cudaStreamSynchronize(on.stream()), "uploading a set"); // the caller may change the elements now
}

given_elements::given_elements(const device &on, const cuda::view &there, const kind_info &kind)
    : given_elements(on, kind) {
  if (there.only)
    throw usage_error("a given set has all of its elements");
  there_ = there;
  there_.stride_bytes =
      require_view({there.data, there.vertices, there.stride_bytes, there.index, there.elements}, kind).stride_bytes;
}

std::optional<given_elements> given_elements::if_it_fits(const device &on, const view &stated, const kind_info &kind) {
  const view elements = require_view(stated, kind);
  const std::size_t n = elements.elements, rows = elements.index ? elements.vertices : n,
                    packed = n * static_cast<std::size_t>(kind.fields) * sizeof(float);
  if (n > most || rows > most ||
      bytes_of(kind, rows, elements.stride_bytes, elements.index != nullptr) > 4 * packed + (std::size_t{1} << 20))
    return {};
  given_elements out(on, kind);
  if (!out.upload(elements))
    return {};
  return out;
}

bool given_elements::upload(const view &elements) {
  const std::size_t rows = elements.index ? elements.vertices : elements.elements,
                    bytes = bytes_of(*kind_, rows, elements.stride_bytes, elements.index != nullptr),
                    indices = elements.index ? elements.elements * static_cast<std::size_t>(kind_->points) : 0;
  const cudaStream_t stream = on_.stream();
  if (!data_.grow(bytes, 0, stream) || !index_.grow(indices, 0, stream))
    return false;
  transfers &moving = on_.buffers().moving;
  moving.upload(data_.data(), elements.data, bytes, stream, "uploading a set");
  moving.upload(index_.data(), elements.index, indices * sizeof(std::uint32_t), stream, "uploading a set");
  there_ = {reinterpret_cast<const float *>(data_.data()), elements.stride_bytes,
            elements.index ? index_.data() : nullptr, static_cast<std::uint32_t>(elements.vertices),
            static_cast<std::uint32_t>(elements.elements)};
  return true;
}

struct given_elements::copy {
  std::vector<std::byte> data;
  std::vector<std::uint32_t> index;
  view elements; // of these
};

given_elements::copy given_elements::download() const {
  copy c;
  const bool indexed = there_.index != nullptr;
  c.data.resize(bytes_of(*kind_, indexed ? there_.vertices : there_.elements, there_.stride_bytes, indexed));
  c.index.resize(indexed ? there_.elements * static_cast<std::size_t>(kind_->points) : 0);
  transfers &moving = on_.buffers().moving;
  moving.download(c.data.data(), there_.data, c.data.size(), on_.stream(), "downloading a set");
  moving.download(c.index.data(), there_.index, c.index.size() * sizeof(std::uint32_t), on_.stream(),
                  "downloading a set");
  c.elements = {reinterpret_cast<const float *>(c.data.data()), there_.vertices, there_.stride_bytes,
                indexed ? c.index.data() : nullptr, there_.elements};
  return c;
}

prepared given_elements::prepare_here(int threads) const {
  return prepare(download().elements, *kind_, at, threads);
}

void given_elements::refuse() const {
  if (const fault f = meetc::check(download().elements, *kind_, at))
    throw input_error(f, *kind_);
}

cuda::tree_box given_elements::bounds() const {
  device_memory<cuda::joined_box> around;
  around.reserve(1, "a box");
  cuda::joined_box found{};
  check(cudaMemsetAsync(around.data(), 0, sizeof found, on_.stream()), "measuring a set");
  check(launchers_of(on_.kernels(), *kind_)
            .pose(there_, cuda_pose(at), nullptr, nullptr, nullptr, around.data(), on_.stream()),
        "starting a kernel");
  check(cudaMemcpyAsync(&found, around.data(), sizeof found, cudaMemcpyDeviceToHost, on_.stream()), "measuring a set");
  check(cudaStreamSynchronize(on_.stream()), "measuring a set");
  return box_of(found);
}

} // namespace meetc
