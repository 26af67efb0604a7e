// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/png.h>
#include <traverse/formats/report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <regex>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;
using ::testing::Not;

Report withEverything(const std::string& text)
{
  Report report{text, text, {}, text};
  Section s{text, {}};
  s.blocks.emplace_back(Paragraph{text});
  s.blocks.emplace_back(Notice{text});
  s.blocks.emplace_back(KeyFigures{{{text, text}}});
  s.blocks.emplace_back(Picture{png(Raster(2, 2)), text});
  s.blocks.emplace_back(Gallery{{Picture{png(Raster(2, 2)), text, true}}});
  s.blocks.emplace_back(Legend{{{1, text, {1, 2, 3}}}});
  s.blocks.emplace_back(Table{text, {text}, {{text, text}}});
  s.blocks.emplace_back(BarChart{text, text, {{text, 3, {}}}});
  s.blocks.emplace_back(Histogram{text, text, 0, 1, {1, 2}});
  report.sections.push_back(s);
  return report;
}

TEST(Report, EscapesEveryText)
{
  const std::string page =
      html(withEverything("<script>alert(1)</script>\" onload='x' & </style></title>"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("\" onload")));
  EXPECT_THAT(page, Not(HasSubstr("' onload")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)"));
  size_t ends = 0;
  for (size_t at = 0; (at = page.find("</style>", at)) != std::string::npos; ++at)
  {
    ++ends;
  }
  EXPECT_EQ(ends, 1U);
}

TEST(Report, LoadsNothing)
{
  const std::string page = html(withEverything("plain"));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  const std::regex source(R"re(src="([^:"]*):)re");
  for (auto it = std::sregex_iterator(page.begin(), page.end(), source);
       it != std::sregex_iterator(); ++it)
  {
    EXPECT_EQ((*it)[1], "data");
  }
}

TEST(Report, BytesThatAreNoUtf8AreShownAsSuch)
{
  const std::string page = html(withEverything("a\xff\xc0\x80\xed\xa0\x80z\x01\xc3\xa9"));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(page, Not(HasSubstr("\x01")));
  EXPECT_THAT(page, HasSubstr("z\xEF\xBF\xBD\xc3\xa9")) << "what is UTF-8 stays";
}

TEST(Report, PicturesAreInThePage)
{
  Report report;
  report.sections.push_back({"s", {Picture{"\x89PNG\r\n\x1a\n", "c"}}});
  EXPECT_THAT(html(report), HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo=\""));
}

TEST(Report, NumbersStandRight)
{
  Report report;
  report.sections.push_back({"s", {Table{"", {"stage", "time"}, {{"decode", "1.5 s"}, {"map"}}}}});
  const std::string page = html(report);
  EXPECT_THAT(page, HasSubstr("<th>stage</th><th class=\"number\">time</th>"));
  EXPECT_THAT(page, HasSubstr("<td>map</td><td class=\"number\"></td>")) << "filled up";
}

TEST(Report, BarsAreProportional)
{
  Report report;
  report.sections.push_back({"s", {BarChart{"", "s", {{"a", 4, {}}, {"b", 1, {}}}}}});
  const std::string page = html(report);
  EXPECT_THAT(page, HasSubstr("width=\"400.00\""));
  EXPECT_THAT(page, HasSubstr("width=\"100.00\""));
}

TEST(Report, BarsOfNoNumberAreDrawnAsZero)
{
  Report report;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  report.sections.push_back(
      {"s", {BarChart{"", "", {{"a", nan, {}}, {"b", inf, {}}, {"c", -1, {}}}}}});
  EXPECT_THAT(html(report), Not(HasSubstr("width=\"nan")));
  EXPECT_THAT(html(report), Not(HasSubstr("width=\"inf")));
}

TEST(Report, SameReportGivesTheSameBytes)
{
  EXPECT_EQ(html(withEverything("x")), html(withEverything("x")));
}

TEST(Histogram, CountsFiniteValuesOverTheirRange)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> values = {0, 1, 1.9F, 2, 4, nan};
  const Histogram h = histogramOf(values, 4, "slope", "deg");
  EXPECT_EQ(h.counts, (std::vector<uint64_t>{1, 2, 1, 1})) << "the largest is in the last bin";
  EXPECT_EQ(h.first_edge, 0);
  EXPECT_EQ(h.bin_width, 1);
}

TEST(Histogram, ConstantAndEmptyOnesAreFine)
{
  EXPECT_EQ(histogramOf(std::vector<float>{3, 3}, 10, "", "").counts, (std::vector<uint64_t>{2}));
  EXPECT_TRUE(histogramOf({}, 10, "", "").counts.empty());
}

TEST(ReadableNumber, GroupsDigits)
{
  EXPECT_EQ(
      readableNumber(1234567),
      "1\xE2\x80\xAF"
      "234\xE2\x80\xAF"
      "567");
  EXPECT_EQ(readableNumber(999), "999");
  EXPECT_EQ(readableNumber(0.123456), "0.1235");
  EXPECT_EQ(
      readableNumber(-1000),
      "\xE2\x88\x92"
      "1\xE2\x80\xAF"
      "000");
}
}  // namespace
