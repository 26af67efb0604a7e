// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "browser.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace traverse::testing
{
/** The first map of a page: where its cells are on the screen, and what it says of them. */
class MapOnScreen
{
 public:
  MapOnScreen(Browser& browser, int width, int height) :
      browser_(browser), width_(width), height_(height)
  {
    EXPECT_TRUE(browser.waitFor("document.querySelector('figure.map')?.dataset.ready === 'yes'"));
    browser.evaluate("document.querySelector('.map canvas').scrollIntoView({block: 'center'})");
  }

  /** Middle of a cell, counted from the lower left. */
  std::pair<double, double> at(int column, int row)
  {
    const auto place = browser_.evaluate(
        "(() => { const c = document.querySelector('.map canvas'), b = c.getBoundingClientRect();"
        "const [size, left, top] = c.dataset.view.split(' ').map(Number);"
        "return [size, b.left + left, b.top + top]; })()");
    const double size = place[0];
    return {
        double(place[1]) + (column + 0.5) * size, double(place[2]) + (height_ - row - 0.5) * size};
  }

  double size()
  {
    return browser_.evaluate("+document.querySelector('.map canvas').dataset.view.split(' ')[0]");
  }

  std::string values()
  {
    return browser_.evaluate("document.querySelector('.map-values').innerText");
  }

  /** "r,g,b,a" of the canvas at a cell. */
  std::string colour(int column, int row)
  {
    const auto [x, y] = at(column, row);
    return browser_.evaluate(
        "(() => { const c = document.querySelector('.map canvas'), b = c.getBoundingClientRect();"
        "return [...c.getContext('2d').getImageData(" +
        std::to_string(x) + " - b.left, " + std::to_string(y) +
        " - b.top, 1, 1).data].join(); })()");
  }

  void choose(const std::string& layer)
  {
    browser_.evaluate("document.querySelector('.map select').focus()");
    for (const char c : layer)  // typing selects, as it does for people
    {
      browser_.call("Input.dispatchKeyEvent", {{"type", "keyDown"}, {"text", std::string(1, c)}});
      browser_.call("Input.dispatchKeyEvent", {{"type", "keyUp"}});
    }
    EXPECT_TRUE(browser_.waitFor(
        "document.querySelector('.map select').selectedOptions[0].textContent === '" + layer +
        "'"));
  }

 private:
  Browser& browser_;
  int width_, height_;
};
}  // namespace traverse::testing
