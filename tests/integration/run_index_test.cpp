// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// traverse-map with exports, and --index over good, hostile and unfinished folders.
#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/** One run, made once. */
class RunIndex : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    made = new ScratchFolder;
    const Finished ran = traverseMap(
        {ini("vlp16"), "--output", *made / "one", "--quiet", "--set",
         "traverse-map.export_ply=true", "--set", "traverse-map.export_pcd=true", "--set",
         "traverse-map.export_geopackage=true"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }

  static void TearDownTestSuite() { delete made; }

  static fs::path run() { return *made / "one"; }

  /** A folder of a run whose metrics.json is this. */
  void folder(const std::string& name, const std::string& metrics)
  {
    fs::create_directory(scratch_ / name);
    writeText(scratch_ / name / "metrics.json", metrics);
  }

  std::string index()
  {
    const Finished ran = traverseMap({"--index", scratch_.path().string()});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out, (scratch_ / "index.html").string() + "\n");
    return readText(scratch_ / "index.html");
  }

  ScratchFolder scratch_;

 private:
  static ScratchFolder* made;
};

ScratchFolder* RunIndex::made = nullptr;

TEST_F(RunIndex, ExportsAreWrittenWhereAskedFor)
{
  for (const char* file : {"map.ply", "map.pcd", "map.gpkg"})
  {
    EXPECT_GT(fs::file_size(run() / file), 10'000U) << file;
  }
  EXPECT_THAT(
      traverse::testing::run({"ogrinfo", "-so", "-al", (run() / "map.gpkg").string()}).out,
      HasSubstr("Feature Count: 4056"));
}

TEST_F(RunIndex, ListsRunsWithPictureAndLink)
{
  fs::copy(run(), scratch_ / "b");
  fs::copy(run(), scratch_ / "a");
  fs::create_directory(scratch_ / "not a run");
  const std::string page = index();
  EXPECT_THAT(page, HasSubstr("2 runs, 2 of them complete"));
  EXPECT_THAT(page, HasSubstr("VLP-16, one turn in a street"));
  EXPECT_THAT(page, HasSubstr("data-value=\"22591\""));
  EXPECT_THAT(page, HasSubstr("img alt=\"\" src=\"data:image/png;base64,"));
  EXPECT_LT(page.find("./a/report.html"), page.find("./b/report.html"));
  EXPECT_THAT(page, Not(HasSubstr("not a run")));
  EXPECT_EQ(index(), page) << "the same runs give the same bytes, over an index that is there";
}

TEST_F(RunIndex, DamagedAndUnfinishedFoldersAreListedAsSuch)
{
  const std::string good = readText(run() / "metrics.json");
  folder("no-json", "{");
  folder("deep", std::string(100'000, '['));
  folder("array", "[1, 2]");
  folder("negative", std::string(good).replace(good.find("\"scans\": 1"), 10, "\"scans\": -1"));
  folder(
      "text",
      std::string(good).replace(good.find("\"complete\": true"), 16, "\"complete\": \"yes\""));
  folder("bytes", std::string(good).replace(good.find("VLP-16"), 6, "<b>\xff\xfe!"));
  folder(
      "partial",
      std::string(good).replace(good.find("\"complete\": true"), 16, "\"complete\": false"));
  fs::create_directory(scratch_ / "writing.partial");
  fs::create_directory(scratch_ / "no-metrics");
  writeText(scratch_ / "no-metrics" / "report.html", "");
  fs::create_directory(scratch_ / "huge");
  writeText(scratch_ / "huge" / "metrics.json", "");
  fs::resize_file(scratch_ / "huge" / "metrics.json", 1U << 31U);
  fs::create_directory_symlink(scratch_ / "nowhere", scratch_ / "link");
  fs::create_symlink("/dev/zero", scratch_ / "partial" / "map_top.png");
  const std::string page = index();
  EXPECT_THAT(page, HasSubstr("10 runs, 0 of them complete"));
  EXPECT_THAT(page, HasSubstr("metrics.json is damaged: no JSON"));
  EXPECT_THAT(page, HasSubstr("metrics.json is damaged: objects within objects"));
  EXPECT_THAT(page, HasSubstr("no proper &#39;scans&#39;"));
  EXPECT_THAT(page, HasSubstr("no proper &#39;complete&#39;"));
  EXPECT_THAT(page, HasSubstr("partial: no reason given"));
  EXPECT_THAT(page, HasSubstr("not finished: a run is writing it, or was ended"));
  EXPECT_THAT(page, HasSubstr("not finished: metrics.json is missing"));
  EXPECT_THAT(page, HasSubstr("metrics.json cannot be read, or is far too long"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
}

TEST_F(RunIndex, AFileThatIsNoIndexOfOursStays)
{
  writeText(scratch_ / "index.html", "<p>mine</p>");
  const Finished ran = traverseMap({"--index", scratch_.path().string()});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("no index of runs; --force replaces it"));
  EXPECT_EQ(readText(scratch_ / "index.html"), "<p>mine</p>");
  EXPECT_EQ(traverseMap({"--index", scratch_.path().string(), "--force"}).exit_code, 0);
}

TEST_F(RunIndex, AMissingFolderIsExitFour)
{
  EXPECT_EQ(traverseMap({"--index", scratch_ / "nowhere"}).exit_code, 4);
  EXPECT_EQ(traverseMap({"--index", scratch_.path().string(), "--output", "x"}).exit_code, 2);
}
}  // namespace
