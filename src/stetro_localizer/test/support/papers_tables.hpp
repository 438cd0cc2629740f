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

#ifndef SUPPORT__PAPERS_TABLES_HPP_
#define SUPPORT__PAPERS_TABLES_HPP_

#include <array>
#include <optional>

/// What S-A and S-B print, with where it is printed and what is wrong with it.
namespace stetro_localizer::papers
{

/// A row of table 3 of both papers [cm]. S-A leaves the errors of rows 15 and 16 blank.
struct Table3Row
{
  int step;
  double y_max_cm;
  double y_min_cm;
  std::optional<double> error_a_cm;  ///< S-A, table 3
  double error_b_cm;                 ///< S-B, table 3
};

/// Table 3 as printed. y_max and y_min are the same in both papers.
constexpr std::array<Table3Row, 16> kTable3{{
  {1, 193.1, 14.0, 2.9, 2.9},
  {2, 193.0, 14.1, 3.1, 3.1},
  {3, 193.2, 14.3, 3.1, 3.1},
  {4, 193.1, 14.1, 3.0, 3.0},
  {5, 192.9, 14.2, 3.3, 3.3},
  {6, 193.1, 14.3, 3.2, 3.2},
  {7, 193.0, 14.3, 3.3, 3.3},
  {8, 193.1, 13.9, 2.8, 2.8},
  {9, 193.1, 14.2, 3.1, 3.1},
  {10, 193.2, 14.1, 3.1, 3.1},  // misfit in both: must be 2.9 (D1-1)
  {11, 193.3, 14.3, 3.0, 3.0},
  {12, 193.1, 14.2, 3.1, 3.1},
  {13, 192.9, 14.0, 3.2, 3.1},  // S-A has rows 13 and 14 swapped (D1-1)
  {14, 193.1, 14.3, 3.1, 3.2},
  {15, 193.2, 14.3, std::nullopt, 3.1},
  {16, 193.0, 14.0, std::nullopt, 3.0},
}};

constexpr double kWidthCm = 205.0;        ///< S-B, table 2
constexpr double kContactWidthCm = 23.0;  ///< follows from table 3, not the printed 20 (D1-1)

/// A row of the static heading test [deg], as printed: clockwise positive (D1-6).
struct HeadingRow
{
  const char * label;
  double vn100_deg;
  double tof_deg;
  double error_deg;  ///< printed without sign
};

/// S-A, table 2.
constexpr std::array<HeadingRow, 5> kHeadingA{{
  {"0 degree", -1.80, -2.80, 1.0},
  {"+45 degree", -44.2, -46.1, 1.90},
  {"0 degree", 1.60, 0.40, 1.20},
  {"-45 degree", 44.4, 42.60, 1.80},
  {"0 degree", -1.83, -2.94, 1.11},
}};

/// S-B, table 1. Row 3 prints 0.80, the difference is 2.00, or a sign is lost (D1-8).
constexpr std::array<HeadingRow, 5> kHeadingB{{
  {"0 degree", -1.80, -2.80, 1.00},
  {"+45 degree", -44.2, -47.1, 2.90},
  {"0 degree", 0.60, -1.40, 0.80},
  {"-45 degree", 44.40, 42.60, 1.80},
  {"0 degree", -1.80, -2.80, 1.00},
}};

constexpr double kFrontBaselineCm = 20.0;  ///< D of eq. (2), "width of the robot" (D1-7)

}  // namespace stetro_localizer::papers

#endif  // SUPPORT__PAPERS_TABLES_HPP_
