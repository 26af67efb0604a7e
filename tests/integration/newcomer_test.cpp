// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A newcomer's quarter of an hour (doc/conventions.md), walked: what they read is there, short and
// true, and what they try does what they were told. The #include that is refused is in
// tests/arrows.

#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace
{
namespace fs = std::filesystem;
using namespace traverse::testing;
using ::testing::HasSubstr;

const fs::path kRoot = TRAVERSE_SOURCE_DIR;

long linesOf(const fs::path& file)
{
  const std::string text = readText(file);
  return std::count(text.begin(), text.end(), '\n');
}

/** Targets of the Markdown links in a file that are files of ours. */
std::vector<fs::path> linksOf(const fs::path& file)
{
  static const std::regex kLink("\\]\\(([^):#]+)[^)]*\\)");
  const std::string text = readText(file);
  std::vector<fs::path> links;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), kLink); i != std::sregex_iterator();
       ++i)
  {
    links.push_back(file.parent_path() / (*i)[1].str());
  }
  return links;
}

TEST(Newcomer, TheReadmeIsOneScreenWithARealPictureAndTwoCommands)
{
  const std::string readme = readText(kRoot / "README.md");
  EXPECT_LE(linesOf(kRoot / "README.md"), 45);
  EXPECT_THAT(readme, HasSubstr("./run demo"));
  EXPECT_THAT(readme, HasSubstr("./run test"));
  EXPECT_EQ(readText(kRoot / "doc/pictures/vlp16.png").substr(1, 3), "PNG");
}

TEST(Newcomer, EveryLinkLeadsSomewhere)
{
  for (const char* page :
       {"README.md", "CONTRIBUTING.md", "mrpt_modules/README.md", "doc/architecture.md"})
  {
    for (const fs::path& target : linksOf(kRoot / page))
    {
      EXPECT_TRUE(fs::exists(target)) << page << " links " << target;
    }
  }
}

TEST(Newcomer, TheArchitectureIsShortAndNamesEveryRoom)
{
  const std::string page = readText(kRoot / "doc/architecture.md");
  EXPECT_LE(linesOf(kRoot / "doc/architecture.md"), 90);
  for (const char* shelf : {"core", "maps", "mrpt"})
  {
    for (const auto& room : fs::directory_iterator(kRoot / "mrpt_modules" / shelf))
    {
      const std::string name = room.path().filename();
      EXPECT_THAT(page, HasSubstr(name + "/"));
      EXPECT_THAT(readText(kRoot / "mrpt_modules/README.md"), HasSubstr(name));
      EXPECT_TRUE(fs::exists(room.path() / "README.md")) << room.path();
      EXPECT_LE(linesOf(room.path() / "README.md"), 60) << room.path();
    }
  }
}

TEST(Newcomer, TheReadmesCommandMapsALog)
{
  const ScratchFolder scratch;
  const Finished ran = traverseMap(
      {ini("vlp16"), "--rawlog", mrptData("test_velodyne_VLP16.rawlog"), "--output",
       scratch / "out"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(fs::exists(scratch / "out" / "map_top.png"));
}

TEST(Newcomer, AMisspeltKeyIsRefusedWithTheRightOne)
{
  const ScratchFolder scratch;
  std::string text = readText(ini("vlp16"));
  text.replace(text.find("cell_size_m"), 11, "cellsize_m");
  writeText(scratch / "mine.ini", text);
  const Finished ran = traverseMap({scratch / "mine.ini", "--check-config"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_THAT(ran.err, HasSubstr("did you mean 'cell_size_m'?"));
}

TEST(Newcomer, EveryIniOfTheHouseIsTaken)
{
  for (const auto& entry : fs::directory_iterator(kRoot / "ini"))
  {
    if (entry.is_directory())  // scenes: traverse-sim's
    {
      continue;
    }
    const bool is_of_navigator = entry.path().filename().string().rfind("nav_", 0) == 0;
    const Finished ran = is_of_navigator
                             ? run(
                                   {std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-nav",
                                    entry.path(), "--check-config"})
                             : traverseMap({entry.path(), "--check-config"});
    EXPECT_EQ(ran.exit_code, 0) << entry.path() << ": " << ran.err;
  }
}
}  // namespace
