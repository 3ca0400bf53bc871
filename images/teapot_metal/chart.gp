# Draws the charts. Run gnuplot 5 on it in this folder:
#   gnuplot chart.gp
set logscale xy
set format y '10^{%L}'
set grid lt 1 lw 0.7 lc rgb '#d8d8d8'
set border lc rgb '#444444'
set key at screen 0.5,0.015 center bottom horizontal maxrows 4 Left reverse samplen 2.5 noenhanced
set bmargin 8.5
set title 'teapot_metal, 256x256, all bounces' . "\n" . 'median and min-max band of 6 seeds, less the noise of the reference' noenhanced
set ylabel 'relMSE = mean of (x-r)^2 / (r^2 + 0.01)'
bottom = 0.01
set yrange [bottom:*]

set xlabel 'render time of one picture, seconds (wall clock)'
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2)
set xrange [0.0315952:4.19984]
set terminal svg size 960,640 font 'sans,14' background rgb 'white'
set output 'error_vs_time.svg'
plot \
  0.01 with filledcurves y1=bottom fc rgb '#999999' fs pattern 4 noborder title 'noise of the reference, 0.0003', \
  'chart.dat' index 0 using 2:6:7 with filledcurves fc rgb '#e69f00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 1 using 2:6:7 with filledcurves fc rgb '#d55e00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 2 using 2:6:7 with filledcurves fc rgb '#56b4e9' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 3 using 2:6:7 with filledcurves fc rgb '#000000' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 0 using 2:5 with linespoints lw 2 ps 1.1 pt 7 lc rgb '#e69f00' title 'point', \
  'chart.dat' index 1 using 2:5 with linespoints lw 2 ps 1.1 pt 5 lc rgb '#d55e00' title 'solid-angle', \
  'chart.dat' index 2 using 2:5 with linespoints lw 2 ps 1.1 pt 13 lc rgb '#56b4e9' title 'line-rays', \
  'chart.dat' index 3 using 2:5 with linespoints lw 2 ps 1.1 pt 9 lc rgb '#000000' title 'line', \
  2.11686*(x/0.0347548)**(-1) with lines lw 1 dt 2 lc rgb '#777777' title 'slope -1', \
  2.11686*(x/0.0347548)**(-1.5) with lines lw 1 dt 4 lc rgb '#777777' title 'slope -1.5'
unset output
set terminal pngcairo size 1440,960 font 'sans,19' linewidth 1.5 background rgb 'white'
set output 'error_vs_time.png'
plot \
  0.01 with filledcurves y1=bottom fc rgb '#999999' fs pattern 4 noborder title 'noise of the reference, 0.0003', \
  'chart.dat' index 0 using 2:6:7 with filledcurves fc rgb '#e69f00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 1 using 2:6:7 with filledcurves fc rgb '#d55e00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 2 using 2:6:7 with filledcurves fc rgb '#56b4e9' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 3 using 2:6:7 with filledcurves fc rgb '#000000' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 0 using 2:5 with linespoints lw 2 ps 1.1 pt 7 lc rgb '#e69f00' title 'point', \
  'chart.dat' index 1 using 2:5 with linespoints lw 2 ps 1.1 pt 5 lc rgb '#d55e00' title 'solid-angle', \
  'chart.dat' index 2 using 2:5 with linespoints lw 2 ps 1.1 pt 13 lc rgb '#56b4e9' title 'line-rays', \
  'chart.dat' index 3 using 2:5 with linespoints lw 2 ps 1.1 pt 9 lc rgb '#000000' title 'line', \
  2.11686*(x/0.0347548)**(-1) with lines lw 1 dt 2 lc rgb '#777777' title 'slope -1', \
  2.11686*(x/0.0347548)**(-1.5) with lines lw 1 dt 4 lc rgb '#777777' title 'slope -1.5'
unset output

set xlabel 'samples per pixel'
set xtics (1, 2, 4, 8, 16, 32, 64)
set xrange [0.909091:70.4]
set terminal svg size 960,640 font 'sans,14' background rgb 'white'
set output 'error_vs_spp.svg'
plot \
  0.01 with filledcurves y1=bottom fc rgb '#999999' fs pattern 4 noborder title 'noise of the reference, 0.0003', \
  'chart.dat' index 0 using 1:6:7 with filledcurves fc rgb '#e69f00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 1 using 1:6:7 with filledcurves fc rgb '#d55e00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 2 using 1:6:7 with filledcurves fc rgb '#56b4e9' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 3 using 1:6:7 with filledcurves fc rgb '#000000' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 0 using 1:5 with linespoints lw 2 ps 1.1 pt 7 lc rgb '#e69f00' title 'point', \
  'chart.dat' index 1 using 1:5 with linespoints lw 2 ps 1.1 pt 5 lc rgb '#d55e00' title 'solid-angle', \
  'chart.dat' index 2 using 1:5 with linespoints lw 2 ps 1.1 pt 13 lc rgb '#56b4e9' title 'line-rays', \
  'chart.dat' index 3 using 1:5 with linespoints lw 2 ps 1.1 pt 9 lc rgb '#000000' title 'line', \
  2.11686*(x/1)**(-1) with lines lw 1 dt 2 lc rgb '#777777' title 'slope -1', \
  2.11686*(x/1)**(-1.5) with lines lw 1 dt 4 lc rgb '#777777' title 'slope -1.5'
unset output
set terminal pngcairo size 1440,960 font 'sans,19' linewidth 1.5 background rgb 'white'
set output 'error_vs_spp.png'
plot \
  0.01 with filledcurves y1=bottom fc rgb '#999999' fs pattern 4 noborder title 'noise of the reference, 0.0003', \
  'chart.dat' index 0 using 1:6:7 with filledcurves fc rgb '#e69f00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 1 using 1:6:7 with filledcurves fc rgb '#d55e00' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 2 using 1:6:7 with filledcurves fc rgb '#56b4e9' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 3 using 1:6:7 with filledcurves fc rgb '#000000' fs transparent solid 0.14 noborder notitle, \
  'chart.dat' index 0 using 1:5 with linespoints lw 2 ps 1.1 pt 7 lc rgb '#e69f00' title 'point', \
  'chart.dat' index 1 using 1:5 with linespoints lw 2 ps 1.1 pt 5 lc rgb '#d55e00' title 'solid-angle', \
  'chart.dat' index 2 using 1:5 with linespoints lw 2 ps 1.1 pt 13 lc rgb '#56b4e9' title 'line-rays', \
  'chart.dat' index 3 using 1:5 with linespoints lw 2 ps 1.1 pt 9 lc rgb '#000000' title 'line', \
  2.11686*(x/1)**(-1) with lines lw 1 dt 2 lc rgb '#777777' title 'slope -1', \
  2.11686*(x/1)**(-1.5) with lines lw 1 dt 4 lc rgb '#777777' title 'slope -1.5'
unset output
