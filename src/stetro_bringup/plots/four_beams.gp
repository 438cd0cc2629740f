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

# Draws the time of a four-beam search against the size of its map: table 1 of S-G for our own run.
#   gnuplot -e "table='out/bench/four_beams.csv'; folder='out/bench'" four_beams.gp
# Writes four_beams.svg into the folder. The table is what bench_four_beams prints as CSV.

set datafile separator ','
set terminal svg size 900,560 font 'Helvetica,13' background rgb 'white'
set key outside right center
set grid lc rgb '#dddddd'
set logscale xy
set format y '%g'
set xlabel 'cells of the map'
set ylabel 'time of a search, CPU [µs]'
set title 'Where is the robot? The paper''s methods and the index'
# The medians of one line: rows are named after the line, the cells' size and the aggregate.
median_us(line) = (strstrt(strcol("name"), line.'/mm:') == 1 && strstrt(strcol("name"), '_median') > 0) ? column("cpu_time") : NaN

set output folder.'/four_beams.svg'
set datafile missing NaN
plot table using "cells":(median_us('published/method_1')) with linespoints pt 7 ps 0.6 lw 2 lc rgb '#d62728' title 'method 1', \
     table using "cells":(median_us('published/method_2')) with linespoints pt 7 ps 0.6 lw 2 lc rgb '#ff7f0e' title 'method 2', \
     table using "cells":(median_us('hybrid/every_cell')) with linespoints pt 6 ps 0.9 lw 1 lc rgb '#8c564b' title 'hybrid', \
     table using "cells":(median_us('published/method_1_from_obstacles')) with linespoints pt 7 ps 0.6 dt 2 lw 2 lc rgb '#d62728' title 'method 1, from obstacles', \
     table using "cells":(median_us('published/method_2_from_obstacles')) with linespoints pt 7 ps 0.6 dt 2 lw 2 lc rgb '#ff7f0e' title 'method 2, from obstacles', \
     table using "cells":(median_us('hybrid/from_obstacles')) with linespoints pt 6 ps 0.9 dt 2 lw 1 lc rgb '#8c564b' title 'hybrid, from obstacles', \
     table using "cells":(median_us('three_of_four')) with linespoints pt 7 ps 0.6 lw 2 lc rgb '#2ca02c' title 'any 3 of 4 beams, ±1 cell', \
     table using "cells":(median_us('indexed/tolerance_2')) with linespoints pt 7 ps 0.6 dt 3 lw 2 lc rgb '#1f77b4' title 'index, ±2 cells', \
     table using "cells":(median_us('indexed/tolerance_1')) with linespoints pt 7 ps 0.6 dt 2 lw 2 lc rgb '#1f77b4' title 'index, ±1 cell', \
     table using "cells":(median_us('indexed/exact')) with linespoints pt 7 ps 0.6 lw 2 lc rgb '#1f77b4' title 'index, exact'
