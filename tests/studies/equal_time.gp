# Chart of equal_time_study: error over time. Run it in the folder of the tables.
set datafile separator ";"
set logscale xy
set format y "10^{%L}"
set xlabel "processor seconds for the picture"
set ylabel "relMSE in penumbrae"
set grid lc rgb "#dddddd"
set key top right samplen 2
load "equal_time_style.gp"  # colour and mark of each curve; the first `plain` are not padded
do for [output in "png svg"] {
  if (output eq "png") { set terminal pngcairo size 800,560 font "sans,11" }
  if (output eq "svg") { set terminal svg size 800,560 font "sans,11" background rgb "white" }
  set output "equal_time." . output
  plot for [i = 1:plain] "equal_time_curves.csv" index i-1 using 1:2 with linespoints \
         pt int(mark[i]) ps 0.8 lw 1.5 lc rgb colour[i] title columnheader(1), \
       for [i = plain + 1:|colour|] "equal_time_curves.csv" index i-1 using 1:2 with lines dt 2 \
         lc rgb colour[i] title columnheader(1), \
       1e-5 with lines dt 3 lc rgb "#999999" notitle, 1e-6 with lines dt 3 lc rgb "#999999" notitle
  unset output
}
