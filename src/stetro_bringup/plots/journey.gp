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

# Draws the way through a building from its path and its walls.
#   gnuplot -e "folder='out/demo'" journey.gp
# Writes journey.svg into the folder.

set datafile separator ','
set terminal svg size 900,620 font 'Helvetica,13' background rgb 'white'
set output folder.'/journey.svg'
set key outside top center horizontal
set title 'The way through the building'
set xlabel 'x [m]'
set ylabel 'y [m]'
set zlabel 'z [m]' rotate
set zrange [0:*]
set xyplane at 0
set view 55,335
set view equal xy
splot folder.'/walls.csv' using "x_m":"y_m":"z_m" with lines lc rgb '#999999' title 'walls and treads', \
      folder.'/path.csv' using "true_x_m":"true_y_m":"true_z_m" with lines lw 3 lc rgb '#ff7f0e' title 'true', \
      folder.'/path.csv' using "x_m":"y_m":"z_m" with lines lw 1 lc rgb '#1f77b4' title 'estimated'
set output
