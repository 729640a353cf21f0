# meetc_add_instruction_sets(TARGET SETS CHOICE SOURCE ...): compiles sources once more for each of the instruction sets in the
# list SETS, and adds them to the target's library, which chooses when the program starts. CHOICE is the source that holds the
# choice, such as NAMESPACE_runtime.cpp, and SOURCES are those of predicates. Known
# sets are avx2 (with fma) and avx512. They are left out for a processor other than x86-64: 64-bit Arm has NEON and fma in
# its baseline.
function(meetc_add_instruction_sets target sets choice)
  set(flags_of_avx2 -mavx2 -mfma)
  set(flags_of_avx512 -mavx2 -mfma -mavx512f -mavx512bw -mavx512dq -mavx512vl -mprefer-vector-width=512)
  foreach(set IN LISTS sets)
    if(NOT DEFINED flags_of_${set})
      message(FATAL_ERROR "${target}: no instruction set '${set}'; known: avx2, avx512")
    endif()
    if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" OR NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      continue()
    endif()
    add_library(${target}_${set} OBJECT ${choice} ${ARGN})
    target_compile_features(${target}_${set} PRIVATE cxx_std_20)
    target_include_directories(${target}_${set} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    get_target_property(position_independent ${target} POSITION_INDEPENDENT_CODE)
    if(position_independent)
      set_target_properties(${target}_${set} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    target_compile_options(${target}_${set} PRIVATE ${flags_of_${set}} -ffp-contract=off)
    target_compile_definitions(${target}_${set} PRIVATE MEETC_INSTRUCTION_SET=${set})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${set}>)
    set_property(SOURCE ${choice} APPEND PROPERTY COMPILE_DEFINITIONS MEETC_WITH_${set})
  endforeach()
endfunction()
