// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <csignal>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

namespace traverse::testing
{
#if defined(__x86_64__)
/** What happens to the n-th system call on files that a child makes. */
struct Fault
{
  int at = 0;     //!< counted from 0
  int error = 0;  //!< an errno that the call fails with; 0: SIGKILL before the call
};

struct FaultRun
{
  bool reached = false;  //!< the child made so many calls
  int exit_code = -1;    //!< -1 where it was killed
};

namespace detail
{
inline bool isFileCall(unsigned long long call)
{
  constexpr std::array kCalls = {SYS_open,   SYS_openat,     SYS_write,     SYS_fsync,
                                 SYS_rename, SYS_renameat2,  SYS_mkdir,     SYS_unlink,
                                 SYS_rmdir,  SYS_unlinkat,   SYS_flock,     SYS_close,
                                 SYS_access, SYS_newfstatat, SYS_getdents64};
  return std::find(kCalls.begin(), kCalls.end(), static_cast<long>(call)) != kCalls.end();
}

/** Lets the child run to its next stop at a system call; false where it ended. */
inline bool toNextCall(pid_t child, int& status)
{
  ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
  ::waitpid(child, &status, 0);
  return WIFSTOPPED(status);
}

inline void failThisCall(pid_t child, user_regs_struct registers, int error)
{
  int status = 0;
  registers.orig_rax = ~0ULL;  // no call at all
  ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
  if (toNextCall(child, status))
  {
    ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
    registers.rax = static_cast<unsigned long long>(-static_cast<long long>(error));
    ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
  }
}
}  // namespace detail

/** Runs work() -> exit code in a child of its own, with the fault. */
template <class Work>
FaultRun runWithFault(const Fault& fault, Work&& work)
{
  const pid_t child = ::fork();
  if (child == 0)
  {
    ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    ::raise(SIGSTOP);
    ::_exit(work());
  }
  FaultRun run;
  int status = 0;
  ::waitpid(child, &status, 0);
  ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_EXITKILL);
  int calls = 0;
  bool at_entry = false;
  while (detail::toNextCall(child, status))
  {
    at_entry = !at_entry;
    user_regs_struct registers = {};
    ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
    if (!at_entry || !detail::isFileCall(registers.orig_rax) || calls++ != fault.at)
    {
      continue;
    }
    run.reached = true;
    if (fault.error == 0)
    {
      ::kill(child, SIGKILL);
    }
    else
    {
      detail::failThisCall(child, registers, fault.error);
      at_entry = false;
    }
  }
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}
#endif
}  // namespace traverse::testing
