// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/interrupt.h>

#include <csignal>

namespace traverse::app
{
namespace
{
std::atomic<bool> raised{false};
std::atomic<int> signal_number{0};

void remember(int number)
{
  signal_number = number;
  raised = true;
}
}  // namespace

Interrupt::Interrupt()
{
  raised = false;
  signal_number = 0;
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

Interrupt::~Interrupt()
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& Interrupt::flag()
{
  return raised;
}

std::optional<ExitCode> Interrupt::exitCode()
{
  if (!raised)
  {
    return std::nullopt;
  }
  return signal_number == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
}
}  // namespace traverse::app
