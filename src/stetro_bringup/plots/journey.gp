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

# Draws a way through a building from its path, its walls, the checks of its pose and its kidnaps.
#   gnuplot -e "folder='out/demo'" journey.gp
# Writes journey.svg into the folder: a plan in which every place is drawn as much farther up as it
# is higher, so that floors do not lie on each other and flights join them.

set datafile separator ','
set terminal svg size 1000,1060 font 'Helvetica,15' background rgb 'white'
set output folder.'/journey.svg'
walls = folder.'/walls.csv'
path = folder.'/path.csv'
checks = folder.'/checks.csv'
kidnaps = folder.'/kidnaps.csv'

lift = 2.0                         # metres up the page for a metre of height
up(y, z) = y + lift * z
same(a, b, x) = a eq b ? x : NaN

# A pose that is found anew is no line from where it was. Every sixth row is enough for a curve.
last_x = NaN
last_y = NaN
goes_on(x, y) = (far = abs(x - last_x) + abs(y - last_y) > 0.3, last_x = x, last_y = y, far ? NaN : x)

stats walls using "x_m":(up(column("y_m"), column("z_m"))) name 'plan' nooutput
set xrange [plan_min_x - 0.3:plan_max_x + 0.3]
set yrange [plan_min_y - 0.9:plan_max_y + 0.5]
set size ratio -1
unset border
unset tics
set key at graph 0.99, graph 0.0 right bottom Left reverse samplen 2 spacing 1.1
set title 'The way through the building, each place drawn 2 m up the page for every metre of its height'

# a scale
set arrow from plan_min_x, plan_min_y - 0.45 rto 1, 0 nohead lw 2
set label '1 m' at plan_min_x + 0.5, plan_min_y - 0.7 center

# names of the segments, at the first corner of each
named = ''
name(id) = strstrt(named, '['.id.']') > 0 ? '' : (named = named.'['.id.']', id)

plot walls using "x_m":(same(strcol("kind"), 'tread', up(column("y_m"), column("z_m")))) \
       with lines lw 1 lc rgb '#cccccc' title 'treads', \
     walls using "x_m":(same(strcol("kind"), 'wall', up(column("y_m"), column("z_m")))) \
       with lines lw 2 lc rgb '#888888' title 'walls as a scanner sees them', \
     walls using (column("x_m") + 0.1):(up(column("y_m"), column("z_m")) - 0.22):(name(strcol("segment"))) \
       with labels left tc rgb '#555555' notitle, \
     path every 6 using (goes_on(column("true_x_m"), column("true_y_m"))):(up(column("true_y_m"), column("true_z_m"))) \
       with lines lw 4 lc rgb '#ffbb78' title 'true', \
     path every 6 using (goes_on(column("x_m"), column("y_m"))):(up(column("y_m"), column("z_m"))) \
       with lines lw 1.2 lc rgb '#1f77b4' title 'estimated', \
     checks using "x_m":(same(strcol("verdict"), 'agrees', up(column("y_m"), column("z_m")))) \
       with points pt 7 ps 0.45 lc rgb '#2ca02c' title 'the profile agrees', \
     checks using "x_m":(same(strcol("verdict"), 'corrected', up(column("y_m"), column("z_m")))) \
       with points pt 9 ps 0.9 lc rgb '#9467bd' title 'the profile says: here', \
     kidnaps using "from_x_m":(up(column("from_y_m"), column("from_z_m"))):(column("to_x_m") - column("from_x_m")):(column("to_y_m") - column("from_y_m")) \
       with vectors head filled size 0.2,20 dt 2 lw 2 lc rgb '#d62728' title 'carried off', \
     path every ::0::0 using "true_x_m":(up(column("true_y_m"), column("true_z_m"))) \
       with points pt 6 ps 1.6 lw 2 lc rgb 'black' title 'start'
set output
