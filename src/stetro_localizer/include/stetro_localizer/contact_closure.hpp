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

#ifndef STETRO_LOCALIZER__CONTACT_CLOSURE_HPP_
#define STETRO_LOCALIZER__CONTACT_CLOSURE_HPP_

#include <optional>

namespace stetro_localizer
{

/// S-A and S-B eq. (3): Error = W - ((y_max - y_min) + R_w) [m].
/**
 * It is called contact closure here and is no measure of accuracy: with y_max = W - d_L and
 * y_min = d_R the width cancels, and only the two readings next to the walls remain (D1-3).
 */
[[nodiscard]] constexpr double contact_closure_m(
  double width_m, double y_max_m, double y_min_m, double contact_width_m)
{
  return width_m - ((y_max_m - y_min_m) + contact_width_m);
}

/// Gathers the two ends of one tread's sweep.
class ContactClosure
{
public:
  ContactClosure(double width_m, double contact_width_m)
  : width_m_(width_m), contact_width_m_(contact_width_m)
  {
  }

  void note_right(double y_m) { y_min_m_ = y_m; }  ///< y just before the right contact was used
  void note_left(double y_m) { y_max_m_ = y_m; }   ///< y just before the left contact was used
  void clear()
  {
    y_min_m_.reset();
    y_max_m_.reset();
  }

  /// Eq. (3) of this tread, once both walls were touched.
  [[nodiscard]] std::optional<double> error_m() const
  {
    if (!y_min_m_ || !y_max_m_) {
      return std::nullopt;
    }
    return contact_closure_m(width_m_, *y_max_m_, *y_min_m_, contact_width_m_);
  }

private:
  double width_m_;
  double contact_width_m_;
  std::optional<double> y_min_m_;
  std::optional<double> y_max_m_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__CONTACT_CLOSURE_HPP_
