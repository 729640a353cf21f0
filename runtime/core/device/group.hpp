// core/device/group.hpp: one query, cut between several CUDA devices of one host. The answers are those of one device.
//
// A's elements are cut, in the caller's order, into as many slices as there are devices, and each device has all of B. Every
// pair of elements is thus looked at by one device: lists follow one another, and counts add up. Each device has a thread of the
// host, which uploads to it, asks it, and downloads what it found. A slice of neighbours costs least to search, as the faces
// of a mesh mostly are.
//
// Where A has owners, each device lists its pairs of items, and the lists are joined on the host, because two slices may hold
// elements of one item. A set that is collided with itself is looked at whole: the half that one device leaves out lies in
// other slices.
#ifndef MEETC_CORE_DEVICE_GROUP_HPP
#define MEETC_CORE_DEVICE_GROUP_HPP

#include "meet/core/device/collide.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace meetc {

// It runs one query at a time. Its sets must not outlive it.
class device_group {
public:
  // The devices with these numbers of CUDA. One that stands there twice runs two parts of a query at once. Throws
  // std::invalid_argument where there is no number or a negative one, device_error where there is no such device, and what
  // device() throws.
  device_group(const cuda::catalogue &kernels, std::span<const int> numbers);
  ~device_group();
  device_group(const device_group &) = delete;
  device_group &operator=(const device_group &) = delete;

  std::size_t size() const { return numbers_.size(); }
  std::span<const int> numbers() const { return numbers_; }
  device &operator[](std::size_t i) { return *devices_[i]; }

  // Calls work(i) for each device while that is the current one of its thread; work(0) runs on the calling thread, and others on
  // threads that wait for it. Once all have ended, the exception of the first device that threw one is thrown again.
  void on_each(const std::function<void(std::size_t i)> &work);

private:
  class waiting_threads;

  std::vector<int> numbers_;
  std::unique_ptr<waiting_threads> threads_;
  std::vector<std::unique_ptr<device>> devices_;
};

enum class spread : std::uint8_t {
  cut,   // each device has a slice: a query's first set
  whole, // each device has all elements: its second
};

// A set on the devices of a group. All members throw what those of device_set throw; faults name the caller's elements.
class group_set {
public:
  group_set(device_group &on, const view &elements, const kind_info &kind, spread how, const pose &at = {},
            int threads = 0);
  ~group_set();
  group_set(const group_set &) = delete;
  group_set &operator=(const group_set &) = delete;

  std::size_t elements() const { return elements_; }
  spread how() const { return how_; }
  bool is_on(const device_group &g) const { return on_ == &g; }
  // After a device_error or input_error, some devices have the old pose and others the new one; the set may be moved again.
  void move(const pose &at);
  // The closed box around all elements; lo > hi where there are none.
  void bounds(float lo[3], float hi[3]);

  // What device i has, and the caller's number of its first element.
  device_set &part(std::size_t i) { return *parts_[i]; }
  std::size_t first(std::size_t i) const { return how_ == spread::cut ? elements_ * i / parts_.size() : 0; }

private:
  device_group *on_;
  spread how_;
  std::size_t elements_;
  std::vector<std::unique_ptr<device_set>> parts_;
};

// A is cut and B is whole. Throws what collide() on one device throws. Of the result, seconds are
// the host's wall clock, device_seconds those of the device that took longest, candidates, parts and rungs are
// summed. options.progress tells of the first device.
device_result collide(device_group &on, group_set &a, group_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options = {});

} // namespace meetc

#endif
