// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "object_archive.h"

#include <traverse/poses/pose_track.h>

#include <mrpt/obs/CObservation.h>

#include <optional>
#include <string>

namespace traverse::logs
{
/** A step of the odometry as an action carries it. */
struct Movement
{
  Eigen::Isometry3d T_before_after = Eigen::Isometry3d::Identity();
  std::optional<poses::TimeNs> stamp;
};

/** Gets what a walk over a log meets, in file order. */
class LogListener
{
 public:
  virtual ~LogListener() = default;
  virtual void observation(const mrpt::obs::CObservation::Ptr& observation) = 0;

  virtual void movement(const Movement& /*movement*/) {}

  /** The observations since the last frame's end belong together. */
  virtual void frameEnd() {}

  /** Something that is neither. */
  virtual void other(const std::string& type) = 0;

  /** An entry of the log is done. */
  virtual void entryEnd() = 0;

  /** Asked after each entry: the rest of the log need not be read. */
  virtual bool done() const { return false; }
};

/** Walks the objects of a log. Containers (sensory frames, action collections, a whole CRawlog) are
 * walked too, so that nothing is kept but one observation, and what stands before a damage counts.
 * Odometry actions are read value by value: MRPT would draw particles, as many as the file says. */
class LogWalk
{
 public:
  LogWalk(ByteSource& source, SharedProgress& progress, LogListener& listener) :
      archive_(source, progress), progress_(progress), listener_(listener)
  {
  }

  /** To the end of the log, or until the listener is done; throws LogDamage where the end comes too
   * early. */
  void run();

 private:
  void walk(const ObjectHeader& header, int depth);
  void walkChildren(const ObjectHeader& header, int depth);
  void readLeaf(const ObjectHeader& header);
  void tell(const mrpt::serialization::CSerializable::Ptr& object, const std::string& type);

  ObjectArchive archive_;
  SharedProgress& progress_;
  LogListener& listener_;
};

/** The class without its name space. */
std::string shortType(const std::string& type);

/** The body of a CActionRobotMovement2D; throws LogDamage. */
Movement readMovement2D(ObjectArchive& archive, const ObjectHeader& header);
}  // namespace traverse::logs
