# Draws the heat maps. Run gnuplot 5.2 or later on it in this folder:
#   gnuplot stress.gp
# The panels, in the order of the blocks of stress.dat; the last one is the overview. samples: N of
# the RMSE; 0: it differs.
array title[21] = ['light-aspect: length of the light over its width, in a penumbra', 'light-distance: distance in lengths of the light, in a penumbra', 'grazing-light: distance from the plane of a light beside the receiver', 'horizon: share of the light''s height that is above the horizon', 'light-corner: distance of the receiver from a corner of the light', 'contact: gap between receiver and occluder', 'edge-direction: angle of the shadow edge to the light''s long sides, degrees', 'blinds: slats over four widths of the penumbra', 'needles: occluder cut into this many slivers', 'tessellation: triangles of the occluder', 'degenerate: faces that a mesh should not have', 'roughness: roughness of a mirroring receiver, light''s middle just lit', 'grazing-view: cosine at which a GGX receiver of roughness 0.3 is seen', 'terminator: angle between geometric and shading normal, degrees', 'albedo: reflectance of a closed room that emits 1, all bounces', 'shared-paths: roughness of a ceiling that lights the receiver by shared paths of 16 x 16 pixels', 'scale: size of the scene', 'offset: distance of the scene from the origin, in its own size', 'bright-pair: radiance of a hidden light over that of the visible one', 'many-lights: lights of one power', 'each case at its worst setting; in how many settings of how many']
array columns[21] = [6, 9, 6, 7, 7, 6, 9, 5, 6, 5, 5, 7, 5, 5, 8, 3, 7, 8, 7, 4, 5]
array rows[21] = [5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 20]
array samples[21] = [64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 768, 64, 64, 64, 64, 0]
# The pictures, and the first and last panel of each.
array picture[5] = ['stress', 'stress_light', 'stress_occluder', 'stress_surface', 'stress_scene']
array first[5] = [21, 1, 6, 12, 17]
array last[5] = [21, 5, 11, 16, 20]

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
