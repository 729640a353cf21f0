# Shares of pairs over scale or place and nearness to a contact, as maps: a row for each of these two, a column for each rung.
#   words                       the title of all
#   stops                       the colours of the shares from 0 to 1, as gnuplot defines a palette
#   rows across                 of maps
#   titles[] x_words[] ticks[]  of each map; ticks as gnuplot's list of labels with their places
#   columns[]                   of the cells of each map
#   low high                    the ends of the axis of nearness, in bits
#   $shares                     column, bits, percent; a section for each map
set encoding utf8
set terminal pngcairo noenhanced size 330 * across,50 + 300 * rows background paper font 'Sans,9'
set multiplot layout rows,across title words
eval 'set palette defined ('.stops.')'
set cbrange [0:100]
set format cb '%g %%'
set tics out nomirror
set border 3
unset key
set ylabel 'nearness to a contact, bits'
set yrange [low:high]
set ytics 12
do for [i = 1 : rows * across] {
  set title titles[i]
  set xlabel x_words[i]
  eval 'set xtics ('.ticks[i].')'
  set xrange [-0.5:columns[i] - 0.5]
  plot $shares index (i - 1) using 1:2:3 with image
}
unset multiplot
