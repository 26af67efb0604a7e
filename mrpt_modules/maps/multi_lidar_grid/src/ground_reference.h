// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"
#include "beam_points.h"

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/ground/estimator.h>
#include <traverse/layers/wrapped_grid.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** A patch's ground; z in its middle, over the zero of whoever holds it. */
template <class Height>
struct GroundPlane
{
  Height z_m = std::numeric_limits<Height>::quiet_NaN();
  float slope_x = 0;
  float slope_y = 0;
  float gap_m = std::numeric_limits<float>::infinity();  //!< to the nearest measured patch

  bool isKnown() const { return z_m == z_m; }
};

/** The ground of a region as one cloud needs it: floats above one zero, cells from its corner. */
class LocalGround
{
 public:
  /** Where to look: to be copied before loops that write bytes, as the compiler must take those for
   * any memory. Valid as long as the ground. */
  class View
  {
   public:
    /** NaN where it is not known. The cell lies in the region. */
    float heightAt(int32_t column, int32_t row) const
    {
      const Along& x = along_x_[column];
      const Along& y = along_y_[row];
      const GroundPlane<float>& plane = planes_[y.patch + x.patch];
      return plane.z_m + plane.slope_x * x.offset_m + plane.slope_y * y.offset_m;
    }

    /** Up per along in a direction. */
    float slopeAt(int32_t column, int32_t row, const Direction& to) const
    {
      const GroundPlane<float>& plane = planes_[along_y_[row].patch + along_x_[column].patch];
      return plane.slope_x * to.x + plane.slope_y * to.y;
    }

   private:
    friend class LocalGround;

    struct Along
    {
      uint32_t patch = 0;  //!< in y times the planes of a row
      float offset_m = 0;
    };

    const Along* along_x_ = nullptr;
    const Along* along_y_ = nullptr;
    const GroundPlane<float>* planes_ = nullptr;
  };

  View view() const
  {
    View view;
    view.along_x_ = along_x_.data();
    view.along_y_ = along_y_.data();
    view.planes_ = planes_.data();
    return view;
  }

  float heightAt(int32_t column, int32_t row) const { return view().heightAt(column, row); }

 private:
  friend class GroundReference;
  using Along = View::Along;

  std::vector<Along> along_x_, along_y_;
  std::vector<GroundPlane<float>> planes_;
};

/** The ground's height where sensors met it, on patches that roll with the robot; all sensors add
 * to it, each twice a second or when the robot came on, by a lattice of place and time, so that the
 * reference does not depend on when a map was begun. */
class GroundReference
{
 public:
  GroundReference(const geometry::Lattice& lattice, int32_t edge, const geometry::Vehicle& vehicle);

  void moveTo(geometry::CellIndex centre);

  /** Where the vehicle stands at a cloud's time. */
  struct Stand
  {
    Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
    poses::TimeNs stamp = 0;
    uint32_t sensor_bit = 1;
    double zero_m = 0;  //!< of the points' heights
  };

  /** Whether this sensor's cloud is one to estimate the ground from; remembers that it was. */
  bool isDue(const Stand& stand);

  /** Estimates the ground from a cloud within the region and takes what is better than before. */
  void add(const BeamPoints& points, const geometry::CellRect& region, const Stand& stand);

  /** With `is_level` the vehicle's own plane is the ground wherever nothing is known. */
  const LocalGround& local(const geometry::CellRect& region, const Stand& stand, bool is_level);

  /** Height in a cell, m, map frame; NaN where it is not known. */
  double heightAt(geometry::CellIndex cell) const;

 private:
  struct Slot
  {
    int64_t time = std::numeric_limits<int64_t>::min();
    geometry::CellIndex place;

    friend bool operator==(const Slot&, const Slot&) = default;
  };

  geometry::CellIndex patchOf(geometry::CellIndex cell) const;
  double middle_m(int32_t patch) const;
  GroundPlane<double> planeUnder(const Stand& stand) const;
  geometry::CellRect coarseWindow(const geometry::CellRect& region) const;
  void collect(const BeamPoints& points, const geometry::CellRect& region);
  void addUp(const BeamPoints& points);
  void take(const geometry::CellRect& region, const Stand& stand);

  geometry::Lattice lattice_;  // of the map's cells
  geometry::Lattice coarse_;   // of the estimate's columns
  int32_t merged_ = 1;         // the map's cells along a column
  int32_t patch_cells_ = 1;    // the map's cells along a patch
  geometry::Vehicle vehicle_;
  ground::Params params_;
  layers::WrappedGrid<GroundPlane<double>> planes_;
  std::array<Slot, 32> last_;

  ground::Estimator estimator_;
  std::vector<int32_t> slots_;          // of each coarse cell, its column's or -1
  std::vector<int32_t> slot_of_point_;  // the same of each point
  std::vector<ground::Column> columns_;
  std::vector<float> sums_;
  LocalGround local_;
};
}  // namespace traverse::multi_lidar_grid
