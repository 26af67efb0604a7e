// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/height_slabs.h>
#include <traverse/traversability_grid/params.h>

#include <array>
#include <cstdint>
#include <limits>

namespace traverse::traversability_grid
{
/** What the paper measures in a cell, over the n points that count. Metres of the map frame; NaN
 * where there is nothing to measure. The paper's formulas in its order:
 *
 *     (1) mean        zm = (1/n) sum z
 *     (2) deviation   dz = max |z - zm| = max(z_max - zm, zm - z_min)
 *     (3) mean plane  z = A x + B y + C by least squares; x, y from the cell's smallest corner
 *     (4) slope       cos(gamma) = 1 / sqrt(A^2 + B^2 + 1)
 *     (5) variance    D = (1/n) sum (z - zm)^2 */
struct Features
{
  uint64_t n = 0;
  double mean_m = 0;
  double min_m = 0;
  double max_m = 0;
  double deviation_m = 0;
  double variance_m2 = 0;
  bool has_plane = false;  //!< false: the points lie on one line seen from above, or in one place
                           //!< (or, with SlabReading::thin_mm, in one place)
  double slope_x = 0;      //!< A
  double slope_y = 0;      //!< B
  double at_corner_m = 0;  //!< C
  double noise_m2 = 0;     //!< part of the variance that the sensor's noise makes
  double residual_m2 = 0;  //!< variance of the heights off the mean plane; the variance without one
  uint64_t level_n = 0;    //!< points met at their sensor's own height
  poses::TimeNs last_seen = 0;

  /** tan^2 of the angle gamma between the plane and the horizontal. */
  double tan2Slope() const { return slope_x * slope_x + slope_y * slope_y; }

  /** gamma in degrees; NaN without a plane. */
  double slope_deg() const;
};

/** How far the noise of the sensor by itself takes the farthest of the points off a surface, m. */
double noiseSpan_m(const Features& features);

/** How a cell's slabs are read. */
struct SlabReading
{
  int32_t slab_mm = 500;
  int64_t clearance_mm = 2000;   //!< the vehicle's height
  bool ignore_overhangs = true;  //!< upward to the first gap of at least clearance_mm only

  /** Points whose smaller horizontal standard deviation is below this have their slope fitted along
   * the larger direction only. 0: never (the paper). */
  double thin_mm = 0;

  /** Slabs wholly below are passed over where one reaches above: false returns from under the
   * ground. */
  int64_t floor_mm = std::numeric_limits<int64_t>::min();
};

/** Features of the cell whose lowest slab is given (nullptr: n = 0). */
Features featuresOf(
    const layers::HeightSlabs& slabs, const layers::HeightSlab* lowest, const SlabReading& reading);

/** Step 5: features to class, by the cell itself. */
class Classifier
{
 public:
  explicit Classifier(const Params& params);

  /** The first class whose limits the features do not exceed. Undefined: fewer than min_points;
   * with classifier = paper also no plane where the other features alone are not an obstacle's (a
   * plane could still worsen the class, so they do not decide). classifier = default takes the
   * sensor's noise off the features first. */
  Class operator()(const Features& features) const;

  /** Of a surface so much above the ground that the vehicle comes from. */
  Class ofStep(double step_m) const { return worstOf(step_m, 0, 0); }

 private:
  struct Limits
  {
    double deviation_m;
    double tan2_slope;
    double variance_m2;
  };

  Class worstOf(double deviation_m, double variance_m2, double tan2_slope) const;

  ClassifierKind kind_;
  uint64_t min_points_;
  std::array<Limits, 3> limits_;
};

/** Index of undefined cells where a number must be stored; layers show NaN. */
inline constexpr uint8_t kNoIndex = 255;

/** Step 6: 0..100, less is easier; kNoIndex for undefined. */
uint8_t indexOf(Class of, const Params& params);
}  // namespace traverse::traversability_grid
