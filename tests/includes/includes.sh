#!/usr/bin/env bash
# includes.sh [--draw|--check] [TREE]: compares every #include of gen/, runtime/, generated/ and tests/ with the order of the
# rooms in includes.awk, counts the files of each folder, and looks for cycles. --draw writes the picture of the rooms to
# docs/images/includes.dot, and includes.svg beside it if Graphviz is installed; --check fails if includes.dot would change.
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
find gen runtime generated tests -type f ! -path '*/__pycache__/*' | LC_ALL=C sort >"$files"
check() { { grep -E '[.]([ch]pp|[ch]|cuh?)$' "$files" | xargs grep -HnE '^ *# *include' || [ $? = 123 ]; } | awk -v files="$files" "$@" -f "$here/includes.awk"; }
case $mode in
order)
  check
  echo "the includes of $(grep -cE '[.]([ch]pp|[ch]|cuh?)$' "$files") files keep the order"
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
