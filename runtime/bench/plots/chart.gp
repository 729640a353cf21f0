# Curves of positive numbers over sizes, both axes by powers of ten.
#   width, height               of the picture, in pixels
#   title_words x_words y_words
#   x_low x_high y_low y_high   the powers of ten at the ends of the axes
#   curves names[] colours[]    how many, what each is called, and its colour
#   $points                     x y; a section for each curve
set encoding utf8
set terminal pngcairo noenhanced size width,height background paper font sprintf('Sans,%d', width < 630 ? 7 : width / 90)
set title title_words
set xlabel x_words
set ylabel y_words
set logscale xy
set border 3
set tics nomirror out
set key above left vertical Left reverse maxcols 1 samplen 3
set grid xtics mxtics ytics lt 1 lc rgb line, lt 1 lc rgb thin_line

# Thousands and millions as the paper writes them.
power(e) = e < -3 || e > 8 ? sprintf('1e%d', e) : e < 0 ? sprintf('%g', 10.0**e) : \
           e < 3 ? sprintf('%d', 10**e) : e < 6 ? sprintf('%dK', 10**(e - 3)) : sprintf('%dM', 10**(e - 6))
set xtics ()
set ytics ()
do for [e = x_low : x_high] {
  set xtics add (power(e) 10.0**e)
  if (e < x_high) { do for [k = 2 : 9] { set xtics add ('' k * 10.0**e 1) } } # 1: between the others
}
do for [e = y_low : y_high] { set ytics add (power(e) 10.0**e) }
# The ranges are a little wider than the powers, because gnuplot leaves out an end's label that it rounds to the wrong side.
set xrange [0.99999 * 10.0**x_low : 1.00001 * 10.0**x_high]
set yrange [0.99999 * 10.0**y_low : 1.00001 * 10.0**y_high]

if (curves == 0) {
  plot NaN notitle
} else {
  plot for [i = 1 : curves] $points index (i - 1) using 1:2 with linespoints linewidth 2 pointtype 7 pointsize 1 \
       linecolor rgb colours[i] title names[i]
}
