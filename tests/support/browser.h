// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/scratch_folder.h"

#include <nlohmann/json.hpp>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace traverse::testing
{
/** A headless Chromium with one page, driven through its debugging pipe: real pointers and keys. */
class Browser
{
 public:
  using Json = nlohmann::json;

  /** Throws std::runtime_error where it cannot start, as do all others where it does not answer. */
  Browser();
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void open(const std::filesystem::path& file);

  /** The value of a JavaScript expression (promises are awaited); throws what it throws. */
  Json evaluate(const std::string& expression);

  /** Waits until the expression is true; false after 20 s. */
  bool waitFor(const std::string& expression);

  void move(double x, double y);
  void click(double x, double y);
  void drag(double x, double y, double to_x, double to_y);
  void wheel(double x, double y, double down);
  void key(const std::string& key, bool shift = false);

  /** Two fingers from `apart` to `to_apart` pixels around a place. */
  void pinch(double x, double y, double apart, double to_apart);

  void size(int width, int height);
  void dark(bool on);
  void scripts(bool on);

  /** The window as PNG. */
  void screenshot(const std::filesystem::path& file);

  /** What the page asked the network or disk for, without itself and data in it. */
  const std::vector<std::string>& requests() const { return requests_; }

  /** Errors and refusals that the page met. */
  const std::vector<std::string>& complaints() const { return complaints_; }

  /** A call of the DevTools protocol to the page. */
  Json call(const std::string& method, const Json& params = Json::object());

 private:
  void start(int from_browser[2], int to_browser[2]);
  Json receive();
  void note(const Json& event);
  void mouse(const std::string& type, double x, double y, const std::string& button);

  ScratchFolder profile_;
  pid_t pid_ = -1;
  int write_ = -1;
  int read_ = -1;
  int last_id_ = 0;
  std::string session_;
  std::string received_;
  std::string url_;
  std::vector<std::string> requests_;
  std::vector<std::string> complaints_;
};
}  // namespace traverse::testing
