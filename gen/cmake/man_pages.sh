#!/usr/bin/env bash
# man_pages.sh HELP2MAN MEET MEETC FOLDER: writes the pages meet.1, meet-collide.1, meetc.1, ... of the programs and their
# commands into the folder, from what --help prints.
set -euo pipefail
help2man=$1 folder=$4
shift
rm -rf "$folder"
mkdir -p "$folder"
for program in "$1" "$2"; do
  name=$(basename "$program")
  version=$("$program" --version | awk '{print $NF}')
  what=$("$program" --help | head -n 1)
  "$help2man" --no-info --no-discard-stderr --version-string="$version" --name="${what%.}" "$program" >"$folder/$name.1"
  "$program" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p' | while read -r command; do
    what=$("$program" "$command" --help | head -n 1)
    # A page of a command is that of a program with this name.
    wrapper=$(mktemp -d)
    printf '#!/bin/sh\nexec "%s" %s "$@"\n' "$program" "$command" >"$wrapper/$name-$command"
    chmod +x "$wrapper/$name-$command"
    "$help2man" --no-info --no-discard-stderr --version-string="$version" --name="${what%.}" "$wrapper/$name-$command" \
      >"$folder/$name-$command.1"
    rm -r "$wrapper"
  done
done
