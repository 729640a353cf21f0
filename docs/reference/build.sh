#!/usr/bin/env bash
# build.sh FOLDER: the reference of the installed headers, as HTML, by Doxygen. A warning fails.
set -euo pipefail
folder=$(realpath -m "$1")
cd "$(dirname "$0")/../.."

# headers LIST FOLDER: the names in a list of gen/cmake/package.cmake.
headers() {
  sed -n "/^set($1 /,/)/p" gen/cmake/package.cmake | tr -d '\n' | sed -E "s/^set\($1 //; s/\).*//" |
    awk -v at="$2" -v RS=' +' 'NF { print at "/" $1 }'
}
input=$(
  headers MEETC_CORE_HEADERS runtime/core
  headers MEETC_WORLD_HEADERS runtime/core
  headers MEETC_FRONT_HEADERS runtime
  headers MEETC_DEVICE_HEADERS runtime/core/device
  headers MEETC_IO_HEADERS runtime/io
  ls runtime/kernel/meetc/table/{table,formula_table}.hpp
)
for file in $input; do
  [ -f "$file" ] || { echo "no such header: $file" && exit 1; }
done
# run [SETTING ...]: Doxygen with these settings besides those of all headers.
run() {
  {
    cat docs/reference/Doxyfile
    echo "INPUT = docs/reference/main.md $(tr '\n' ' ' <<<"$input")"
    echo "OUTPUT_DIRECTORY = \"$folder\""
    echo "STRIP_FROM_PATH = runtime runtime/kernel"
    printf '%s\n' "$@"
  } | doxygen - 2>&1
}
rm -rf "$folder"
mkdir -p "$folder"
# Each function of a namespace says what it does; members may be told by their class.
silent=$({ run "EXTRACT_ALL = NO" "WARN_IF_UNDOCUMENTED = YES" "GENERATE_HTML = NO" "GENERATE_XML = YES" || true; } |
  grep -F '(function) of namespace' || true)
rm -rf "$folder/xml"
[ -z "$silent" ] || { echo "$silent" && exit 1; }
run
# Each header has its page, and each question its entry.
pages=$(find "$folder/html" -name '*_8hpp.html' | wc -l)
[ "$pages" -eq "$(wc -w <<<"$input")" ] || { echo "$pages pages for $(wc -w <<<"$input") headers" && exit 1; }
for name in 'meetc::collide' 'first_met' 'input_error'; do
  grep -rqF "${name##*::}" "$folder/html" || { echo "the reference has no $name" && exit 1; }
done
echo "$folder/html/index.html: $pages headers"
