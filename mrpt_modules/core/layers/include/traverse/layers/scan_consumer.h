// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>
#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::layers
{
/** What one scan did to a map. A scan is one transaction: all of it or nothing. */
struct UpdateStats
{
  bool inserted = false;       //!< the map changed
  bool no_pose = false;        //!< skipped: no valid pose at the scan's time
  uint64_t points = 0;         //!< added
  uint64_t outside = 0;        //!< points beyond the map's extent or range limits
  uint64_t touched_cells = 0;  //!< cells that got a point
  uint64_t bad_points = 0;     //!< skipped: NaN, Inf, or further than anything on the ground
  uint64_t over_budget = 0;    //!< points that the map's memory budget had no room for
};

/** A file of a map's own beside layers and archive: its name ends so, and its bytes. */
struct ExtraFile
{
  std::string ending;  //!< ".bt"
  std::string bytes;
};

/** A line of text about a cell, for people. */
struct Fact
{
  std::string key;
  std::string value;
};

/** A map that takes decoded, deskewed scans. The apps cast what MRPT's map factory made to this. */
class ScanConsumer
{
 public:
  virtual ~ScanConsumer() = default;

  /** Adds a deskewed scan at the track's pose for its stamp. */
  virtual UpdateStats insertScan(const points::Scan& scan, const poses::PoseTrack& track) = 0;

  /** Time goes on without a scan: what is too old goes, from maps that forget. */
  virtual void advance(poses::TimeNs /*now*/) {}

  /** A label for each point of the scan that was inserted last, which must be given again: 0
   * undefined, 1 ground, 2 obstacle, 3 overhanging. Empty from maps that have no labels. */
  virtual std::vector<uint32_t> pointLabels(
      const points::Scan& /*scan*/, const poses::PoseTrack& /*track*/) const
  {
    return {};
  }

  /** The map's layers in a window (all of it by default; cells outside the map are unknown). Others
   * than the wanted ones may be left out: those that cost something are. */
  virtual LayerSet layerSet(
      std::optional<geometry::CellRect> window = std::nullopt,
      const LayerChoice& wanted = {}) const = 0;

  /** The map as a checked, versioned, deterministic byte string (formats/archive.h). */
  virtual std::string archive() const = 0;

  /** What archives of this class of map are called (formats/archive.h). */
  virtual std::string_view archiveKind() const = 0;

  /** Replaces the map by that of archive(). Throws formats::FormatError, with the map as it was. */
  virtual void setFromArchive(std::string_view bytes) = 0;

  /** Adds the points of another map of this kind and options, given as its archive(): the result is
   * the map of both maps' scans, whatever their order, to the last byte of archive().
   *
   * All or nothing. Throws formats::FormatError for bytes that are no such archive,
   * std::invalid_argument for a map of other options, std::length_error beyond the memory budget.
   */
  virtual void mergeArchive(std::string_view bytes) = 0;

  /** Why maps of pieces of a log, merged, would not be the map of the whole log (options by which
   * it forgets): text for the user, which says what to use. Empty where they would. */
  virtual std::string mergeObstacle() const = 0;

  /** Why the cell at a place of the map frame (|x|, |y| <= 1e6 m) is what it is: key and value. */
  virtual std::vector<Fact> explain(double x_m, double y_m) const = 0;

  /** What else the map wants saved. */
  virtual std::vector<ExtraFile> extraFiles() const { return {}; }

  /** Ending of the extra file that mergeExtra() takes; empty: none. */
  virtual std::string mergedEnding() const { return {}; }

  /** Adds such a file of another map of this kind and options, as mergeArchive() adds its archive.
   */
  virtual void mergeExtra(std::string_view /*bytes*/) {}

  /** What a user must know of points that the map did not take, beyond UpdateStats. */
  virtual std::vector<std::string> warnings() const { return {}; }

  /** Edge of the largest square of points, centred at the pose, of which insertScan() leaves out
   * none for being too far aside, m. */
  virtual double pieceEdge_m() const { return std::numeric_limits<double>::infinity(); }
};
}  // namespace traverse::layers
