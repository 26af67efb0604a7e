// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sandbox.h"

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace traverse::sandbox
{
namespace
{
constexpr uint64_t kMebi = uint64_t{1} << 20U;

void resetSignals()
{
  for (int signal = 1; signal < NSIG; ++signal)
  {
    ::signal(signal, SIG_DFL);
  }
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void limit(int what, uint64_t amount)
{
  const rlimit both = {amount, amount};
  setrlimit(static_cast<__rlimit_resource>(what), &both);
}

ChildFiles keepOnly(const ChildFiles& files)
{
  // Out of the way first: the numbers wanted may be taken by one another.
  constexpr int kAside = 64;
  const int input = fcntl(files.input, F_DUPFD, kAside);
  const int frames = fcntl(files.frames, F_DUPFD, kAside);
  const int talk = fcntl(files.talk, F_DUPFD, kAside);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(talk, STDOUT_FILENO);
  dup2(talk, STDERR_FILENO);
  const ChildFiles kept = {3, 4, STDERR_FILENO};
  dup2(input, kept.input);
  dup2(frames, kept.frames);
  close_range(5, std::numeric_limits<unsigned>::max(), 0);
  return kept;
}

/** The n-th word (from 0) of a file of one line, after its last ')' (a name may have blanks). */
std::string wordOf(const std::string& file, int n)
{
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const size_t bracket = line.rfind(')');
  std::istringstream words(bracket == std::string::npos ? line : line.substr(bracket + 1));
  std::string word;
  for (int i = 0; i <= n && words >> word; ++i)
  {
  }
  return words ? word : "0";
}
}  // namespace

ChildFiles enterSandbox(const ChildFiles& files, const ReaderLimits& limits, pid_t parent)
{
  resetSignals();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent)
  {
    _exit(1);
  }
  const ChildFiles kept = keepOnly(files);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);  // MRPT writes an external file that it does not find
#ifndef TRAVERSE_SANITIZED
  limit(RLIMIT_AS, addressSpace() + static_cast<uint64_t>(limits.memory_mb) * kMebi);
#else
  static_cast<void>(limits);
#endif
  return kept;
}

uint64_t addressSpace()
{
  return std::stoull(wordOf("/proc/self/statm", 0)) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

uint64_t residentMemory(pid_t pid)
{
  return std::stoull(wordOf("/proc/" + std::to_string(pid) + "/statm", 1)) *
         static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

double processorTime(pid_t pid)
{
  const std::string file = "/proc/" + std::to_string(pid) + "/stat";
  constexpr int kUser = 11;  // fields 14 and 15 of proc(5), counted behind the name
  const double ticks = std::stod(wordOf(file, kUser)) + std::stod(wordOf(file, kUser + 1));
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}
}  // namespace traverse::sandbox
