#!/usr/bin/env bash
# includes.sh [--draw|--check] [TREE]: compares every #include of gen/, runtime/ and generated/ with the order of the rooms
# in includes.awk, and looks for cycles. --draw writes the picture of the rooms to docs/images/includes.dot, and
# includes.svg beside it if Graphviz is installed; --check fails if includes.dot would change.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mode=order
case ${1:-} in
--draw | --check)
  mode=${1#--}
  shift
  ;;
esac
cd "${1:-$here/../..}"
files=$(mktemp)
trap 'rm -f "$files"' EXIT
find gen runtime generated -type f \( -name '*.[ch]pp' -o -name '*.[ch]' -o -name '*.cu' -o -name '*.cuh' \) | LC_ALL=C sort >"$files"
check() { { xargs grep -HnE '^ *# *include' <"$files" || [ $? = 123 ]; } | awk -v files="$files" "$@" -f "$here/includes.awk"; }
case $mode in
order)
  check
  echo "the includes of $(wc -l <"$files") files keep the order"
  ;;
draw)
  check -v draw=1 >docs/images/includes.dot
  ! command -v dot >/dev/null || dot -Tsvg docs/images/includes.dot >docs/images/includes.svg
  ;;
check)
  check -v draw=1 | diff docs/images/includes.dot - || {
    echo "docs/images/includes.dot is not the picture of this tree: run ./dev generate"
    exit 1
  }
  ;;
esac
