// Code that is compiled for several instruction sets into one program.
//
// Problem: an inline function that two units compile with different flags has one name, and the linker keeps one copy:
// perhaps the one with instructions that the processor lacks.
// Method: a unit that is compiled for an instruction set of its own defines MEETC_INSTRUCTION_SET, and all functions of
// the kernel headers and of the emitted ones then stand in an inline namespace of that name, so none is shared. The plain
// types of table.hpp and of logic.hpp's first part are common to all, and such a unit is reached through a table of
// functions alone.
#ifndef MEETC_ENVIRONMENT_INSTRUCTION_SET_HPP
#define MEETC_ENVIRONMENT_INSTRUCTION_SET_HPP

#include <cstdint>

#if defined(MEETC_INSTRUCTION_SET)
#define MEETC_NAMESPACE(space) namespace space::inline MEETC_INSTRUCTION_SET
#define MEETC_COMPILED_FOR ::meetc::instruction_set::MEETC_INSTRUCTION_SET
#else
#define MEETC_NAMESPACE(space) namespace space
#define MEETC_COMPILED_FOR ::meetc::instruction_set::baseline
#endif

namespace meetc {

// The instruction sets for which kernels are compiled. `baseline` is that of the whole program: on x86-64 SSE2 unless
// its builder says more, on 64-bit Arm NEON.
enum class instruction_set : std::uint8_t { baseline, avx2, avx512 };
inline constexpr int instruction_set_count = 3;

constexpr const char *name_of(instruction_set s) {
  constexpr const char *names[] = {"baseline", "avx2", "avx512"};
  return names[static_cast<int>(s)];
}

// Whether this processor and the operating system support it.
inline bool runs_here(instruction_set s) {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__)) && !defined(__CUDA_ARCH__)
  switch (s) {
  case instruction_set::baseline:
    return true;
  case instruction_set::avx2:
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  case instruction_set::avx512:
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  }
  return false;
#else
  return s == instruction_set::baseline;
#endif
}

} // namespace meetc

#endif
