#include "mixed.hpp"
#include "mixed_count.hpp"

long wrong_there(std::size_t n) {
  return wrong_of_all(n);
}
