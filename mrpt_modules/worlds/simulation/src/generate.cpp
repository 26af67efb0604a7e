// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"
#include "paper_3.h"
#include "paper_5.h"
#include "refuse.h"

namespace traverse::simulation
{
namespace
{
void addRandom(SceneParams& scene, uint64_t seed)
{
  switch (scene.random.style)
  {
    case RandomStyle::none:
      return;
    case RandomStyle::paper_3:
      return Paper3(scene, seed).addAll();
    case RandomStyle::paper_5:
      return Paper5(scene, seed).addAll();
    case RandomStyle::clutter:
      return addClutter(scene, seed);
    case RandomStyle::park:
      return addPark(scene, seed);
    case RandomStyle::tunnel:
      return addTunnel(scene, seed);
    case RandomStyle::warehouse:
      return addWarehouse(scene, seed);
    case RandomStyle::icy_lot:
      return addIcyLot(scene, seed);
  }
}
}  // namespace

SceneParams generate(const SceneParams& fixed, uint64_t seed)
{
  SceneParams scene = fixed;
  if (fixed.random.style != RandomStyle::none)
  {
    inSection(
        "Random",
        [&]
        {
          options::check(fixed.random);
          addRandom(scene, seed);
          scene.random = {};
        });
  }
  return scene;
}
}  // namespace traverse::simulation
