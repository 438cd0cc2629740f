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
set terminal pngcairo size 1300,720 font 'Helvetica,12' background rgb 'white'
set size ratio -1
set border lc rgb '#888888'
set xlabel 'x [m]'
set ylabel 'y [m]'
set key off
do for [name in maps] {
  set output folder.'/usability_'.name.'.png'
  set multiplot layout 1,2 title name noenhanced
  set title 'spectral radius of a centroid step: it comes home below 1'
  set palette defined (0 '#1a9850', 0.5 '#a6d96a', 1 '#ffffbf', 1.001 '#fdae61', 2 '#d73027', 3 '#67001f')
  set cbrange [0:3]
  plot table('usability', name) using "x_m":"y_m":"spectral_radius" with points pt 5 ps 0.45 palette, \
       table('walls', name) using "x_m":"y_m" with dots lc rgb 'black'
  set title 'standard deviation of the position that the map promises [cm]'
  set palette defined (0 '#1a9850', 1.25 '#d9ef8b', 1.26 '#fee08b', 3 '#f46d43', 10 '#a50026')
  set cbrange [0:10]
  plot table('usability', name) using "x_m":"y_m":(100.0 * column("worst_sigma_m")) with points pt 5 ps 0.45 palette, \
       table('walls', name) using "x_m":"y_m" with dots lc rgb 'black'
  unset multiplot
}

# One scan where it was found.
set terminal pngcairo size 1250,860 font 'Helvetica,12' background rgb 'white'
fate(what) = stringcolumn("fate") eq what ? column("x_m") : NaN
place(what) = stringcolumn("what") eq what ? column("x_m") : NaN
set key outside right top
do for [name in logs] {
  set output folder.'/scan_'.name.'.png'
  set title name.': a scan at the pose that was found' noenhanced
  plot table('walls', name) using "x_m":"y_m" with points pt 5 ps 0.25 lc rgb '#bbbbbb' title 'walls of the map', \
       table('scan', name) using (fate('agrees')):"y_m" with points pt 7 ps 0.5 lc rgb '#1a9850' title 'beam agrees', \
       table('scan', name) using (fate('behind')):"y_m" with points pt 7 ps 0.5 lc rgb '#1f77b4' title 'on a wall behind one that is gone', \
       table('scan', name) using (fate('shorter')):"y_m" with points pt 7 ps 0.5 lc rgb '#d62728' title 'before the wall', \
       table('scan', name) using (fate('longer')):"y_m" with points pt 7 ps 0.5 lc rgb '#ff7f0e' title 'on nothing', \
       table('places', name) using (place('published')):"y_m" with linespoints pt 2 ps 1 lc rgb '#9467bd' title 'published search, from the belief', \
       table('places', name) using (place('centroid_scan_all')):"y_m" with points pt 12 ps 2 lw 2 lc rgb '#d62728' title 'centroid of the scan, all beams', \
       table('places', name) using (place('centroid_map_all')):"y_m" with points pt 8 ps 2 lw 2 lc rgb '#d62728' title 'centroid of the map, all beams', \
       table('places', name) using (place('centroid_scan')):"y_m" with points pt 12 ps 2 lw 2 lc rgb '#1a9850' title 'of the scan, beams that agree', \
       table('places', name) using (place('centroid_map')):"y_m" with points pt 8 ps 2 lw 2 lc rgb '#1a9850' title 'of the map, beams that agree', \
       table('places', name) using (place('reference')):"y_m" with points pt 4 ps 2 lw 2 lc rgb 'black' title 'reference', \
       table('places', name) using (place('found')):"y_m" with points pt 1 ps 2 lw 2 lc rgb 'black' title 'found'
}

if (convergence) {
  set terminal svg size 800,500 font 'Helvetica,13' background rgb 'white'
  set output folder.'/convergence.svg'
  set size noratio
  set grid lc rgb '#dddddd'
  set key top right title 'spectral radius at the true place'
  set logscale y
  set xlabel 'steps of the published search'
  set ylabel 'median error [m]'
  set title 'The published search on real maps, by what the map says of the place'
  kind(what) = stringcolumn("radius") eq what ? column("step") : NaN
  plot folder.'/convergence.csv' using (kind('below 0.5')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#1a9850' title 'below 0.5', \
       '' using (kind('0.5 to 1')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#ff7f0e' title '0.5 to 1', \
       '' using (kind('above 1')):"median_error_m" with linespoints pt 7 lw 2 lc rgb '#d73027' title 'above 1'
}
