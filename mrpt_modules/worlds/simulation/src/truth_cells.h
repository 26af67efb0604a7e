// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "truth_grid.h"
#include "truth_pieces.h"
#include "truth_stack.h"

#include <traverse/simulation/truth.h>

#include <array>
#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** One cell of the truth; members as the layers of cellTruth(). */
struct TrueCell
{
  TrueClass of = TrueClass::unknown;
  TrueState state = TrueState::unknown;
  float roughness_m = 0;
  float step_m = 0;
  float slope_deg = 0;
  float ground_m = 0;
  uint32_t object = Scene::kNoObject;
  Label label = Label::none;
};

/** What is known of the sub-squares. */
struct SubSquares
{
  const Scene& scene;
  const SubGrid& grid;
  const GroundSamples& ground;
  const std::vector<float>& climb_m;
  const std::vector<uint8_t>& reached;
  const Pieces& pieces;
};

/** Judges cells by their sub-squares; columns and rows are counted from the extent's corner. */
class CellJudge
{
 public:
  CellJudge(const SubSquares& subs, const geometry::Vehicle& vehicle, const TruthParams& params);

  TrueCell at(int32_t x, int32_t y);

 private:
  static constexpr int kSubs = kSubsPerCell * kSubsPerCell;

  /** Of one cell, from its sub-squares. */
  struct Gathered
  {
    std::array<float, kSubs> hard_m{};
    std::array<float, kSubs> top_m{};
    float hard_step_m = 0;
    float top_step_m = 0;
    float ditch_m = 0;
    float ground_m = 0;
    bool known = true;
    bool reached = false;
    bool overhang = false;
    uint32_t object = Scene::kGround;
    Label label = Label::ground;
    float decides_m = -1;  //!< deviation of the sub-square that decides
  };

  Gathered gather(int32_t x, int32_t y);
  void addSub(Gathered& cell, int k, size_t sub);
  TrueClass classOf(float roughness_m) const;
  float slopeDegAt(int32_t x, int32_t y) const;
  double riseAlong(int32_t middle, int32_t line, bool along_x) const;
  TrueState stateOf(const Gathered& cell, TrueClass of) const;

  SubSquares subs_;
  const geometry::Vehicle& vehicle_;
  const TruthParams& params_;
  Stacker stacker_;
};

/** The layers' arrays while they are filled. */
class CellLayers
{
 public:
  explicit CellLayers(const geometry::CellRect& extent);

  void put(int32_t x, int32_t y, const TrueCell& cell);

  layers::LayerSet take(const geometry::Lattice& lattice);

 private:
  geometry::CellRect extent_;
  std::vector<uint8_t> of_, state_, label_;
  std::vector<uint32_t> object_;
  std::vector<float> roughness_, step_, slope_, ground_;
};
}  // namespace traverse::simulation
