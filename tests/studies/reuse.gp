# Chart of reuse_study: efficiency with shared paths over samples. Run it in the table's folder.
set datafile separator ";"
set logscale xy 2
set format x "%.0f"
set format y "%.0f"
set xlabel "samples per pixel"
set grid lc rgb "#dddddd"
set xrange [3:340]
set yrange [0.7:64]
scenes = "`head -1 reuse_efficiency.csv | cut -d';' -f2- | tr ';' ' '`"
do for [output in "png svg"] {
  if (output eq "png") { set terminal pngcairo size 1200,460 noenhanced font "sans,11" }
  if (output eq "svg") {
    set terminal svg size 1200,460 noenhanced font "sans,11" background rgb "white"
  }
  set output "reuse." . output
  set multiplot layout 1,4 title "1/(relMSE s), times that without sharing"
  do for [i = 0:3] {
    set title sprintf("--reuse %d", 2 ** (i + 1))
    if (i == 0) { set key top right samplen 1 } else { unset key }
    plot for [k = 2:words(scenes) + 1] "reuse_efficiency.csv" index i every ::1 using 1:k \
         with linespoints pt 7 ps 0.6 lw 1.5 lt k - 1 title word(scenes, k - 1)
  }
  unset multiplot
  unset output
}
