// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/cell_walk.h>
#include <traverse/navigation/costmap.h>

#include <cstddef>
#include <vector>

namespace traverse::navigation
{
/** A costmap as one plan sees it: what a metre costs the vehicle's middle in each cell, kClosed
 * where it may not go. One closed cell more on each side spares the search its bounds. */
class Terrain
{
 public:
  static constexpr float kClosed = std::numeric_limits<float>::infinity();

  /** A metre through hard cells, where the vehicle stands in them and must get out, costs so much
   * more. */
  static constexpr float kWayOutPrice = 50.0F;

  /** Prices above are taken for it: 1000 times what options allow. */
  static constexpr float kMostPrice = 1e6F;

  /** Open and unknown cells (these as Costmap::is_unknown_planned says) are open, all others
   * closed; so are cells whose price is not finite. Throws std::invalid_argument where passage or
   * price are not as many as the extent's cells. */
  void set(const Costmap& costmap);

  /** Opens the soft cells that hang together with this one, if it is soft. */
  void openSoft(const Costmap& costmap, geometry::CellIndex from);

  /** Opens soft cells up to so many cells beside strips; strips with a hard cell within `room`
   * cells are closed. */
  void openBesideStrips(const Costmap& costmap, int32_t reach, int32_t room = 0);

  /** Opens what leads out of the hard buffer, where the vehicle stands in one or, by noise, in an
   * obstacle: hard cells, and obstacle cells within `radius_m` of it, each no nearer to an obstacle
   * than the one before. Then the soft cells around. */
  void openWayOut(const Costmap& costmap, geometry::CellIndex from, double radius_m);

  const geometry::Lattice& lattice() const { return lattice_; }

  const geometry::CellRect& extent() const { return extent_; }

  size_t size() const { return price_.size(); }

  /** Cells from one row to the next. */
  size_t stride() const { return stride_; }

  bool covers(Place place) const
  {
    return place.x_m >= least_.x_m && place.y_m >= least_.y_m && place.x_m < most_.x_m &&
           place.y_m < most_.y_m && extent_.contains(cellOf(place, lattice_));
  }

  /** Of a cell of the extent, or beside it. */
  size_t indexOf(geometry::CellIndex c) const
  {
    return static_cast<size_t>(c.y - extent_.min.y + 1) * stride_ +
           static_cast<size_t>(c.x - extent_.min.x + 1);
  }

  size_t indexAt(Place place) const { return indexOf(cellOf(place, lattice_)); }

  geometry::CellIndex cell(size_t index) const;
  Place centre(size_t index) const;

  float price(size_t index) const { return price_[index]; }

  bool isOpen(size_t index) const { return price_[index] < kClosed; }

  /** The highest price of an open cell. */
  float highest() const { return highest_; }

  /** The mean price of open cells; kLeastPrice where there are none. */
  double mean() const;

  /** Sum of metres times price along a straight way between places that it covers; infinity where
   * it meets a closed cell. */
  double priceOfLine(Place from, Place to) const;

 private:
  void open(size_t index, float price);
  void openSoftAround(const Costmap& costmap, std::vector<geometry::CellIndex>& front);

  geometry::Lattice lattice_;
  geometry::CellRect extent_;
  Place least_;
  Place most_;
  size_t stride_ = 0;
  float highest_ = kLeastPrice;
  std::vector<float> price_;
};
}  // namespace traverse::navigation
