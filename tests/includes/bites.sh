#!/usr/bin/env bash
# bites.sh: a small tree that keeps the order passes includes.sh, and each fault that is planted in it is reported with its
# location.
set -euo pipefail
check=$(cd "$(dirname "$0")" && pwd)/includes.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"

# put FILE LINE...
put() {
  local file=$1
  shift
  mkdir -p "$(dirname "$file")"
  printf '%s\n' "$@" >"$file"
}
sound() {
  rm -rf gen runtime generated
  put gen/support/source.hpp '#include <string>'
  put gen/lang/load.hpp '#include "gen/support/source.hpp"'
  put gen/algebra/metric.hpp '#include <string>'
  put gen/ir/arena.hpp '#include "gen/support/source.hpp"'
  put gen/bound/bound.hpp '#include "gen/ir/arena.hpp"'
  put gen/lower/kernel.hpp '#include "gen/bound/bound.hpp"' '#include "gen/lang/load.hpp"'
  put gen/target/text.cpp '#include "gen/lower/kernel.hpp"' '#include <fmt/format.h>'
  put gen/oracle/dense.hpp '#include <gmpxx.h>'
  put gen/verify/verify.cpp '#include "gen/oracle/dense.hpp"' '#include "gen/lower/kernel.hpp"'
  put gen/driver.cpp '#include "gen/lower/kernel.hpp"'
  put runtime/kernel/meetc/table.hpp '#include <cstdint>'
  put runtime/core/view.hpp '#include "meetc/table.hpp"'
  put runtime/core/device/set.hpp '#include "core/view.hpp"'
  put runtime/core/device/every_pair/engine.hpp '#include "core/device/set.hpp"' '#include "meetc/every_pair/table.hpp"'
  put runtime/kernel/meetc/every_pair/table.hpp '#include <meetc/table.hpp>'
  put runtime/kernel/meetc/cuda_table.hpp '#include <meetc/table.hpp>'
  put runtime/io/read.hpp '#include "core/view.hpp"'
  put runtime/app/sets.cpp '#include "io/read.hpp"' '#include <cga/cga.hpp>'
  put runtime/bench/peers/peers.hpp '#include "meetc/table.hpp"'
  put runtime/bench/baselines/vectors.hpp '#include "core/view.hpp"'
  put runtime/bench/truth/distance.hpp '#include "bench/baselines/vectors.hpp"'
  put runtime/bench/harness/table.hpp '#include "core/view.hpp"' '#include "bench/peers/peers.hpp"'
  put runtime/bench/scenes/sets.hpp '#include "bench/truth/distance.hpp"'
  put runtime/bench/tables/read.hpp '#include "bench/harness/table.hpp"' '#include "bench/scenes/sets.hpp"' \
    '#include "core/device/every_pair/engine.hpp"'
  put runtime/main.cpp '#include "bench/tables/read.hpp"'
  put generated/default/cga/cga.hpp '#include <meetc/table.hpp>' '#include <cga/kinds.hpp>' '#include <cmath>'
  put generated/default/cga/kinds.hpp '#include <meetc/table.hpp>'
}

# refused TEXT FILE LINE: with LINE at the end of FILE the check fails with a message that contains TEXT.
refused() {
  local said
  sound
  mkdir -p "$(dirname "$2")"
  echo "$3" >>"$2"
  if said=$("$check" . 2>&1); then
    echo "FAILED: passes with $3 in $2"
    exit 1
  fi
  [[ $said == *"$1"* ]] || {
    echo "FAILED: with $3 in $2 it says: $said"
    exit 1
  }
}

sound
"$check" . >/dev/null
refused "gen/support/source.hpp:2: gen/support may not include gen/lang" gen/support/source.hpp '#include "gen/lang/load.hpp"'
refused "gen/bound/bound.hpp:2: gen/bound may not include gen/lower" gen/bound/bound.hpp '#  include "gen/lower/kernel.hpp"'
refused "gen/ir/arena.hpp:2: gen/ir may not include gen (" gen/ir/arena.hpp '#include "gen/driver.cpp"'
refused "gen/oracle may not include gen/support" gen/oracle/dense.hpp '#include "gen/support/source.hpp"'
refused "gen/lower may not include gen/oracle" gen/lower/kernel.hpp '#include "gen/oracle/dense.hpp"'
refused "gen/verify may not include gen/target" gen/verify/verify.cpp '#include "gen/target/text.cpp"'
refused "gen/target may not include gen/verify" gen/target/text.cpp '#include "gen/verify/verify.cpp"'
refused "gen/target may not include gen/algebra" gen/target/text.cpp '#include "gen/algebra/metric.hpp"'
refused "gen/target may not include runtime/kernel" gen/target/text.cpp '#include <meetc/table.hpp>'
refused "gen/target may not include generated" gen/target/text.cpp '#include <cga/cga.hpp>'
refused "runtime/core may not include runtime/io" runtime/core/view.hpp '#include "io/read.hpp"'
refused "runtime/core may not include runtime/core/device" runtime/core/view.hpp '#include "core/device/set.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/core/device/set.hpp \
  '#include "meetc/every_pair/table.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/app/sets.cpp \
  '#include "core/device/every_pair/engine.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/kernel/meetc/cuda_table.hpp \
  '#include <meetc/every_pair/table.hpp>'
refused "runtime/core may not include generated" runtime/core/view.hpp '#include <cga/cga.hpp>'
refused "runtime/app may not include runtime/bench/harness" runtime/app/sets.cpp '#include "bench/harness/table.hpp"'
refused "runtime/bench/peers may not include runtime/bench/harness" runtime/bench/peers/peers.hpp '#include "bench/harness/table.hpp"'
refused "runtime/bench/harness may not include runtime/bench/tables" runtime/bench/harness/table.hpp '#include "bench/tables/read.hpp"'
refused "runtime/bench/truth may not include runtime/app" runtime/bench/truth/distance.hpp '#include "app/sets.cpp"'
refused "runtime/bench/truth may not include runtime/core" runtime/bench/truth/distance.hpp '#include "core/view.hpp"'
refused "this file lies in no room of the order" runtime/bench/new.hpp '#include <string>'
refused "runtime/io may not include generated" runtime/io/read.hpp '#include <cga/cga.hpp>'
refused "runtime/io may not include gen/support" runtime/io/read.hpp '#include "gen/support/source.hpp"'
refused "generated may not include runtime/core" generated/default/cga/cga.hpp '#include "core/view.hpp"'
refused "generated code includes <meetc/...> and its own files, not <fmt/format.h>" generated/default/cga/kinds.hpp '#include <fmt/format.h>'
refused '"nowhere.hpp" is no file of this tree' gen/lang/load.hpp '#include "nowhere.hpp"'
refused "this file lies in no room of the order" gen/somewhere/new.hpp '#include <string>'
crowd() {
  for i in {1..24}; do put runtime/bench/scenes/$i.hpp '#include <string>'; done
  "$check" . >/dev/null || return 1
  ! said=$(put runtime/bench/scenes/25.hpp '#include <string>' && "$check" . 2>&1) && [[ $said == *"runtime/bench/scenes: holds 26 files"* ]]
}
sound
crowd || {
  echo "FAILED: 25 or 26 files in a folder of benchmarks"
  exit 1
}
refused "a cycle of includes: generated/default/cga/" generated/default/cga/kinds.hpp '#include <cga/cga.hpp>'
echo "a sound tree passes, and each fault is reported"
