#include <cell/cell.hpp>
#include <cell/cell_runtime.hpp>
#include <cstdio>
#include <odd/odd.hpp>
#include <odd/odd_runtime.hpp>
#include <other/other.hpp>
#include <other/other_runtime.hpp>

int second();

int main() {
  std::printf("%d %d %d\n", cell::catalogue().predicate_count, other::catalogue().predicate_count,
              odd::catalogue().predicate_count);
  for (int i = 0; i < odd::catalogue().predicate_count; ++i)
    std::printf("%s of %s\n", odd::catalogue().predicates[i].name, odd::catalogue().predicates[i].a->name);
  std::printf("second %d\n", second());
}
