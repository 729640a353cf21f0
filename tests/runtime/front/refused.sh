#!/usr/bin/env bash
# refused.sh COMPILER INCLUDE SOURCE: the compiler refuses memory of a wrong type, each with one error that says what to write.
set -euo pipefail
said=$("$1" -std=c++20 -fsyntax-only "-I$2" "-I$3/runtime/kernel" "-I$3/generated/default" -x c++ "$3/tests/runtime/front/refused.txt" \
  2>&1) && echo "nothing is refused" && exit 1
got=$(grep -oE '(static assertion|static_assert) failed.*meet: [^:;,"]*' <<<"$said" | sed 's/.*meet: /meet: /' | LC_ALL=C sort)
want=$(sed -n 's|.*// \(meet: .*\)|\1|p' "$3/tests/runtime/front/refused.txt" | LC_ALL=C sort)
[ "$got" = "$want" ] || {
  diff <(echo "$want") <(echo "$got") || true
  exit 1
}
# Nothing else is wrong.
if grep 'error:' <<<"$said" | grep -vE '(static assertion|static_assert) failed'; then exit 1; fi
grep -c . <<<"$want"
