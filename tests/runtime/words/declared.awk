# declared.awk: prints the name of every public function that headers declare, one a line: `pairs`, `prepared::bounds`. With
# -v pointers=1 it prints the functions of a table instead, which are members that point to functions: `kind_info::boxes`.
#
# It knows as much C++ as our headers use. Constructors count by their class's name; destructors, operators, and what is
# defaulted or deleted do not count.
{
  sub(/^[ \t]*#.*/, "")
  sub(/\/\/.*/, "")
  gsub(/"([^"\\]|\\.)*"/, "\"\"")
  text = text $0 "\n"
}

# The name that a declaration declares, or "".
function name_of(decl,    before, pointed) {
  gsub(/\[\[[^\]]*\]\]/, " ", decl)
  gsub(/__attribute__\(\([^)]*\)\)/, " ", decl)
  while (gsub(/<[^<>]*>/, " ", decl)) {
  }
  if (decl ~ /^[ \n]*(using|typedef|friend|static_assert|enum)/ || decl ~ /=[ \n]*(delete|default)[ \n]*$/ || decl ~ /operator|~/)
    return ""
  pointed = decl ~ /\([ \n]*\*[ \n]*[A-Za-z_0-9]+[ \n]*\)[ \n]*\(/
  if (pointers != pointed)
    return ""
  if (pointed) {
    match(decl, /\([ \n]*\*[ \n]*[A-Za-z_0-9]+/)
    before = substr(decl, RSTART, RLENGTH)
  } else {
    if (!index(decl, "("))
      return ""
    before = substr(decl, 1, index(decl, "(") - 1)
    if (before ~ /=/) # a variable, and what it is made from
      return ""
  }
  sub(/[ \n]+$/, "", before)
  return match(before, /[A-Za-z_0-9]+$/) ? substr(before, RSTART) : ""
}

function declare(decl,    name, at, i) {
  name = name_of(decl)
  if (name == "")
    return
  for (i = 1; i <= depth; ++i) {
    if (kind[i] == "class" && !open_to_all[i])
      return
    if (kind[i] == "class")
      at = at label[i] "::"
  }
  print at name
}

# The place behind the brace that closes the one at `from`.
function skip(from,    level, c) {
  for (; from <= length(text); ++from) {
    c = substr(text, from, 1)
    level += (c == "{") - (c == "}")
    if (level == 0)
      return from + 1
  }
  return from
}

END {
  for (at = 1; at <= length(text);) {
    c = substr(text, at, 1)
    if (c == "{") {
      if (decl ~ /^[ \n]*(inline[ \n]+)?namespace/ || decl ~ /^[ \n]*extern/) {
        kind[++depth] = "namespace"
        decl = ""
      } else if (decl ~ /(^|[ \n>])(class|struct)[ \n]/ && decl !~ /\(/) {
        kind[++depth] = "class"
        open_to_all[depth] = decl ~ /(^|[ \n>])struct[ \n]/
        sub(/[ \n]:[^:].*/, "", decl)
        sub(/[ \n]*(final)?[ \n]*$/, "", decl)
        match(decl, /[A-Za-z_0-9]+$/)
        label[depth] = substr(decl, RSTART)
        decl = ""
      } else {
        at = skip(at)
        if (decl ~ /\(/ && decl !~ /=[ \n]*$/ && decl !~ /^[ \n]*enum/) { # a body
          declare(decl)
          decl = ""
        }
        continue
      }
    } else if (c == "}") {
      --depth
      decl = ""
    } else if (c == ";") {
      declare(decl)
      decl = ""
    } else if (c == ":" && decl ~ /(^|[ \n])(public|private|protected)[ \n]*$/) {
      open_to_all[depth] = decl ~ /public/
      decl = ""
    } else {
      decl = decl c
    }
    ++at
  }
}
