// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sandbox.h"

#include <traverse/options/untrusted_text.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace traverse::sandbox
{
namespace
{
constexpr int kWaitMs = 50;
constexpr int kPipeBytes = 1 << 20;
constexpr size_t kKeptTalk = 2048;

[[noreturn]] void fail(const char* what)
{
  throw std::system_error(errno, std::generic_category(), what);
}

std::pair<Fd, Fd> makePipe()
{
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
  {
    fail("no pipe for the reader");
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  fcntl(ends[1], F_SETPIPE_SZ, kPipeBytes);
  return {Fd(ends[0]), Fd(ends[1])};
}

[[noreturn]] void runChild(
    const ChildFiles& files,
    const ReaderLimits& limits,
    pid_t parent,
    const ReaderJob& job,
    SharedProgress& progress)
{
  const ChildFiles kept = enterSandbox(files, limits, parent);
  int status = 1;
  try
  {
    job(kept.input, kept.frames, progress);
    status = 0;
  }
  catch (const std::exception& e)
  {
    dprintf(kept.talk, "%s\n", e.what());
  }
  _exit(status);  // no destructors of the parent's statics, no flush of its buffers
}
}  // namespace

void ReaderProcess::Unmap::operator()(SharedProgress* p) const
{
  munmap(p, sizeof(SharedProgress));
}

ReaderProcess::ReaderProcess(int input_fd, const ReaderLimits& limits, const ReaderJob& job) :
    limits_(limits)
{
  void* page = mmap(
      nullptr, sizeof(SharedProgress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED)
  {
    fail("no memory for the reader");
  }
  progress_.reset(new (page) SharedProgress);
  auto [frames, frames_in] = makePipe();
  auto [talk, talk_in] = makePipe();
  memory_limit_bytes_ = residentMemory(getpid()) + (static_cast<uint64_t>(limits.memory_mb) << 20U);
  // No handler of ours may run in the child before it is rid of them.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0)
  {
    runChild({input_fd, frames_in.get(), talk_in.get()}, limits, parent, job, *progress_);
  }
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (pid_ < 0)
  {
    errno = error;
    fail("no process for the reader");
  }
  frames_ = std::move(frames);
  talk_ = std::move(talk);
}

ReaderProcess::~ReaderProcess()
{
  finish();
}

void ReaderProcess::wait()
{
  std::array<pollfd, 2> fds = {{{frames_.get(), POLLIN, 0}, {talk_.get(), POLLIN, 0}}};
  waits_ += poll(fds.data(), fds.size(), kWaitMs) == 0 ? 1 : 0;
  if ((fds[1].revents & (POLLIN | POLLHUP)) != 0)
  {
    takeTalk();
  }
}

bool ReaderProcess::receive(std::vector<uint8_t>& to)
{
  constexpr size_t kSome = 1U << 18U;
  const size_t before = to.size();
  to.resize(before + kSome);
  const ssize_t got = ::read(frames_.get(), to.data() + before, kSome);
  to.resize(before + static_cast<size_t>(std::max<ssize_t>(got, 0)));
  received_ += static_cast<uint64_t>(std::max<ssize_t>(got, 0));
  closed_ = got == 0;
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

std::string ReaderProcess::misbehaviour()
{
  if (residentMemory(pid_) > memory_limit_bytes_)
  {
    return fmt::format("the reader took more than {} MiB of memory", limits_.memory_mb);
  }
  const double cpu_s = processorTime(pid_);
  if (progress_->object != seen_object_ || received_ != seen_bytes_)
  {
    seen_object_ = progress_->object;
    seen_bytes_ = received_;
    cpu_then_s_ = cpu_s;
    waits_ = 0;
  }
  // One that uses no processor either waits for something that never comes; a busy machine and a
  // slow disk get four times as long.
  const double waited_s = waits_ * kWaitMs * 1e-3;
  if (cpu_s - cpu_then_s_ > limits_.timeout_s || waited_s > 4 * limits_.timeout_s)
  {
    return fmt::format("the reader made no progress in {} s", limits_.timeout_s);
  }
  return "";
}

void ReaderProcess::takeTalk()
{
  std::array<char, 4096> some{};
  const ssize_t got = ::read(talk_.get(), some.data(), some.size());
  if (got <= 0)
  {
    if (got == 0)
    {
      talk_.reset();
    }
    return;
  }
  said_.append(some.data(), static_cast<size_t>(got));
  if (said_.size() > kKeptTalk)
  {
    said_.erase(0, said_.size() - kKeptTalk);
  }
}

std::string ReaderProcess::lastWords() const
{
  const size_t end = said_.find_last_not_of("\r\n ");
  if (end == std::string::npos)
  {
    return "";
  }
  const size_t begin = said_.find_last_of('\n', end);
  const std::string_view line = std::string_view(said_).substr(begin + 1, end - begin);
  return ", its last words: " + options::printable(line, 200);
}

std::string ReaderProcess::finish()
{
  if (pid_ < 0)
  {
    return "";
  }
  int status = 0;
  pid_t reaped = waitpid(pid_, &status, WNOHANG);
  // A child that has closed its pipe is about to exit on its own.
  for (int i = 0; reaped == 0 && closed_ && i < 400; ++i)
  {
    poll(nullptr, 0, kWaitMs / 10);
    takeTalk();
    reaped = waitpid(pid_, &status, WNOHANG);
  }
  if (reaped == 0)
  {
    kill(pid_, SIGKILL);
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR)
    {
    }
  }
  pid_ = -1;
  takeTalk();
  if (WIFSIGNALED(status))
  {
    return fmt::format("the reader died (signal {}){}", WTERMSIG(status), lastWords());
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) != 0)
  {
    return fmt::format("the reader gave up (status {}){}", WEXITSTATUS(status), lastWords());
  }
  return "";
}
}  // namespace traverse::sandbox
