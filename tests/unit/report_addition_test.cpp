// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/report_addition.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHostile =
    "</main>\n<footer></nav>\n</header>\n<!-- added: x --><!-- end of x -->";

std::string page()
{
  Report report;
  report.title = kHostile;
  report.sections = {{kHostile, {Paragraph{kHostile}}}};
  report.footer = kHostile;
  return html(report);
}

Section section(const std::string& text)
{
  return {"Against <the> truth", {Paragraph{text}, Table{"t", {"a"}, {{"1"}}}}};
}

/** Without what stands between the markers. */
std::string stripped(std::string text)
{
  const std::string end = "<!-- end of x -->";
  while (text.find("<!-- added: x -->") != std::string::npos)
  {
    const size_t from = text.find("<!-- added: x -->");
    text.erase(from, text.find(end) + end.size() - from);
  }
  return text;
}

TEST(ReportAddition, AddsASectionAndALink)
{
  const std::string longer = withAddedSection(page(), "x", section("new"));
  EXPECT_THAT(longer, HasSubstr("<a href=\"#x\">Against &lt;the&gt; truth</a>"));
  EXPECT_THAT(
      longer, HasSubstr("<section id=\"x\">\n<h2>Against &lt;the&gt; truth</h2>\n<p>new</p>"));
  EXPECT_LT(longer.find("<section id=\"x\">"), longer.find("</main>"));
}

TEST(ReportAddition, TheRestStaysAsItIs)
{
  EXPECT_EQ(stripped(withAddedSection(page(), "x", section(kHostile))), page());
}

TEST(ReportAddition, ReplacesItsOwn)
{
  const std::string once = withAddedSection(page(), "x", section("one"));
  EXPECT_EQ(withAddedSection(once, "x", section("one")), once);
  const std::string twice = withAddedSection(once, "x", section("two"));
  EXPECT_THAT(twice, Not(HasSubstr("<p>one</p>")));
  const std::string both = withAddedSection(once, "y", section("two"));
  EXPECT_THAT(both, HasSubstr("<p>one</p>"));
  EXPECT_THAT(both, HasSubstr("<p>two</p>"));
}

TEST(ReportAddition, OtherPagesAreRefused)
{
  EXPECT_THROW(withAddedSection("", "x", section("")), FormatError);
  EXPECT_THROW(withAddedSection("<html></html>", "x", section("")), FormatError);
  const std::string good = page();
  EXPECT_THROW(withAddedSection(good.substr(0, good.size() / 2), "x", section("")), FormatError);
  EXPECT_THROW(withAddedSection(good + "</main>\n<footer>", "x", section("")), FormatError);
  EXPECT_THROW(withAddedSection(good + "<!-- added: x -->", "x", section("")), FormatError);
}

TEST(ReportAddition, IdsAndScriptsAreChecked)
{
  for (const char* id : {"", "a b", "--", "x-->", "\"", "A"})
  {
    EXPECT_THROW(withAddedSection(page(), id, section("")), std::invalid_argument) << id;
  }
  EXPECT_THROW(
      withAddedSection(page(), "x", Section{"t", {LayerMap{"c", "{}"}}}), std::invalid_argument);
}
}  // namespace
