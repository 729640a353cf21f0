// Segments that go down a hierarchy alone, a thread a segment, each to what it meets first. Included by nvcc, or behind a
// stand-in for a warp.
#ifndef MEETC_CUDA_FIRST_WALK_HPP
#define MEETC_CUDA_FIRST_WALK_HPP

#include <meetc/cuda/lists.hpp>
#include <meetc/volume/fours_way.hpp>

namespace meetc::cuda {

inline constexpr unsigned first_walk_hits = 128; // that wait, of a warp
// Lanes without a segment get one where so many have none, and elements are decided where so many lanes have one.
inline constexpr int least_without = 8, least_decided = 8;

// One warp. Threads have very different ways to go, so that a thread which has ended takes the next segment of the warp's; and
// a lane that comes to an element waits until several have one, since a decision costs as much as some ten nodes. Decide::of()
// says of rows of P's operands yes and no where that is proved.
template <class P, class Decide> class first_walk {
  static_assert(P::inputs_a == 6);

public:
  __device__ first_walk(const first_walk_job &job, index_pair *room)
      : job_(job), hits_(job.hits, room), lane_(threadIdx.x % 32) {}

  // Does the chunks of this one of all warps, up to the hits that wait.
  __device__ void run(std::uint32_t warp, std::uint32_t warps) {
    const std::uint32_t first_element = job_.tree.shape.first_element();
    take_chunk(warp);
    for (;;) {
      const unsigned without = __ballot_sync(~0U, way_.at() == nowhere);
      if (__popc(without) >= least_without && next_ < end_) {
        start(without);
        if (next_ == end_)
          take_chunk(next_chunk(warps));
        continue;
      }
      const unsigned at_element = __ballot_sync(~0U, way_.at() != nowhere && way_.at() >= first_element);
      const unsigned at_node = ~(without | at_element);
      if (at_node != 0 && __popc(at_element) < least_decided) {
        if (at_node >> lane_ & 1) {
          std::uint32_t keys[4];
          line_.enter(job_.tree.nodes[way_.at()], keys);
          order_keys(keys);
          way_.enter(keys);
        }
        continue;
      }
      if (at_element == 0)
        break;
      decide(at_element >> lane_ & 1, first_element);
      if (at_element >> lane_ & 1)
        way_.next();
    }
    if (lane_ == 0 && decided_ > 0)
      atomicAdd(job_.decided, decided_);
  }
  // The hits that it has found and not written yet.
  __device__ waiting_list<first_walk_hits> &hits() { return hits_; }

private:
  __device__ std::uint32_t chunks() const { return (job_.of.end_a - job_.of.first_a - 1) / 32 + 1; }
  __device__ std::uint32_t next_chunk(std::uint32_t warps) const {
    unsigned long long at = 0;
    if (lane_ == 0)
      at = atomicAdd(job_.taken, 1ULL);
    at = warps + __shfl_sync(~0U, at, 0);
    return at < chunks() ? static_cast<std::uint32_t>(at) : chunks();
  }
  // The segments that lanes take next; none where all are taken, or a list is full.
  __device__ void take_chunk(std::uint32_t chunk) {
    next_ = end_ = 0;
    if (chunk >= chunks() || full(job_.hits) || full(job_.unsure))
      return;
    next_ = job_.of.first_a + chunk * 32;
    end_ = job_.of.end_a - next_ < 32 ? job_.of.end_a : next_ + 32;
  }
  // Lanes without a segment take the next ones.
  __device__ void start(unsigned without) {
    const std::uint32_t mine = next_ + __popc(without & ((1U << lane_) - 1)), left = end_ - next_;
    if ((without >> lane_ & 1) && mine < end_) {
      segment_ = mine;
      line_ = first_line(job_.a + std::size_t{mine} * P::inputs_a);
      way_.start();
    }
    const auto taken = static_cast<std::uint32_t>(__popc(without));
    next_ += taken < left ? taken : left;
  }
  // Some lanes are at an element.
  __device__ void decide(bool here, std::uint32_t first_element) {
    const std::uint32_t at = way_.at(), slot = at - first_element;
    const index_pair pair[1] = {{segment_, slot}};
    here = here && slot - job_.of.first_b < job_.of.end_b - job_.of.first_b;
    answer x = answer::no;
    if (here)
      x = Decide::of(job_.a + std::size_t{segment_} * P::inputs_a, job_.b + std::size_t{slot} * P::inputs_b);
    if (x == answer::yes)
      line_.meets(job_.tree.nodes[(at - 1) / 4], (at - 1) % 4);
    decided_ += __popc(__ballot_sync(~0U, here));
    hits_.append(x == answer::yes ? 1U : 0U, pair);
    append(x == answer::unsure ? 1U : 0U, pair, job_.unsure);
  }

  const first_walk_job &job_;
  waiting_list<first_walk_hits> hits_;
  unsigned lane_;
  first_line line_;
  fours_way way_; // nowhere: it has no segment
  std::uint32_t segment_ = 0;
  std::uint32_t next_ = 0, end_ = 0; // slots of the warp's chunk
  unsigned long long decided_ = 0;
};

} // namespace meetc::cuda

#endif
