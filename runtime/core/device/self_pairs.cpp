#include "meet/core/device/self_pairs.hpp"

#include "meet/core/cascade/cascade.hpp"
#include "meet/core/device/answers/element_pairs.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/query/mesh_kernels.hpp"
#include "meet/core/device/query/parts.hpp"
#include "meet/core/device/query/query.hpp"
#include "meet/core/query/operand.hpp"
#include "meet/core/threads/execution.hpp"
#include "meet/core/views/collinear.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meetc/cuda/cascade.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <stdexcept>

namespace meetc {
namespace {

using on_device::orders_of_corners;

void require(bool holds, const char *text) {
  if (!holds)
    throw usage_error(text);
}

// The corners of a mesh, and the items of its elements.
class mesh_corners {
public:
  mesh_corners(const device &on, const device_rows &mesh, const device_self_options &options) {
    const std::uint32_t n = mesh.elements();
    const cudaStream_t stream = on.stream();
    rows_.reserve(std::size_t{9} * orders_of_corners * n, "the corners of a mesh");
    numbers_.reserve(std::size_t{3} * n, "the corners of a mesh");
    check(on_device::order_corners(mesh.data(), n, rows_.data(), stream), "starting a kernel");
    if (options.merge) {
      const auto bits = static_cast<int>(std::bit_width(std::size_t{6} * n));
      cells_.reserve(std::size_t{1} << bits, "the corners of a mesh");
      check(on_device::number_corners(mesh.data(), n, cells_.data(), bits, numbers_.data(), stream),
            "starting a kernel");
    } else {
      upload(options.vertices, vertices_, stream);
      check(on_device::name_corners(vertices_.data(), mesh.order(), n, numbers_.data(), stream), "starting a kernel");
    }
    upload(options.owner, owner_, stream);
  }

  const float *rows() const { return rows_.data(); }
  const std::uint32_t *numbers() const { return numbers_.data(); }
  const std::uint32_t *owner() const { return owner_.data(); } // null: none

private:
  device_memory<float> rows_; // of each element in each order of its corners
  device_memory<std::uint32_t> numbers_, cells_, vertices_, owner_;

  static void upload(std::span<const std::uint32_t> from, device_memory<std::uint32_t> &to, cudaStream_t stream) {
    if (!from.empty())
      check(cudaMemcpyAsync(to.reserve(from.size(), "the corners of a mesh"), from.data(), from.size_bytes(),
                            cudaMemcpyHostToDevice, stream),
            "uploading the corners of a mesh");
  }
};

// Sorts candidates by their common corners, and decides neighbours.
class neighbour_sieve final : public candidate_sieve {
public:
  neighbour_sieve(const device &on, const device_rows &mesh, const mesh_corners &corners,
                  const cuda::predicate_launchers &one, const cuda::predicate_launchers &two, self_result &r)
      : on_(on), buffers_(on.buffers()), mesh_(mesh),
        corners_(corners), neighbours_{{one, counter::one_common, counter::one_kept, counter::one_unsure_fp32, {}},
                                       {two, counter::two_common, counter::two_kept, counter::two_unsure_fp32, {}}},
        r_(r) {}

  void sift(const cuda::pair_list &candidates, const cuda::pair_list &kept, const cuda::pair_list &hits) override {
    cuda::pair_list lists[2];
    for (int i = 0; i < 2; ++i)
      lists[i] = {neighbours_[i].list.reserve(candidates.capacity, "a list of neighbours"),
                  buffers_.count_of(neighbours_[i].found), candidates.capacity};
    check(on_device::sort_by_corners({candidates, corners_.numbers(), mesh_.order(), corners_.owner(), kept, lists[0],
                                      lists[1], hits, buffers_.count_of(counter::three_common)},
                                     on_.stream()),
          "starting a kernel");
    for (int i = 0; i < 2; ++i) {
      const kind_of_neighbours &n = neighbours_[i];
      check(cuda::decide(n.by, rung::certified, corners_.rows(), corners_.rows(),
                         {lists[i],
                          {candidates.pairs, buffers_.count_of(n.kept), candidates.capacity},
                          buffers_.count_of(n.unsure)},
                         hits, on_.stream()),
            "starting a decision step");
    }
    check(on_device::to_slots(hits, on_.stream()), "starting a kernel");
  }
  void take() override {
    for (int i = 0; i < 2; ++i) {
      r_.neighbours[i] += buffers_.seen_of(neighbours_[i].found);
      for (int k = 0; k < bounded_rungs; ++k)
        r_.rungs.unsure[k] += buffers_.seen_of(static_cast<counter>(static_cast<int>(neighbours_[i].unsure) + k));
    }
    r_.neighbours[2] += buffers_.seen_of(counter::three_common);
  }

private:
  struct kind_of_neighbours {
    const cuda::predicate_launchers &by;
    counter found, kept, unsure; // unsure: the first of three
    device_memory<index_pair> list;
  };
  const device &on_;
  const device_buffers &buffers_;
  const device_rows &mesh_;
  const mesh_corners &corners_;
  kind_of_neighbours neighbours_[2];
  self_result &r_;
};

// The elements whose corners lie on one line: the device finds those that may do so, and the host looks at these.
class flat_elements {
public:
  flat_elements(const device &on, const device_rows &mesh) : on_(on) {
    found_.reserve(mesh.elements(), "elements without an extent");
    check(cudaMemsetAsync(count_.reserve(1, "a counter"), 0, sizeof(unsigned), on.stream()), "clearing a counter");
    check(on_device::find_flat(mesh.data(), mesh.order(), mesh.elements(), found_.data(), count_.data(), on.stream()),
          "starting a kernel");
  }
  std::vector<std::uint32_t> confirmed() const {
    unsigned n = 0;
    download(&n, count_.data(), 1);
    std::vector<on_device::flat_element> found(n);
    download(found.data(), found_.data(), n);
    std::vector<std::uint32_t> out;
    for (const on_device::flat_element &e : found)
      if (collinear(e.row))
        out.push_back(e.element);
    std::sort(out.begin(), out.end());
    return out;
  }

private:
  const device &on_;
  device_memory<on_device::flat_element> found_;
  device_memory<unsigned> count_;

  template <class T> void download(T *to, const T *from, std::size_t n) const {
    if (n == 0)
      return;
    check(cudaMemcpyAsync(to, from, n * sizeof(T), cudaMemcpyDeviceToHost, on_.stream()), "measuring a mesh");
    check(cudaStreamSynchronize(on_.stream()), "measuring a mesh");
  }
};

void require_mesh(const device &on, const device_set &mesh, const self_predicates &by,
                  const device_self_options &options) {
  for (const predicate_info *p : {&by.apart, &by.one_common, &by.two_common}) {
    require(p->a->points == 3 && p->a->fields == 9 && same_kind(*p->a, mesh.kind()) && same_kind(*p->b, mesh.kind()),
            "the predicates of a mesh with itself take two elements of its kind, with three points");
    require(cascade(*p, rung::certified).count > 0, text(status::no_such_rung));
  }
  require(mesh.on() == on, "the set is on another device");
  const std::size_t n = mesh.elements();
  require(options.owner.empty() || options.owner.size() == n, "an owner map needs one item for each element");
  require(options.vertices.empty() || options.vertices.size() == 3 * n, "each element of a mesh has three vertices");
  require(options.list_capacity >= least_capacity, "a list holds at least 2^11 pairs");
  if (orders_of_corners * n > 0xffffffff)
    throw std::length_error("a mesh with itself on a device has fewer than a third of 2^31 elements");
}

device_self_result find_self_pairs(const device &on, device_set &mesh, const self_predicates &by,
                                   const cuda::catalogue &neighbours, const device_self_options &options) {
  const auto start = std::chrono::steady_clock::now();
  require_mesh(on, mesh, by, options);
  go_on(options.stop);
  const cuda::predicate_launchers &apart = launchers_of(on.kernels(), by.apart),
                                  &one = launchers_of(neighbours, by.one_common),
                                  &two = launchers_of(neighbours, by.two_common);
  device_rows &rows = mesh.rows();
  if (mesh.as_given())
    rows.make(*mesh.as_given(), 0);
  device_self_result r;
  if (rows.elements() > 0) {
    const device_buffers &buffers = on.buffers();
    buffers.start_clock();
    const mesh_corners corners(on, rows, options);
    const flat_elements flat(on, rows);
    neighbour_sieve sieve(on, rows, corners, one, two, r);
    const std::unique_ptr<on_device::query_answer> answers[] = {
        std::make_unique<on_device::element_pairs>(options.leave_there)};
    answers[0]->start({on, rows, rows});
    device_result found;
    decide_all({on, rows, rows, apart, rung::certified, true, answers, options.list_capacity, options.progress,
                options.stop, false, &sieve},
               found);
    answers[0]->finish();
    answers[0]->download(found);
    r.degenerate = flat.confirmed();
    r.pairs = std::move(found.pairs);
    r.candidates = found.candidates;
    r.parts = found.parts;
    for (int i = 0; i < bounded_rungs; ++i)
      r.rungs.unsure[i] += found.rungs.unsure[i];
    r.device_seconds = buffers.clocked();
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace

device_self_result self_pairs(const device &on, device_set &mesh, const self_predicates &predicates,
                              const cuda::catalogue &neighbours, const device_self_options &options) {
  return under_standard_word([&] {
    const auto lock = on.use();
    if (options.leave_there)
      options.leave_there->clear();
    return find_self_pairs(on, mesh, predicates, neighbours, options);
  });
}

} // namespace meetc
