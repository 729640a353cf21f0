#!/usr/bin/env bash
# readme.sh MEETC SOURCE: the README's spec is the example file, and its header is what meetc shows for it; what
# docs/spec.md shows of the compiler's stages is what meetc prints.
set -euo pipefail
meetc=$1
cd "$2"

# block MARK [FILE]: the fenced block that follows the comment line <!-- MARK -->.
block() {
  awk -v mark="<!-- $1 -->" '$0 == mark {on = 1; next} on && /^```/ {if (seen) exit; seen = 1; next} on && seen' "${2:-README.md}"
}

diff <(block docs/examples/tiny.toml) docs/examples/tiny.toml
shown=$("$meetc" show docs/examples/tiny_scene.toml 'norm2(meet(sphere, line))')
wanted=$(block "meetc show docs/examples/tiny_scene.toml 'norm2(meet(sphere, line))'")
[ -n "$wanted" ]
case $shown in
*"$wanted"*) ;;
*)
  echo "README.md shows another header than meetc"
  diff <(echo "$wanted") <(echo "$shown")
  exit 1
  ;;
esac
[ "$(wc -l <docs/examples/tiny.toml)" -le 10 ]
"$meetc" verify docs/examples/tiny_scene.toml

# Every command that docs/spec.md marks, with the whole of its output.
mapfile -t commands < <(sed -n 's/^<!-- meetc \(.*\) -->$/\1/p' docs/spec.md)
[ ${#commands[@]} -gt 0 ]
for command in "${commands[@]}"; do
  eval "arguments=($command)"
  diff <(block "meetc $command" docs/spec.md) <("$meetc" "${arguments[@]}") || {
    echo "docs/spec.md shows something else than: meetc $command"
    exit 1
  }
done
