// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/png.h>
#include <traverse/formats/run_index.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

RunEntry run(const std::string& folder)
{
  RunEntry entry;
  entry.folder = folder;
  entry.state = "complete";
  entry.good = true;
  entry.has_report = true;
  return entry;
}

TEST(RunIndex, ShowsARunWithItsNumbers)
{
  RunEntry entry = run("monday");
  entry.title = "A drive";
  entry.recorded_s = 1519637026.5;
  entry.scans = 1234;
  entry.seconds = 7.25;
  const std::string page = runIndex("Runs", {entry});
  EXPECT_THAT(page, StartsWith(std::string(runIndexMark())));
  EXPECT_THAT(page, HasSubstr("<a href=\"./monday/report.html\">A drive</a>"));
  EXPECT_THAT(page, HasSubstr("<td>2018-02-26 09:23</td>"));
  EXPECT_THAT(
      page, HasSubstr("data-value=\"1234\">1\xE2\x80\xAF"
                      "234<"));
  EXPECT_THAT(page, HasSubstr("data-value=\"7.25\">7.3<"));
  EXPECT_THAT(page, HasSubstr("1 runs, 1 of them complete"));
}

TEST(RunIndex, HostileTextsAndFoldersStayWhatTheyAre)
{
  const std::string evil = "javascript:alert(1)//\"><script>x</script>/../\xff#?%";
  RunEntry entry = run(evil);
  entry.title = entry.log = entry.state = evil;
  entry.recorded_s = std::numeric_limits<double>::infinity();
  entry.seconds = std::numeric_limits<double>::quiet_NaN();
  const std::string page = runIndex(evil, {entry}, evil);
  EXPECT_THAT(page, Not(HasSubstr("<script>x")));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(
      page, HasSubstr("href=\"./javascript%3Aalert%281%29%2F%2F%22%3E%3Cscript%3Ex%3C%2Fscript%3E"
                      "%2F..%2F%FF%23%3F%25/report.html\""));
  EXPECT_THAT(page, Not(HasSubstr(">nan<")));
}

TEST(RunIndex, LongTextsAreCut)
{
  RunEntry entry = run("folder");
  entry.log = std::string(100'000, 'x');
  EXPECT_LT(runIndex("t", {entry}).size(), 20'000U);
}

TEST(RunIndex, RunsOnlyItsOwnScriptAndLoadsNothing)
{
  const std::string page = runIndex("t", {run("a")});
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:"));
  EXPECT_THAT(page, HasSubstr("script-src 'sha256-"));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
}

TEST(Thumbnail, IsTheAverageOfThePicture)
{
  Raster picture(400, 200, {200, 100, 0});
  const auto small = thumbnail(png(picture), 100);
  Raster expected(100, 50, {200, 100, 0});
  EXPECT_EQ(small, png(expected));
}

TEST(Thumbnail, SmallPicturesStayAsTheyAre)
{
  Raster picture(2, 1, {1, 2, 3});
  EXPECT_EQ(thumbnail(png(picture), 100), png(picture));
}

TEST(Thumbnail, WhatIsNoPictureGivesNone)
{
  EXPECT_FALSE(thumbnail("", 100));
  EXPECT_FALSE(thumbnail("no PNG", 100));
  EXPECT_FALSE(thumbnail("<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"/>", 100));
}

TEST(Thumbnail, DamagedPicturesDoNoHarm)
{
  Raster picture(64, 64, {200, 100, 0});
  for (size_t i = 0; i < picture.pixels.size(); ++i)
  {
    picture.pixels[i].g = static_cast<uint8_t>(i * 7919 >> 3U);
  }
  const std::string whole = png(picture);
  size_t made = 0;
  for (size_t i = 0; i < whole.size(); i += 13)
  {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    made += static_cast<size_t>(thumbnail(damaged, 16).has_value());
    thumbnail(whole.substr(0, i), 16);
  }
  EXPECT_LT(made, whole.size() / 13) << "some were refused";
}
}  // namespace
