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

# Draws how well the estimators did, from the tables of stetro_accuracy.
#   gnuplot -e "folder='out/accuracy'; estimators='fused paper'" accuracy.gp
# Writes accuracy.svg into the folder: error against step above, the errors' shares below.

set datafile separator ','
set terminal svg size 1200,720 font 'Helvetica,13' background rgb 'white'
set grid lc rgb '#dddddd'
set key top right
mm = 1000.0
deg = 180.0 / pi
color(name) = name eq 'fused' ? '#1f77b4' : '#d62728'
treads(name) = folder.'/'.name.'_treads.csv'
shares(name) = folder.'/'.name.'_histogram.csv'

set output folder.'/accuracy.svg'
set multiplot layout 2,3

set xlabel 'step'
set logscale y
set yrange [*:*]
set xrange [0.5:*]
set title 'x: from the riser ahead'
set ylabel 'error, rms; 95 % dashed [mm]'
plot for [name in estimators] treads(name) using "step":(column("x_rmse_m") * mm) with linespoints pt 7 ps 0.5 lw 2 lc rgb color(name) title name, \
     for [name in estimators] treads(name) using "step":(column("x_p95_m") * mm) with lines dt 2 lc rgb color(name) notitle
set title 'y: from the right wall'
plot for [name in estimators] treads(name) using "step":(column("y_rmse_m") * mm) with linespoints pt 7 ps 0.5 lw 2 lc rgb color(name) title name, \
     for [name in estimators] treads(name) using "step":(column("y_p95_m") * mm) with lines dt 2 lc rgb color(name) notitle
set title 'heading'
set ylabel 'error, rms; 95 % dashed [deg]'
plot for [name in estimators] treads(name) using "step":(column("heading_rmse_rad") * deg) with linespoints pt 7 ps 0.5 lw 2 lc rgb color(name) title name, \
     for [name in estimators] treads(name) using "step":(column("heading_p95_rad") * deg) with lines dt 2 lc rgb color(name) notitle

unset logscale y
set yrange [0:*]
set xrange [*:*]
set ylabel 'share of the estimates [%]'
set title 'x'
set xlabel 'error [mm]; what lies beyond is not drawn'
plot for [name in estimators] shares(name) every ::1::118 using (column("error_m") * mm):(column("x_share") * 100) with steps lw 2 lc rgb color(name) title name
set title 'y'
plot for [name in estimators] shares(name) every ::1::118 using (column("error_m") * mm):(column("y_share") * 100) with steps lw 2 lc rgb color(name) title name
set title 'heading'
set xlabel 'error [deg]; what lies beyond is not drawn'
plot for [name in estimators] shares(name) every ::1::118 using (column("error_rad") * deg):(column("heading_share") * 100) with steps lw 2 lc rgb color(name) title name
unset multiplot
set output
