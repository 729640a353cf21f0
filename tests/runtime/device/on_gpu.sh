#!/usr/bin/env bash
# Tests and times a build on a machine with a GPU; writes logs and tables to OUT.
#   on_gpu.sh BUILD OUT [DATA]
# DATA: a folder of meshes; the default is built-in bodies. PARTS in the environment, some of "tests sanitizer bench
# paper counters", selects these parts only. `./dev gpu` builds first and copies the tables into
# docs/gpu.md. compute-sanitizer and ncu are used if they are found.
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
  [ -z "$data" ] || step test_cuda_data "$build/tests/runtime/device/test_cuda_pairs" --data "$data"
  step collide_ends "$(dirname "$0")/collide_ends.sh" "$meet"
fi

if ! does sanitizer; then
  :
elif command -v compute-sanitizer >/dev/null; then
  for tool in memcheck racecheck initcheck synccheck; do
    # Under these tools the probe would take minutes.
    step "sanitizer_$tool" timeout 150 compute-sanitizer --tool $tool --kernel-name-exclude kernel_substring=probe_kernel \
      --error-exitcode 1 "$build/tests/runtime/device/test_cuda_pairs" --small
  done
else
  echo "skipped  compute-sanitizer: not found"
fi

! does bench || step bench_gpu "$meet" bench gpu -o "$out" ${data:+--data "$data"}
for table in hard choice lbvh first; do
  ! does bench || step "bench_$table" timeout 150 "$meet" bench gpu --only $table -o "$out/$table" ${data:+--data "$data"}
done
if does bench && [ "$(nvidia-smi --list-gpus 2>/dev/null | wc -l)" -gt 1 ]; then
  step bench_group timeout 150 "$meet" bench gpu --only group -o "$out/group" ${data:+--data "$data"}
fi
! does paper || step bench_paper "$meet" bench paper --device cuda -o "$out/paper" ${data:+--data "$data"}

# The use of the matrix units and the logic units in the filter of balls x balls.
if ! does counters; then
  :
elif command -v ncu >/dev/null; then
  metrics=sm__pipe_tensor_cycles_active.avg.pct_of_peak_sustained_active
  metrics+=,sm__inst_executed_pipe_alu.avg.pct_of_peak_sustained_active
  metrics+=,smsp__issue_active.avg.pct_of_peak_sustained_active
  metrics+=,sm__warps_active.avg.pct_of_peak_sustained_active
  step counters ncu --clock-control none --kernel-id '::regex:mma_kernel:2' --csv --metrics $metrics \
    "$meet" bench gpu --only balls
  {
    echo "| kernel | matrix unit busy | logic unit busy | issue slots used | warps there |"
    echo "|---|---|---|---|---|"
    # ncu's columns are quoted; the last two are the metric's name and value after its unit.
    grep '^"[0-9]' "$out/counters.log" | awk -F'","' '
      { kernel = $5; sub(/^.*::/, "", kernel); sub(/\(.*/, "", kernel); value = $NF; gsub(/"/, "", value)
        name = $(NF - 2); key = $1 kernel
        if (!(key in seen)) { seen[key] = ++n; title[n] = $5; sub(/\(const.*/, "", title[n]) }
        row[seen[key], name] = value }
      END { for (i = 1; i <= n; ++i)
              printf "| `%s` | %s %% | %s %% | %s %% | %s %% |\n", title[i],
                row[i, "sm__pipe_tensor_cycles_active.avg.pct_of_peak_sustained_active"],
                row[i, "sm__inst_executed_pipe_alu.avg.pct_of_peak_sustained_active"],
                row[i, "smsp__issue_active.avg.pct_of_peak_sustained_active"],
                row[i, "sm__warps_active.avg.pct_of_peak_sustained_active"] }'
  } >"$out/counters.md"
else
  echo "skipped  counters: ncu was not found"
fi
exit $failed
