// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/ini_document.h>
#include <traverse/config/strict.h>
#include <traverse/geometry/vehicle.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
using namespace traverse::config;
using ::testing::AllOf;
using ::testing::HasSubstr;
using traverse::geometry::Vehicle;

IniDocument ini(const std::string& text)
{
  return IniDocument::fromText(text, "car.ini");
}

std::string messageOf(const std::function<void()>& act)
{
  try
  {
    act();
  }
  catch (const ConfigError& e)
  {
    return e.what();
  }
  return "no error";
}

std::string loadError(const std::string& text)
{
  return messageOf(
      [&]
      {
        Vehicle v;
        load(ini(text), "Vehicle", v);
      });
}

TEST(IniDocument, LoadsASection)
{
  Vehicle v;
  load(ini("[Vehicle]\nheight_m = 1.8 // with the mast\nMAX_STEP_M=0.1\n"), "vehicle", v);
  EXPECT_DOUBLE_EQ(v.height_m, 1.8);
  EXPECT_DOUBLE_EQ(v.max_step_m, 0.1);
}

TEST(IniDocument, UnknownKeyNamesFileLineAndTheNearestKey)
{
  EXPECT_THAT(
      loadError("[Vehicle]\n\nheigth_m = 2\n"),
      AllOf(
          HasSubstr("car.ini:3:"), HasSubstr("'heigth_m'"), HasSubstr("did you mean 'height_m'?")));
}

TEST(IniDocument, BadValueNamesFileLineValueAndRange)
{
  EXPECT_THAT(
      loadError("[Vehicle]\nheight_m = 1,8\n"),
      AllOf(HasSubstr("car.ini:2:"), HasSubstr("'1,8'"), HasSubstr("0.05 to 20")));
  EXPECT_THAT(loadError("[Vehicle]\nheight_m = 2 # m\n"), HasSubstr("'2 # m'"));
  EXPECT_THAT(loadError("[Vehicle]\nheight_m =\n"), HasSubstr("height_m = ''"));
}

TEST(IniDocument, RefusesWhatMrptReadsOver)
{
  EXPECT_THAT(messageOf([] { ini("a = 1\n"); }), HasSubstr("car.ini:1: 'a' stands before"));
  EXPECT_THAT(messageOf([] { ini("[A]\nb\n"); }), HasSubstr("car.ini:2: neither"));
  EXPECT_THAT(messageOf([] { ini("[A\nb=1\n"); }), HasSubstr("'[' without ']'"));
  EXPECT_THAT(
      messageOf([] { ini("[A]\nb=1\n[a]\nB=2\n"); }),
      HasSubstr("stands twice; first at car.ini:2"));
  EXPECT_THAT(messageOf([] { ini(std::string("[A]\nb=\0\n", 8)); }), HasSubstr("NUL"));
  EXPECT_THAT(
      messageOf([] { ini("[A]\nb=" + std::string(100000, 'x')); }),
      HasSubstr("car.ini:2: this line"));
  EXPECT_THAT(
      messageOf([] { IniDocument::fromFile("/nonexistent.ini"); }), HasSubstr("no such file"));
  EXPECT_THAT(messageOf([] { IniDocument::fromFile("/tmp"); }), HasSubstr("no such file"));
}

TEST(IniDocument, ACommentNeverSwallowsTheNextLine)
{
  const std::string text = "[A]\n// in C:\\logs\\\nb=1\n";
  EXPECT_THAT(messageOf([&] { ini(text); }), HasSubstr("car.ini:2: a comment"));
}

TEST(IniDocument, ExpandsAsMrptDoes)
{
  const IniDocument d = ini("@define TALL 1.9\n[Vehicle]\nheight_m = ${TALL}\n");
  EXPECT_EQ(d.find("Vehicle", "height_m")->value, "1.9");
  EXPECT_THAT(messageOf([] { ini("[A]\nb = ${UNDEFINED_THING}\n"); }), HasSubstr("car.ini"));
}

TEST(IniDocument, SetOverridesAndAdds)
{
  IniDocument d = ini("[Vehicle]\nheight_m = 2\n");
  d.set("vehicle.height_m = 3");
  d.set("Maps_X_00_insertOpts.cell_size_m=0.1");
  EXPECT_EQ(d.find("Vehicle", "height_m")->value, "3");
  EXPECT_EQ(
      d.find("Maps_X_00_insertOpts", "cell_size_m")->place,
      "--set Maps_X_00_insertOpts.cell_size_m");
  EXPECT_THAT(messageOf([&] { d.set("height_m=3"); }), HasSubstr("section.key=value"));
  EXPECT_THAT(d.text(), HasSubstr("[Vehicle]\nheight_m = 3\n"));
}

TEST(IniDocument, ADecimalCommaLocaleChangesNothing)
{
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  Vehicle v;
  load(ini("[Vehicle]\nheight_m = 1.5\n"), "Vehicle", v);
  std::setlocale(LC_ALL, "C");
  EXPECT_DOUBLE_EQ(v.height_m, 1.5) << "locale " << (set == nullptr ? "not installed here" : set);
}
}  // namespace
