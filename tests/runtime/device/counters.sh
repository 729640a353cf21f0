#!/usr/bin/env bash
# counters.sh: counters.awk makes a table of what ncu prints, and fails where no kernel was watched.
set -euo pipefail
here=$(dirname "$0")
row() { printf '"%s","9","meet","127.0.0.1","%s","1","13","(128, 1, 1)","(792, 1, 1)","0","9.0","Metrics","%s","%s","%s"\n' "$@"; }
table() { awk -v titles='time|issue slots used' -v metrics=time.sum,issue.avg -f "$here/counters.awk"; }

made=$({
  echo '==PROF== Connected to process 9'
  echo '"ID","Process ID","Process Name","Host Name","Kernel Name","Context","Stream","Block Size","Grid Size","Device","CC","Section Name","Metric Name","Metric Unit","Metric Value"'
  row 0 'void walk_kernel<8, 4>(const float *, int)' issue.avg % 73.25
  row 0 'void walk_kernel<8, 4>(const float *, int)' time.sum ns '1,234,567'
  row 1 'meetc::<unnamed>::order_kernel(meetc::hit_order)' time.sum ns 2500
  row 2 'order_kernel' time.sum ns 12500.00
  row 3 'void cub::SortKernel<cub::policy<unsigned int>::Policy1000, 0>(T1 *, int)' issue.avg % 9
  row 4 'void cuda::rest<2>(int)' issue.avg % 9
} | table)
diff - <(echo "$made") <<'TEXT'
| kernel | time | issue slots used |
|---|---:|---:|
| `walk_kernel<8, 4>` | 1.23 ms | 73.2 % |
| `order_kernel` | 0.0025 ms | - |
| `order_kernel` | 0.0125 ms | - |
| `SortKernel` | - | 9.0 % |
| `void cuda::rest<2>(int)` | - | 9.0 % |
TEXT
if echo '==PROF== No kernels were profiled.' | table 2>/dev/null; then
  echo "a log without kernels makes a table"
  exit 1
fi
