#include "meet/core/hierarchy/box_tests.hpp"

#include <bit>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#include <immintrin.h>
#define MEETC_TARGETS 1
// For functions that are inlined into one of the same set.
#define MEETC_PART_FOR(set) __attribute__((target(set), always_inline)) inline
#else
#define MEETC_TARGETS 0
#endif

namespace meetc {
namespace {

// The first element that a mask names, in a block with this number.
std::uint32_t first_of(std::uint32_t mask, std::uint32_t block) {
  return block * lanes + static_cast<std::uint32_t>(std::countr_zero(mask));
}
// The box around a block, from the blocks of the level above.
box around(std::uint32_t number, const box_block *above) {
  return above[number / lanes].get(number % lanes);
}

// The tests to come, element by element: the number of a block times lanes, plus the lane of an element that touches the
// box around it. elements[i] are those of numbers[i]. There is room for most_meetings.
std::size_t by_element(const std::uint32_t *numbers, const std::uint32_t *elements, std::size_t count,
                       std::uint32_t *tests) {
  std::size_t n = 0;
  for (std::uint32_t lane = 0; lane < lanes; ++lane)
    for (std::size_t i = 0; i < count; ++i) {
      tests[n] = numbers[i] * lanes + lane;
      n += elements[i] >> lane & 1;
    }
  return n;
}

std::size_t touched_baseline(const box_block *blocks, const std::uint32_t *numbers, std::size_t count, const box &q,
                             std::uint32_t *out) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::uint32_t left = touching(blocks[numbers[i]], q); left != 0; left &= left - 1)
      out[n++] = first_of(left, numbers[i]);
  return n;
}

std::size_t meetings_baseline(const meeting_query &q, meeting *out) {
  std::uint32_t numbers[lanes], elements[lanes]; // blocks, and the elements that touch the box around each
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < q.count; ++i) {
    const std::uint32_t number = numbers[blocks] = q.numbers[i];
    const std::uint32_t touches = touching(q.others[number], q.around) != 0;
    elements[blocks] = touching(*q.walker, around(number, q.around_others)) * touches;
    blocks += elements[blocks] != 0;
  }
  std::uint32_t tests[most_meetings];
  const std::size_t count = by_element(numbers, elements, blocks, tests);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t mask = touching(q.others[tests[i] / lanes], q.walker->get(tests[i] % lanes));
    out[n] = {tests[i], mask};
    n += mask != 0;
  }
  return n;
}

index_pair *pairs_of_baseline(const meeting *meetings, std::size_t n, std::uint32_t first, bool swapped,
                              index_pair *out) {
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t mine = first + meetings[i].lane();
    for (std::uint32_t left = meetings[i].mask; left != 0; left &= left - 1) {
      const std::uint32_t theirs = first_of(left, meetings[i].block());
      *out++ = swapped ? index_pair{theirs, mine} : index_pair{mine, theirs};
    }
  }
  return out;
}

#if MEETC_TARGETS

// ---- AVX2 ----

struct sides_8 {
  __m256 lo[3], hi[3];
};
MEETC_PART_FOR("avx2") sides_8 sides_avx2(const box &q) {
  sides_8 s;
  for (int k = 0; k < 3; ++k)
    s.lo[k] = _mm256_set1_ps(q.lo[k]), s.hi[k] = _mm256_set1_ps(q.hi[k]);
  return s;
}
MEETC_PART_FOR("avx2") std::uint32_t mask_avx2(const box_block &block, const sides_8 &q) {
  std::uint32_t apart = 0;
  for (int from = 0; from < lanes; from += 8) {
    __m256 any = _mm256_setzero_ps();
    for (int k = 0; k < 3; ++k) {
      const __m256 below = _mm256_cmp_ps(q.hi[k], _mm256_load_ps(block.lo[k] + from), _CMP_LT_OQ);
      const __m256 above = _mm256_cmp_ps(_mm256_load_ps(block.hi[k] + from), q.lo[k], _CMP_LT_OQ);
      any = _mm256_or_ps(any, _mm256_or_ps(below, above));
    }
    apart |= static_cast<std::uint32_t>(_mm256_movemask_ps(any)) << from;
  }
  return ~apart & 0xffff;
}
__attribute__((target("avx2"))) std::size_t touched_avx2(const box_block *blocks, const std::uint32_t *numbers,
                                                         std::size_t count, const box &q, std::uint32_t *out) {
  const sides_8 sides = sides_avx2(q);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::uint32_t left = mask_avx2(blocks[numbers[i]], sides); left != 0; left &= left - 1)
      out[n++] = first_of(left, numbers[i]);
  return n;
}
__attribute__((target("avx2"))) std::size_t meetings_avx2(const meeting_query &q, meeting *out) {
  const sides_8 sides = sides_avx2(q.around);
  std::uint32_t numbers[lanes], elements[lanes]; // blocks, and the elements that touch the box around each
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < q.count; ++i) {
    const std::uint32_t number = numbers[blocks] = q.numbers[i];
    const std::uint32_t touches = mask_avx2(q.others[number], sides) != 0;
    elements[blocks] = mask_avx2(*q.walker, sides_avx2(around(number, q.around_others))) * touches;
    blocks += elements[blocks] != 0;
  }
  std::uint32_t tests[most_meetings];
  const std::size_t count = by_element(numbers, elements, blocks, tests);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t mask = mask_avx2(q.others[tests[i] / lanes], sides_avx2(q.walker->get(tests[i] % lanes)));
    out[n] = {tests[i], mask};
    n += mask != 0;
  }
  return n;
}

// ---- AVX-512 ----

struct sides_16 {
  __m512 lo[3], hi[3];
};
MEETC_PART_FOR("avx512f") sides_16 sides_avx512(const box &q) {
  sides_16 s;
  for (int k = 0; k < 3; ++k)
    s.lo[k] = _mm512_set1_ps(q.lo[k]), s.hi[k] = _mm512_set1_ps(q.hi[k]);
  return s;
}
MEETC_PART_FOR("avx512f") __mmask16 mask_avx512(const box_block &block, const sides_16 &q) {
  // Two chains of comparisons, each of those lanes that the one before left. Not less: where one is NaN they touch.
  __mmask16 below = 0xffff, above = 0xffff;
  for (int k = 0; k < 3; ++k) {
    below = _mm512_mask_cmp_ps_mask(below, q.hi[k], _mm512_load_ps(block.lo[k]), _CMP_NLT_UQ);
    above = _mm512_mask_cmp_ps_mask(above, _mm512_load_ps(block.hi[k]), q.lo[k], _CMP_NLT_UQ);
  }
  return below & above;
}
// The numbers block * lanes + lane of the lanes in a mask, at the front.
MEETC_PART_FOR("avx512f") __m512i numbers_avx512(__mmask16 mask, std::uint32_t block) {
  const __m512i each = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m512i first = _mm512_set1_epi32(static_cast<int>(block * lanes));
  return _mm512_maskz_compress_epi32(mask, _mm512_add_epi32(each, first));
}
// All sixteen numbers are stored, and those behind the end are written over.
__attribute__((target("avx512f"))) std::size_t touched_avx512(const box_block *blocks, const std::uint32_t *numbers,
                                                              std::size_t count, const box &q, std::uint32_t *out) {
  const sides_16 sides = sides_avx512(q);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const __mmask16 mask = mask_avx512(blocks[numbers[i]], sides);
    _mm512_storeu_si512(out + n, numbers_avx512(mask, numbers[i]));
    n += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(mask)));
  }
  return n;
}
// A pair is a number of 64 bits, so sixteen of them are two registers. All are stored, and those behind the end are
// written over.
struct pairs_of_slot {
  __m512i mine;
  unsigned shift; // of the other element
};
MEETC_PART_FOR("avx512f") pairs_of_slot slot_avx512(std::uint32_t slot, bool swapped) {
  static_assert(sizeof(index_pair) == 8 && std::endian::native == std::endian::little);
  const unsigned my_shift = swapped ? 32 : 0;
  return {_mm512_maskz_slli_epi64(0xff, _mm512_set1_epi64(slot), my_shift), 32 - my_shift};
}
MEETC_PART_FOR("avx512f")
index_pair *store_avx512(__mmask16 mask, std::uint32_t block, const pairs_of_slot &of, index_pair *out) {
  const __m512i theirs = numbers_avx512(mask, block);
  for (int half = 0; half < 2; ++half) {
    const __m256i eight =
        half == 0 ? _mm512_maskz_extracti64x4_epi64(0xf, theirs, 0) : _mm512_maskz_extracti64x4_epi64(0xf, theirs, 1);
    const __m512i wide = _mm512_maskz_slli_epi64(0xff, _mm512_maskz_cvtepu32_epi64(0xff, eight), of.shift);
    _mm512_storeu_si512(half == 0 ? out : out + lanes / 2, _mm512_or_si512(wide, of.mine));
  }
  return out + std::popcount(static_cast<unsigned>(mask));
}
__attribute__((target("avx512f"))) std::size_t meetings_avx512(const meeting_query &q, meeting *out) {
  const sides_16 sides = sides_avx512(q.around);
  alignas(64) std::uint32_t elements[lanes] = {}; // that touch the box around each block
  for (std::size_t i = 0; i < q.count; ++i) {
    const std::uint32_t number = q.numbers[i];
    const std::uint32_t touches = mask_avx512(q.others[number], sides) != 0;
    elements[i] = mask_avx512(*q.walker, sides_avx512(around(number, q.around_others))) * touches;
  }
  // The tests to come, by element.
  const __m512i of_blocks = _mm512_load_si512(elements);
  const auto asked = static_cast<__mmask16>((std::uint32_t{1} << q.count) - 1);
  const __m512i first = _mm512_maskz_slli_epi32(0xffff, _mm512_maskz_loadu_epi32(asked, q.numbers), 4);
  std::uint32_t tests[most_meetings];
  std::size_t count = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const __mmask16 blocks = _mm512_test_epi32_mask(of_blocks, _mm512_set1_epi32(1 << lane));
    const __m512i all = _mm512_or_si512(first, _mm512_set1_epi32(lane));
    _mm512_storeu_si512(tests + count, _mm512_maskz_compress_epi32(blocks, all));
    count += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(blocks)));
  }
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t mask = mask_avx512(q.others[tests[i] / lanes], sides_avx512(q.walker->get(tests[i] % lanes)));
    out[n].block_and_lane = tests[i];
    out[n].mask = mask;
    n += mask != 0;
  }
  return n;
}
__attribute__((target("avx512f"))) index_pair *pairs_of_avx512(const meeting *meetings, std::size_t n,
                                                               std::uint32_t first, bool swapped, index_pair *out) {
  for (std::size_t i = 0; i < n; ++i)
    out = store_avx512(static_cast<__mmask16>(meetings[i].mask), meetings[i].block(),
                       slot_avx512(first + meetings[i].lane(), swapped), out);
  return out;
}

#endif

} // namespace

const box_tests *box_tests_for(instruction_set set) {
  static constexpr box_tests baseline{instruction_set::baseline, touched_baseline, meetings_baseline,
                                      pairs_of_baseline};
  if (!runs_here(set))
    return nullptr;
  switch (set) {
  case instruction_set::baseline:
    return &baseline;
#if MEETC_TARGETS
  case instruction_set::avx2: {
    static constexpr box_tests avx2{instruction_set::avx2, touched_avx2, meetings_avx2, pairs_of_baseline};
    return &avx2;
  }
  case instruction_set::avx512: {
    static constexpr box_tests avx512{instruction_set::avx512, touched_avx512, meetings_avx512, pairs_of_avx512};
    return &avx512;
  }
#endif
  default:
    return nullptr;
  }
}

const box_tests &best_box_tests() {
  static const box_tests &best = [&]() -> const box_tests & {
    for (int i = instruction_set_count; i-- > 1;)
      if (const box_tests *const tests = box_tests_for(static_cast<instruction_set>(i)))
        return *tests;
    return *box_tests_for(instruction_set::baseline);
  }();
  return best;
}

} // namespace meetc
