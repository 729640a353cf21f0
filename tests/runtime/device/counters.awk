# counters.awk: a table in Markdown of what `ncu --csv --print-units base` wrote, a row for each kernel that it watched.
#   awk -v titles='TITLE|...' -v metrics=NAME,... -f counters.awk LOG
# A metric in percent is shown with its sign, and a time, which is in nanoseconds, in milliseconds.
BEGIN {
  FS = "\",\"" # all columns are quoted; the last three are the metric's name, its unit and its value
  columns = split(metrics, metric, ",")
  split(titles, title, "|")
  head = "| kernel |"
  rule = "|---|"
  for (i = 1; i <= columns; ++i) {
    head = head " " title[i] " |"
    rule = rule "---:|"
  }
}
/^"[0-9]/ {
  # The name in the kernel's declaration, and the numbers that it is a template of.
  kernel = match($5, /[A-Za-z_0-9]*[Kk]ernel(<[0-9, ]*>)?/) ? substr($5, RSTART, RLENGTH) : $5
  row = $1 kernel # the first column numbers the kernels that ran
  if (!(row in seen)) {
    seen[row] = ++rows
    name[rows] = kernel
  }
  x = $NF
  gsub(/[",]/, "", x)
  value[seen[row], $(NF - 2)] = $(NF - 1) == "%" ? sprintf("%.1f %%", x) : sprintf("%.3g ms", x / 1e6)
}
END {
  if (!rows) {
    print "counters.awk: no kernel was watched" > "/dev/stderr"
    exit 1
  }
  print head
  print rule
  for (i = 1; i <= rows; ++i) {
    line = "| `" name[i] "` |"
    for (j = 1; j <= columns; ++j)
      line = line " " ((i, metric[j]) in value ? value[i, metric[j]] : "-") " |"
    print line
  }
}
