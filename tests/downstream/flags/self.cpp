// Prints the result of self_test(), every fault by its text. Exit code 1 where there is one.
#include <meetc/support.hpp>

#include <cstdio>

int main() {
  const unsigned faults = meetc::self_test();
  std::printf("faults %u: %s\n", faults, meetc::text_of_faults(faults));
  if (faults & static_cast<unsigned>(meetc::arithmetic_fault::reassociation))
    std::printf("reassociation\n");
  for (unsigned bit = 1; bit & meetc::fault_bits; bit <<= 1)
    if (faults & bit)
      std::printf("  %s\n", meetc::text_of(static_cast<meetc::arithmetic_fault>(bit)));
  return faults != 0;
}
