// The tests of one instruction set. This is compiled once for each, with MEETC_INSTRUCTION_SET, and for the program's own
// flags, and then holds the choice too. A unit for a set of its own must emit no inline function of another header: it uses
// plain data of these alone.
#include "meet/core/hierarchy/box_tests.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

MEETC_NAMESPACE(meetc) {

namespace {

// Three steps of each test: mask_of() finds the lanes of a block that a box touches, put_lanes() writes the numbers
// block * lanes + lane of those in a mask, and put_pairs() their pairs with an element. The latter two return the end.
//
#if defined(__AVX512F__)

struct sides {
  __m512 lo[3], hi[3];
};
sides sides_of(const box &q) {
  sides s;
  for (int k = 0; k < 3; ++k)
    s.lo[k] = _mm512_set1_ps(q.lo[k]), s.hi[k] = _mm512_set1_ps(q.hi[k]);
  return s;
}
std::uint32_t mask_of(const box_block &block, const sides &q) {
  // Two chains of comparisons, each of those lanes that the one before left. Not less: where one is NaN they touch.
  __mmask16 below = 0xffff, above = 0xffff;
  for (int k = 0; k < 3; ++k) {
    below = _mm512_mask_cmp_ps_mask(below, q.hi[k], _mm512_load_ps(block.lo[k]), _CMP_NLT_UQ);
    above = _mm512_mask_cmp_ps_mask(above, _mm512_load_ps(block.hi[k]), q.lo[k], _CMP_NLT_UQ);
  }
  return below & above;
}

__m512i numbers_of(std::uint32_t mask, std::uint32_t block) {
  const __m512i each = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m512i first = _mm512_set1_epi32(static_cast<int>(block * lanes));
  return _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), _mm512_add_epi32(each, first));
}
// All sixteen numbers are stored, and those behind the end are written over.
std::uint32_t *put_lanes(std::uint32_t mask, std::uint32_t block, std::uint32_t *out) {
  _mm512_storeu_si512(out, numbers_of(mask, block));
  return out + __builtin_popcount(mask);
}
// A pair is a number of 64 bits, so sixteen of them are two registers. All are stored, and those behind the end are
// written over.
index_pair *put_pairs(std::uint32_t mask, std::uint32_t block, std::uint32_t slot, bool swapped, index_pair *out) {
  static_assert(sizeof(index_pair) == 8 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  const unsigned shift = swapped ? 32 : 0; // of the slot
  const __m512i mine = _mm512_maskz_slli_epi64(0xff, _mm512_set1_epi64(slot), shift), theirs = numbers_of(mask, block);
  for (int half = 0; half < 2; ++half) {
    const __m256i eight =
        half == 0 ? _mm512_maskz_extracti64x4_epi64(0xf, theirs, 0) : _mm512_maskz_extracti64x4_epi64(0xf, theirs, 1);
    const __m512i wide = _mm512_maskz_slli_epi64(0xff, _mm512_maskz_cvtepu32_epi64(0xff, eight), 32 - shift);
    _mm512_storeu_si512(half == 0 ? out : out + lanes / 2, _mm512_or_si512(wide, mine));
  }
  return out + __builtin_popcount(mask);
}

#else

#if defined(__AVX2__)
struct sides {
  __m256 lo[3], hi[3];
};
sides sides_of(const box &q) {
  sides s;
  for (int k = 0; k < 3; ++k)
    s.lo[k] = _mm256_set1_ps(q.lo[k]), s.hi[k] = _mm256_set1_ps(q.hi[k]);
  return s;
}
std::uint32_t mask_of(const box_block &block, const sides &q) {
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
#else
const box &sides_of(const box &q) {
  return q;
}
std::uint32_t mask_of(const box_block &block, const box &q) {
  return touching(block, q);
}
#endif

// The first number that a mask names.
std::uint32_t first_of(std::uint32_t mask, std::uint32_t block) {
  return block * lanes + static_cast<std::uint32_t>(__builtin_ctz(mask));
}
std::uint32_t *put_lanes(std::uint32_t mask, std::uint32_t block, std::uint32_t *out) {
  for (; mask != 0; mask &= mask - 1)
    *out++ = first_of(mask, block);
  return out;
}
index_pair *put_pairs(std::uint32_t mask, std::uint32_t block, std::uint32_t slot, bool swapped, index_pair *out) {
  for (; mask != 0; mask &= mask - 1) {
    const std::uint32_t theirs = first_of(mask, block);
    *out++ = swapped ? index_pair{theirs, slot} : index_pair{slot, theirs};
  }
  return out;
}

#endif

box box_in(const box_block &of, std::uint32_t lane) {
  return {{of.lo[0][lane], of.lo[1][lane], of.lo[2][lane]}, {of.hi[0][lane], of.hi[1][lane], of.hi[2][lane]}};
}

std::size_t touched(const box_block *blocks, const std::uint32_t *numbers, std::size_t count, const box &q,
                    std::uint32_t *out) {
  const auto &s = sides_of(q);
  std::uint32_t *end = out;
  for (std::size_t i = 0; i < count; ++i)
    end = put_lanes(mask_of(blocks[numbers[i]], s), numbers[i], end);
  return static_cast<std::size_t>(end - out);
}

// The tests to come, element by element: the number of a block times lanes, plus the lane of an element that touches the
// box around it. elements[i] are those of numbers[i], and 0 from `count` on. There is room for most_meetings.
std::size_t by_element(const std::uint32_t *numbers, const std::uint32_t *elements, std::size_t count,
                       std::uint32_t *tests) {
  std::size_t n = 0;
#if defined(__AVX512F__)
  static_cast<void>(count);
  const __m512i of_blocks = _mm512_load_si512(elements),
                first = _mm512_maskz_slli_epi32(0xffff, _mm512_load_si512(numbers), 4);
  for (int lane = 0; lane < lanes; ++lane) {
    const __mmask16 blocks = _mm512_test_epi32_mask(of_blocks, _mm512_set1_epi32(1 << lane));
    const __m512i all = _mm512_or_si512(first, _mm512_set1_epi32(lane));
    _mm512_storeu_si512(tests + n, _mm512_maskz_compress_epi32(blocks, all));
    n += static_cast<std::size_t>(__builtin_popcount(blocks));
  }
#else
  for (std::uint32_t lane = 0; lane < lanes; ++lane)
    for (std::size_t i = 0; i < count; ++i) {
      tests[n] = numbers[i] * lanes + lane;
      n += elements[i] >> lane & 1;
    }
#endif
  return n;
}

std::size_t meetings(const meeting_query &q, meeting *out) {
  const auto &s = sides_of(q.around);
  alignas(64) std::uint32_t numbers[lanes] = {}, elements[lanes] = {}; // that touch the box around each block
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < q.count; ++i) {
    const std::uint32_t number = numbers[blocks] = q.numbers[i];
    const std::uint32_t touches = mask_of(q.others[number], s) != 0;
    const box whole = box_in(q.around_others[number / lanes], number % lanes);
    elements[blocks] = mask_of(*q.walker, sides_of(whole)) * touches;
    blocks += elements[blocks] != 0;
  }
  std::uint32_t tests[most_meetings];
  const std::size_t count = by_element(numbers, elements, blocks, tests);
  std::size_t n = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const box one = box_in(*q.walker, tests[i] % lanes);
    const std::uint32_t mask = mask_of(q.others[tests[i] / lanes], sides_of(one));
    out[n].block_and_lane = tests[i];
    out[n].mask = mask;
    n += mask != 0;
  }
  return n;
}

index_pair *pairs_of(const meeting *of, std::size_t n, std::uint32_t first, bool swapped, index_pair *out) {
  for (std::size_t i = 0; i < n; ++i)
    out = put_pairs(of[i].mask, of[i].block_and_lane / lanes, first + of[i].block_and_lane % lanes, swapped, out);
  return out;
}

} // namespace

extern const box_tests compiled_box_tests;
constexpr box_tests compiled_box_tests{MEETC_COMPILED_FOR, touched, meetings, pairs_of};

} // MEETC_NAMESPACE(meetc)

#if !defined(MEETC_INSTRUCTION_SET)
namespace meetc {

#if defined(MEETC_WITH_avx2)
namespace avx2 {
extern const box_tests compiled_box_tests;
}
#endif
#if defined(MEETC_WITH_avx512)
namespace avx512 {
extern const box_tests compiled_box_tests;
}
#endif

const box_tests *box_tests_for(instruction_set set) {
  if (!runs_here(set))
    return nullptr;
  switch (set) {
  case instruction_set::baseline:
    return &compiled_box_tests;
#if defined(MEETC_WITH_avx2)
  case instruction_set::avx2:
    return &avx2::compiled_box_tests;
#endif
#if defined(MEETC_WITH_avx512)
  case instruction_set::avx512:
    return &avx512::compiled_box_tests;
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
    return compiled_box_tests;
  }();
  return best;
}

} // namespace meetc
#endif
