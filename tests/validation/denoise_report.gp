# Chart of denoise.py: error over time. Run it in the folder of the tables with `scenes` set.
set datafile separator ";"
set datafile missing NaN
set terminal pngcairo size 1200,500 noenhanced font "sans,11"
set output "denoise.png"
set logscale xy
set format x "%g"
set format y "%.0e"
set grid lc rgb "#dddddd"
set xlabel "seconds of one thread"
grey = "#999999"; black = "#000000"; orange = "#e08214"; blue = "#2166ac"
# Columns: 2 reuse, 4 mode, 6 and 8 seconds of rendering and denoising, 9 error, 12 squared bias.
x(reuse, mode) = (column(2) == reuse && strcol(4) eq mode) ? column(6) + column(8) : NaN
set multiplot layout 1,words(scenes) margins .07,.98,.25,.93 spacing .055
do for [i = 1:words(scenes)] {
  file = word(scenes, i) . ".csv"
  set title word(scenes, i)
  if (i == 1) { set ylabel "relMSE"; set key at screen .5,.1 center maxrows 2 samplen 3 } \
  else { unset ylabel; unset key }
  plot file every ::1 using (x(1, "plain")):9 with linespoints pt 7 ps .6 lw 1.5 \
         lc rgb grey title "plain, --reuse 1", \
       file every ::1 using (x(16, "plain")):9 with linespoints pt 7 ps .6 lw 1.5 \
         lc rgb black title "plain, --reuse 16", \
       file every ::1 using (x(1, "clean")):9 with linespoints pt 5 ps .6 lw 1.5 \
         lc rgb orange title "denoised, --reuse 1", \
       file every ::1 using (x(1, "clean")):12 with lines dt 2 lw 1.5 \
         lc rgb orange title "squared bias, --reuse 1", \
       file every ::1 using (x(16, "clean")):9 with linespoints pt 5 ps .6 lw 1.5 \
         lc rgb blue title "denoised, --reuse 16", \
       file every ::1 using (x(16, "clean")):12 with lines dt 2 lw 1.5 \
         lc rgb blue title "squared bias, --reuse 16"
}
unset multiplot
