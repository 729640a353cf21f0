#!/usr/bin/env bash
# Each header that an installed header includes is installed.
#   installed.sh RUNTIME HEADER...
# RUNTIME: the folder runtime/. HEADER: an installed header as it is included, meet/... or meetc/...
set -euo pipefail
runtime=${1:?the folder runtime/}
shift
[ $# -gt 0 ] || { echo "no headers are installed" >&2; exit 1; }
declare -A installed
for header in "$@"; do installed[$header]=1; done

missing=0 seen=0
for header in "$@"; do
  case $header in
  meetc/environment/version.hpp) continue ;; # made in the build
  meetc/*) file=$runtime/kernel/$header ;;
  meet/*) file=$runtime/${header#meet/} ;;
  *) echo "$header is in no folder of the runtime" >&2; exit 1 ;;
  esac
  [ -r "$file" ] || { echo "$header is not there: $file" >&2; exit 1; }
  while read -r included; do
    seen=$((seen + 1))
    [ -n "${installed[$included]:-}" ] || { echo "$header includes $included, which is not installed"; missing=1; }
  done < <(sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*["<](meetc?\/[^">]*)[">].*/\1/p' "$file")
done
[ $seen -gt 0 ] || { echo "no header includes another" >&2; exit 1; }
[ $missing -eq 0 ]
echo "$# headers, $seen includes"
