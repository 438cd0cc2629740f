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

#ifndef STETRO_SITE__SITE_HPP_
#define STETRO_SITE__SITE_HPP_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/floor.hpp"

namespace stetro_site
{

/// How far numbers that say the same thing may differ, unless the site file says otherwise [m].
constexpr double kDefaultTolerance = 0.01;

/// What a site is made of.
struct SiteSpec
{
  std::string name;
  std::vector<Floor> floors;
  std::vector<Flight> flights;
  double tolerance_m = kDefaultTolerance;
  std::vector<std::string> notes;  ///< what the file left open and how it was read

  /// Where the file says what: `flights[0].width_m` and the like. Empty without a file.
  std::map<std::string, stetro_config::Origin> origins;

  /// Where a key was written, or the nearest thing above it that was.
  [[nodiscard]] stetro_config::Origin origin(const std::string & key) const;
};

/// The building the robot knows: floors, and flights of stairs that join them.
/**
 * Floors and flights together are called segments. They form a graph in which a flight has two
 * neighbours, its lower and its upper floor, and every segment can be reached from every other.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class Site
{
public:
  /// \throws stetro_config::ConfigError with every contradiction of `check_graph`
  explicit Site(SiteSpec spec);

  [[nodiscard]] const std::string & name() const noexcept { return spec_.name; }
  [[nodiscard]] const std::vector<Flight> & flights() const noexcept { return spec_.flights; }
  [[nodiscard]] const std::vector<Floor> & floors() const noexcept { return spec_.floors; }
  [[nodiscard]] const std::vector<std::string> & notes() const noexcept { return spec_.notes; }

  /// Null if there is none of that id.
  [[nodiscard]] const Flight * find_flight(const std::string & id) const noexcept;
  [[nodiscard]] const Floor * find_floor(const std::string & id) const noexcept;

  /// Whether somebody has drawn a floor: then a robot can find its way on floors, too.
  [[nodiscard]] bool has_drawn_floor() const noexcept;

  /// \throws std::out_of_range naming the id and those there are
  [[nodiscard]] const Flight & flight(const std::string & id) const;
  [[nodiscard]] const Floor & floor(const std::string & id) const;

  /// Ids of the segments next to one: of a flight its lower floor, then its upper; of a floor the
  /// flights that join it, in the order of the file.
  /** \throws std::out_of_range naming the id and those there are */
  [[nodiscard]] std::vector<std::string> neighbours(const std::string & id) const;

  /// Where a key such as `flights[0].width_m` was written, or the nearest thing above it.
  [[nodiscard]] stetro_config::Origin origin(const std::string & key) const
  {
    return spec_.origin(key);
  }

private:
  SiteSpec spec_;
};

/// Every contradiction between the segments of a site, with its place if the site has a file.
/**
 * Ids are unique and no reserved frame; a flight joins two floors that exist; the elevation of
 * its lower floor plus its risers is the elevation of its upper floor, and the lower end stands on
 * the lower floor, both within the tolerance; all segments hang together.
 */
[[nodiscard]] stetro_config::Faults check_graph(const SiteSpec & spec);

/// Reads a site file and the grid maps it names. Nothing if a fault was added.
[[nodiscard]] std::optional<Site> read_site(
  const std::string & path, stetro_config::Faults & faults);

/// Reads a site file. \throws stetro_config::ConfigError with every fault
[[nodiscard]] Site load_site(const std::string & path);

}  // namespace stetro_site

#endif  // STETRO_SITE__SITE_HPP_
