# Draws the heat maps. Run gnuplot 5 on it in this folder:
#   gnuplot stress.gp
set palette defined (-4 '#f2f7fc', -2 '#b9d4ec', -1 '#fee08b', 0 '#f4814f', 0.5 '#d9463a')
set cbrange [-4:0.5]
set format cb '10^{%g}'
set cbtics 1
set cblabel 'RMSE / truth, N = 64'
set lmargin 20
set rmargin 14
set tmargin 2.5
set bmargin 2
set tics nomirror scale 0 noenhanced
set border lc rgb '#888888'
unset key

set terminal svg size 1000,964 font 'sans,12' background rgb 'white'
set output 'stress.svg'
set title "each case at its worst setting; in how many settings of how many" noenhanced
set xrange [-0.5:4.5]
set yrange [18.5:-0.5]
set xtics ('point' 0, 'solid-angle' 1, 'line-ratio' 2, 'line-rays' 3, 'line' 4)
set ytics ('light-aspect' 0, 'light-distance' 1, 'grazing-light' 2, 'horizon' 3, 'light-corner' 4, 'contact' 5, 'edge-direction' 6, 'blinds' 7, 'needles' 8, 'tessellation' 9, 'degenerate' 10, 'roughness' 11, 'grazing-view' 12, 'terminator' 13, 'albedo' 14, 'scale' 15, 'offset' 16, 'bright-pair' 17, 'many-lights' 18)
plot 'stress.dat' index 19 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 19 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 19 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset output
set terminal pngcairo size 1000,964 font 'sans,12' background rgb 'white'
set output 'stress.png'
set title "each case at its worst setting; in how many settings of how many" noenhanced
set xrange [-0.5:4.5]
set yrange [18.5:-0.5]
set xtics ('point' 0, 'solid-angle' 1, 'line-ratio' 2, 'line-rays' 3, 'line' 4)
set ytics ('light-aspect' 0, 'light-distance' 1, 'grazing-light' 2, 'horizon' 3, 'light-corner' 4, 'contact' 5, 'edge-direction' 6, 'blinds' 7, 'needles' 8, 'tessellation' 9, 'degenerate' 10, 'roughness' 11, 'grazing-view' 12, 'terminator' 13, 'albedo' 14, 'scale' 15, 'offset' 16, 'bright-pair' 17, 'many-lights' 18)
plot 'stress.dat' index 19 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 19 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 19 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset output

set terminal svg size 1000,1600 font 'sans,12' background rgb 'white'
set output 'stress_light.svg'
set multiplot layout 5,1
set title "light-aspect: length of the light over its width, in a penumbra" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 0 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 0 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 0 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "light-distance: distance in lengths of the light, in a penumbra" noenhanced
set xrange [-0.5:8.5]
set yrange [4.5:-0.5]
set xtics ('0.0001' 0, '0.001' 1, '0.01' 2, '0.1' 3, '1' 4, '10' 5, '100' 6, '1000' 7, '10000' 8)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 1 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 1 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 1 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "grazing-light: distance from the plane of a light beside the receiver" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 2 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 2 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 2 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "horizon: share of the light's height that is above the horizon" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.5' 1, '0.1' 2, '0.01' 3, '0.001' 4, '0.0001' 5, '1e-05' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 3 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 3 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 3 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "light-corner: distance of the receiver from a corner of the light" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5, '1e-06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 4 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 4 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 4 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output
set terminal pngcairo size 1000,1600 font 'sans,12' background rgb 'white'
set output 'stress_light.png'
set multiplot layout 5,1
set title "light-aspect: length of the light over its width, in a penumbra" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 0 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 0 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 0 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "light-distance: distance in lengths of the light, in a penumbra" noenhanced
set xrange [-0.5:8.5]
set yrange [4.5:-0.5]
set xtics ('0.0001' 0, '0.001' 1, '0.01' 2, '0.1' 3, '1' 4, '10' 5, '100' 6, '1000' 7, '10000' 8)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 1 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 1 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 1 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "grazing-light: distance from the plane of a light beside the receiver" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 2 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 2 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 2 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "horizon: share of the light's height that is above the horizon" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.5' 1, '0.1' 2, '0.01' 3, '0.001' 4, '0.0001' 5, '1e-05' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 3 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 3 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 3 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "light-corner: distance of the receiver from a corner of the light" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5, '1e-06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 4 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 4 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 4 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output

set terminal svg size 1000,1920 font 'sans,12' background rgb 'white'
set output 'stress_occluder.svg'
set multiplot layout 6,1
set title "contact: gap between receiver and occluder" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 5 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 5 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 5 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "edge-direction: angle of the shadow edge to the light's long sides, degrees" noenhanced
set xrange [-0.5:8.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '0.1' 1, '1' 2, '10' 3, '45' 4, '80' 5, '89' 6, '89.9' 7, '90' 8)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 6 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 6 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 6 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "blinds: slats over four widths of the penumbra" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 7 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 7 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 7 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "needles: occluder cut into this many slivers" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 8 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 8 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 8 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "tessellation: triangles of the occluder" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('100' 0, '1000' 1, '10000' 2, '100000' 3, '1e+06' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 9 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 9 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 9 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "degenerate: faces that a mesh should not have" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('clean' 0, 'twice' 1, 'coplanar' 2, 'no-area' 3, 'all' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 10 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 10 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 10 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output
set terminal pngcairo size 1000,1920 font 'sans,12' background rgb 'white'
set output 'stress_occluder.png'
set multiplot layout 6,1
set title "contact: gap between receiver and occluder" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4, '1e-05' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 5 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 5 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 5 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "edge-direction: angle of the shadow edge to the light's long sides, degrees" noenhanced
set xrange [-0.5:8.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '0.1' 1, '1' 2, '10' 3, '45' 4, '80' 5, '89' 6, '89.9' 7, '90' 8)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 6 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 6 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 6 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "blinds: slats over four widths of the penumbra" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 7 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 7 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 7 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "needles: occluder cut into this many slivers" noenhanced
set xrange [-0.5:5.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 8 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 8 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 8 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "tessellation: triangles of the occluder" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('100' 0, '1000' 1, '10000' 2, '100000' 3, '1e+06' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 9 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 9 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 9 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "degenerate: faces that a mesh should not have" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('clean' 0, 'twice' 1, 'coplanar' 2, 'no-area' 3, 'all' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 10 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 10 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 10 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output

set terminal svg size 1000,1280 font 'sans,12' background rgb 'white'
set output 'stress_surface.svg'
set multiplot layout 4,1
set title "roughness: roughness of a mirroring receiver, light's middle just lit" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.3' 1, '0.1' 2, '0.03' 3, '0.01' 4, '0.003' 5, '0.001' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 11 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 11 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 11 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "grazing-view: cosine at which a GGX receiver of roughness 0.3 is seen" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('0.5' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 12 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 12 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 12 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "terminator: angle between geometric and shading normal, degrees" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '10' 1, '30' 2, '60' 3, '80' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 13 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 13 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 13 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "albedo: reflectance of a closed room that emits 1, all bounces" noenhanced
set xrange [-0.5:7.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '0.25' 1, '0.5' 2, '0.75' 3, '0.9' 4, '0.97' 5, '0.99' 6, '0.999' 7)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 14 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 14 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 14 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output
set terminal pngcairo size 1000,1280 font 'sans,12' background rgb 'white'
set output 'stress_surface.png'
set multiplot layout 4,1
set title "roughness: roughness of a mirroring receiver, light's middle just lit" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '0.3' 1, '0.1' 2, '0.03' 3, '0.01' 4, '0.003' 5, '0.001' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 11 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 11 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 11 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "grazing-view: cosine at which a GGX receiver of roughness 0.3 is seen" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('0.5' 0, '0.1' 1, '0.01' 2, '0.001' 3, '0.0001' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 12 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 12 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 12 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "terminator: angle between geometric and shading normal, degrees" noenhanced
set xrange [-0.5:4.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '10' 1, '30' 2, '60' 3, '80' 4)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 13 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 13 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 13 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "albedo: reflectance of a closed room that emits 1, all bounces" noenhanced
set xrange [-0.5:7.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '0.25' 1, '0.5' 2, '0.75' 3, '0.9' 4, '0.97' 5, '0.99' 6, '0.999' 7)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 14 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 14 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 14 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output

set terminal svg size 1000,1280 font 'sans,12' background rgb 'white'
set output 'stress_scene.svg'
set multiplot layout 4,1
set title "scale: size of the scene" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1e-06' 0, '0.0001' 1, '0.01' 2, '1' 3, '100' 4, '10000' 5, '1e+06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 15 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 15 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 15 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "offset: distance of the scene from the origin, in its own size" noenhanced
set xrange [-0.5:7.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '1' 1, '10' 2, '100' 3, '1000' 4, '10000' 5, '100000' 6, '1e+06' 7)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 16 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 16 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 16 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "bright-pair: radiance of a hidden light over that of the visible one" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5, '1e+06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 17 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 17 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 17 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "many-lights: lights of one power" noenhanced
set xrange [-0.5:3.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 18 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 18 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 18 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output
set terminal pngcairo size 1000,1280 font 'sans,12' background rgb 'white'
set output 'stress_scene.png'
set multiplot layout 4,1
set title "scale: size of the scene" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1e-06' 0, '0.0001' 1, '0.01' 2, '1' 3, '100' 4, '10000' 5, '1e+06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 15 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 15 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 15 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "offset: distance of the scene from the origin, in its own size" noenhanced
set xrange [-0.5:7.5]
set yrange [4.5:-0.5]
set xtics ('0' 0, '1' 1, '10' 2, '100' 3, '1000' 4, '10000' 5, '100000' 6, '1e+06' 7)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 16 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 16 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 16 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "bright-pair: radiance of a hidden light over that of the visible one" noenhanced
set xrange [-0.5:6.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3, '10000' 4, '100000' 5, '1e+06' 6)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 17 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 17 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 17 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
set title "many-lights: lights of one power" noenhanced
set xrange [-0.5:3.5]
set yrange [4.5:-0.5]
set xtics ('1' 0, '10' 1, '100' 2, '1000' 3)
set ytics ('point' 0, 'solid-angle' 1, 'line-ratio (biased)' 2, 'line-rays' 3, 'line' 4)
plot 'stress.dat' index 18 using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror fs solid border lc rgb 'white' fc palette notitle, \
  '' index 18 using 1:2:4 with labels offset 0,0.4 notitle, \
  '' index 18 using 1:2:5 with labels offset 0,-0.6 font ',9' notitle
unset multiplot
unset output
