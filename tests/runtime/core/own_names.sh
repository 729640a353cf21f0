#!/usr/bin/env bash
# own_names.sh NM SET OBJECT: the box tests of an instruction set give the linker their table and nothing else, so that no code
# of that set takes the place of the program's own.
set -euo pipefail
defined=$("$1" -C --defined-only --extern-only "$3" | sed 's/^[0-9a-f]* . //')
[ "$defined" = "meetc::$2::compiled_box_tests" ] || {
  echo "$3 defines: $defined"
  exit 1
}
