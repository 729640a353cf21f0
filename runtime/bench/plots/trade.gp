# The trade of speed for accuracy: time of a pair across, the farthest wrong answer upwards, a panel for each family of pairs.
#   about               a line that says on what was measured
#   least_ns            the left end of the axes
#   panels titles[]     how many, and the title of each
#   subjects names[] colours[]   the predicates
#   methods labels[] shapes[]    the methods
#   never nothing apart low high where no answer is wrong, and where wrong ones are wrong by 0: the lowest of the lines, the
#                       step from line to line (each predicate has its own), and the ends of the axis
#   $marks              ns, height, shape, colour; a section for each panel
#   $proved             ns, height, colour; lines of a predicate, parted by an empty line; a section for each panel
set encoding utf8
rows = (int(panels) + 1) / 2
set terminal pngcairo noenhanced size 1300,60 + 340 * rows background paper font 'Sans,11'
high_share = 1.0 - 50.0 / (60 + 340 * rows) # of the panels' area, below the title
set multiplot title about
set logscale xy
set border 3
set tics nomirror out
set grid lt 1 lc rgb line
set xrange [least_ns:5000]
set yrange [low:high]
set xlabel 'ns a pair' offset 0,0.4
unset key
do for [p = 1 : panels] {
  across = (p - 1) % 2
  down = (p - 1) / 2
  set lmargin at screen 0.10 + 0.36 * across
  set rmargin at screen 0.44 + 0.36 * across
  set tmargin at screen high_share * (1 - (down + 0.07) / rows)
  set bmargin at screen high_share * (1 - (down + 0.78) / rows)
  set title titles[p]
  if (across) {
    unset ylabel
    set ytics ('' never * apart, '' nothing * apart, '' 1e-32, '' 1e-24, '' 1e-16, '' 1e-8, '' 1)
  } else {
    set ylabel 'farthest wrong answer / size'
    set ytics ('none wrong' never * apart, 'wrong by 0' nothing * apart, \
               '1e-32' 1e-32, '1e-24' 1e-24, '1e-16' 1e-16, '1e-8' 1e-8, '1' 1)
  }
  plot $marks index (p - 1) using 1:2:3:4 with points pointtype variable pointsize 1.5 linewidth 2 linecolor rgb variable, \
       $proved index (p - 1) using 1:2:3 with lines dashtype 2 linewidth 1.5 linecolor rgb variable
}
# One legend for all panels, on their right.
unset title
unset xlabel
unset ylabel
unset border
unset tics
unset grid
set tmargin at screen high_share
set key at screen 0.82,high_share left top vertical Left reverse samplen 2 spacing 1.3
plot for [i = 1 : subjects] NaN with lines linewidth 4 linecolor rgb colours[i] title names[i], \
     NaN with lines dashtype 2 linewidth 1.5 linecolor rgb ink title 'proved', \
     for [i = 1 : methods] NaN with points pointtype int(shapes[i]) pointsize 1.5 linewidth 2 linecolor rgb ink title labels[i]
unset multiplot
