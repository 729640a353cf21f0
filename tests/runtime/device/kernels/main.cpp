#include "cuda_test.hpp"

#include <cmath>
#include <exception>

int main() {
  if (cuda_test::no_device())
    return cuda_test::skipped;
  try {
    const long differences = cuda_test::sound_arithmetic() + cuda_test::same_decisions() + cuda_test::same_signs() +
                             cuda_test::same_formulas();
    std::printf("%ld differences between CPU and device\n", differences);
    return differences ? 1 : 0;
  } catch (const std::exception &e) {
    std::printf("error: %s\n", e.what());
    return 1;
  }
}
