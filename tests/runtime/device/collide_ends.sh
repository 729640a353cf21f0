#!/usr/bin/env bash
# `meet collide` on the device against the CPU, on files at the ends of float32: radii and coordinates of FLT_MAX, boxes that
# overflow, subnormal numbers. The pair lists must be the same, byte for byte.
#   collide_ends.sh MEET
set -euo pipefail
meet=${1:?the program meet is needed}
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
most=3.4028234663852886e38 least=1e-45

# A large sphere reaches one that is far from the others; its box overflows on all sides.
printf 'x,y,z,r\n1e6,0,0,1\n' >"$room/far.csv"
{
  echo 'x,y,z,r'
  for i in $(seq 20); do echo "$i,0,0,0.25"; done
  echo "0,0,0,$most"
} >"$room/huge.csv"

# A table of numbers from a palette and of small integers.
table() { # SEED ROWS FIELDS RADIUS(0|1) HEADER
  echo "$5"
  awk -v seed="$1" -v rows="$2" -v fields="$3" -v radius="$4" -v most=$most -v least=$least 'BEGIN {
    srand(seed); n = split("0 -0 1 -1 2 0.5 " most " -" most " 1.7e38 -1.7e38 1e30 " least " -" least " 1.2e-38 3e19", p, " ")
    for (i = 0; i < rows; ++i) {
      line = ""
      for (k = 1; k <= fields; ++k) {
        v = p[1 + int(rand() * n)]
        if (rand() < 0.5) v = int(rand() * 40) - 20
        if (radius && k == fields) sub(/^-/, "", v)
        line = line (k > 1 ? "," : "") v
      }
      print line
    }
  }'
}
table 1 3000 4 1 x,y,z,r >"$room/spheres.csv"
table 2 2000 4 1 x,y,z,r >"$room/other_spheres.csv"
table 3 2000 6 0 x0,y0,z0,x1,y1,z1 >"$room/segments.csv"
table 4 1500 6 0 x0,y0,z0,x1,y1,z1 >"$room/other_segments.csv"
for seed in 5 6; do
  table $seed 1200 3 0 points | awk -F, 'NR > 1 {print "v", $1, $2, $3} END {for (i = 1; i + 2 < NR; i += 3) print "f", i, i + 1, i + 2}' \
    >"$room/triangles_$seed.obj"
done

failed=0 sets=0 pairs=0
both() { # A B [option ...]
  local a=$1 b=$2
  shift 2
  for device in cpu cuda; do
    "$meet" collide "$room/$a" "$room/$b" "$@" --device $device --pairs "$room/$device.csv" >"$room/$device.log" 2>&1 || {
      if grep -qE "there is no CUDA device|no driver" "$room/$device.log"; then
        echo "skipped: no CUDA device"
        exit 77
      fi
      cat "$room/$device.log"
      failed=1
      return
    }
  done
  local found
  found=$(($(wc -l <"$room/cpu.csv") - 1))
  sets=$((sets + 1)) pairs=$((pairs + found))
  cmp -s "$room/cpu.csv" "$room/cuda.csv" || {
    echo "FAILED: $a $b $*: the CPU has $found pairs, the device $(($(wc -l <"$room/cuda.csv") - 1)), or others"
    failed=1
  }
}
both far.csv huge.csv
[ "$(wc -l <"$room/cpu.csv")" -eq 2 ] || { echo "FAILED: the large sphere touches one"; failed=1; }
for mode in solid surface; do
  both spheres.csv other_spheres.csv --mode $mode
  both spheres.csv segments.csv --mode $mode
  both spheres.csv triangles_5.obj --mode $mode
done
both segments.csv other_segments.csv
both segments.csv triangles_5.obj
both triangles_5.obj triangles_6.obj
both triangles_5.obj triangles_5.obj
both spheres.csv other_spheres.csv --precision exact
echo "$sets pairs of sets at the ends of float32, $pairs pairs; $([ $failed -eq 0 ] && echo "the device's lists equal the CPU's" || echo "FAILED")"
exit $failed
