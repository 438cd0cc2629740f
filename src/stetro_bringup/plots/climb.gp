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

# Draws a climb from its trace: the papers' figures 6 to 9 (S-A) for our own run.
#   gnuplot -e "trace='out/demo/trace.csv'; folder='out/demo'" climb.gp
# Writes ranges.svg, path_2d.svg, path_3d.svg and heading.svg into the folder.

set datafile separator ','
set terminal svg size 900,520 font 'Helvetica,13' background rgb 'white'
set key outside top center horizontal
set grid lc rgb '#dddddd'
deg = 180.0 / pi
stats trace using "stamp_ns" every ::1::1 nooutput
start_ns = STATS_min
minutes(ns) = (ns - start_ns) / 60e9

set output folder.'/ranges.svg'
set title 'What the side sensors said'
set xlabel 'time [min]'
set ylabel 'range [m]'
set xrange [0:*]
set yrange [0:2.2]
plot trace using (minutes(column("stamp_ns"))):"side_left_m" with dots lc rgb '#1f77b4' notitle, \
     trace using (minutes(column("stamp_ns"))):"side_right_m" with dots lc rgb '#d62728' notitle, \
     NaN with points pt 7 lc rgb '#1f77b4' title 'left', \
     NaN with points pt 7 lc rgb '#d62728' title 'right', \
     1.2 with lines dt 2 lc rgb '#555555' title 'reliable to 1.2 m'

set output folder.'/path_2d.svg'
set title 'The path from above: each tread from wall to wall (papers: x is the middle of the tread)'
set xrange [*:*]
set xlabel 'x, up the stairs [m]'
set ylabel 'y, from the right wall [m]'
set yrange [0:*]
plot trace using "true_x_m":"true_y_m" with lines lw 3 lc rgb '#bbbbbb' title 'true', \
     trace using "x_m":"y_m" with lines lw 1 lc rgb '#1f77b4' title 'estimated'

set output folder.'/path_3d.svg'
set title 'The path in space'
set xlabel 'x [m]'
set ylabel 'y [m]'
set zlabel 'z [m]' rotate
set zrange [0:*]
set view 62,328
set ticslevel 0
splot trace using "true_x_m":"true_y_m":"true_z_m" with lines lw 3 lc rgb '#bbbbbb' title 'true', \
      trace using "x_m":"y_m":"z_m" with lines lw 1 lc rgb '#1f77b4' title 'estimated'

set output folder.'/heading.svg'
set title 'Heading, counter-clockwise from straight up the stairs'
set xlabel 'time [min]'
set ylabel 'heading [deg]'
set xrange [0:*]
set yrange [*:*]
plot trace using (minutes(column("stamp_ns"))):(column("heading_rad") * deg) with lines lc rgb '#1f77b4' title 'estimated', \
     trace using (minutes(column("stamp_ns"))):(column("true_heading_rad") * deg) with lines lw 2 lc rgb '#ff7f0e' title 'true', \
     3 with lines dt 2 lc rgb '#555555' title 'dead band', -3 with lines dt 2 lc rgb '#555555' notitle
set output
