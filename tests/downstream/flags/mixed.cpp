#include "mixed.hpp"
#include "mixed_count.hpp"

#include <cstdio>

long wrong_here(std::size_t n) {
  return wrong_of_all(n);
}

int main() {
  const long here = wrong_here(4000), there = wrong_there(4000);
  std::printf("%ld wrong here, %ld wrong there\n", here, there);
  return here + there != 0;
}
