# Copyright 2026 The sTetro Authors
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

# Draws what the profiles tell, from the tables of stetro_profiles.
#   gnuplot -e "folder='out/profiles'; maps='tau_fl4'; logs='uw_tb4_line'; convergence=1" profiles.gp
# Writes usability_<map>.png, scan_<log>.png and convergence.svg into the folder.

set datafile separator ','
set datafile missing NaN
table(kind, name) = folder.'/'.kind.'_'.name.'.csv'

# Where the centre of mass is worth something, and where the position is determined at all.
set border lc rgb '#888888'
do for [name in maps] {
  set autoscale  # of the floor before
  stats table('walls', name) using "x_m":"y_m" name 'SIZE' nooutput
  wide = SIZE_max_x - SIZE_min_x + 2.0
  high = SIZE_max_y - SIZE_min_y + 2.0
  # Three panels of equal scale.
  panel_w = 430
  panel_h = int((panel_w - 190) * high / wide) + 110
  set terminal pngcairo size 3 * panel_w, panel_h + 30 font 'Helvetica,11' background rgb 'white'
  set output folder.'/usability_'.name.'.png'
  set multiplot layout 1,3 title name.': below 1 a centroid step brings a small error home, '.\
    'below 1.25 cm the place is determined' noenhanced font ',13'
  set lmargin 7
  set rmargin 8
  set tmargin 3
  set bmargin 3.5
  set size ratio -1
  set key off
  set xrange [SIZE_min_x - 1.0 : SIZE_max_x + 1.0]
  set yrange [SIZE_min_y - 1.0 : SIZE_max_y + 1.0]
  set xlabel 'x [m]' offset 0, 0.4
  set ylabel 'y [m]' offset 1, 0
  dot = (panel_w - 190) / wide * 0.25 / 6.0  # places stand 0.25 m apart
  wall = dot * 0.2  # cells of 5 cm
  set palette defined (0 '#1a9850', 0.5 '#a6d96a', 1 '#ffffbf', 1.001 '#fdae61', 2 '#d73027', 3 '#67001f')
  set cbrange [0:3]
  set cbtics ('0' 0, '1' 1, '2' 2, '3+' 3)
  set title 'spectral radius of the steps that run'
  plot table('usability', name) using "x_m":"y_m":"spectral_radius" with points pt 5 ps dot palette, \
       table('walls', name) using "x_m":"y_m" with points pt 5 ps wall lc rgb 'black'
  set title 'spectral radius of the published steps'
  plot table('usability', name) using "x_m":"y_m":"published_radius" with points pt 5 ps dot palette, \
       table('walls', name) using "x_m":"y_m" with points pt 5 ps wall lc rgb 'black'
  set title 'standard deviation by the map [cm]'
  set palette defined (0 '#1a9850', 1.25 '#d9ef8b', 1.26 '#fee08b', 3 '#f46d43', 5 '#a50026')
  set cbrange [0:5]
  set cbtics ('0' 0, '1.25' 1.25, '2.5' 2.5, '5+' 5)
  plot table('usability', name) using "x_m":"y_m":(100.0 * column("worst_sigma_m")) with points pt 5 ps dot palette, \
       table('walls', name) using "x_m":"y_m" with points pt 5 ps wall lc rgb 'black'
  unset multiplot
}
set autoscale
set xlabel 'x [m]'
set ylabel 'y [m]'
unset lmargin
unset rmargin
unset tmargin
unset bmargin

# One scan where it was found.
fate(what) = stringcolumn("fate") eq what ? column("x_m") : NaN
place(what) = stringcolumn("what") eq what ? column("x_m") : NaN
set key outside right top Left reverse samplen 2 spacing 1.15
set size ratio -1
do for [name in logs] {
  set terminal pngcairo size 1100,720 font 'Helvetica,12' background rgb 'white'
  set output folder.'/scan_'.name.'.png'
  # All of the scan and of the search; the map's profile may go on.
  set autoscale
  stats table('scan', name) using "x_m":"y_m" name 'SCAN' nooutput
  stats table('places', name) using "x_m":"y_m" name 'PLACES' nooutput
  least(a, b) = (a < b ? a : b) - 0.7
  most(a, b) = (a > b ? a : b) + 0.7
  set xrange [least(SCAN_min_x, PLACES_min_x) : most(SCAN_max_x, PLACES_max_x)]
  set yrange [least(SCAN_min_y, PLACES_min_y) : most(SCAN_max_y, PLACES_max_y)]
  set title name.': a scan where it was found, and the profile of the map from there' noenhanced
  walls = system("wc -l < '".table('walls', name)."'") > 1  # a map made of scans has no cells
  plot table('scan', name) using "model_x_m":"model_y_m" with lines lw 1 lc rgb '#d8c8a8' title 'profile by the map', \
       walls ? table('walls', name) : '/dev/null' using 1:2 with points pt 5 ps 0.2 lc rgb '#aaaaaa' title (walls ? 'walls of the map' : ''), \
       table('scan', name) using (fate('agrees')):"y_m" with points pt 7 ps 0.6 lc rgb '#1a9850' title 'beam agrees', \
       table('scan', name) using (fate('behind')):"y_m" with points pt 7 ps 0.6 lc rgb '#1f77b4' title 'left out: on a wall behind', \
       table('scan', name) using (fate('shorter')):"y_m" with points pt 7 ps 0.6 lc rgb '#d62728' title 'left out: before the wall', \
       table('scan', name) using (fate('longer')):"y_m" with points pt 7 ps 0.6 lc rgb '#ff7f0e' title 'left out: on nothing', \
       table('places', name) using (place('published')):"y_m" with linespoints pt 2 ps 1 lw 1.5 lc rgb '#9467bd' title 'published search', \
       table('places', name) using (place('centroid_scan_all')):"y_m" with points pt 12 ps 2 lw 2 lc rgb '#d62728' title 'centroid of the scan, all', \
       table('places', name) using (place('centroid_map_all')):"y_m" with points pt 8 ps 2 lw 2 lc rgb '#d62728' title 'centroid of the map, all', \
       table('places', name) using (place('centroid_scan')):"y_m" with points pt 12 ps 2 lw 2 lc rgb '#1a9850' title 'of the scan, that agree', \
       table('places', name) using (place('centroid_map')):"y_m" with points pt 8 ps 2 lw 2 lc rgb '#1a9850' title 'of the map, that agree', \
       table('places', name) using (place('reference')):"y_m" with points pt 4 ps 2 lw 2 lc rgb 'black' title 'reference', \
       table('places', name) using (place('found')):"y_m" with points pt 1 ps 2 lw 2 lc rgb 'black' title 'found'
}

if (convergence) {
  set terminal svg size 800,500 font 'Helvetica,13' background rgb 'white'
  set output folder.'/convergence.svg'
  set size noratio
  set grid lc rgb '#dddddd'
  set autoscale
  set key inside top right Left reverse title 'spectral radius at the true place'
  set logscale y
  set yrange [0.03:10]
  set xlabel 'steps of the published search'
  set ylabel 'median error [m]'
  set title 'The published search on real maps, by what the map says of the place'
  kind(what) = stringcolumn("radius") eq what ? column("step") : NaN
  plot folder.'/convergence.csv' using (kind('below 0.5')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#1a9850' title 'below 0.5', \
       '' using (kind('0.5 to 1')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#ff7f0e' title '0.5 to 1', \
       '' using (kind('above 1')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#d73027' title 'above 1'
}
