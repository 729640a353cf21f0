# comments.awk FILE.hpp: the header as Doxygen reads it. A comment before a declaration and one behind it are documentation, and
# the first one is the file's. A comment before declarations without a blank line between them is about each. Its text is text:
# no character of it is a command, a tag or a link.
function plain(text) {
  gsub(/&/, "\\&amp;", text)
  gsub(/</, "\\&lt;", text)
  gsub(/>/, "\\&gt;", text)
  gsub(/[\\@]/, "\\\\&", text)
  gsub(/[*_`~|#]/, "\\\\&", text)
  return text
}
FNR == 1 { head = 1; mark = "/// \\file\n///" }
head && /^\/\// {
  print mark plain(substr($0, 3))
  mark = "///"
  next
}
head { head = 0 }
/^ *\/\/ ----/ { next } # a heading
/^ *\/\// {
  at = index($0, "//")
  line = substr($0, 1, at - 1) "///" plain(substr($0, at + 2))
  said = commented ? said "\n" line : line
  commented = 1
  ended = 0
  print line
  next
}
/^ *$/ { said = "" }
{ commented = 0 }
# The next declaration of the namespace.
ended && said != "" && /^[A-Za-z\[]/ { print said }
!/^(namespace|MEETC_NAMESPACE|} \/\/)/ { depth += gsub(/[{]/, "{") - gsub(/[}]/, "}") }
{ ended = depth == 0 && /[;}]( *\/\/.*)?$/ }
/[^:"]\/\/ / && !/"[^"]*\/\/[^"]*"/ {
  at = index($0, "// ")
  text = substr($0, at + 3)
  if (text ~ /^(NOLINT|namespace |MEETC_NAMESPACE)/)
    print substr($0, 1, at - 1)
  else
    print substr($0, 1, at - 1) "///< " plain(text)
  next
}
{ print }
