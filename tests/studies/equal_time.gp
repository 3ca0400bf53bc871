# Chart of equal_time_study: error over time. Run it in the folder of the tables.
set datafile separator ";"
set logscale xy
set format y "10^{%L}"
set xlabel "processor seconds for the picture"
set ylabel "relMSE in penumbrae"
set grid lc rgb "#dddddd"
set key top right samplen 2
colors = "#e69f00 #d55e00 #56b4e9 #000000 #d55e00 #000000"
do for [output in "png svg"] {
  if (output eq "png") { set terminal pngcairo size 800,560 font "sans,11" }
  if (output eq "svg") { set terminal svg size 800,560 font "sans,11" background rgb "white" }
  set output "equal_time." . output
  plot for [i = 0:3] "equal_time_curves.csv" index i using 1:2 with linespoints pt 7 ps 0.6 \
         lw (i == 3 ? 2.5 : 1.5) lc rgb word(colors, i + 1) title columnheader(1), \
       for [i = 4:5] "equal_time_curves.csv" index i using 1:2 with lines dt 2 \
         lc rgb word(colors, i + 1) title columnheader(1), \
       1e-5 with lines dt 3 lc rgb "#999999" notitle, 1e-6 with lines dt 3 lc rgb "#999999" notitle
  unset output
}
