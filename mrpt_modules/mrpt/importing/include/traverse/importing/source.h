// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/point_channels.h>

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace traverse::importing
{
/** Input that cannot be imported at all: missing, of no known layout, or damaged from the start;
 * says the file and why. */
class ImportError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** One entry of the log that is made. */
struct Entry
{
  mrpt::obs::CObservation::Ptr observation;
  formats::PointChannels channels;  //!< of a cloud's points, in their order; else empty
};

/** What was met in the input. */
struct ImportReport
{
  std::map<std::string, uint64_t> imported;  //!< observations, by "label class"
  std::map<std::string, uint64_t> skipped;   //!< by reason: "/topic: its type std_msgs/String"
  std::vector<std::string> warnings;         //!< what people should know: guessed rates, sizes ...
  std::vector<std::string> damage;           //!< what could not be read; empty: complete
};

/** Recordings in some other layout, as observations. */
class Source
{
 public:
  virtual ~Source() = default;

  /** The next observation, in the order in which the log shall have them (by stamp where the input
   * has stamps); nothing at the end, and report() says how it went. Damaged parts of the input are
   * left out and reported. */
  virtual std::optional<Entry> next() = 0;

  /** How much of the input is done, 0..1. */
  virtual double progress() const = 0;

  virtual const ImportReport& report() const = 0;
};
}  // namespace traverse::importing
