// core/control_word.hpp: the floating-point control word while this library works.
//
// Any library linked with -ffast-math sets flush-to-zero for the whole process, and poses and rungs then lose
// subnormals. A guard sets round-to-nearest with gradual underflow and restores the old word at the end. Each thread
// needs its own.
#ifndef MEETC_CORE_CONTROL_WORD_HPP
#define MEETC_CORE_CONTROL_WORD_HPP

#include <meetc/control_word.hpp>

namespace meetc {

class control_word_guard {
public:
  control_word_guard() { set_control_word(plain_control_word); }
  ~control_word_guard() { set_control_word(found_); }
  control_word_guard(const control_word_guard &) = delete;
  control_word_guard &operator=(const control_word_guard &) = delete;

private:
  decltype(control_word()) found_ = control_word();
};

} // namespace meetc

#endif
