// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refuse.h"
#include "terrain_piece.h"

#include <traverse/simulation/build.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kBin_m = 4;

/** Those pieces of a terrain that may change the ground in a bin. */
struct Nearby
{
  uint32_t piece = 0;
  uint32_t first = 0;  //!< of its segments here
  uint32_t count = 0;
};

/** All [Terrain_NN] added up, found by bins of 4 m. */
class SummedTerrain : public Terrain
{
 public:
  SummedTerrain(const SceneParams& params, std::vector<TerrainPiece> pieces) :
      pieces_(std::move(pieces)),
      area_{
          params.extent.min_x_m, params.extent.min_y_m, params.extent.max_x_m,
          params.extent.max_y_m},
      material_(chosenOr(params.extent.ground_material, Material::soil)),
      label_(chosenOr(params.extent.ground_label, Label::ground)),
      columns_(binsOf(area_.max_x_m - area_.min_x_m)),
      rows_(binsOf(area_.max_y_m - area_.min_y_m))
  {
    fillBins();
  }

  GroundAt at(double x_m, double y_m) const override
  {
    const GroundSum sum = sumAt(x_m, y_m, [](const TerrainPiece&) { return true; });
    const double height_m = sum.base_m + sum.rough_m + sum.bumps_m - sum.ditch_m;
    return {height_m, sum.base_m, sum.ditch_m, sum.material, sum.label};
  }

  GroundLook look(double x_m, double y_m) const override
  {
    const GroundSum sum = sumAt(x_m, y_m, [](const TerrainPiece& piece) { return piece.paints(); });
    return {sum.material, sum.label};
  }

  bool isSharpIn(const Area& area) const override
  {
    return std::any_of(
        pieces_.begin(), pieces_.end(),
        [&](const TerrainPiece& piece) { return piece.isSharpIn(area); });
  }

 private:
  template <class Counts>
  GroundSum sumAt(double x_m, double y_m, const Counts& counts) const
  {
    GroundSum sum;
    sum.material = material_;
    sum.label = label_;
    const Eigen::Vector2d place(x_m, y_m);
    const size_t bin = binOf(x_m, y_m);
    for (uint32_t i = begins_[bin]; i < begins_[bin + 1]; ++i)
    {
      const Nearby& near = nearby_[i];
      if (counts(pieces_[near.piece]))
      {
        pieces_[near.piece].add(sum, place, {segments_.data() + near.first, near.count});
      }
    }
    return sum;
  }

  static size_t binsOf(double length_m)
  {
    return static_cast<size_t>(std::ceil(length_m / kBin_m));
  }

  /** The last one is for all places outside of the area. */
  size_t binOf(double x_m, double y_m) const
  {
    const bool inside = x_m >= area_.min_x_m && x_m <= area_.max_x_m && y_m >= area_.min_y_m &&
                        y_m <= area_.max_y_m;
    if (!inside)
    {
      return columns_ * rows_;
    }
    const auto column = static_cast<size_t>((x_m - area_.min_x_m) / kBin_m);
    const auto row = static_cast<size_t>((y_m - area_.min_y_m) / kBin_m);
    return std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
  }

  void fillBins()
  {
    begins_.push_back(0);
    for (size_t row = 0; row < rows_; ++row)
    {
      for (size_t column = 0; column < columns_; ++column)
      {
        const double x = area_.min_x_m + static_cast<double>(column) * kBin_m;
        const double y = area_.min_y_m + static_cast<double>(row) * kBin_m;
        fillBin({x, y, x + kBin_m, y + kBin_m});
      }
    }
    constexpr double kAll = 1e9;
    fillBin({-kAll, -kAll, kAll, kAll});
  }

  void fillBin(const Area& bin)
  {
    for (size_t i = 0; i < pieces_.size(); ++i)
    {
      const TerrainPiece& piece = pieces_[i];
      const size_t first = segments_.size();
      std::copy_if(
          piece.line().begin(), piece.line().end(), std::back_inserter(segments_),
          [&](const Segment& s) { return mayReach(s, piece.reach_m(), bin); });
      const size_t count = segments_.size() - first;
      if (count > 0 || piece.isEverywhere())
      {
        nearby_.push_back(
            {static_cast<uint32_t>(i), static_cast<uint32_t>(first), static_cast<uint32_t>(count)});
      }
    }
    begins_.push_back(static_cast<uint32_t>(nearby_.size()));
  }

  std::vector<TerrainPiece> pieces_;
  Area area_;
  Material material_;
  Label label_;
  size_t columns_ = 0;
  size_t rows_ = 0;
  std::vector<uint32_t> begins_;
  std::vector<Nearby> nearby_;
  std::vector<Segment> segments_;
};

void checkExtent(const SceneExtentParams& extent)
{
  options::check(extent);
  if (!(extent.max_x_m - extent.min_x_m >= 1))
  {
    refuse("max_x_m", extent.max_x_m, "min_x_m + 1 and more");
  }
  if (!(extent.max_y_m - extent.min_y_m >= 1))
  {
    refuse("max_y_m", extent.max_y_m, "min_y_m + 1 and more");
  }
}
}  // namespace

std::shared_ptr<const Terrain> buildTerrain(const SceneParams& params)
{
  inSection("Scene", [&] { checkExtent(params.extent); });
  std::vector<TerrainPiece> pieces;
  pieces.reserve(params.terrains.size());
  for (size_t i = 0; i < params.terrains.size(); ++i)
  {
    inSection(
        numberedSection("Terrain_", i), [&] { pieces.emplace_back(params.terrains[i], params); });
  }
  return std::make_shared<SummedTerrain>(params, std::move(pieces));
}
}  // namespace traverse::simulation
