// core/device/group.hpp: several CUDA devices of one host, and sets on them, for one query that is cut between them.
//
// The elements of one set are cut, in the caller's order, into as many slices as there are devices, and each device has all
// of the other. Every pair of elements is thus looked at by one device: lists are joined, and counts add up. The larger set
// is to be cut, since each device walks and orders all of the other one. Each device has a thread of the host, which uploads
// to it, asks it, and downloads what it found. A slice of neighbours costs least to search, as the faces of a mesh mostly
// are.
//
// Where the set that is cut has owners, each device lists its pairs of items, because two slices may hold elements of one
// item. A set that is collided with itself is looked at whole: the half that one device leaves out lies in other slices. One
// device answers that sooner.
#ifndef MEETC_CORE_DEVICE_GROUP_HPP
#define MEETC_CORE_DEVICE_GROUP_HPP

#include "meet/core/device/set/device_set.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace meetc {

// A copy is the same group, and a set has one.
class device_group {
public:
  // The devices with these numbers of CUDA. One that stands there twice runs two parts of a query at once. Throws
  // usage_error where there is no number or a negative one, missing_device where there is none of a number, and what
  // device() throws.
  device_group(const cuda::catalogue &kernels, std::span<const int> numbers);

  std::size_t size() const { return devices_->size(); }
  const device &operator[](std::size_t i) const { return *(*devices_)[i].on; }
  bool operator==(const device_group &) const = default;

  // Calls work(i) for each device while that is the current one of its thread; work(0) runs on the calling thread, and
  // others on threads that end with it. Once all have ended, the exception of the first device that threw one is thrown
  // again.
  void on_each(const std::function<void(std::size_t i)> &work) const;

private:
  struct numbered {
    int number;
    std::optional<device> on;
  };
  std::shared_ptr<std::vector<numbered>> devices_;
};

enum class spread : std::uint8_t {
  cut,   // each device has a slice
  whole, // each device has all elements
};
// How two sets of so many elements are to be spread: the larger is cut, or the first where it is asked what that meets first.
constexpr std::pair<spread, spread> spread_for(std::size_t elements_a, std::size_t elements_b, bool first_met) {
  return elements_a >= elements_b || first_met ? std::pair(spread::cut, spread::whole)
                                               : std::pair(spread::whole, spread::cut);
}

// A set on the devices of a group. All members throw what those of device_set throw; faults name the caller's elements.
class group_set {
public:
  group_set(const device_group &on, const view &elements, const kind_info &kind, spread how, const pose &at = {},
            int threads = 0);

  std::size_t elements() const { return elements_; }
  spread how() const { return how_; }
  const device_group &on() const { return on_; }
  // After a device_error or input_error, some devices have the old pose and others the new one; the set may be moved again.
  void move(const pose &at);
  // The closed box around all elements; lo > hi where there are none.
  void bounds(float lo[3], float hi[3]);

  // The part on device i, and the caller's number of its first element.
  device_set &part(std::size_t i) { return *parts_[i]; }
  std::size_t first(std::size_t i) const { return how_ == spread::cut ? begin(i) : 0; }

private:
  std::size_t begin(std::size_t i) const { return elements_ * i / parts_.size(); }
  void on_each_part(const std::function<void(std::size_t i)> &work) const;

  device_group on_;
  const kind_info *kind_;
  spread how_;
  std::size_t elements_;
  std::vector<std::optional<device_set>> parts_;
};

} // namespace meetc

#endif
