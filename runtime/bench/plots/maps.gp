# Shares of pairs over scale or place and nearness to a contact, as maps: a row for each of these two, a column for each rung.
#   words                       the title of all
#   rows across                 of maps
#   titles[] x_words[] ticks[]  of each map; ticks as gnuplot's list of labels with their places
#   columns[]                   of the cells of each map
#   low high                    the ends of the axis of nearness, in bits
#   $shares                     column, bits, percent; a section for each map
set encoding utf8
set terminal pngcairo noenhanced size 330 * across,50 + 300 * rows background '#fcfcfb' font 'Sans,9'
set multiplot layout rows,across title words
set palette defined (0 '#f2f5f7', 0.001 '#cfe3f1', 0.05 '#8ab6d9', 0.25 '#f0c36a', 0.6 '#d9693a', 1 '#8e1b2c')
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
