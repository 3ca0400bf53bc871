# Chart of cost_study: time over the triangles of the sheet. Run it in the folder of the tables.
set datafile separator ";"
set logscale xy
set format x "10^{%L}"
set xrange [50:2e6]
set xlabel "triangles of the sheet"
set grid lc rgb "#dddddd"
set key top left Left reverse samplen 2
do for [output in "png svg"] {
  if (output eq "png") { set terminal pngcairo size 1200,520 font "sans,11" }
  if (output eq "svg") { set terminal svg size 1200,520 font "sans,11" background rgb "white" }
  set output "cost." . output
  set multiplot layout 1,2
  set title "time of a query"
  set ylabel "ns"
  plot "cost_sheet.csv" using 1:2 with linespoints pt 7 lc rgb "#e69f00" title "shadow ray", \
       "" using 1:3 with linespoints pt 7 lc rgb "#000000" title "segment query", \
       "" using 1:(50*sqrt($1)) with lines dt 3 lc rgb "#999999" title "square root", \
       "" using 1:(20*log($1)) with lines dt 2 lc rgb "#999999" title "logarithm"
  set title "cost of a line, and what it may cost"
  set ylabel "solid-angle points"
  set yrange [1:1000]
  plot "cost_sheet.csv" using 1:4 with linespoints pt 7 lc rgb "#56b4e9" title "segment / ray", \
       "" using 1:5 with linespoints pt 7 lc rgb "#000000" \
         title "estimate, line / solid-angle", \
       for [b in "3.9 13.5 48"] real(b) with lines dt 2 lc rgb "#d55e00" \
         title "break-even " . b . " at N = " . (b eq "3.9" ? "4" : b eq "13.5" ? "16" : "64")
  set yrange [*:*]
  unset multiplot
  unset output
}
