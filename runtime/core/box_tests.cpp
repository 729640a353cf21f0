#include "core/box_tests.hpp"

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

index_pair pair_of(const block_query &q, std::uint32_t theirs) {
  return q.swapped ? index_pair{theirs, q.slot} : index_pair{q.slot, theirs};
}

// The first block that a mask names.
struct leaf {
  std::uint32_t number;
  int lane; // of the box around it
};
leaf first_of(std::uint32_t mask, const leaf_query &q) {
  const int lane = std::countr_zero(mask);
  return {q.first + static_cast<std::uint32_t>(lane), lane};
}
// Those of the mask that are wanted.
std::uint32_t wanted(std::uint32_t mask, const leaf_query &q) {
  const std::uint32_t before = q.from > q.first ? q.from - q.first : 0;
  return before < lanes ? mask >> before << before : 0;
}

std::uint32_t touching_baseline(const box_block &block, const box &q) {
  return touching(block, q);
}
index_pair *pairs_baseline(const block_query &q, index_pair *out) {
  for (std::size_t i = 0; i < q.count; ++i)
    for (std::uint32_t left = touching(q.blocks[q.numbers[i]], q.around); left != 0; left &= left - 1)
      *out++ = pair_of(q, q.numbers[i] * lanes + static_cast<std::uint32_t>(std::countr_zero(left)));
  return out;
}

std::size_t leaves_baseline(const leaf_query &q, std::uint32_t *numbers, std::uint32_t *elements) {
  std::size_t n = 0;
  for (std::uint32_t left = wanted(touching(*q.around_leaves, q.around), q); left != 0; left &= left - 1) {
    const leaf at = first_of(left, q);
    numbers[n] = at.number;
    elements[n] = touching(*q.walker, q.around_leaves->get(at.lane));
    n += elements[n] != 0 && touching(q.leaves[at.number], q.around) != 0;
  }
  return n;
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
__attribute__((target("avx2"))) std::uint32_t touching_avx2(const box_block &block, const box &q) {
  return mask_avx2(block, sides_avx2(q));
}
__attribute__((target("avx2"))) index_pair *pairs_avx2(const block_query &q, index_pair *out) {
  const sides_8 sides = sides_avx2(q.around);
  for (std::size_t i = 0; i < q.count; ++i)
    for (std::uint32_t left = mask_avx2(q.blocks[q.numbers[i]], sides); left != 0; left &= left - 1)
      *out++ = pair_of(q, q.numbers[i] * lanes + static_cast<std::uint32_t>(std::countr_zero(left)));
  return out;
}
__attribute__((target("avx2"))) std::size_t leaves_avx2(const leaf_query &q, std::uint32_t *numbers,
                                                        std::uint32_t *elements) {
  const sides_8 sides = sides_avx2(q.around);
  std::size_t n = 0;
  for (std::uint32_t left = wanted(mask_avx2(*q.around_leaves, sides), q); left != 0; left &= left - 1) {
    const leaf at = first_of(left, q);
    numbers[n] = at.number;
    elements[n] = mask_avx2(*q.walker, sides_avx2(q.around_leaves->get(at.lane)));
    n += elements[n] != 0 && mask_avx2(q.leaves[at.number], sides) != 0;
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
__attribute__((target("avx512f"))) std::uint32_t touching_avx512(const box_block &block, const box &q) {
  return mask_avx512(block, sides_avx512(q));
}
// A pair is a number of 64 bits, so sixteen of them are two registers. All are stored, and those behind the end are
// written over.
__attribute__((target("avx512f"))) index_pair *pairs_avx512(const block_query &q, index_pair *out) {
  static_assert(sizeof(index_pair) == 8 && std::endian::native == std::endian::little);
  const sides_16 sides = sides_avx512(q.around);
  const __m512i each = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const unsigned my_shift = q.swapped ? 32 : 0, shift = 32 - my_shift;
  const __m512i mine = _mm512_maskz_slli_epi64(0xff, _mm512_set1_epi64(q.slot), my_shift);
  for (std::size_t i = 0; i < q.count; ++i) {
    const __mmask16 mask = mask_avx512(q.blocks[q.numbers[i]], sides);
    if (mask == 0)
      continue;
    const __m512i first = _mm512_set1_epi32(static_cast<int>(q.numbers[i] * lanes));
    const __m512i theirs = _mm512_maskz_compress_epi32(mask, _mm512_add_epi32(each, first));
    for (int half = 0; half < 2; ++half) {
      const __m256i eight =
          half == 0 ? _mm512_maskz_extracti64x4_epi64(0xf, theirs, 0) : _mm512_maskz_extracti64x4_epi64(0xf, theirs, 1);
      const __m512i wide = _mm512_maskz_slli_epi64(0xff, _mm512_maskz_cvtepu32_epi64(0xff, eight), shift);
      _mm512_storeu_si512(half == 0 ? out : out + lanes / 2, _mm512_or_si512(wide, mine));
    }
    out += std::popcount(static_cast<unsigned>(mask));
  }
  return out;
}
__attribute__((target("avx512f"))) std::size_t leaves_avx512(const leaf_query &q, std::uint32_t *numbers,
                                                             std::uint32_t *elements) {
  const sides_16 sides = sides_avx512(q.around);
  std::size_t n = 0;
  for (std::uint32_t left = wanted(mask_avx512(*q.around_leaves, sides), q); left != 0; left &= left - 1) {
    const leaf at = first_of(left, q);
    numbers[n] = at.number;
    elements[n] = mask_avx512(*q.walker, sides_avx512(q.around_leaves->get(at.lane)));
    n += elements[n] != 0 && mask_avx512(q.leaves[at.number], sides) != 0;
  }
  return n;
}

#endif

} // namespace

const box_tests *box_tests_for(instruction_set set) {
  static constexpr box_tests baseline{instruction_set::baseline, touching_baseline, pairs_baseline, leaves_baseline};
  if (!runs_here(set))
    return nullptr;
  switch (set) {
  case instruction_set::baseline:
    return &baseline;
#if MEETC_TARGETS
  case instruction_set::avx2: {
    static constexpr box_tests avx2{instruction_set::avx2, touching_avx2, pairs_avx2, leaves_avx2};
    return &avx2;
  }
  case instruction_set::avx512: {
    static constexpr box_tests avx512{instruction_set::avx512, touching_avx512, pairs_avx512, leaves_avx512};
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
