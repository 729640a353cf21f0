#!/usr/bin/env bash
# Tests and times a build on a machine with a GPU; writes logs and tables to OUT.
#   on_gpu.sh BUILD OUT [DATA]
# DATA: a folder of meshes; the default is built-in bodies. PARTS in the environment, some of "tests sanitizer bench
# paper counters", selects these parts only. `./dev gpu` builds first and copies the tables into
# docs/measured/gpu.md. compute-sanitizer and ncu are used if they are found.
set -uo pipefail
build=${1:?the build folder is needed}
out=${2:?a folder for the results is needed}
data=${3:-}
parts=" ${PARTS:-tests sanitizer bench paper counters} "
mkdir -p "$out"
meet="$build/runtime/app/meet"
failed=0

# step NAME COMMAND...: its output goes to OUT/NAME.log; one line reports the result.
step() {
  local name=$1
  shift
  local start=$SECONDS
  if "$@" >"$out/$name.log" 2>&1; then
    echo "passed   $name ($((SECONDS - start)) s): $(tail -n 1 "$out/$name.log")"
  else
    local rc=$?
    if [ $rc -eq 77 ]; then
      echo "skipped  $name: $(tail -n 1 "$out/$name.log")"
      failed=1
    elif [ $rc -eq 124 ]; then # of timeout: a tool that hangs is no finding
      echo "no end   $name ($((SECONDS - start)) s)"
    else
      echo "FAILED   $name (exit $rc): $(tail -n 1 "$out/$name.log")"
      failed=1
    fi
  fi
}

does() { [[ $parts == *" $1 "* ]]; }

if does tests; then
  for test in test_cuda test_cuda_fast_math test_cuda_pairs test_cuda_extremes; do
    step $test "$build/tests/runtime/device/$test"
  done
  step test_cuda_tolerant "$build/tests/generated/tolerant/test_cuda_tolerant"
  step test_cuda_groups "$build/tests/generated/groups/test_cuda_groups"
  [ -z "$data" ] || step test_cuda_data "$build/tests/runtime/device/test_cuda_pairs" --data "$data"
  step collide_ends "$(dirname "$0")/collide_ends.sh" "$meet"
fi

if ! does sanitizer; then
  :
elif command -v compute-sanitizer >/dev/null; then
  for tool in memcheck racecheck initcheck synccheck; do
    # Under these tools the probe would take minutes.
    step "sanitizer_$tool" timeout 150 compute-sanitizer --tool $tool --report-api-errors no --kernel-name-exclude kernel_substring=probe_kernel \
      --error-exitcode 1 "$build/tests/runtime/device/test_cuda_pairs" --small
  done
else
  echo "skipped  compute-sanitizer: not found"
fi

! does bench || step bench_gpu "$meet" bench gpu -o "$out" ${data:+--data "$data"}
for table in hard lbvh first contacts self bodies memory formulas; do
  ! does bench || step "bench_$table" timeout 150 "$meet" bench gpu --only $table -o "$out/$table" ${data:+--data "$data"}
done
if does bench && [ "$(nvidia-smi --list-gpus 2>/dev/null | wc -l)" -gt 1 ]; then
  step bench_group timeout 150 "$meet" bench gpu --only group -o "$out/group" ${data:+--data "$data"}
fi
! does paper || step bench_paper "$meet" bench paper --device cuda -o "$out/paper" ${data:+--data "$data"}

# counters FILE SCENES KERNELS TITLE=METRIC ...: of some kernels while the scenes of `meet bench gpu --only SCENES` are
# measured, a table. KERNELS: a regular expression, and which launch of each of its names is watched.
counters() {
  local file=$1 scenes=$2 kernels=$3 titles= metrics= each
  shift 3
  for each in "$@"; do
    titles+="${titles:+|}${each%%=*}"
    metrics+="${metrics:+,}${each#*=}"
  done
  step "$file" ncu --clock-control none --kernel-id "::regex:$kernels" --print-units base --csv --metrics "$metrics" \
    "$meet" bench gpu --only "$scenes" ${data:+--data "$data"}
  awk -v titles="$titles" -v metrics="$metrics" -f "$(dirname "$0")/counters.awk" "$out/$file.log" >"$out/$file.md" || failed=1
}

share=avg.pct_of_peak_sustained
if ! does counters; then
  :
elif command -v ncu >/dev/null; then
  # The use of the matrix units and the logic units in the filter of balls x balls.
  counters counters balls 'mma_kernel:2' "matrix unit busy=sm__pipe_tensor_cycles_active.${share}_active" \
    "logic unit busy=sm__inst_executed_pipe_alu.${share}_active" "issue slots used=smsp__issue_active.${share}_active" \
    "warps there=sm__warps_active.${share}_active"
  # The limits of the kernels of a query by the hierarchy, on sets as they are given.
  for balls in 1048576 16777216; do
    counters counters_$balls "memory:balls, $balls x" 'kernel|Kernel:3' time=gpu__time_duration.sum \
      "issue slots used=smsp__issue_active.${share}_active" "warps there=sm__warps_active.${share}_active" \
      "memory busy=dram__throughput.${share}_elapsed" "second-level cache busy=lts__throughput.${share}_elapsed"
  done
else
  echo "skipped  counters: ncu was not found"
fi
exit $failed
