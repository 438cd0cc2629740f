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

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "stetro_config/kept_file.hpp"

namespace
{

std::function<void(bool is_folder)> on_flush;  // NOLINT: for the function of the system below

}  // namespace

/// In place of the system's: tells the test what is flushed.
extern "C" int fsync(int file)
{
  struct stat found = {};
  if (on_flush && ::fstat(file, &found) == 0) {
    on_flush(S_ISDIR(found.st_mode));
  }
  return ::fdatasync(file);
}

namespace stetro_config
{
namespace
{

using Kind = KeptReading::Kind;

// Checksums of "sample 1\nstep 7\n", from another implementation.
constexpr char kWithCrc32[] = "sample 1\nstep 7\ncrc32 b44e5333\n";
constexpr char kWithFnv1a[] = "sample 1\nstep 7\nchecksum 3887356061156357325\n";

std::string content(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A kept file in a folder of the test's own.
class KeptFileTest : public testing::TestWithParam<Seal>
{
protected:
  KeptFileTest()
  {
    std::string name = (std::filesystem::temp_directory_path() / "kept_file_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    path_ = folder_ / "kept";
  }
  ~KeptFileTest() override
  {
    on_flush = nullptr;
    std::filesystem::remove_all(folder_);
  }

  [[nodiscard]] KeptFile file() const { return KeptFile(path_, "sample 1", GetParam()); }
  [[nodiscard]] KeptReading reading() const { return file().read(); }
  [[nodiscard]] static std::string whole()
  {
    return GetParam() == Seal::kCrc32 ? kWithCrc32 : kWithFnv1a;
  }
  void put(const std::string & text) const { std::ofstream(path_, std::ios::binary) << text; }

  /// Damage is told with the path in front and these words after it.
  void expect_damaged(const std::string & words) const
  {
    const KeptReading found = reading();
    EXPECT_EQ(found.kind, Kind::kDamaged);
    EXPECT_EQ(found.why.find(path_.string() + ": "), 0U) << found.why;
    EXPECT_NE(found.why.find(words), std::string::npos) << found.why;
    EXPECT_TRUE(found.lines.empty());
  }

  std::filesystem::path folder_;
  std::filesystem::path path_;
};

/// Takes the right to write from this process, which may be root's, until the end of its scope.
class ReadOnly
{
public:
  explicit ReadOnly(const std::filesystem::path & folder) : folder_(folder.string())
  {
    ::chmod(folder_.c_str(), 0555);
    was_root_ = ::geteuid() == 0 && ::seteuid(65534) == 0;
  }
  ~ReadOnly()
  {
    EXPECT_TRUE(!was_root_ || ::seteuid(0) == 0);
    ::chmod(folder_.c_str(), 0755);
  }
  ReadOnly(const ReadOnly &) = delete;
  ReadOnly & operator=(const ReadOnly &) = delete;

private:
  std::string folder_;
  bool was_root_;
};

TEST_P(KeptFileTest, IsTheHeadingTheLinesAndTheSeal)
{
  ASSERT_FALSE(file().replace("step 7\n"));
  EXPECT_EQ(content(path_), whole());
  EXPECT_FALSE(std::filesystem::exists(path_.string() + ".new"));
}

TEST_P(KeptFileTest, GivesBackTheLines)
{
  put(whole());
  EXPECT_EQ(reading().kind, Kind::kFound) << reading().why;
  EXPECT_EQ(reading().lines, "step 7\n");
  for (const char * lines : {"", "checksum 1\n", "crc32 0\ncrc32 00000000\n"}) {
    ASSERT_FALSE(file().replace(lines));
    ASSERT_EQ(reading().kind, Kind::kFound) << reading().why;
    EXPECT_EQ(reading().lines, lines);
  }
}

TEST_P(KeptFileTest, IsMissingWhereThereIsNone)
{
  EXPECT_EQ(reading().kind, Kind::kMissing);
  EXPECT_EQ(
    KeptFile((folder_ / "no/such/folder").string(), "sample 1", GetParam()).read().kind,
    Kind::kMissing);
}

TEST_P(KeptFileTest, KeepsNothingUnderAnEmptyPath)
{
  const KeptFile none("", "sample 1", GetParam());
  EXPECT_FALSE(none.replace("step 7\n"));
  EXPECT_EQ(none.read().kind, Kind::kMissing);
}

// Property: no byte can be lost, changed or added without the file being known as damaged.
TEST_P(KeptFileTest, KnowsEveryCutAndEveryFlippedByte)
{
  for (std::size_t i = 0; i < whole().size(); ++i) {
    put(whole().substr(0, i));
    ASSERT_EQ(reading().kind, Kind::kDamaged) << "cut after " << i << " bytes";
    std::string flipped = whole();
    flipped[i] = static_cast<char>(flipped[i] ^ 0x04);
    put(flipped);
    ASSERT_EQ(reading().kind, Kind::kDamaged) << "byte " << i << " flipped";
  }
  put(whole() + "x");
  EXPECT_EQ(reading().kind, Kind::kDamaged);
}

TEST_P(KeptFileTest, NamesTheDamage)
{
  put("");
  expect_damaged("does not begin with 'sample 1'");
  put("sample 10\nstep 7\n");
  expect_damaged("does not begin with 'sample 1'");
  put("sample 1\nstep 7\n");
  expect_damaged("no checksum");
  put("sample 1\nstep 8" + whole().substr(15));
  expect_damaged("checksum does not fit");
  put(std::string((1U << 20U) + 1, 'x'));
  expect_damaged("larger than 1 MiB");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  expect_damaged("Is a directory");
}

TEST_P(KeptFileTest, DoesNotTakeTheOtherSeal)
{
  put(GetParam() == Seal::kCrc32 ? kWithFnv1a : kWithCrc32);
  expect_damaged("no checksum");
}

TEST_P(KeptFileTest, SaysWhatKeepsItFromReplacing)
{
  const std::string nowhere = (folder_ / "no/such/file").string();
  const auto no_folder = KeptFile(nowhere, "sample 1", GetParam()).replace("step 7\n");
  EXPECT_EQ(no_folder, "cannot write " + nowhere + ".new: No such file or directory");

  std::filesystem::create_directories(path_ / "in the way");
  const auto in_the_way = file().replace("step 7\n");
  ASSERT_TRUE(in_the_way);
  EXPECT_EQ(in_the_way->find("cannot replace " + path_.string()), 0U) << *in_the_way;
}

TEST_P(KeptFileTest, LeavesTheOldFileInAFolderThatCannotBeWritten)
{
  ASSERT_FALSE(file().replace("step 7\n"));
  {
    const ReadOnly read_only(folder_);
    EXPECT_EQ(
      file().replace("step 8\n"), "cannot write " + path_.string() + ".new: Permission denied");
  }
  EXPECT_EQ(content(path_), whole());
}

TEST_P(KeptFileTest, FlushesTheFileBeforeItTakesTheNameAndThenTheFolder)
{
  ASSERT_FALSE(file().replace("step 7\n"));
  std::vector<std::string> flushed;
  on_flush = [&](bool is_folder) {
    flushed.push_back((is_folder ? "folder: " : "file: ") + reading().lines);
  };
  ASSERT_FALSE(file().replace("step 8\n"));
  EXPECT_EQ(flushed, (std::vector<std::string>{"file: step 7\n", "folder: step 8\n"}));
}

INSTANTIATE_TEST_SUITE_P(
  Seals, KeptFileTest, testing::Values(Seal::kFnv1a, Seal::kCrc32),
  [](const auto & seal) { return seal.param == Seal::kCrc32 ? "Crc32" : "Fnv1a"; });

}  // namespace
}  // namespace stetro_config
