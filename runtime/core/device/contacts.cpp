#include "meet/core/device/contacts.hpp"

#include "meet/core/contacts/steps.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/query/label_places.hpp"
#include "meet/core/device/query/query.hpp"

#include <cmath>

namespace meetc {
namespace {

template <class T> void upload(const device_buffers &buffers, device_memory<T> &to, std::span<const T> from) {
  to.reserve(from.size(), "contacts");
  if (!from.empty())
    check(cudaMemcpyAsync(to.data(), from.data(), from.size_bytes(), cudaMemcpyHostToDevice, buffers.stream),
          "uploading contacts");
}

template <class Real> class steps_there final : public contact_steps<Real> {
public:
  steps_there(const device &on, const predicate_info &predicate, execution on_host, device_contact_work &work)
      : buffers_(on.buffers()), by_(launchers_of(on.kernels(), predicate).pairs.contacts),
        here_(predicate, std::move(on_host)), work_(work) {}

  void find_codes(const touched_rows &a, const touched_rows &b, std::span<const index_pair> pairs,
                  std::uint64_t *codes) override {
    here_a_ = &a, here_b_ = &b;
    upload<float>(buffers_, a_, a.rows), upload<float>(buffers_, b_, b.rows);
    device_memory<index_pair> pairs_there;
    device_memory<std::uint64_t> codes_there;
    upload(buffers_, pairs_there, pairs);
    codes_there.reserve(pairs.size(), "contacts");
    work_.codes_seconds = timed([&] {
      check(by_({a_.data(), b_.data(), pairs_there.data(), pairs.size(), codes_there.data()}, buffers_.stream),
            "starting a kernel");
    });
    download(codes, codes_there, pairs.size());
    finish_codes(pairs, codes);
  }

  void place_nodes(std::span<const node_source> nodes, Real *points) override {
    device_memory<node_source> nodes_there;
    device_memory<Real> points_there;
    upload(buffers_, nodes_there, nodes);
    points_there.reserve(3 * nodes.size(), "contacts");
    work_.places_seconds = timed([&] {
      check(on_device::place_labels(
                {a_.data(), b_.data(), here_a_->corners, here_b_->corners, nodes_there.data(), nodes.size()},
                points_there.data(), buffers_.stream),
            "starting a kernel");
    });
    download(points, points_there, 3 * nodes.size());
    finish_places(nodes, points);
  }

  // Those with kernels have none.
  void place_witnesses(std::span<const index_pair> pairs, const std::uint64_t *codes, Real *points) override {
    here_.place_witnesses(pairs, codes, points);
  }

private:
  device_buffers &buffers_;
  cudaError_t (*by_)(const cuda::contact_job &, cudaStream_t);
  steps_on_cpu<Real> here_;
  device_contact_work &work_;
  const touched_rows *here_a_ = nullptr, *here_b_ = nullptr;
  device_memory<float> a_, b_;

  template <class Start> double timed(const Start &start) {
    buffers_.start_clock();
    start();
    buffers_.mark_clock();
    return buffers_.clocked();
  }
  template <class T> void download(T *to, const device_memory<T> &from, std::size_t n) {
    if (n == 0)
      return;
    check(cudaMemcpyAsync(to, from.data(), n * sizeof(T), cudaMemcpyDeviceToHost, buffers_.stream),
          "downloading contacts");
    check(cudaStreamSynchronize(buffers_.stream), "downloading contacts");
  }

  // The pairs and nodes that the device left, gathered so that the CPU's step takes them together.
  void finish_codes(std::span<const index_pair> pairs, std::uint64_t *codes) {
    std::vector<std::size_t> left;
    std::vector<index_pair> of_left;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (codes[i] == cuda::undecided_code)
        left.push_back(i), of_left.push_back(pairs[i]);
    std::vector<std::uint64_t> found(left.size());
    here_.find_codes(*here_a_, *here_b_, of_left, found.data());
    for (std::size_t i = 0; i < left.size(); ++i)
      codes[left[i]] = found[i];
    work_.pairs_left = left.size();
  }
  void finish_places(std::span<const node_source> nodes, Real *points) {
    std::vector<std::size_t> left;
    std::vector<node_source> of_left;
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (std::isnan(points[3 * n]) || std::isnan(points[3 * n + 1]) || std::isnan(points[3 * n + 2]))
        left.push_back(n), of_left.push_back(nodes[n]);
    std::vector<Real> found(3 * left.size());
    here_.place_nodes(of_left, found.data());
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        points[3 * left[i] + k] = found[3 * i + k];
    work_.nodes_left = left.size();
  }
};

} // namespace

template <class Real>
contact_set<Real> contacts(const device &on, const view &a, const view &b, const predicate_info &predicate,
                           std::span<const index_pair> pairs, const contact_options &options,
                           device_contact_work *work) {
  device_contact_work unasked;
  if (!predicate.contacts || !launchers_of(on.kernels(), predicate).pairs.contacts)
    return contacts<Real>(a, b, predicate, pairs, options);
  const auto lock = on.use();
  steps_there<Real> steps(on, predicate, execution_on(options.threads, options.stop), work ? *work : unasked);
  return contacts_by(steps, a, b, predicate, pairs, options);
}

template contact_set<float> contacts(const device &, const view &, const view &, const predicate_info &,
                                     std::span<const index_pair>, const contact_options &, device_contact_work *);
template contact_set<double> contacts(const device &, const view &, const view &, const predicate_info &,
                                      std::span<const index_pair>, const contact_options &, device_contact_work *);

} // namespace meetc
