// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "senses_interface.h"

#include <mrpt/nav/reactive/CAbstractPTGBasedReactive.h>

#include <memory>
#include <string>

namespace traverse::reactive
{
/** What we need of one of MRPT's navigators beyond what it shows. */
class WatchedNavigator
{
 public:
  virtual ~WatchedNavigator() = default;
  virtual mrpt::nav::CAbstractPTGBasedReactive& mrptNavigator() = 0;
  virtual bool isLogging() const = 0;

  /** Poses with times later than those to come would mislead it. */
  virtual void forgetPoses() = 0;
};

/** A navigator of MRPT's, mute, whose emergency stops become events of the interface: MRPT itself
 * forgets them at the end of the step. */
template <class Base>
class Watched final : public Base, public WatchedNavigator
{
 public:
  explicit Watched(SensesInterface& senses) : Base(senses, false, false), senses_(senses)
  {
    this->logging_enable_console_output = false;
    this->setMinLoggingLevel(mrpt::system::LVL_ERROR);
    // What it measures there comes out in a table on stdout when it is destroyed.
    this->m_timlog_delays.clear(true);
    this->m_timlog_delays.enable(false);
  }

  mrpt::nav::CAbstractPTGBasedReactive& mrptNavigator() override { return *this; }

  bool isLogging() const override { return this->m_logFile != nullptr; }

  void forgetPoses() override
  {
    this->m_latestPoses.clear();
    this->m_latestOdomPoses.clear();
  }

 protected:
  void doEmergencyStop(const std::string& message) override
  {
    senses_.events().error = message;
    Base::doEmergencyStop(message);
  }

 private:
  SensesInterface& senses_;
};

/** The one that the params name, with the ini read, collision grids made or read from the cache,
 * and one step done: in the first one MRPT must see a target that trajectories reach. Throws
 * std::runtime_error with MRPT's words. */
std::unique_ptr<WatchedNavigator> makeNavigator(
    Navigator kind,
    const std::string& ini,
    const std::filesystem::path& cache,
    SensesInterface& senses);

/** Writes .reactivenavlog files there from now on; throws std::runtime_error. */
void writeLog(WatchedNavigator& navigator, const std::filesystem::path& folder);
}  // namespace traverse::reactive
