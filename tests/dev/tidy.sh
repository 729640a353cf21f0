#!/usr/bin/env bash
# tidy.sh BUILD [COMMIT]: clang-tidy (.clang-tidy) on the sources of gen/ and runtime/ that have changed since COMMIT, and
# on one that includes each changed header. The default COMMIT is where this branch left main, or the previous commit;
# where there is neither, as in a clone without a history, nothing is checked. No unit is begun after MEETC_TIDY_SECONDS
# (900); the units that were not checked are then reported.
set -euo pipefail
build=$1 base=${2:-} seconds=${MEETC_TIDY_SECONDS:-900}
[ -e "$build/compile_commands.json" ] || {
  echo "tidy: $build has no compile_commands.json"
  exit 1
}
base=$("$(dirname "$0")/base.sh" "$base")
[ -n "$base" ] || {
  echo "tidy: there is no previous commit to compare with; name one"
  exit 0
}

mapfile -t changed < <(git diff --name-only --diff-filter=d "$base" -- 'gen/*.[ch]pp' 'runtime/*.[ch]pp')
[ ${#changed[@]} -gt 0 ] || {
  echo "tidy: nothing in gen/ and runtime/ has changed since $base"
  exit 0
}

# The sources of gen/ and runtime/ that are compiled; and who includes whom there, as "FILE INCLUDED".
compiled() { find gen runtime -name '*.cpp' | sort | while read -r file; do
  ! grep -qF "/$file\"" "$build/compile_commands.json" || echo "$file"
done; }
includes() { grep -roE --include='*.[ch]pp' '^#include ["<][a-z]+/[^">]*' gen runtime | sort |
  sed -E 's|:#include .gen/| gen/|; s|:#include .meetc/| runtime/kernel/meetc/|; s|:#include .meet/| runtime/|'; }
# The changed sources; and for each changed header that none of them includes, on whatever way, the nearest source that does.
mapfile -t units < <(awk '
  function see(file, parts, n, i) {
    if (file in seen) return
    seen[file] = 1
    n = split(below[file], parts)
    for (i = 1; i <= n; ++i) see(parts[i])
  }
  function take(unit) { print unit; see(unit) }
  function take_nearest(header, queue, met, parts, first, last, n, i) {
    queue[last = 1] = header
    met[header] = 1
    for (first = 1; first <= last; ++first) {
      if (queue[first] in compiled) { take(queue[first]); return }
      n = split(above[queue[first]], parts)
      for (i = 1; i <= n; ++i) if (!(parts[i] in met)) { met[parts[i]] = 1; queue[++last] = parts[i] }
    }
    print "tidy: nothing that is compiled here includes " header > "/dev/stderr"
  }
  FILENAME == ARGV[1] { compiled[$1]; next }
  FILENAME == ARGV[2] { below[$1] = below[$1] " " $2; above[$2] = above[$2] " " $1; next }
  /[.]cpp$/ { if ($1 in compiled) take($1); next }
  { headers[++count] = $1 }
  END { for (i = 1; i <= count; ++i) if (!(headers[i] in seen)) take_nearest(headers[i]) }
' <(compiled) <(includes) <(printf '%s\n' "${changed[@]}"))
[ ${#units[@]} -gt 0 ] || {
  echo "tidy: nothing that has changed since $base is compiled here"
  exit 0
}

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
# clang does not read headers that gcc has parsed.
mkdir "$log/database"
sed 's/ -Winvalid-pch -include [^ ]*//' "$build/compile_commands.json" >"$log/database/compile_commands.json"
export log
# One unit: its output is shown if it fails. A unit that would start too late is reported as not checked.
look() {
  local name=${1//\//_}
  if [ "$(date +%s)" -ge "$deadline" ]; then
    echo "$1" >>"$log/late"
  elif ! clang-tidy-14 -p "$log/database" --quiet --extra-arg=-Wno-unknown-warning-option "$1" >"$log/$name" 2>"$log/$name.err"; then
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
