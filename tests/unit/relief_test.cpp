// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/ground/estimator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <vector>

namespace traverse::ground
{
namespace
{
constexpr geometry::CellRect kWindow{{-75, -75}, {75, 75}};  // 30 x 30 m of 0.2 m cells

/** A level field of columns with some of another shape, and what the estimate says of them. */
class Field
{
 public:
  using Where = std::function<bool(double x_m, double y_m)>;

  explicit Field(uint32_t points)
  {
    for (int32_t y = kWindow.min.y; y < kWindow.max.y; ++y)
    {
      for (int32_t x = kWindow.min.x; x < kWindow.max.x; ++x)
      {
        columns_[{y, x}] = {{x, y}, points, -0.005F, 0, 0.005F, 0.005F, 0};
      }
    }
  }

  /** Gives the columns at some places these heights. */
  Field& with(const Column& shape, const Where& where)
  {
    for (auto& [place, column] : columns_)
    {
      if (where(lattice_.centre_m(place.second), lattice_.centre_m(place.first)))
      {
        const geometry::CellIndex cell = column.cell;
        column = shape;
        column.cell = cell;
      }
    }
    return *this;
  }

  Verdict at(double x_m, double y_m) const
  {
    std::vector<Column> columns;
    columns.reserve(columns_.size());
    std::transform(
        columns_.begin(), columns_.end(), std::back_inserter(columns),
        [](const auto& entry) { return entry.second; });
    Estimator estimator;
    const std::vector<Seed> seeds = {{0, 0, 0, 0, 0, 1}};
    const auto verdicts = estimator.estimate(columns, seeds, lattice_, kWindow, Params{});
    const auto cell = lattice_.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
    const auto found = columns_.find({cell.y, cell.x});
    return verdicts[static_cast<size_t>(std::distance(columns_.begin(), found))];
  }

 private:
  geometry::Lattice lattice_{200};
  std::map<std::pair<int32_t, int32_t>, Column> columns_;
};

Column column(uint32_t n, float low_m, float mean_m, float top_m, float noise_m = 0)
{
  return {{}, n, low_m, mean_m, top_m, top_m, noise_m};
}

Field::Where box(double x0, double y0, double x1, double y1)
{
  return [=](double x, double y) { return x >= x0 && x < x1 && y >= y0 && y < y1; };
}

TEST(Relief, OfALevelFieldIsBelowWhatFlatAllows)
{
  const Field field(100);
  EXPECT_LT(field.at(5.1, 3.1).relief_m, 0.01F);
  EXPECT_TRUE(field.at(5.1, 3.1).is_measured);
}

TEST(Relief, OfAClodIsItsHeight)
{
  // A tenth is added, and a little for few of the points being on it.
  const Field field = Field(300).with(column(300, 0, 0.01F, 0.07F), box(5.0, 3.0, 5.2, 3.2));
  EXPECT_GT(field.at(5.1, 3.1).relief_m, 0.07F);
  EXPECT_LT(field.at(5.1, 3.1).relief_m, 0.085F);
  EXPECT_LT(field.at(5.3, 3.1).relief_m, 0.03F) << "the cell beside it is flat";
}

TEST(Relief, OfALevelBeamsHitIsWhatWasSeenOfIt)
{
  Column hit = column(5, 0, 0, 0.005F);
  hit.top_m = 0.5F;  // taken to stand upright
  const Field field = Field(300).with(hit, box(5.0, 3.0, 5.2, 3.2));
  EXPECT_LT(field.at(5.1, 3.1).relief_m, 0.03F);
}

TEST(Relief, OfANarrowBankIsItsHeightThoughItsTopIsFlat)
{
  const Field field = Field(300).with(column(300, 0.19F, 0.20F, 0.21F), box(3, 5.1, 12, 5.7));
  EXPECT_NEAR(field.at(7.1, 5.5).relief_m, 0.22F, 0.03F);
}

TEST(Relief, OfADitchIsItsDepthForTheGroundDoesNotSinkIntoIt)
{
  const Field field = Field(300).with(column(300, -0.41F, -0.40F, -0.39F), box(3, 5.1, 12, 5.5));
  EXPECT_GT(field.at(7.1, 5.3).relief_m, 0.35F);
  EXPECT_LT(field.at(7.1, 6.1).relief_m, 0.03F) << "the field beside it is flat";
}

TEST(Relief, OfAFewPointsIsLikeThatOfMostCellsAround)
{
  const Field field = Field(300)
                          .with(column(300, 0, 0.02F, 0.08F), box(4, 2, 6, 4))
                          .with(column(3, 0, 0, 0.01F), box(5.0, 3.0, 5.2, 3.2));
  EXPECT_GT(field.at(5.1, 3.1).relief_m, 0.06F);
}

TEST(Relief, ThingsDoNotMakeSparseGroundBesideThemRough)
{
  const Field field = Field(300)
                          .with(column(300, 0, 0.8F, 1.6F), box(4, 2, 6, 4))
                          .with(column(3, 0, 0, 0.01F), box(5.0, 3.0, 5.2, 3.2));
  EXPECT_LT(field.at(5.1, 3.1).relief_m, 0.03F);
}

TEST(Relief, NoiseThatExplainsTheScatterIsTakenOff)
{
  const Field field =
      Field(300).with(column(300, -0.05F, 0, 0.05F, 0.05F), box(5.0, 3.0, 5.2, 3.2));
  EXPECT_LT(field.at(5.1, 3.1).relief_m, 0.02F);
}

TEST(Relief, APatchOfGrassIsLowGrowthAFenceIsNot)
{
  const Column grass = column(60, 0, 0.04F, 0.35F);
  EXPECT_TRUE(Field(100).with(grass, box(4, 2, 6, 4)).at(5.1, 3.1).is_low_growth);
  EXPECT_FALSE(Field(100).with(grass, box(4, 3.0, 6, 3.2)).at(5.1, 3.1).is_low_growth)
      << "one cell wide: a fence of wire, which much is seen through";
  const Column wire = column(60, 0, 0.1F, 1.2F);
  EXPECT_FALSE(Field(100)
                   .with(grass, box(4, 2, 6, 4))
                   .with(wire, box(5.2, 3.0, 5.4, 3.2))
                   .at(5.1, 3.1)
                   .is_low_growth)
      << "grass beside something tall may be part of it";
  const Column board = column(60, 0, 0.17F, 0.35F);
  EXPECT_FALSE(Field(100).with(board, box(4, 2, 6, 4)).at(5.1, 3.1).is_low_growth);
}

TEST(Relief, APavementSeenByOneRingSaysNothing)
{
  const Column ring = column(4, 0.14F, 0.145F, 0.15F);
  const Field field = Field(4).with(ring, box(4, 5.0, 8, 5.4));
  EXPECT_LT(field.at(5.1, 5.1).relief_m, 0.03F);
}
}  // namespace
}  // namespace traverse::ground
