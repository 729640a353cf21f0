#!/usr/bin/env bash
# base.sh [COMMIT]: prints what a change is compared with: COMMIT, or where this branch left main, or the previous commit.
# Prints nothing where there is none, as in a clone without a history.
set -euo pipefail
base=${1:-}
if [ -z "$base" ]; then
  head=$(git rev-parse -q --verify HEAD) || head=
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null) || base=$head
  [ "$base" != "$head" ] || base=$(git rev-parse -q --verify HEAD~1) || base=
fi
[ -n "$base" ] || exit 0
git rev-parse -q --verify "$base^{commit}" || {
  echo "'$base' is no commit" >&2
  exit 1
}
