# Chart of rates_study: error over the number of samples. Run it in the folder of the tables.
set datafile separator ";"
set logscale xy
set format y "10^{%L}"
set xlabel "samples"
set ylabel "relMSE"
set xrange [4:1024]
set xtics (4, 16, 64, 256, 1024)
set grid lc rgb "#dddddd"
set key bottom left font ",9" samplen 2
files = "oblique across along lit near grazing"
titles = "'penumbra, edge oblique' 'penumbra, edge across chords 0' \
'penumbra, edge along chords 0' 'fully lit' 'near the light' 'grazing'"
colors = "#999999 #e69f00 #d55e00 #56b4e9 #000000 #009e73 #cc79a7"
do for [output in "png svg"] {
  if (output eq "png") { set terminal pngcairo size 1500,950 font "sans,11" }
  if (output eq "svg") { set terminal svg size 1500,950 font "sans,11" background rgb "white" }
  set output "rates." . output
  set multiplot layout 2,3
  do for [i = 1:6] {
    set title word(titles, i)
    if (i == 2) { unset key }
    plot for [m = 2:6] "rates_" . word(files, i) . ".csv" using 1:m with linespoints pt 7 ps 0.6 \
           lw (m == 6 ? 2.5 : 1.5) lc rgb word(colors, m - 1) title columnheader(m), \
         for [m = 7:8] "rates_" . word(files, i) . ".csv" using 1:m with lines dt 2 \
           lc rgb word(colors, m - 1) title columnheader(m)
  }
  unset multiplot
  set key
  unset output
}
