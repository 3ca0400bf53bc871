# The lines above are this run's own; the rest is the same for every run.
# Columns of stress.dat: column and row of the cell, RMSE / truth, verdict, and the labels of its
# column and row.
low = -4.0
high = 0.5
colour(rmse) = rmse <= 10 ** low ? low : rmse >= 10 ** high ? high : log10(rmse)
number(rmse) = sprintf(rmse < 9.5 ? '%.1g' : '%.0f', rmse)
set palette defined (low '#f2f7fc', -2 '#b9d4ec', -1 '#fee08b', 0 '#f4814f', high '#d9463a')
set cbrange [low:high]
set format cb '10^{%g}'
set cbtics 1
set lmargin 20
set rmargin 14
set tmargin 2.5
set bmargin 2
set tics nomirror scale 0 noenhanced
set border lc rgb '#888888'
unset key

row_height = 46
panel_rest = 90
min_rows = 4  # leave room for the colours' scale

do for [p = 1:|picture|] {
  panels = last[p] - first[p] + 1
  shown_rows = p == 1 && rows[first[p]] < min_rows ? min_rows : rows[first[p]]
  height = panels * (row_height * shown_rows + panel_rest)
  do for [type in 'svg pngcairo'] {
    # Pictures have a white background on dark pages, too.
    if (type eq 'svg') {
      set terminal svg size 1000,height font 'sans,12' background rgb 'white'
    } else {
      set terminal pngcairo size 1000,height font 'sans,12' background rgb 'white'
    }
    set output picture[p] . (type eq 'svg' ? '.svg' : '.png')
    set multiplot layout panels,1
    do for [i = int(first[p]):int(last[p])] {
      set title title[i] noenhanced
      set cblabel samples[i] > 0 ? sprintf('RMSE / truth, N = %d', samples[i]) : 'RMSE / truth'
      set xrange [-0.5 : columns[i] - 0.5]
      set yrange [rows[i] - 0.5 : -0.5]
      plot 'stress.dat' index i-1 \
          using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):(colour($3)):xticlabels(5):yticlabels(6) \
          with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
        '' index i-1 using 1:2:(number($3)) with labels offset 0,0.4 notitle, \
        '' index i-1 using 1:2:4 with labels offset 0,-0.6 font ',9' notitle
    }
    unset multiplot
    unset output
  }
}
