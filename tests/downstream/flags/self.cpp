// What self_test() says, every fault by its text. Exit code 1 where there is one.
#include <meet/support.hpp>

#include <cstdio>

int main() {
  const unsigned faults = meet::self_test();
  std::printf("faults %u: %s\n", faults, meet::text_of_faults(faults));
  if (faults & static_cast<unsigned>(meet::arithmetic_fault::reassociation))
    std::printf("reassociation\n");
  for (unsigned bit = 1; bit & meet::fault_bits; bit <<= 1)
    if (faults & bit)
      std::printf("  %s\n", meet::text_of(static_cast<meet::arithmetic_fault>(bit)));
  return faults != 0;
}
