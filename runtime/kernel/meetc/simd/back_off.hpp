// Whether a cheap attempt is worth making, from how it went for the pairs before.
#ifndef MEETC_SIMD_BACK_OFF_HPP
#define MEETC_SIMD_BACK_OFF_HPP

#include <meetc/environment/environment.hpp>

MEETC_NAMESPACE(meetc) {

// Neighbouring pairs are mostly alike. After a failure the attempt is left out once, and twice as often and once more after
// each further one, up to 15 times; a success begins anew.
class back_off {
public:
  // Whether to make the attempt now.
  MEETC_INLINE bool tries() {
    if (left_out_ == 0)
      return true;
    --left_out_;
    return false;
  }
  // How an attempt went.
  MEETC_INLINE void went(bool well) {
    most_ = well ? 0 : most_ < 15 ? 2 * most_ + 1 : 15;
    left_out_ = most_;
  }

private:
  int most_ = 0, left_out_ = 0;
};

} // MEETC_NAMESPACE(meetc)

#endif
