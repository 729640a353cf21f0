// bench/harness/device_clock.hpp: the clock of works that are enqueued on a device's stream: its events.
#ifndef MEETC_BENCH_HARNESS_DEVICE_CLOCK_HPP
#define MEETC_BENCH_HARNESS_DEVICE_CLOCK_HPP

#include "meet/bench/baselines/gpu_baselines.hpp"
#include "meet/bench/harness/turns.hpp"
#include "meet/core/device/memory/memory.hpp"

#include <functional>

namespace meetc::bench {

class device_clock final : public clock {
public:
  explicit device_clock(const device &on) : on_(on) {
    for (cudaEvent_t &e : events_)
      check(cudaEventCreate(&e), "making an event");
    check(cudaStreamCreateWithFlags(&beside_, cudaStreamNonBlocking), "making a stream");
    reading_.reserve(1, "the clock");
  }
  ~device_clock() override {
    for (cudaEvent_t e : events_)
      cudaEventDestroy(e);
    cudaStreamDestroy(beside_);
  }
  device_clock(const device_clock &) = delete;
  device_clock &operator=(const device_clock &) = delete;

  void start() override { check(cudaEventRecord(events_[0], on_.stream()), "starting a clock"); }
  double stop() override {
    check(cudaEventRecord(events_[1], on_.stream()), "stopping a clock");
    check(cudaEventSynchronize(events_[1]), "waiting for a kernel");
    float ms = 0;
    check(cudaEventElapsedTime(&ms, events_[0], events_[1]), "reading a clock");
    return static_cast<double>(ms) / 1000;
  }

  // The seconds of one work alone.
  double seconds(const std::function<void()> &work, int runs) {
    return take_turns(*this, {work}, {runs, 60, 0}).seconds[0];
  }

  // The clock rate of a multiprocessor in hertz, while the work runs repeatedly.
  double clock_during(const std::function<void()> &work, double seconds_of_it) {
    const double wanted = 0.02;
    check(read_clock(reading_.data(), wanted * 1000, beside_), "reading the clock");
    const int times = static_cast<int>(1.5 * wanted / seconds_of_it) + 1;
    for (int i = 0; i < times; ++i)
      work();
    check(cudaStreamSynchronize(on_.stream()), "waiting for a kernel");
    check(cudaStreamSynchronize(beside_), "reading the clock");
    clock_reading r{};
    check(cudaMemcpy(&r, reading_.data(), sizeof r, cudaMemcpyDeviceToHost), "reading the clock");
    return static_cast<double>(r.cycles) / (static_cast<double>(r.nanoseconds) * 1e-9);
  }

private:
  device on_;
  cudaEvent_t events_[2] = {nullptr, nullptr};
  cudaStream_t beside_ = nullptr;
  device_memory<clock_reading> reading_;
};

} // namespace meetc::bench

#endif
