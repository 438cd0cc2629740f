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

#ifndef STETRO_CONFIG__KEPT_FILE_HPP_
#define STETRO_CONFIG__KEPT_FILE_HPP_

#include <optional>
#include <string>

namespace stetro_config
{

/// How the last line of a kept file says the checksum of everything before it.
enum class Seal {
  kFnv1a,  ///< `checksum 3887356061156357325`: FNV-1a of 64 bits, decimal
  kCrc32   ///< `crc32 b44e5333`: CRC-32 of IEEE 802.3, eight hexadecimal digits
};

/// What reading a kept file gave.
struct KeptReading
{
  enum class Kind { kFound, kMissing, kDamaged };

  Kind kind = Kind::kMissing;
  std::string lines;  ///< of `kFound`: what stands between heading and seal
  std::string why;    ///< of `kDamaged`, for a person; it begins with the path
};

/// A small text file in which a program, not a person, keeps something for its next start.
/**
 *   stetro_mission 1        the heading: format and version
 *   step 7                  the lines: their meaning is the caller's
 *   crc32 b44e5333          the seal
 *
 * It is replaced, never edited: written beside itself, flushed to the disk and renamed over the old
 * one, and then the folder is flushed, so that a cut of power leaves either the old file or the new
 * one. A file that is cut off, edited, of another format or not readable is damaged; it stays where
 * it is until the next `replace`. Two programs must not keep the same file.
 */
class KeptFile
{
public:
  /// \param path empty keeps nothing: reads as missing, and `replace` does nothing
  /// \param heading first line, without its end
  KeptFile(std::string path, std::string heading, Seal seal);

  [[nodiscard]] KeptReading read() const;

  /// \param lines each with its end \return nothing if they are safely on the disk, otherwise what
  ///   went wrong, with the path and the system's reason
  [[nodiscard]] std::optional<std::string> replace(const std::string & lines) const;

  [[nodiscard]] const std::string & path() const { return path_; }

private:
  [[nodiscard]] std::string seal_of(const std::string & text) const;
  [[nodiscard]] KeptReading open_seal(const std::string & text) const;
  [[nodiscard]] KeptReading damaged(const std::string & why) const;

  std::string path_;
  std::string heading_;
  Seal seal_;
};

}  // namespace stetro_config

#endif  // STETRO_CONFIG__KEPT_FILE_HPP_
