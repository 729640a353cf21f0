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
  rm -rf gen runtime generated tests
  put gen/support/source.hpp '#include <string>'
  put gen/lang/load.hpp '#include "gen/support/source.hpp"'
  put gen/algebra/metric.hpp '#include <string>'
  put gen/ir/arena.hpp '#include "gen/support/source.hpp"'
  put gen/bound/bound.hpp '#include "gen/ir/arena.hpp"'
  put gen/lower/expand/model.hpp '#include "gen/lang/load.hpp"'
  put gen/lower/kernel/kernel.hpp '#include "gen/bound/bound.hpp"' '#include "gen/lower/expand/model.hpp"'
  put gen/target/target.hpp '#include "gen/lower/kernel/kernel.hpp"' '#include <fmt/format.h>'
  put gen/target/text/text.cpp '#include "gen/target/target.hpp"'
  put gen/target/registry/registry.cpp '#include "gen/target/target.hpp"'
  put gen/oracle/dense.hpp '#include <gmpxx.h>'
  put gen/verify/verify.cpp '#include "gen/oracle/dense.hpp"' '#include "gen/lower/kernel/kernel.hpp"'
  put gen/driver.cpp '#include "gen/lower/kernel/kernel.hpp"'
  put runtime/kernel/meetc/number/grid.hpp '#include <cstdint>'
  put runtime/kernel/meetc/table/table.hpp '#include <cstdint>'
  put runtime/kernel/meetc/support.hpp '#include <meetc/table/table.hpp>'
  put runtime/core/views/view.hpp '#include "meetc/table/table.hpp"'
  put runtime/core/query/collide.hpp '#include "meet/core/views/view.hpp"'
  put runtime/core/device/set.hpp '#include "meet/core/query/collide.hpp"'
  put runtime/core/device/every_pair/engine.hpp '#include "meet/core/device/set.hpp"' '#include "meetc/every_pair/table.hpp"'
  put runtime/kernel/meetc/every_pair/table.hpp '#include <meetc/table/table.hpp>'
  put runtime/kernel/meetc/cuda/table.hpp '#include <meetc/table/table.hpp>'
  put runtime/io/read.hpp '#include "meet/core/views/view.hpp"'
  put runtime/app/input/sets.cpp '#include "meet/io/read.hpp"' '#include <cga/cga.hpp>'
  put runtime/bench/peers/peers.hpp '#include "meetc/table/table.hpp"'
  put runtime/bench/baselines/vectors.hpp '#include "meet/core/views/view.hpp"'
  put runtime/bench/truth/distance.hpp '#include "meet/bench/baselines/vectors.hpp"'
  put runtime/bench/harness/table.hpp '#include "meet/core/views/view.hpp"' '#include "meet/bench/peers/peers.hpp"'
  put runtime/bench/scenes/sets.hpp '#include "meet/bench/truth/distance.hpp"'
  put runtime/bench/tables/read.hpp '#include "meet/bench/harness/table.hpp"' '#include "meet/bench/scenes/sets.hpp"' \
    '#include "meet/core/device/every_pair/engine.hpp"'
  put runtime/main.cpp '#include "meet/bench/tables/read.hpp"'
  put generated/default/cga/cga.hpp '#include <meetc/support.hpp>' '#include <cga/kinds.hpp>' '#include <cmath>'
  put generated/default/cga/kinds.hpp '#include <meetc/support.hpp>'
  put tests/one/judge.hpp '#include <cga/cga.hpp>'
  put tests/two/test_judge.cpp '#include "tests/one/judge.hpp"' '#include "meet/core/device/every_pair/engine.hpp"'
  put tests/two/judge.hpp '#include <string>'
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
refused "gen/bound/bound.hpp:2: gen/bound may not include gen/lower" gen/bound/bound.hpp \
  '#  include "gen/lower/kernel/kernel.hpp"'
refused "gen/ir/arena.hpp:2: gen/ir may not include gen (" gen/ir/arena.hpp '#include "gen/driver.cpp"'
refused "gen/oracle may not include gen/support" gen/oracle/dense.hpp '#include "gen/support/source.hpp"'
refused "gen/lower/kernel may not include gen/oracle" gen/lower/kernel/kernel.hpp '#include "gen/oracle/dense.hpp"'
refused "gen/lower/expand may not include gen/lower/kernel" gen/lower/expand/model.hpp '#include "gen/lower/kernel/kernel.hpp"'
refused "gen/verify may not include gen/target" gen/verify/verify.cpp '#include "gen/target/target.hpp"'
refused "gen/target/text may not include gen/target/registry" gen/target/text/text.cpp '#include "gen/target/registry/registry.cpp"'
refused "gen/target/text may not include gen/verify" gen/target/text/text.cpp '#include "gen/verify/verify.cpp"'
refused "gen/target/text may not include gen/algebra" gen/target/text/text.cpp '#include "gen/algebra/metric.hpp"'
refused "gen/target/text may not include runtime/kernel" gen/target/text/text.cpp '#include <meetc/table/table.hpp>'
refused "gen/target/text may not include generated" gen/target/text/text.cpp '#include <cga/cga.hpp>'
refused "gen/target may not include tests/two" gen/target/target.hpp '#include "tests/two/judge.hpp"'
refused "runtime/kernel/meetc/number may not include runtime/kernel/meetc/table" runtime/kernel/meetc/number/grid.hpp \
  '#include <meetc/table/table.hpp>'
refused "the kernel headers are <meetc/...>, not <meet/kernel/meetc/number/grid.hpp>" runtime/core/views/view.hpp \
  '#include "meet/kernel/meetc/number/grid.hpp"'
refused "runtime/core/views may not include runtime/io" runtime/core/views/view.hpp '#include "meet/io/read.hpp"'
refused "runtime/core/views may not include runtime/core/query" runtime/core/views/view.hpp '#include "meet/core/query/collide.hpp"'
refused "runtime/core/query may not include runtime/core/device" runtime/core/query/collide.hpp '#include "meet/core/device/set.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/core/device/set.hpp \
  '#include "meetc/every_pair/table.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/app/input/sets.cpp \
  '#include "meet/core/device/every_pair/engine.hpp"'
refused "only benchmarks and tests include the engine of every pair" runtime/kernel/meetc/cuda/table.hpp \
  '#include <meetc/every_pair/table.hpp>'
refused "only benchmarks and tests include the engine of every pair" generated/default/cga/cga_cuda.cu \
  '#include <meetc/every_pair/table.hpp>'
refused "runtime/core/views may not include generated" runtime/core/views/view.hpp '#include <cga/cga.hpp>'
refused "runtime/app/input may not include runtime/bench/harness" runtime/app/input/sets.cpp '#include "meet/bench/harness/table.hpp"'
refused "runtime/bench/peers may not include runtime/bench/harness" runtime/bench/peers/peers.hpp \
  '#include "meet/bench/harness/table.hpp"'
refused "runtime/bench/harness may not include runtime/bench/tables" runtime/bench/harness/table.hpp \
  '#include "meet/bench/tables/read.hpp"'
refused "runtime/bench/truth may not include runtime/app" runtime/bench/truth/distance.hpp '#include "meet/app/input/sets.cpp"'
refused "runtime/bench/truth may not include runtime/core" runtime/bench/truth/distance.hpp '#include "meet/core/views/view.hpp"'
refused "this file lies in no room of the order" runtime/bench/new.hpp '#include <string>'
refused "this file lies in no room of the order" runtime/core/new.hpp '#include <string>'
refused "runtime/io may not include generated" runtime/io/read.hpp '#include <cga/cga.hpp>'
refused "runtime/io may not include gen/support" runtime/io/read.hpp '#include "gen/support/source.hpp"'
refused "\"core/views/view.hpp\" is no file of this tree" runtime/io/read.hpp '#include "core/views/view.hpp"'
refused "generated may not include runtime/core" generated/default/cga/cga.hpp '#include "meet/core/views/view.hpp"'
refused "generated code includes <meetc/...> and its own files, not <fmt/format.h>" generated/default/cga/kinds.hpp '#include <fmt/format.h>'
refused '"nowhere.hpp" is no file of this tree' gen/lang/load.hpp '#include "nowhere.hpp"'
refused "this file lies in no room of the order" gen/somewhere/new.hpp '#include <string>'
refused "a cycle of folders: tests/" tests/one/judge.hpp '#include "tests/two/judge.hpp"'
refused "a cycle of includes: generated/default/cga/" generated/default/cga/kinds.hpp '#include <cga/cga.hpp>'
# crowd FOLDER: with 25 files it passes, and with 26 it does not, whatever they are.
crowd() {
  sound
  for i in $(seq 25); do put "$1/$i.txt" text; done
  find "$1" -maxdepth 1 -type f ! -name '*.txt' -delete
  "$check" . >/dev/null || return 1
  ! said=$(put "$1/26.txt" text && "$check" . 2>&1) && [[ $said == *"$1: holds 26 files"* ]]
}
for folder in gen/cmake runtime/bench/plots tests/three; do
  crowd $folder || {
    echo "FAILED: 25 or 26 files in $folder"
    exit 1
  }
done
echo "a sound tree passes, and each fault is reported"
