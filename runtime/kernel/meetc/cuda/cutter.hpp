// Arrays in one piece of memory.
#ifndef MEETC_CUDA_CUTTER_HPP
#define MEETC_CUDA_CUTTER_HPP

#include <cstddef>

namespace meetc::cuda {

// Cuts memory, which is 256-byte aligned, into arrays. Without memory it only adds up what is needed.
class cutter {
public:
  cutter(void *memory, std::size_t bytes) : at_(static_cast<char *>(memory)), bytes_(bytes) {}
  template <class T> T *take(std::size_t n) {
    const std::size_t begin = used_;
    used_ += (n * sizeof(T) + 255) / 256 * 256;
    return at_ ? reinterpret_cast<T *>(at_ + begin) : nullptr;
  }
  std::size_t used() const { return used_; }
  bool fits() const { return used_ <= bytes_; }

private:
  char *at_;
  std::size_t bytes_, used_ = 0;
};

} // namespace meetc::cuda

#endif
