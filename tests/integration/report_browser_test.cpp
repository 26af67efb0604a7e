// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// report.html in a headless Chromium: pointed at, clicked, and held against what the map has there.
#include <traverse/formats/layer_map.h>
#include <traverse/formats/run_index.h>
#include <traverse/formats/safe_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <support/browser.h>
#include <support/every_type.h>
#include <support/map_on_screen.h>
#include <support/traverse_map.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using traverse::layers::LayerSet;

bool hasChromium()
{
  return run({"sh", "-c", "command -v chromium"}).exit_code == 0;
}

#define NEEDS_CHROMIUM()                              \
  do                                                  \
  {                                                   \
    if (!hasChromium())                               \
    {                                                 \
      GTEST_SKIP() << "SKIPPED: chromium is missing"; \
    }                                                 \
  } while (false)

std::string pageOf(const LayerSet& set, const std::vector<std::array<double, 3>>& path = {})
{
  Report report{"A map", "", {}, ""};
  report.sections.push_back({"Map", {layerMap(set, path)}});
  return html(report);
}

/** A browser with a page of everyType({-1, -3}), 3 x 2 cells. */
class ReportInBrowser : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    NEEDS_CHROMIUM();
    writeFile(
        scratch_ / "report.html", pageOf(everyType({-1, -3}), {{-0.1, -0.5, 0}, {0.3, -0.3, 0}}));
    browser_.emplace();
    browser_->open(scratch_ / "report.html");
    map_.emplace(*browser_, 3, 2);
  }

  ScratchFolder scratch_;
  std::optional<Browser> browser_;
  std::optional<MapOnScreen> map_;
};

TEST_F(ReportInBrowser, TheCellUnderThePointerSaysAllItsValues)
{
  auto [x, y] = map_->at(0, 0);
  browser_->move(x, y);
  EXPECT_THAT(
      map_->values(),
      AllOf(
          HasSubstr("cell\t-1, -3"), HasSubstr("x\t-0.20 to 0.00 m"),
          HasSubstr("y\t-0.60 to -0.40 m"), HasSubstr("traversability_class\tsmall roughness"),
          HasSubstr("height_mean\t1.5 m"), HasSubstr("point_count\t4294967295"),
          HasSubstr("last_seen_s\t15196")));
  std::tie(x, y) = map_->at(1, 0);
  browser_->move(x, y);
  EXPECT_THAT(map_->values(), AllOf(HasSubstr("cell\t0, -3"), HasSubstr("height_mean\tunknown")));
  std::tie(x, y) = map_->at(2, 1);
  browser_->move(x, y);
  EXPECT_THAT(map_->values(), HasSubstr("nothing known"));
}

TEST_F(ReportInBrowser, ItAsksForNothingAndComplainsOfNothing)
{
  EXPECT_THAT(browser_->requests(), IsEmpty());
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, ThePolicyKeepsOtherScriptsAndTheNetworkOut)
{
  browser_->evaluate(
      "(() => { const s = document.createElement('script'); s.textContent = 'window.evil = 1';"
      "document.body.append(s); const i = new Image(); i.src = 'http://127.0.0.1:9/x.png'; })()");
  EXPECT_EQ(browser_->evaluate("typeof window.evil"), "undefined");
  EXPECT_EQ(
      browser_->evaluate("fetch('http://127.0.0.1:9/').then(() => 'went', () => 'refused')"),
      "refused");
  EXPECT_GE(browser_->complaints().size(), 2U) << "the browser says what it refused";
}

TEST_F(ReportInBrowser, AClickKeepsACellAndEscapeLetsGo)
{
  auto [x, y] = map_->at(0, 0);
  browser_->click(x, y);
  const auto [other_x, other_y] = map_->at(2, 0);
  browser_->move(other_x, other_y);
  EXPECT_THAT(map_->values(), HasSubstr("cell\t-1, -3"));
  browser_->key("Escape");
  browser_->move(other_x, other_y);
  browser_->move(other_x + 1, other_y);
  EXPECT_THAT(map_->values(), HasSubstr("cell\t1, -3"));
}

TEST_F(ReportInBrowser, LayersAreSwitchedAndColoured)
{
  browser_->click(2, 2);
  browser_->evaluate(
      "document.querySelector('.map input').click()");  // the trajectory lies over it
  EXPECT_EQ(map_->colour(0, 0), "190,150,220,255") << "small roughness, as the legend has it";
  EXPECT_EQ(map_->colour(2, 0), "200,20,60,255");
  EXPECT_EQ(map_->colour(2, 1), "0,0,0,0") << "nothing known";
  map_->choose("point_count");
  EXPECT_EQ(map_->colour(1, 0), "0,0,0,0") << "no points";
  EXPECT_NE(map_->colour(0, 0), map_->colour(2, 0)) << "most points and fewest";
  EXPECT_THAT(
      std::string(browser_->evaluate("document.querySelector('.map-scale').innerText")),
      HasSubstr("4294967295"));
}

TEST_F(ReportInBrowser, TheTrajectoryIsDrawnUntilItIsSwitchedOff)
{
  const std::string with = map_->colour(1, 0);  // the line from the first to the fifth cell's edge
  EXPECT_EQ(map_->colour(0, 0), "0,0,0,255") << "it starts there";
  browser_->evaluate("document.querySelector('.map input').click()");
  EXPECT_EQ(map_->colour(0, 0), "190,150,220,255");
}

TEST_F(ReportInBrowser, WheelDragPinchAndKeysMoveTheMap)
{
  const double before = map_->size();
  auto [x, y] = map_->at(0, 0);
  browser_->wheel(x, y, -100);
  EXPECT_GT(map_->size(), before * 1.1);
  EXPECT_NEAR(map_->at(0, 0).first, x, 1) << "the place under the pointer stays";
  browser_->drag(x, y, x + 40, y - 30);
  EXPECT_NEAR(map_->at(0, 0).first, x + 40, 1);
  EXPECT_NEAR(map_->at(0, 0).second, y - 30, 1);
  browser_->evaluate("document.querySelector('.map canvas').focus()");
  browser_->key("0");
  EXPECT_NEAR(map_->size(), before, 1e-6);
  browser_->key("-");
  EXPECT_LT(map_->size(), before);
  const double small = map_->size();
  browser_->pinch(x, y, 60, 90);
  EXPECT_NEAR(map_->size() / small, 1.5, 0.05);
}

TEST_F(ReportInBrowser, TheKeyboardStepsThroughCells)
{
  browser_->evaluate("document.querySelector('.map canvas').focus()");
  browser_->key("ArrowLeft", true);
  browser_->key("ArrowLeft", true);
  browser_->key("ArrowDown", true);
  EXPECT_THAT(map_->values(), HasSubstr("cell\t-1, -3"));
  browser_->key("ArrowUp", true);
  EXPECT_THAT(map_->values(), HasSubstr("cell\t-1, -2"));
}

TEST_F(ReportInBrowser, WithoutScriptItSaysSoAndStaysReadable)
{
  browser_->scripts(false);
  browser_->open(scratch_ / "report.html");
  browser_->scripts(true);
  EXPECT_THAT(
      std::string(browser_->evaluate("document.body.innerText")), Not(HasSubstr("cell_mm")));
  EXPECT_EQ(browser_->evaluate("document.querySelectorAll('canvas').length"), 0);
}

TEST(IndexInBrowser, AClickSortsAndASecondTurnsIt)
{
  NEEDS_CHROMIUM();
  std::vector<RunEntry> runs(3);
  const std::array<std::optional<uint64_t>, 3> scans = {9, std::nullopt, 100};
  for (size_t i = 0; i < 3; ++i)
  {
    runs[i].folder = std::string(1, static_cast<char>('a' + i));
    runs[i].scans = scans[i];
  }
  const ScratchFolder scratch;
  writeFile(scratch / "index.html", runIndex("Runs", runs));
  Browser browser;
  browser.open(scratch / "index.html");
  const auto order = [&]() -> std::string
  {
    return browser.evaluate(
        "[...document.querySelectorAll('tbody tr')].map(r => r.cells[2].textContent).join('')");
  };
  const auto heading = browser.evaluate(
      "(() => { const b = [...document.querySelectorAll('th button')].find(b => b.textContent === "
      "'scans')"
      ".getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; })()");
  EXPECT_EQ(order(), "abc");
  browser.click(heading[0], heading[1]);
  EXPECT_EQ(order(), "acb") << "by number, those without one last";
  browser.click(heading[0], heading[1]);
  EXPECT_EQ(order(), "cab");
  EXPECT_THAT(browser.requests(), IsEmpty());
  EXPECT_THAT(browser.complaints(), IsEmpty());
}

TEST(ReportOfARun, ShowsWhatTheGeoTiffsHave)
{
  NEEDS_CHROMIUM();
  const ScratchFolder scratch;
  ASSERT_EQ(traverseMap({ini("vlp16"), "--output", scratch / "out", "--quiet"}).exit_code, 0);
  Browser browser;
  browser.open(scratch / "out" / "report.html");
  ASSERT_TRUE(browser.waitFor("document.querySelector('figure.map')?.dataset.ready === 'yes'"));
  EXPECT_THAT(browser.requests(), IsEmpty());
  EXPECT_THAT(browser.complaints(), IsEmpty());
  const auto rect = browser.evaluate(
      "(() => { const m = JSON.parse(document.querySelector('figure.map script').textContent);"
      "return [m.x, m.y, m.width, m.height, m.cell_mm]; })()");
  MapOnScreen map(browser, rect[2], rect[3]);
  std::istringstream cells(run({"gdal_translate", "-q", "-of", "XYZ",
                                (scratch / "out" / "height_mean.tif").string(), "/vsistdout/"})
                               .out);
  int known = 0;
  int compared = 0;
  for (std::string x_m, y_m, expected; cells >> x_m >> y_m >> expected;)
  {
    if (expected == "nan" || ++known % 50 != 0)
    {
      continue;
    }
    const double cell_m = int(rect[4]) / 1000.0;
    const auto [x, y] = map.at(
        int(std::floor(std::stod(x_m) / cell_m)) - int(rect[0]),
        int(std::floor(std::stod(y_m) / cell_m)) - int(rect[1]));
    browser.move(x, y);
    const std::string values = map.values();
    const size_t found = values.find("height_mean\t");
    ASSERT_NE(found, std::string::npos) << x_m << " " << y_m << ": " << values;
    const double height = std::stod(expected);
    EXPECT_NEAR(std::stod(values.substr(found + 12)), height, std::abs(height) * 7e-5)
        << "five digits are shown, at " << x_m << " " << y_m;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}
}  // namespace
