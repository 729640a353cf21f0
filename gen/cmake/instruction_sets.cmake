# meetc_add_instruction_sets(TARGET RUNTIME_SOURCE SOURCE ...): compiles the sources of generated kernels once more for
# each instruction set that the processor may have, and adds them to the target's library, which chooses when the program
# starts. RUNTIME_SOURCE is NAMESPACE_runtime.cpp, which holds the choice, and SOURCES are the predicates' sources.
# MEETC_INSTRUCTION_SETS names the sets: by default avx2 (with fma) and avx512 on x86-64, and none elsewhere, since 64-bit
# Arm has NEON and fma in its baseline.
set(default_sets "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(default_sets avx2 avx512)
endif()
set(MEETC_INSTRUCTION_SETS "${default_sets}" CACHE STRING "Instruction sets to compile the kernels for besides the baseline")

function(meetc_add_instruction_sets target runtime_source)
  set(flags_of_avx2 -mavx2 -mfma)
  set(flags_of_avx512 -mavx2 -mfma -mavx512f -mavx512bw -mavx512dq -mavx512vl -mprefer-vector-width=512)
  foreach(set IN LISTS MEETC_INSTRUCTION_SETS)
    if(NOT DEFINED flags_of_${set})
      message(FATAL_ERROR "MEETC_INSTRUCTION_SETS: no instruction set '${set}'; known: avx2, avx512")
    endif()
    add_library(${target}_${set} OBJECT ${runtime_source} ${ARGN})
    target_compile_features(${target}_${set} PRIVATE cxx_std_20)
    target_include_directories(${target}_${set} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    # -O2: lanes are vectors already, and -O3 takes half as long again.
    target_compile_options(${target}_${set} PRIVATE ${flags_of_${set}} -ffp-contract=off
      $<$<NOT:$<CONFIG:Debug>>:-O2>)
    target_compile_definitions(${target}_${set} PRIVATE MEETC_INSTRUCTION_SET=${set})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${set}>)
    set_property(SOURCE ${runtime_source} APPEND PROPERTY COMPILE_DEFINITIONS MEETC_WITH_${set})
  endforeach()
endfunction()
