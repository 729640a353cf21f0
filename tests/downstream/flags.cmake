# The checked-in headers under a user's flags, without library and CMake: no certified answer may be wrong. Flags that
# break the arithmetic itself are refused, or each call notices them and then uses only integers.
include("${CMAKE_CURRENT_LIST_DIR}/flags_steps.cmake")
set(sound "standard 1, faults 0:" "${right}" "0 transforms inexact" "words: 13 noticed, 0 missed, 0 lacking; 0 certified wrong, 0 hits wrong")

# refused(COMPILER TEXT FLAGS ...): each set of flags stops the compilation with a message that contains TEXT.
function(refused compiler text)
  foreach(flags IN LISTS ARGN)
    string(REPLACE " " ";" flags "${flags}")
    run_to_fail("${compiler}" -std=c++20 ${flags} ${headers} -fsyntax-only "${ROOM}/flags/self.cpp")
    expect("${text}")
  endforeach()
endfunction()

foreach(compiler IN ITEMS ${GXX} ${CLANGXX})
  # Harmless flags, contraction among them: the transforms stand behind barriers, and the bounds hold with or without it.
  # One of the compilers takes all predicates.
  set(plain "-O2" ${few})
  if("${compiler}" STREQUAL "${GXX}")
    set(plain "-O2")
  endif()
  foreach(flags IN ITEMS "${plain}" "-O3;-march=native;-ffp-contract=fast;${few}")
    run_hostile("${compiler}" ${flags})
    expect(${sound})
  endforeach()
  # Only the self-test, at the optimisation levels that the programs above do not use.
  set(levels "-O0" "-O1")
  if(LONG)
    list(APPEND levels "-O2" "-O3" "-O2\;-march=native\;-ffp-contract=fast" "-O2\;-ffp-contract=off")
  endif()
  foreach(flags IN LISTS levels)
    compile("${compiler}" self ${flags} ${strict} "${ROOM}/flags/self.cpp")
    run("${ROOM}/self")
    expect("faults 0: the arithmetic is as the error bounds assume")
  endforeach()
  # These are refused.
  refused("${compiler}" "compile without it" "-ffast-math" "-Ofast" "-ffinite-math-only" "-O2 -ffast-math -march=native")
  # One object of the program is linked with -ffast-math: subnormals are flushed in all of it. Hits are right all the same.
  run("${compiler}" -std=c++20 -O2 ${few} ${headers} -c "${hostile}" -o "${ROOM}/hostile.o")
  run("${compiler}" -ffast-math "${ROOM}/hostile.o" -o "${ROOM}/hostile")
  run("${ROOM}/hostile")
  expect("standard 0," "subnormal numbers are flushed to zero" "${right}")
  # The fma() of this C library rounds twice. The self-test says so, for plain rungs; certified ones use none.
  run("${compiler}" "${ROOM}/hostile.o" "${ROOM}/flags/twice.cpp" -o "${ROOM}/hostile")
  run("${ROOM}/hostile")
  expect("fma() is not rounded once" "${right}")
  # The control word is changed between calls.
  compile("${compiler}" switched -O2 ${strict} "${ROOM}/flags/switched.cpp")
  run("${ROOM}/switched")
  expect("0 wrong beside changes of the control word")
endforeach()

# gcc defines macros if sums are reassociated or intermediate results are wide; clang does not, and the calls notice.
set(reassociating "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math" "-O2 -funsafe-math-optimizations")
if(GXX)
  refused("${GXX}" "compile without it" ${reassociating} "-fsingle-precision-constant")
  execute_process(COMMAND "${GXX}" -dumpmachine OUTPUT_VARIABLE machine)
  if(machine MATCHES "^x86_64")
    refused("${GXX}" "intermediate results are wider" "-mfpmath=387" "-mfpmath=both")
  endif()
endif()
if(CLANGXX)
  foreach(flags IN LISTS reassociating)
    string(REPLACE " " ";" flags "${flags}")
    compile("${CLANGXX}" self ${flags} "${ROOM}/flags/self.cpp")
    run_to_fail("${ROOM}/self")
    expect("reassociation")
  endforeach()
endif()
