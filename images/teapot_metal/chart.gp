# Draws the charts. Run gnuplot 5.2 or later on it in this folder:
#   gnuplot chart.gp
title = 'teapot_metal, 256x256, all bounces'
subtitle = 'median and min-max band of 6 seeds, less the noise of the reference'
epsilon = 0.01  # of relMSE
noise = 0.000510444  # relMSE of the reference itself; 0: not known
bottom = 0.0001  # of the error axis
top = 1.40896  # the largest error
# By samples per pixel and by seconds: the smallest value, the largest, and labels.
array low[2] = [1, 0.0688797]
array high[2] = [64, 7.56435]
array tics[2] = ['1 2 4 8 16 32 64 ', '0.1 0.2 0.5 1 2 5']
# The methods, in the order of chart.dat.
array label[4] = ['point', 'solid-angle', 'line-rays', 'line']
array colour[4] = ['#e69f00', '#d55e00', '#56b4e9', '#000000']
array mark[4] = ['7', '5', '13', '9']

# The lines above are the chart's own; the rest is the same for every chart.
set logscale xy
set format y '10^{%L}'
set grid lt 1 lw 0.7 lc rgb '#d8d8d8'
set border lc rgb '#444444'
set key at screen 0.5,0.015 center bottom horizontal maxrows 4 Left reverse samplen 2.5 noenhanced
set bmargin 8.5
set title title . "\n" . subtitle noenhanced
set ylabel sprintf('relMSE = mean of (x-r)^2 / (r^2 + %g)', epsilon)
set yrange [bottom:*]

# Lines of known slopes run through a corner above the highest curve.
guide(x, slope) = 1.5 * top * (x / low[column]) ** slope

do for [over = 1:2] {
  # Columns of chart.dat: samples per pixel, seconds (median, least, largest), error (the same).
  column = over
  set xlabel over == 1 ? 'samples per pixel' : 'render time of one picture, seconds (wall clock)'
  set xrange [low[over] / 1.1 : 1.1 * high[over]]
  set xtics auto
  if (words(tics[over]) > 0) {
    set xtics ()
    do for [t in tics[over]] { set xtics add (t real(t)) }
  }
  do for [type in 'svg png'] {
    # Charts have a white background on dark pages, too.
    if (type eq 'svg') {
      set terminal svg size 960,640 font 'sans,14' background rgb 'white'
    } else {
      set terminal pngcairo size 1440,960 font 'sans,19' linewidth 1.5 background rgb 'white'
    }
    set output sprintf('error_vs_%s.%s', over == 1 ? 'spp' : 'time', type)
    plot \
      for [i = 1:noise > 0] (noise > bottom ? noise : bottom) with filledcurves y1=bottom \
        fc rgb '#999999' fs pattern 4 noborder \
        title sprintf('noise of the reference, %.2g', noise), \
      for [i = 1:|label|] 'chart.dat' index i-1 using over:6:7 with filledcurves \
        fc rgb colour[i] fs transparent solid 0.14 noborder notitle, \
      for [i = 1:|label|] 'chart.dat' index i-1 using over:5 with linespoints \
        lw 2 ps 1.1 pt int(mark[i]) lc rgb colour[i] title label[i], \
      guide(x, -1) with lines lw 1 dt 2 lc rgb '#777777' title 'slope -1', \
      guide(x, -1.5) with lines lw 1 dt 4 lc rgb '#777777' title 'slope -1.5'
    unset output
  }
}
