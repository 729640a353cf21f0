// bench/harness/clock.hpp: clocks for one piece of work.
//
// Problem: on a shared machine other processes take turns on the same cores, and a device works beside the host.
// Method: one interface, of which there are three kinds: the time of this process on its cores, in which other processes
// do not count; the time on the wall, for works on several threads; and a device's events (device_clock.hpp).
#ifndef MEETC_BENCH_HARNESS_CLOCK_HPP
#define MEETC_BENCH_HARNESS_CLOCK_HPP

namespace meetc::bench {

class clock {
public:
  virtual ~clock() = default;
  virtual void start() = 0;
  virtual double stop() = 0; // seconds since start()
};

// The clock of the operating system: of this process for works on one thread, else on the wall.
class host_clock final : public clock {
public:
  explicit host_clock(int threads) : of_process_(threads == 1) {}
  void start() override { start_ = now(); }
  double stop() override { return now() - start_; }

private:
  double now() const;
  bool of_process_;
  double start_ = 0;
};

} // namespace meetc::bench

#endif
