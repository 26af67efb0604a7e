// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_3.h"

#include <algorithm>
#include <tuple>

namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  hills = 1,
  road,
  kerb,
  ditch,
  banks,
  drifts,
  ruts
};

TerrainParams terrain(TerrainKind kind)
{
  TerrainParams p;
  p.kind = kind;
  return p;
}
}  // namespace

void Paper3::addGround()
{
  scene_.extent.ground_material = choose(winter_ ? Material::snow : Material::soil);
  addHills();
  addRoad();
  addKerb();
  addDitch();
  addBanks();
  addDrifts();
  addRuts();
}

void Paper3::addHills()
{
  Random random = randomFor(Purpose::hills);
  const auto add = [&](TerrainKind kind, double height_m, double wavelength_m)
  {
    TerrainParams p = terrain(kind);
    p.height_m = inMillimetres(height_m);
    p.wavelength_m = inMillimetres(wavelength_m);
    p.seed = seedOf(random);
    if (p.height_m > 0)
    {
      scene_.terrains.push_back(p);
    }
  };
  const double high = asks_.hill_height_m * random.uniform(0.2, 1);
  add(TerrainKind::hills, high, random.uniform(20, 36));
  // one draw a statement: the order within one is the compiler's choice
  const double low = high * random.uniform(0.1, 0.25);
  add(TerrainKind::hills, low, random.uniform(9, 14));
  const double rough = std::min(0.015, asks_.roughness_m * random.uniform(0.5, 1.6));
  add(TerrainKind::roughness, rough, random.uniform(0.45, 1.1));
  const double fine = random.uniform(0.001, 0.004);
  add(TerrainKind::roughness, fine, random.uniform(0.2, 0.35));
}

void Paper3::addRoad()
{
  Random random = randomFor(Purpose::road);
  TerrainParams p = terrain(TerrainKind::road);
  follow(p, -way_.half_m(), way_.half_m(), 0);
  p.width_m = 2 * half_road_m_;
  p.height_m = rounded(random, 0.005, 0.07);
  if (winter_ && random.chance(0.6))
  {
    p.material = choose(random.chance(0.7) ? Material::snow : Material::ice);
  }
  scene_.terrains.push_back(p);
  p.kind = TerrainKind::roughness;
  p.height_m = rounded(random, 0.001, 0.005);
  p.wavelength_m = rounded(random, 0.3, 1.2);
  p.edge_m = 0.1;
  p.material = MaterialChoice::usual;
  p.seed = seedOf(random);
  scene_.terrains.push_back(p);
}

void Paper3::addKerb()
{
  if (kerb_side_ == 0)
  {
    return;
  }
  Random random = randomFor(Purpose::kerb);
  TerrainParams p = terrain(TerrainKind::kerb);
  const double from = random.chance(0.5) ? -way_.half_m() : random.uniform(-24, -4);
  const double to = random.chance(0.5) ? way_.half_m() : random.uniform(4, 24);
  follow(p, from, to, kerb_side_ * (half_road_m_ + kerb_m_ / 2));
  p.width_m = kerb_m_;
  p.height_m = rounded(random, 0.1, 0.2);
  scene_.terrains.push_back(p);
}

void Paper3::addDitch()
{
  if (ditch_side_ == 0)
  {
    return;
  }
  Random random = randomFor(Purpose::ditch);
  TerrainParams p = terrain(TerrainKind::ditch);
  p.width_m = rounded(random, 0.6, 1.5);
  p.height_m = rounded(random, 0.3, 0.9);
  p.edge_m = rounded(random, 0.05, 0.25);
  const double from = random.uniform(-26, -2);
  const double off = half_road_m_ + 1.6 + p.width_m / 2 + random.uniform(0, 1.5);
  follow(p, from, std::min(28.0, from + random.uniform(10, 30)), ditch_side_ * off);
  plot_.take(discsAlong(p.xs_m, p.ys_m, p.width_m / 2));
  scene_.terrains.push_back(p);
}

TerrainParams Paper3::randomBank(Random& random) const
{
  TerrainParams p = terrain(TerrainKind::bank);
  p.width_m = rounded(random, 0.5, 1.3);
  p.height_m = rounded(random, 0.13, 0.24);
  p.edge_m = rounded(random, 0.04, 0.15);
  p.wavelength_m = rounded(random, 0.4, 1.6);
  p.seed = seedOf(random);
  if (!winter_ && random.chance(0.4))
  {
    p.material = choose(Material::soil);
  }
  return p;
}

void Paper3::addBank(double from_m, double to_m, double side, Random& random)
{
  TerrainParams p = randomBank(random);
  // on a pavement's side at the foot of the kerb, on the road
  const double off = side == kerb_side_ ? half_road_m_ - p.width_m / 2
                                        : half_road_m_ + random.uniform(-0.3, 1.4 - p.width_m / 2);
  const double nearest = side == lane_side_ ? lane_m_ + 1.1 : kDriveFree_m + 0.05;
  follow(p, from_m, to_m, side * std::max(nearest + p.width_m / 2, off));
  scene_.terrains.push_back(p);
}

void Paper3::addDrifts()
{
  Random random = randomFor(Purpose::drifts);
  const int n = static_cast<int>(7 * asks_.bank_share * random.uniform());
  for (int i = 0; i < n; ++i)
  {
    TerrainParams p = randomBank(random);
    const double side = random.chance(0.5) ? 1 : -1;
    double along = random.uniform(-20, 20);
    double off = half_road_m_ + 4 + random.uniform(0, 12);
    const double step = random.chance(0.5) ? 1.5 : -1.5;
    double aside = random.uniform(-1, 1);
    const int corners = 3 + static_cast<int>(random.index(5));
    for (int corner = 0; corner < corners; ++corner)
    {
      const Eigen::Vector2d at = way_.place(along, side * off);
      p.xs_m.push_back(inMillimetres(at.x()));
      p.ys_m.push_back(inMillimetres(at.y()));
      along += step;
      off = std::max(half_road_m_ + 3, off + aside);
      aside += random.uniform(-0.4, 0.4);
    }
    scene_.terrains.push_back(p);
  }
}

void Paper3::addBanks()
{
  Random random = randomFor(Purpose::banks);
  const double sure_side = random.chance(0.5) ? 1 : -1;
  const double sure = random.uniform(-12, 4);
  if (asks_.bank_share > 0)
  {
    addBank(sure, sure + random.uniform(6, 12), sure_side, random);
  }
  for (const double side : {1.0, -1.0})
  {
    double from = random.uniform(-30, -22);
    while (from < 24)
    {
      const double to = from + random.uniform(3, 11);
      const bool apart = side != sure_side || to < sure - 1 || from > sure + 13;
      if (random.chance(asks_.bank_share) && apart)
      {
        addBank(from, to, side, random);
      }
      from = to + random.uniform(1, 5);
    }
  }
}

void Paper3::addRutsAside(Random& random, TerrainParams& p) const
{
  const double side = openSide(random);
  const double from = random.uniform(-18, 8);
  const double ahead = random.chance(0.5) ? 1 : -1;
  const double steep = random.uniform(0.3, 1.2);
  const int corners = 5 + static_cast<int>(random.index(4));
  for (int i = 0; i < corners; ++i)
  {
    // leaves the road along a parabola
    const double along = from + ahead * 2.2 * i;
    const double off = half_road_m_ + 1.2 + steep * 0.25 * i * i;
    const Eigen::Vector2d at = way_.place(along, side * off);
    p.xs_m.push_back(inMillimetres(at.x()));
    p.ys_m.push_back(inMillimetres(at.y()));
  }
}

void Paper3::addRuts()
{
  Random random = randomFor(Purpose::ruts);
  const int n = asks_.ruts == 0 ? 0 : std::max(1, about(asks_.ruts, random));
  for (int i = 0; i < n; ++i)
  {
    TerrainParams p = terrain(TerrainKind::ruts);
    p.width_m = rounded(random, 1.3, 1.9);
    p.height_m = rounded(random, 0.035, 0.085);
    p.groove_m = rounded(random, 0.2, 0.38);
    p.edge_m = rounded(random, 0.01, 0.04);
    const bool on_road = random.chance(0.4);
    if (on_road)
    {
      const double from = random.uniform(-20, 4);
      const double to = from + random.uniform(8, 22);
      follow(p, from, to, random.uniform(-0.5, 0.5));
    }
    else
    {
      addRutsAside(random, p);
      plot_.take(discsAlong(p.xs_m, p.ys_m, p.width_m / 2 + 0.3));
    }
    scene_.terrains.push_back(p);
  }
}
}  // namespace traverse::simulation
