#include "meet/core/device/set/order.hpp"

#include "meet/core/device/memory/buffers.hpp"

#include <algorithm>
#include <optional>

namespace meetc {
namespace {

device_rows::order_request request(const device_buffers &buffers, std::span<const needed_elements> sets, std::size_t i,
                                   const cuda::joined_box *common) {
  constexpr float least_share = 0.125F; // of the device
  float all = 0;
  for (const needed_elements &s : sets)
    all += static_cast<float>(s.elements.elements);
  const float share = std::clamp(static_cast<float>(sets[i].elements.elements) / all, least_share, 1 - least_share);
  return {sets[i].elements,
          sets[i].of->as_given()->at,
          sets[i].of->elements(),
          sets.size() > 1 ? share : 1,
          buffers.found() + i,
          i == 0 ? buffers.counts() : std::span<unsigned long long>(),
          common};
}

void make_tree(device_rows &rows, cudaStream_t stream) {
  if (rows.elements() > 0)
    rows.tree(stream);
}

// Two sets of one kind, by one kernel.
void order_together(std::span<const needed_elements> sets, const device_buffers &buffers,
                    const cuda::joined_box *common, bool clock_runs) {
  std::optional<cuda::arrange_job> plans[2];
  for (std::size_t i = 0; i < 2; ++i)
    plans[i] = sets[i].of->rows().plan_order(request(buffers, sets, i, common), buffers.stream);
  if (!clock_runs)
    buffers.start_clock();
  cuda::arrange_job jobs[2] = {};
  int n = 0;
  for (const auto &plan : plans)
    if (plan)
      jobs[n++] = *plan;
  if (n > 0)
    check(sets[0].of->rows().launchers().arrange(jobs, n, buffers.stream), "starting a kernel");
  for (const needed_elements &s : sets)
    make_tree(s.of->rows(), buffers.stream);
}

} // namespace

void order(const device &on, std::span<const needed_elements> sets, const cuda::joined_box *common, bool clock_runs) {
  const device_buffers &buffers = on.buffers();
  const bool two = sets.size() > 1;
  if (two && &sets[0].of->rows().launchers() == &sets[1].of->rows().launchers() &&
      can_arrange(sets[0].elements.elements) && can_arrange(sets[1].elements.elements)) {
    order_together(sets, buffers, common, clock_runs);
    return;
  }
  const auto order_one = [&](std::size_t i, cudaStream_t stream) {
    device_rows &rows = sets[i].of->rows();
    if (const auto job = rows.plan_order(request(buffers, sets, i, common), stream))
      check(rows.launchers().arrange(&*job, 1, stream), "starting a kernel");
    make_tree(rows, stream);
  };
  if (!clock_runs)
    buffers.start_clock();
  if (two) {
    buffers.fork();
    order_one(1, buffers.beside);
  }
  order_one(0, buffers.stream);
  if (two)
    buffers.join();
}

bool are_in_order(const device &on, std::span<const needed_elements> sets) {
  const query_notes &seen = on.buffers().seen->of_query;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (const std::uint32_t n = sets[i].elements.elements; n > 0 && !is_order(seen.found[i], n))
      return false;
  return true;
}

} // namespace meetc
