# claim.awk: translates a Gappa script to a Coq proposition `name`: its definitions and its claim, in real numbers and
# Flocq's roundings only. A rule after the claim is a hint to Gappa and not part of it. The scripts of signs also hold for
# all finer formats, a different one for each rounding (gen/target/gappa/gappa.cpp), and so does the proposition: `rnd i` is
# the script's rounding number i, to a format with the least exponent `least i`.
# Limits: it reads what the emitter writes, not all of Gappa's language.
function rounding(direction) {
  if (direction == "ne") return "ZnearestE"
  if (direction == "dn") return "Zfloor"
  exit 1
}
# An expression: 33b-25 is a multiple of a power of two, and a minus before a product applies to the whole product.
function expression(text,    out, token, depth, before, open) {
  out = ""
  before = "("
  depth = 0
  while (match(text, /[a-zA-Z_][a-zA-Z_0-9]*|[0-9]+b-?[0-9]+|[0-9]+|[^ ]/)) {
    token = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    if (token ~ /^[0-9]+b/)
      token = "(" substr(token, 1, index(token, "b") - 1) " * bpow radix2 (" substr(token, index(token, "b") + 1) "))"
    else if (token ~ /^[a-zA-Z_]/ && !(token in defined))
      variable(token)
    if (token == "rnd") token = token " " roundings++ "%nat "
    if ((token ~ /^[-+)]$/) && open[depth]) {
      out = out ")"
      open[depth] = 0
    }
    if (token == "-" && before == "(") {
      out = out "- ("
      open[depth] = 1
      before = "-"
      continue
    }
    if (token == "(") open[++depth] = 0
    if (token == ")") --depth
    out = out (token ~ /^[-+*\/]$/ ? " " token " " : token)
    before = token
  }
  return out (open[0] ? ")" : "")
}
function variable(name) {
  if (name in known) return
  known[name]
  variables = variables " " name
}
# The subject of a bound: X, |X|, or |X -/ Y|, a relative error.
function measured(text,    at, of) {
  gsub(/^ +| +$/, "", text)
  if (text ~ /^\|/) return "Rabs (" measured(substr(text, 2, length(text) - 2)) ")"
  if (at = index(text, " -/ "))
    return "(" expression(substr(text, 1, at - 1)) " - " (of = expression(substr(text, at + 4))) ") / " of
  return expression(text)
}
# A bound: a number with its sign.
function bound(text) {
  gsub(/[] \[]/, "", text)
  if (text ~ /^-[0-9]+b/) return "(-" substr(expression(substr(text, 2)), 2)
  return expression(text)
}
function atom(text,    at, ends) {
  if (at = index(text, " in [")) {
    split(substr(text, at + 5), ends, ",")
    return bound(ends[1]) " <= " measured(substr(text, 1, at - 1)) " <= " bound(ends[2])
  }
  if (at = index(text, "<=")) return measured(substr(text, 1, at - 1)) " <= " bound(substr(text, at + 2))
  if (at = index(text, ">=")) return bound(substr(text, at + 2)) " <= " measured(substr(text, 1, at - 1))
  exit 1
}
function atoms(text, between,    parts, n, i, out) {
  n = split(text, parts, /\/\\/)
  for (i = 1; i <= n; ++i) out = out (i > 1 ? between : "  ") atom(parts[i])
  return out
}
!/^#/ { all = all $0 " " }
END {
  open_brace = index(all, "{")
  arrow = open_brace + index(substr(all, open_brace), "->") - 1
  close_brace = index(all, "}")
  if (!open_brace || close_brace < arrow) exit 1
  n = split(substr(all, 1, open_brace - 1), statement, ";")
  for (i = 1; i < n; ++i) {
    split(statement[i], side, / = /)
    gsub(/[ @]/, "", side[1])
    if (statement[i] ~ /@/) {
      split(side[2], format, /[<,> ]+/)
      least = "(" format[3] ")"
      if (side[1] == "rnd") {
        formats = "forall least : nat -> Z, (forall i, least i <= " format[3] ")%Z ->\n  "
        least = "(least i)"
        side[1] = "rnd i"
        defined["rnd"]
      }
      value = "round radix2 (FLT_exp " least " " format[2] ") " rounding(format[4])
    } else
      value = expression(side[2])
    defined[side[1]]
    lets = lets "  let " side[1] " := " value " in\n"
  }
  given = atoms(substr(all, open_brace + 1, arrow - open_brace - 1), " ->\n  ")
  shown = atoms(substr(all, arrow + 2, close_brace - arrow - 2), " /\\\n  ")
  printf "Definition %s : Prop :=\n  %sforall%s : R,\n%s%s ->\n%s.\n", name, formats, variables, lets, given, shown
}
