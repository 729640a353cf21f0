#!/usr/bin/env bash
# usage.sh EXTREMES: wrong options are named, and are an error.
set -euo pipefail
for options in "--cases many" "--judge nobody"; do
  ! said=$("$1" $options 2>&1) && [[ $said == *"usage: extremes"* ]] || {
    echo "FAILED: extremes $options: $said"
    exit 1
  }
done
