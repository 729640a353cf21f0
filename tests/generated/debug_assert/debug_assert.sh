#!/usr/bin/env bash
# debug_assert.sh COMPILER SOURCE: a debug build ends where an operand is not valid, and says why. With NDEBUG nothing is
# left of the test, and the program has no symbol of it.
set -euo pipefail
compiler=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build() { "$compiler" -std=c++20 "${@:2}" "-I$source/runtime/kernel" "-I$source/generated/default" \
  "$source/tests/generated/debug_assert/ask.cpp" -o "$work/$1"; }
fail() { echo "FAILED: $1" && exit 1; }

build debug -O0 -DMEETC_PLAIN_INLINE
build release -O0 -DMEETC_PLAIN_INLINE -DNDEBUG
[ "$("$work/debug" 0.5)" = "hit 1, filter 1, fp32 1" ] || fail "a valid operand: $("$work/debug" 0.5)"
[ "$("$work/release" 0.5)" = "hit 1, filter 1, fp32 1" ] || fail "a valid operand: $("$work/release" 0.5)"
for bad in nan inf -1; do
  ! { "$work/debug" "$bad" >/dev/null 2>"$work/said"; } 2>/dev/null || fail "r = $bad is not told"
  grep -q 'an operand has a number that is not finite, or breaks the rule of its kind' "$work/said" || fail "$(cat "$work/said")"
  "$work/release" "$bad" >/dev/null || fail "r = $bad ends a release build"
done
nm -C "$work/debug" >"$work/debug.names"
nm -C "$work/release" >"$work/release.names"
grep -q '__assert_fail' "$work/debug.names" || fail "a debug build has no assertion"
! grep -qE '__assert_fail|cga::valid' "$work/release.names" || fail "a release build tests operands"
echo "invalid operands end a debug build, and cost a release build nothing"
