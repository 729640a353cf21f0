#!/usr/bin/env bash
# slowest.sh BUILD SINCE LOG: where the time went: the ten units that took longest among those built since SINCE (seconds
# since 1970), and the ten tests in LOG, which CTest wrote.
set -euo pipefail
# sort is read to its end: a closed pipe would kill it, and with it whoever asked.
build=$1 since=$2 log=$3
echo "The slowest units of $build, seconds:"
[ ! -e "$build/.ninja_log" ] ||
  awk -v since="$since" '!/^#/ && $3 / 1e9 >= since {
    unit[$4] = ($2 - $1) / 1000; sum += ($2 - $1) / 1000 # of several outputs of one command each has a line
  } END { for (each in unit) printf "%8.1f %s\n", unit[each], each }' "$build/.ninja_log" | sort -rn | awk 'NR <= 10'
echo "The slowest tests, seconds:"
sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: (.*[^ .]) \.*[* ]*(Passed|Failed|Timeout|Skipped|Not Run).* ([0-9.]+) sec.*$/\3 \1/p' "$log" |
  sort -rn | awk 'NR <= 10 { time = $1; $1 = ""; printf "%8.1f%s\n", time, $0 }'
