// Copyright 2026 The sTetro Authors
//
// Licensed under the Apache License, Version 2.0 (the "License");
// you may not use this file except in compliance with the License.
// You may obtain a copy of the License at
//
//     http://www.apache.org/licenses/LICENSE-2.0
//
// Unless required by applicable law or agreed to in writing, software
// distributed under the License is distributed on an "AS IS" BASIS,
// WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
// See the License for the specific language governing permissions and
// limitations under the License.

#include "accuracy/plot_tables.hpp"

#include <ostream>

#include "stetro_bringup/trace.hpp"

namespace stetro_bringup
{

void write_treads_csv(std::ostream & out, const EstimatorTotals & totals)
{
  out << "step,x_rmse_m,x_p95_m,y_rmse_m,y_p95_m,heading_rmse_rad,heading_p95_rad,x_sigma_m,"
         "y_sigma_m,heading_sigma_rad\n";
  for (std::size_t step = 1; step < totals.treads.size(); ++step) {
    const TreadTotals & tread = totals.treads[step];
    if (tread.y_m.count() == 0) {
      continue;
    }
    out << step;
    for (const ErrorDistribution * errors : {&tread.x_m, &tread.y_m, &tread.heading_rad}) {
      put_field(out, errors->rmse());
      put_field(out, errors->percentile(0.95));
    }
    put_field(out, tread.sigma_x_m.rms());
    put_field(out, tread.sigma_y_m.rms());
    put_field(out, tread.sigma_heading_rad.rms());
    out << '\n';
  }
}

void write_histogram_csv(std::ostream & out, const EstimatorTotals & totals)
{
  out << "error_m,x_share,y_share,error_rad,heading_share\n";
  for (std::size_t bin = 0; bin < totals.y_histogram.bins(); ++bin) {
    out << totals.y_histogram.centre(bin);
    put_field(out, totals.x_histogram.share(bin));
    put_field(out, totals.y_histogram.share(bin));
    put_field(out, totals.heading_histogram.centre(bin));
    put_field(out, totals.heading_histogram.share(bin));
    out << '\n';
  }
}

}  // namespace stetro_bringup
