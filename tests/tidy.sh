#!/usr/bin/env bash
# tidy.sh BUILD [COMMIT]: clang-tidy (.clang-tidy) on the sources of gen/ and runtime/ that have changed since COMMIT, and
# on one that includes each changed header. The default COMMIT is where this branch left main, or the previous commit. It
# takes at most MEETC_TIDY_SECONDS (900) and then reports the units that were not checked.
set -euo pipefail
build=$1 base=${2:-} seconds=${MEETC_TIDY_SECONDS:-900}
[ -e "$build/compile_commands.json" ] || {
  echo "tidy: $build has no compile_commands.json"
  exit 1
}
if [ -z "$base" ]; then
  base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null) || base=
  [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse -q --verify HEAD~1) || base=
fi
[ -n "$base" ] || {
  echo "tidy: there is no previous commit to compare with; name one"
  exit 0
}
git rev-parse -q --verify "$base^{commit}" >/dev/null || {
  echo "tidy: '$base' is no commit"
  exit 1
}

mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- 'gen/*.[ch]pp' 'runtime/*.[ch]pp')
# A header is checked through the source with its name, or the first source that includes it.
units=()
for file in "${changed[@]}"; do
  case $file in
  *.cpp) units+=("$file") ;;
  *)
    source=${file%.hpp}.cpp
    [ -e "$source" ] || source=$(grep -rlF --include='*.cpp' "${file#runtime/}\"" gen runtime | sort | head -n 1) || true
    [ -z "$source" ] || units+=("$source")
    ;;
  esac
done
mapfile -t units < <(printf '%s\n' "${units[@]}" | sort -u | while read -r file; do
  ! grep -qF "/$file\"" "$build/compile_commands.json" || echo "$file"
done)
[ ${#units[@]} -gt 0 ] || {
  echo "tidy: nothing has changed since $base"
  exit 0
}

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
export build log
# One unit: its output is shown if it fails. A unit that would start too late is reported as not checked.
look() {
  local name=${1//\//_}
  if [ "$(date +%s)" -ge "$deadline" ]; then
    echo "$1" >>"$log/late"
  elif ! clang-tidy-14 -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option "$1" >"$log/$name" 2>"$log/$name.err"; then
    echo "FAILED: $1"
    cat "$log/$name"
    [ -s "$log/$name" ] || cat "$log/$name.err"
    return 1
  fi
}
deadline=$(($(date +%s) + seconds))
export deadline
export -f look
status=0
printf '%s\0' "${units[@]}" | xargs -0 -P "$(nproc)" -n 1 bash -c 'look "$1"' look || status=1
late=0
[ ! -e "$log/late" ] || late=$(wc -l <"$log/late")
echo "tidy: $((${#units[@]} - late)) of ${#units[@]} changed units were checked"
[ "$late" = 0 ] || sed 's/^/tidy: no time was left for /' "$log/late"
exit $status
