#!/usr/bin/env bash
# insert.sh PAGE NAME FILE: puts FILE between the lines `<!-- NAME -->` and `<!-- end of NAME -->` of PAGE, with headings
# one level lower, without the title and without the pictures at the end (from the heading "Figures" on).
set -euo pipefail
page=$1 name=$2 file=$3
[ -s "$file" ] || { echo "$file: nothing to insert" >&2; exit 1; }
grep -q "^<!-- $name -->\$" "$page" || { echo "$page: has no place for $name" >&2; exit 1; }
awk -v name="$name" -v file="$file" '
  $0 == "<!-- " name " -->" { print; print ""; 
    while ((getline line < file) > 0 && line != "## Figures") {
      sub(/^## /, "### ", line)
      if (line !~ /^# /) print line
    }
    print ""; skip = 1 }
  $0 == "<!-- end of " name " -->" { skip = 0 }
  !skip && !($0 == "<!-- " name " -->") { print }' "$page" >"$page.new"
mv "$page.new" "$page"
