// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/process.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;

namespace traverse::testing
{
namespace
{
fs::path temporaryName(const char* stem)
{
  std::string name =
      (fs::temp_directory_path() / (std::string("traverse_") + stem + "_XXXXXX")).string();
  const int file = mkstemp(name.data());
  if (file < 0)
  {
    throw std::runtime_error("no temporary file");
  }
  close(file);
  return name;
}

/** In the child: never returns. */
[[noreturn]] void become(
    const std::vector<std::string>& argv, const std::vector<std::string>& environment)
{
  for (const std::string& setting : environment)
  {
    const size_t equals = setting.find('=');
    setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> words;
  words.reserve(argv.size() + 1);
  for (const std::string& word : argv)
  {
    words.push_back(const_cast<char*>(word.c_str()));
  }
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}
}  // namespace

Process::Process(
    const std::vector<std::string>& argv,
    const std::vector<std::string>& environment,
    bool keep_stdin) :
    out_file_(temporaryName("out")), err_file_(temporaryName("err"))
{
  int input[2] = {-1, -1};
  if (pipe2(input, O_CLOEXEC) != 0)
  {
    throw std::runtime_error("no pipe");
  }
  pid_ = fork();
  if (pid_ == 0)
  {
    const int in = keep_stdin ? input[0] : open("/dev/null", O_RDONLY);
    const int out = open(out_file_.c_str(), O_WRONLY | O_TRUNC);
    const int err = open(err_file_.c_str(), O_WRONLY | O_TRUNC);
    dup2(in, 0);
    dup2(out, 1);
    dup2(err, 2);
    become(argv, environment);
  }
  close(input[0]);
  stdin_ = input[1];
  if (pid_ < 0)
  {
    throw std::runtime_error("no process");
  }
}

Process::~Process()
{
  reap(false);
  if (!reaped_)
  {
    kill(pid_, SIGKILL);
    reap(true);
  }
  close(stdin_);
  std::error_code ignored;
  fs::remove(out_file_, ignored);
  fs::remove(err_file_, ignored);
}

void Process::type(const std::string& text) const
{
  if (write(stdin_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
  {
    throw std::runtime_error("the program does not read");
  }
}

void Process::signal(int number) const
{
  kill(pid_, number);
}

void Process::reap(bool block)
{
  if (!reaped_)
  {
    reaped_ = waitpid(pid_, &status_, block ? 0 : WNOHANG) == pid_;
  }
}

bool Process::running()
{
  reap(false);
  return !reaped_;
}

Finished Process::wait(std::chrono::seconds limit)
{
  const auto end = std::chrono::steady_clock::now() + limit;
  while (running())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      kill(pid_, SIGKILL);
      reap(true);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const int code = WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  return {code, readText(out_file_), readText(err_file_)};
}

Finished run(
    const std::vector<std::string>& argv,
    const std::vector<std::string>& environment,
    std::chrono::seconds limit)
{
  return Process(argv, environment).wait(limit);
}
}  // namespace traverse::testing
