// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/browser.h"

#include "support/base64.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace traverse::testing
{
namespace
{
constexpr int kPatience = 60'000;  // ms
}  // namespace

Browser::Browser()
{
  int from_browser[2];
  int to_browser[2];
  if (::pipe2(from_browser, O_CLOEXEC) != 0 || ::pipe2(to_browser, O_CLOEXEC) != 0)
  {
    throw std::runtime_error("no pipes");
  }
  start(from_browser, to_browser);
  const Json target = call("Target.createTarget", {{"url", "about:blank"}});
  const Json session =
      call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}});
  session_ = session["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Network", "Log"})
  {
    call(std::string(domain) + ".enable");
  }
  size(1200, 900);
}

void Browser::start(int from_browser[2], int to_browser[2])
{
  const std::string profile = "--user-data-dir=" + profile_.path().string();
  pid_ = ::fork();
  if (pid_ == 0)
  {
    // The browser reads commands from 3 and answers on 4; what is there now may be the other's.
    const int commands = ::fcntl(to_browser[0], F_DUPFD, 10);
    const int answers = ::fcntl(from_browser[1], F_DUPFD, 10);
    ::dup2(commands, 3);
    ::dup2(answers, 4);
    const int null = ::open("/dev/null", O_RDWR);
    ::dup2(null, 1);
    ::dup2(null, 2);
    ::setpgid(0, 0);
    ::execlp(
        "chromium", "chromium", "--headless=new", "--no-sandbox", "--disable-gpu",
        "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions",
        "--remote-debugging-pipe", profile.c_str(), "about:blank", nullptr);
    ::_exit(127);
  }
  ::close(to_browser[0]);
  ::close(from_browser[1]);
  write_ = to_browser[1];
  read_ = from_browser[0];
}

Browser::~Browser()
{
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  ::close(write_);
  ::close(read_);
}

Browser::Json Browser::receive()
{
  while (received_.find('\0') == std::string::npos)
  {
    pollfd ready = {read_, POLLIN, 0};
    char part[65536];
    const ssize_t got =
        ::poll(&ready, 1, kPatience) > 0 ? ::read(read_, part, sizeof part) : ssize_t{0};
    if (got <= 0)
    {
      throw std::runtime_error("the browser does not answer");
    }
    received_.append(part, static_cast<size_t>(got));
  }
  const size_t end = received_.find('\0');
  const Json message = Json::parse(received_.substr(0, end));
  received_.erase(0, end + 1);
  return message;
}

void Browser::note(const Json& event)
{
  const std::string method = event.value("method", "");
  if (method == "Network.requestWillBeSent")
  {
    const std::string url = event["params"]["request"]["url"];
    if (url != url_ && url.rfind("data:", 0) != 0)
    {
      requests_.push_back(url);
    }
  }
  else if (method == "Log.entryAdded")
  {
    complaints_.push_back(event["params"]["entry"]["text"]);
  }
  else if (method == "Runtime.exceptionThrown")
  {
    complaints_.push_back(event["params"]["exceptionDetails"].dump());
  }
}

Browser::Json Browser::call(const std::string& method, const Json& params)
{
  Json message = {{"id", ++last_id_}, {"method", method}, {"params", params}};
  if (!session_.empty())
  {
    message["sessionId"] = session_;
  }
  const std::string text = message.dump();
  for (size_t sent = 0; sent <= text.size();)  // with the 0 at its end
  {
    const ssize_t put = ::write(write_, text.c_str() + sent, text.size() + 1 - sent);
    if (put <= 0)
    {
      throw std::runtime_error("the browser does not listen");
    }
    sent += static_cast<size_t>(put);
  }
  for (;;)
  {
    const Json answer = receive();
    if (answer.value("id", 0) != last_id_)
    {
      note(answer);
      continue;
    }
    if (answer.contains("error"))
    {
      throw std::runtime_error(method + ": " + answer["error"].dump());
    }
    return answer["result"];
  }
}

void Browser::open(const std::filesystem::path& file)
{
  url_ = "file://" + std::filesystem::absolute(file).string();
  requests_.clear();
  complaints_.clear();
  call("Page.navigate", {{"url", url_}});
  waitFor("document.readyState === 'complete' && location.protocol === 'file:'");
}

Browser::Json Browser::evaluate(const std::string& expression)
{
  const Json answer = call(
      "Runtime.evaluate",
      {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (answer.contains("exceptionDetails"))
  {
    throw std::runtime_error(answer["exceptionDetails"].dump());
  }
  return answer["result"].value("value", Json());
}

bool Browser::waitFor(const std::string& expression)
{
  for (int i = 0; i < 200; ++i)
  {
    if (evaluate(expression) == true)
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

void Browser::mouse(const std::string& type, double x, double y, const std::string& button)
{
  call(
      "Input.dispatchMouseEvent", {{"type", type},
                                   {"x", x},
                                   {"y", y},
                                   {"button", button},
                                   {"clickCount", button == "left" ? 1 : 0}});
}

void Browser::move(double x, double y)
{
  mouse("mouseMoved", x, y, "none");
}

void Browser::click(double x, double y)
{
  move(x, y);
  mouse("mousePressed", x, y, "left");
  mouse("mouseReleased", x, y, "left");
}

void Browser::drag(double x, double y, double to_x, double to_y)
{
  move(x, y);
  mouse("mousePressed", x, y, "left");
  mouse("mouseMoved", (x + to_x) / 2, (y + to_y) / 2, "left");
  mouse("mouseMoved", to_x, to_y, "left");
  mouse("mouseReleased", to_x, to_y, "left");
}

void Browser::wheel(double x, double y, double down)
{
  call(
      "Input.dispatchMouseEvent",
      {{"type", "mouseWheel"}, {"x", x}, {"y", y}, {"deltaX", 0}, {"deltaY", down}});
}

void Browser::key(const std::string& key, bool shift)
{
  for (const char* type : {"keyDown", "keyUp"})
  {
    call("Input.dispatchKeyEvent", {{"type", type}, {"key", key}, {"modifiers", shift ? 8 : 0}});
  }
}

void Browser::pinch(double x, double y, double apart, double to_apart)
{
  const auto fingers = [&](double gap)
  {
    return Json::array(
        {{{"x", x - gap / 2}, {"y", y}, {"id", 1}}, {{"x", x + gap / 2}, {"y", y}, {"id", 2}}});
  };
  const auto touch = [&](const char* type, const Json& points) {
    call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", points}});
  };
  touch("touchStart", fingers(apart));
  touch("touchMove", fingers((apart + to_apart) / 2));
  touch("touchMove", fingers(to_apart));
  touch("touchEnd", Json::array());
}

void Browser::size(int width, int height)
{
  call(
      "Emulation.setDeviceMetricsOverride",
      {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

void Browser::dark(bool on)
{
  call(
      "Emulation.setEmulatedMedia",
      {{"features",
        Json::array({{{"name", "prefers-color-scheme"}, {"value", on ? "dark" : "light"}}})}});
}

void Browser::scripts(bool on)
{
  call("Emulation.setScriptExecutionDisabled", {{"value", !on}});
}

void Browser::screenshot(const std::filesystem::path& file)
{
  const Json picture = call("Page.captureScreenshot", {{"format", "png"}});
  writeText(file, fromBase64(picture["data"]));
}
}  // namespace traverse::testing
