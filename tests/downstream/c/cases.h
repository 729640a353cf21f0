/* The same numbers for both programs: a lattice on which operands often share corners, planes and lines. */
#ifndef CASES_H
#define CASES_H
#include <stdint.h>

enum { cases = 3000 };
static uint32_t state = 1;

static float next_number(void) {
  state = state * 1664525u + 1013904223u;
  const int on_lattice = (int)(state >> 28) % 5 - 2;
  /* Every fourth lies a little off the lattice. */
  return (state >> 20 & 3u) == 0 ? (float)on_lattice + 0x1p-20f * (float)(state >> 12 & 7u) : (float)on_lattice;
}

static void fill(float *to, int count) {
  for (int i = 0; i < count; ++i)
    to[i] = next_number();
}
#endif
