// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"

#include <traverse/simulating/truth_section.h>
#include <traverse/simulation/recording.h>

#include <string>

namespace traverse::app
{
/** A scene and what is recorded of it. */
struct SimSettings
{
  simulation::Scene scene;
  simulation::RecordingParams recording;
  simulating::TruthSection truth;
  std::string text;   //!< of all, every key written out: an ini that makes the same again
  std::string files;  //!< the bytes and CRC-32 of each file that the ground is made of, as text
};

/** Throws config::ConfigError. */
SimSettings readSettings(const SimCommand& command);
}  // namespace traverse::app
